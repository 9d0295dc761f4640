"""Conventions of other libraries, as stated in the table of the README."""

from __future__ import annotations

import jax
import jaxlie
import numpy as np
import pytest
from pytransform3d import rotations, transformations
from scipy.spatial.transform import RigidTransform, Rotation

from dualcay import cayley2, exponential

V, W = cayley2.random(2, rng=0)
T, Q = cayley2.pose(V), cayley2.pose(V)[:3, :3]
XI = exponential.from_pose(T)
STEP = np.array([0.1, 0.2, 0.3, 0.4, 0.5, 0.6])
HALVES = np.array([3, 4, 5, 0, 1, 2])


def close(a: object, b: object) -> bool:
    return np.allclose(np.asarray(a), np.asarray(b), rtol=0, atol=1e-12)


def up_to_sign(a: object, b: object) -> bool:
    return close(a, b) or close(a, -np.asarray(b))


def test_scipy():
    pose = RigidTransform.from_matrix(T)
    assert close(pose.as_exp_coords(), XI)
    assert up_to_sign(pose.as_dual_quat(scalar_first=True), cayley2.quaternion(V))
    assert up_to_sign(pose.as_dual_quat(), cayley2.quaternion(V, scalar_first=False))
    assert up_to_sign(Rotation.from_matrix(Q).as_quat(), cayley2.quaternion(V, scalar_first=False)[:4])
    assert close(Rotation.from_matrix(Q).as_mrp(), V[:3])
    assert close((RigidTransform.from_matrix(cayley2.pose(W)) * pose).as_matrix(), cayley2.pose(cayley2.compose(W, V)))


def test_schaub_and_junkins():
    """Compare with formulas from Schaub and Junkins: [BN] of σ, and σ̇ = ¼ B(σ) ω_B."""
    s, x, omega = V[:3], V[:3] @ V[:3], STEP[:3]
    skew = np.cross(s, np.eye(3)).T
    assert close(skew @ omega, np.cross(s, omega))
    assert close(np.eye(3) + (8 * skew @ skew - 4 * (1 - x) * skew) / (1 + x) ** 2, Q.T)
    rate = ((1 - x) * np.eye(3) + 2 * skew + 2 * np.outer(s, s)) @ omega / 4
    assert close(rate, cayley2.body_rate(V, np.concatenate([omega, np.zeros(3)]))[:3])


def test_pytransform3d():
    assert close(transformations.exponential_coordinates_from_transform(T), XI)
    assert up_to_sign(transformations.dual_quaternion_from_transform(T), cayley2.quaternion(V))
    assert close(rotations.mrp_from_quaternion(cayley2.quaternion(V)[:4]), V[:3])
    assert close(transformations.adjoint_from_transform(T), cayley2.adjoint(V))


def test_jaxlie():
    with jax.enable_x64(True):
        pose = jaxlie.SE3.from_matrix(T)
        assert close(pose.log()[HALVES], XI)
        assert up_to_sign(pose.wxyz_xyz[:4], cayley2.quaternion(V)[:4])
        moved = jaxlie.manifold.rplus(pose, STEP[HALVES])
        assert close(moved.as_matrix(), cayley2.pose(cayley2.body_retract(V, STEP)))


def test_pinocchio():
    pinocchio = pytest.importorskip("pinocchio")
    pose = pinocchio.SE3(T)
    assert close(pinocchio.log6(pose).vector[HALVES], XI)
    assert up_to_sign(pinocchio.SE3ToXYZQUAT(pose)[3:], cayley2.quaternion(V, scalar_first=False)[:4])
    jacobian = pinocchio.Jexp6(XI[HALVES])[HALVES][:, HALVES]
    assert close(jacobian @ STEP, exponential.body_twist(XI, STEP))
