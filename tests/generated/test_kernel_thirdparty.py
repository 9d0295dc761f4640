"""Agreement with SciPy's RigidTransform; difference from the Cayley map of 4x4 homogeneous matrices."""

from __future__ import annotations

from types import ModuleType

import numpy as np
import pytest
from scipy.spatial.transform import RigidTransform, Rotation

from tests.support import errors, sampling
from tests.support.sampling import reached

REGIMES = ("uniform", "angle 1e-12", "angle 1e-7", "middle band", "below pi", "shadow", "pure rotation", "identity")
REGIME = pytest.mark.parametrize("regime", REGIMES)
EPS = float(np.finfo(float).eps)


def assert_same(order: int, v: np.ndarray, ours: np.ndarray, theirs: np.ndarray, factor: float = 1.0) -> None:
    """Require agreement within the sum of two gates, which also covers SciPy's errors of some eps."""
    for one, a, b in zip(v, ours, theirs, strict=True):
        local = errors.scales(order, one)
        assert errors.norm(a[:3, :3] - b[:3, :3]) <= factor * errors.AGREE * EPS * local.tensor.re
        assert errors.norm(a[:3, 3] - b[:3, 3]) <= factor * errors.AGREE * EPS * (local.position + local.tensor.du)


@REGIME
def test_poses_and_dual_quaternions(kernel: ModuleType, order: int, regime: str) -> None:
    v = reached(order, regime, 12)
    third = RigidTransform.from_dual_quat(kernel.quaternion(v), scalar_first=True)
    assert_same(order, v, kernel.pose(v), third.as_matrix())
    turned = Rotation.from_quat(kernel.quaternion(v)[:, :4], scalar_first=True).as_matrix()
    np.testing.assert_allclose(kernel.pose(v)[:, :3, :3], turned, rtol=0, atol=errors.AGREE * EPS)


@pytest.mark.parametrize("form", ["quaternion", "tensor", "pose"])
def test_inverse_maps_of_random_transforms(kernel: ModuleType, order: int, form: str) -> None:
    rng = sampling.generator("transforms", order)
    rotations = Rotation.from_quat(rng.normal(size=(30, 4)))
    third = RigidTransform.from_components(3 * rng.normal(size=(30, 3)), rotations)
    matrix = third.as_matrix()
    if form == "quaternion":
        v = kernel.from_quaternion(third.as_dual_quat(scalar_first=True))
    elif form == "pose":
        v = kernel.from_pose(matrix)
    else:
        moments = np.cross(matrix[:, None, :3, 3], np.swapaxes(matrix[:, :3, :3], -1, -2))
        v = kernel.from_tensor(np.stack([matrix[:, :3, :3], np.swapaxes(moments, -1, -2)], axis=1))
    size = 1 + np.linalg.norm(v[:, :3], axis=-1)[:, None, None] ** 2  # n = 1 near π
    assert (abs(kernel.pose(v) - matrix) <= 1e-13 * size).all()


def homogeneous_cayley(v: np.ndarray, order: int) -> np.ndarray:
    """Return the Cayley map of homogeneous matrices, ((I − A)⁻¹ (I + A))^n with A = [[skew ω, t], [0, 0]]."""
    w, t = v[:3], v[3:]
    a = np.zeros((4, 4))
    a[:3, :3] = [[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]]
    a[:3, 3] = t
    return np.linalg.matrix_power(np.linalg.solve(np.eye(4) - a, np.eye(4) + a), order)


def test_the_dual_cayley_map_is_not_the_homogeneous_one(kernel: ModuleType, order: int) -> None:
    """Expect equal rotations and different translations; without rotation, both maps translate by 2n v°."""
    for v in reached(order, "uniform", 12):
        dual, homogeneous = kernel.pose(v), homogeneous_cayley(v, order)
        np.testing.assert_allclose(dual[:3, :3], homogeneous[:3, :3], atol=1e-13)
        assert np.linalg.norm(dual[:3, 3] - homogeneous[:3, 3]) > 0.001 * (v[:3] @ v[:3]) * np.linalg.norm(dual[:3, 3])
    # Along the axis, translations differ by exactly the factor 1 + x.
    axis, x = np.array([0.6, 0.0, 0.8]), 0.01
    v = np.concatenate([0.1 * axis, 2.0 * axis])
    ratio = homogeneous_cayley(v, order)[:3, 3] @ axis / (kernel.pose(v)[:3, 3] @ axis)
    np.testing.assert_allclose(ratio, 1 + x, rtol=1e-13)
    for v in reached(order, "pure translation", 12):
        np.testing.assert_allclose(kernel.pose(v), homogeneous_cayley(v, order), rtol=1e-14)
