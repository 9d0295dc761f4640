"""Branches and screws: counts of branches, inverse maps of inexact poses, screws of any angle, tiny vectors."""

from __future__ import annotations

import importlib
from types import ModuleType

import numpy as np
import pytest

from tests.support import sampling

EPS = float(np.finfo(float).eps)
ROUTES = {
    "from_quaternion": lambda kernel, v: kernel.quaternion(v),
    "from_tensor": lambda kernel, v: kernel.tensor(v),
    "from_pose": lambda kernel, v: kernel.pose(v),
}


@pytest.mark.parametrize("route", ROUTES)
def test_branches_are_counted_modulo_the_order(kernel: ModuleType, order: int, route: str) -> None:
    given = ROUTES[route](kernel, sampling.poses(order, "uniform"))
    for branch in range(order):
        for turns in (-2, -1, 1):
            again = getattr(kernel, route)(given, branch + turns * order)
            np.testing.assert_array_equal(again, getattr(kernel, route)(given, branch))


@pytest.mark.parametrize("route", [*ROUTES, "shadow"])
def test_branches_are_integers(kernel: ModuleType, order: int, route: str) -> None:
    v = sampling.poses(order, "uniform")
    given = v if route == "shadow" else ROUTES[route](kernel, v)
    for form in (given, given[0]):
        expected = getattr(kernel, route)(form, 1)
        np.testing.assert_array_equal(getattr(kernel, route)(form, np.int64(1)), expected)
        np.testing.assert_array_equal(getattr(kernel, route)(form, branch=1), expected)
        for wrong in (0.5, 1.0, "1", None):
            with pytest.raises(TypeError, match="branch"):
                getattr(kernel, route)(form, wrong)


def test_from_screw_takes_any_angle(kernel: ModuleType, order: int) -> None:
    angle, axis = sampling.screws(order, count=6)
    there = kernel.from_screw(angle, axis)
    np.testing.assert_allclose(kernel.from_screw(-angle, axis), -there, rtol=8 * EPS)
    np.testing.assert_allclose(kernel.from_screw(-angle, -axis), there, rtol=8 * EPS)
    for k in range(1, order):
        turned = kernel.from_screw(np.add(angle, (2 * np.pi * k, 0)), axis)
        np.testing.assert_allclose(kernel.pose(turned), kernel.pose(there), atol=1e-11)
        np.testing.assert_allclose(turned, kernel.shadow(there, k), rtol=1e-9, atol=1e-11)


TINY, SMALL = 1e-300, 1e-6


@pytest.mark.parametrize("chart", ["cayley3", "cayley5", "lambert", "sine3", "exponential", "scaled4"])
def test_jacobian_of_a_shadow_is_finite_where_x_underflows(chart: str) -> None:
    kernels = importlib.import_module(f"dualcay.{chart}")
    direction = np.array([1.0, 2.0, -2.0]) / 3
    tiny, small = (kernels.shadow_jacobian([*(size * direction), 0, 0, 0], 1) for size in (TINY, SMALL))
    along, across = direction, np.array([2.0, 1.0, 2.0]) / 3
    assert np.isfinite(tiny).all()
    for block in (slice(0, 3), slice(3, 6)):
        # across the axis, the Jacobian is r_k/r and grows like 1/r
        expected = across @ small[block, block] @ across * SMALL
        assert across @ tiny[block, block] @ across * TINY == pytest.approx(expected, rel=1e-5)
    slope = kernels.shadow_jacobian([TINY, 0, 0, 0.1, 0, 0], 1)
    assert np.isfinite(slope).all(axis=1)[0]
    assert slope[0, 0] == pytest.approx(along @ small[:3, :3] @ along, rel=1e-4, abs=1e-4)
    assert not np.isnan(slope).any()
