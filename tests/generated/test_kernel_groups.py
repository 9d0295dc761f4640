"""Poses of composed vectors, screws, lines and twists."""

from __future__ import annotations

from types import ModuleType

import numpy as np
import pytest

import dualcay
from tests.support import errors, sampling
from tests.support.errors import assert_close
from tests.support.nilpotent import Nil
from tests.support.sampling import reached

EPS = float(np.finfo(float).eps)
REGIMES = ("uniform", "angle 1e-7", "middle band", "shadow", "translation 1e6", "pure translation", "identity")
REGIME = pytest.mark.parametrize("regime", REGIMES)


def dual_product(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return np.stack(
        [a[..., 0, :, :] @ b[..., 0, :, :], a[..., 0, :, :] @ b[..., 1, :, :] + a[..., 1, :, :] @ b[..., 0, :, :]], -3
    )


def pose_scale(order: int, *vectors: np.ndarray) -> Nil:
    """Return the scale of a product of tensors; each factor has the error from rounding its vector."""
    scale = Nil(1.0, 0.0)
    for v in vectors:
        local = errors.scales(order, v)
        scale = scale * (local.tensor + local.tangent * local.vector * local.tensor)
    return scale


@pytest.mark.smoke
@REGIME
def test_composition_is_the_product_of_tensors_v1_first(kernel: ModuleType, order: int, regime: str) -> None:
    v2, v1 = reached(order, regime), reached(order, "uniform")[::-1]
    composed = kernel.compose(v2, v1)
    product = dual_product(kernel.tensor(v2), kernel.tensor(v1))
    for i, v in enumerate(composed):
        scale = pose_scale(order, v2[i], v1[i]) + pose_scale(order, v)
        assert_close(kernel.tensor(v), product[i], scale)
        assert_close(kernel.pose(v), kernel.pose(v2[i]) @ kernel.pose(v1[i]), scale)
        if regime != "identity":
            assert errors.norm(kernel.pose(v) - kernel.pose(v1[i]) @ kernel.pose(v2[i])) > 1e-9  # the order matters


def test_from_screw_takes_any_angle(kernel: ModuleType, order: int) -> None:
    angle, axis = sampling.screws(order, count=6)
    there = kernel.from_screw(angle, axis)
    np.testing.assert_allclose(kernel.from_screw(-angle, axis), -there, rtol=8 * EPS)
    np.testing.assert_allclose(kernel.from_screw(-angle, -axis), there, rtol=8 * EPS)
    for k in range(1, order):
        turned = kernel.from_screw(np.add(angle, (2 * np.pi * k, 0)), axis)
        np.testing.assert_allclose(kernel.pose(turned), kernel.pose(there), atol=1e-11)
        np.testing.assert_allclose(turned, kernel.shadow(there, k), rtol=1e-9, atol=1e-11)


def test_screw_of_a_translation_and_of_the_identity(kernel: ModuleType, order: int) -> None:
    v = np.array([0, 0, 0, 0.0, -3.0, 4.0])
    angle, axis = kernel.to_screw(v)
    np.testing.assert_allclose(angle, [0, 10 * order], rtol=4 * EPS)
    np.testing.assert_allclose(axis, [0, -0.6, 0.8, 0, 0, 0], rtol=4 * EPS)
    np.testing.assert_allclose(kernel.from_screw(angle, axis), v, rtol=8 * EPS)
    angle, axis = kernel.to_screw(np.zeros(6))
    np.testing.assert_array_equal(angle, [0, 0])
    assert np.isnan(axis).all()


@REGIME
def test_lines_move_by_the_dual_tensor_and_with_their_points(kernel: ModuleType, order: int, regime: str) -> None:
    v = reached(order, regime)
    first, second = sampling.points("first", count=6), sampling.points("second", count=6)

    def line(a: np.ndarray, b: np.ndarray) -> np.ndarray:
        return np.concatenate([b - a, np.cross(a, b - a)], axis=-1)

    given = line(first, second)
    moved = kernel.transform_line(v, given)
    by_points = line(kernel.transform_point(v, first), kernel.transform_point(v, second))
    by_tensor = np.einsum("...ij,...j->...i", dualcay.matrix6(kernel.tensor(v)), given)
    for i in range(len(v)):
        local = errors.scales(order, v[i])
        assert_close(moved[i], by_tensor[i], local.tensor * errors.size(given[i]))
        reach = errors.norm(first[i]) + errors.norm(second[i]) + local.position
        assert_close(moved[i], by_points[i], Nil(3 * reach, 3 * reach**2))


def test_matrix6_acts_on_twists_as_the_dual_tensor_does(order: int, kernel: ModuleType) -> None:
    d = kernel.tangent(reached(order, "uniform").reshape(2, 3, 6))
    m = dualcay.matrix6(d)
    assert m.shape == (2, 3, 6, 6)
    assert m.dtype == d.dtype
    np.testing.assert_array_equal(m[..., :3, :3], d[..., 0, :, :])
    np.testing.assert_array_equal(m[..., 3:, 3:], d[..., 0, :, :])
    np.testing.assert_array_equal(m[..., 3:, :3], d[..., 1, :, :])
    np.testing.assert_array_equal(m[..., :3, 3:], 0)
