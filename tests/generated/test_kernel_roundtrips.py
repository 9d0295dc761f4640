"""Round trips v → pose → v: all branches and representations, both signs of the quaternion, group of shadows."""

from __future__ import annotations

from types import ModuleType

import numpy as np
import pytest

from tests.support import errors, sampling
from tests.support.accuracy import Trial
from tests.support.nilpotent import Nil

EPS = float(np.finfo(float).eps)
REGIMES = ("uniform", "middle band", "below pi", "translation 1e6", "pure rotation", "pure translation", "shadow")
ROUTES = {
    "from_quaternion": lambda kernel, v: kernel.quaternion(v),
    "from_tensor": lambda kernel, v: kernel.tensor(v),
    "from_pose": lambda kernel, v: kernel.pose(v),
}


def samples(order: int, regime: str) -> np.ndarray:
    if not sampling.has_regime(order, regime):
        return np.zeros((0, 6))
    return sampling.poses(order, regime, count=3)


def assert_same_pose(kernel: ModuleType, order: int, a: np.ndarray, b: np.ndarray) -> None:
    """Require equal tensors of two batches, up to errors of the tensors and rounding of the vectors."""
    for x, y, left, right in zip(a, b, kernel.tensor(a), kernel.tensor(b), strict=True):
        allowed = Nil(0.0, 0.0)
        for v in (x, y):
            local = errors.scales(order, v)
            allowed = allowed + local.tensor + local.tangent * local.vector * local.tensor
        difference = left - right
        for part, scale in zip(difference, (allowed.re, allowed.du), strict=True):
            assert errors.norm(part) <= errors.AGREE * EPS * scale, (x, y)


@pytest.mark.parametrize("regime", REGIMES)
@pytest.mark.parametrize("route", ROUTES)
def test_every_branch_gives_the_pose_back(kernel: ModuleType, order: int, route: str, regime: str) -> None:
    v = samples(order, regime)
    for branch in range(order):
        found = getattr(kernel, route)(ROUTES[route](kernel, v), branch)
        chart = np.linalg.norm(found[:, :3], axis=-1) < 1e4  # rounding spoils the poses of longer vectors
        assert_same_pose(kernel, order, v[chart], found[chart])


@pytest.mark.parametrize("route", ROUTES)
def test_branches_are_counted_modulo_the_order(kernel: ModuleType, order: int, route: str) -> None:
    given = ROUTES[route](kernel, samples(order, "uniform"))
    for branch in range(order):
        for turns in (-2, -1, 1):
            again = getattr(kernel, route)(given, branch + turns * order)
            np.testing.assert_array_equal(again, getattr(kernel, route)(given, branch))


@pytest.mark.parametrize("route", [*ROUTES, "shadow"])
def test_branches_are_integers(kernel: ModuleType, order: int, route: str) -> None:
    v = samples(order, "uniform")
    given = v if route == "shadow" else ROUTES[route](kernel, v)
    for form in (given, given[0]):
        expected = getattr(kernel, route)(form, 1)
        np.testing.assert_array_equal(getattr(kernel, route)(form, np.int64(1)), expected)
        np.testing.assert_array_equal(getattr(kernel, route)(form, branch=1), expected)
        for wrong in (0.5, 1.0, "1", None):
            with pytest.raises(TypeError, match="branch"):
                getattr(kernel, route)(form, wrong)


@pytest.mark.parametrize("route", ROUTES)
@pytest.mark.parametrize("regime", ["uniform", "pure rotation"])
def test_inverse_maps_are_lipschitz_in_the_violation(kernel: ModuleType, order: int, route: str, regime: str) -> None:
    """Violate unit norm or orthogonality; expect a change of the result of the same order."""
    v = samples(order, regime)
    given = ROUTES[route](kernel, v)
    noise = sampling.generator("noise", route).normal(size=given.shape)
    for step in (1e-10, 1e-7):
        found = getattr(kernel, route)(given + step * noise)
        assert (abs(found - v) <= 1e3 * step * (1 + np.linalg.norm(v, axis=-1, keepdims=True)) ** 2).all()


@pytest.mark.parametrize("regime", ["uniform", "translation 1e6"])
def test_shadows_form_a_cyclic_group(kernel: ModuleType, order: int, regime: str) -> None:
    v = sampling.poses(order, regime, count=2)
    trial = Trial(kernel, order, "uniform")
    for j in range(order):
        middle = kernel.shadow(v, j)
        for k in range(-1, order + 1):
            for start, between, twice, once in zip(
                v, middle, kernel.shadow(middle, k), kernel.shadow(v, j + k), strict=True
            ):
                allowed = trial.shadow_scale(start, once) + trial.shadow_scale(between, once)
                gate = 2 * errors.shadow_gate(order) * EPS
                assert errors.norm(twice[:3] - once[:3]) <= gate * allowed.re
                assert errors.norm(twice[3:] - once[3:]) <= gate * allowed.du


@pytest.mark.parametrize("regime", REGIMES)
def test_shadows_give_the_same_pose_and_the_quaternion_up_to_sign(kernel: ModuleType, order: int, regime: str) -> None:
    v = samples(order, regime)
    q = kernel.quaternion(v)
    for branch in range(order):
        shadows = kernel.shadow(v, branch)
        chart = np.linalg.norm(shadows[:, :3], axis=-1) < 1e4
        assert_same_pose(kernel, order, v[chart], shadows[chart])
        if order % 2 == 0:
            # The closed form has the sign (−1)^k.
            agree = np.einsum("ij,ij->i", kernel.quaternion(shadows[chart])[:, :4], q[chart][:, :4])
            np.testing.assert_allclose(agree, (-1.0) ** branch, rtol=1e-9)
