"""The example of the arm: kinematics by screws, convergence, and the hand–eye problem with known truth."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from scipy.linalg import expm

from examples import arm
from examples.arm import chart

JOINTS = np.array([0.2, -1.2, 1.5, -0.5, 0.8, 0.3])
RNG = np.random.default_rng(1)


def test_published_pose():
    """Compare with the pose that Modern Robotics, example 4.5, prints to a millimetre."""
    printed = [[0, -1, 0, 0.095], [1, 0, 0, 0.109], [0, 0, 1, 0.988], [0, 0, 0, 1]]
    found = chart.pose(arm.tool(np.array([0, -1, 0, 0, 1, 0]) * np.pi / 2))
    assert np.abs(found - printed).max() < 5.001e-4


def test_forward_kinematics_by_matrix_exponentials():
    pose = np.eye(4)
    for angle, screw in zip(JOINTS, arm.SCREWS, strict=True):
        twist = np.zeros((4, 4))
        twist[:3, :3], twist[:3, 3] = np.cross(np.eye(3), screw[:3]), screw[3:]
        pose = pose @ expm(angle * twist)
    # six products and exponentials of size 1
    assert np.abs(pose @ chart.pose(arm.HOME) - chart.pose(arm.tool(JOINTS))).max() < 1e-14


def test_jacobian_is_the_derivative():
    direction, small = RNG.normal(size=6), 1e-6
    moved = chart.local(arm.tool(JOINTS + small * direction), arm.tool(JOINTS - small * direction)) / (2 * small)
    # central differences: the square of the step, and rounding over the step
    assert np.abs(arm.jacobian(JOINTS) @ direction - moved).max() < 1e-9
    assert np.abs(arm.jacobian(JOINTS)[:, ::-1] @ direction - moved).max() > 0.1


def test_batches():
    batch = RNG.uniform(-2, 2, (3, 4, 6))
    assert np.allclose(arm.tool(batch)[1, 2], arm.tool(batch[1, 2]), rtol=0, atol=1e-14)
    assert np.array_equal(arm.jacobian(batch).shape, (3, 4, 6, 6))


def test_inverse_kinematics_converges_quadratically():
    near = JOINTS + RNG.uniform(-0.1, 0.1, 6)
    found, errors = arm.inverse_kinematics(arm.tool(JOINTS), near)
    # joint angles err by the tolerance times the inverse of the Jacobian, which is below 100 here
    assert np.abs(found - JOINTS).max() < 1e-10
    assert all(after < 100 * before**2 + arm.TOLERANCE for before, after in pairwise(errors))


def test_a_pose_out_of_reach_is_an_error():
    with pytest.raises(ArithmeticError, match="no joint angles found"):
        arm.inverse_kinematics(chart.retract(arm.tool(JOINTS), [0, 0, 0, 3, 0, 0]), JOINTS)


def test_hand_eye():
    truth = np.array([0.5, -1, 0.3, 0.1, 0, 0.2])
    A = chart.random(20, rng=RNG, max_angle=2.0)
    B = chart.compose(chart.inverse(truth), chart.compose(A, truth))
    X, slope, _ = arm.hand_eye(A, B)
    assert np.abs(chart.local(X, truth)).max() < 1e-12
    # errors of 50 noisy solutions, each six components, over their variance: mean 6, deviation √(12/50)
    noisy = chart.retract(A, 1e-4 * RNG.normal(size=(50, *A.shape)))
    errors = [chart.local(arm.hand_eye(one, B)[0], truth) / 1e-4 for one in noisy]
    normalized = np.mean([error @ slope.T @ slope @ error for error in errors])
    assert abs(normalized - 6) < 4 * np.sqrt(12 / 50)
