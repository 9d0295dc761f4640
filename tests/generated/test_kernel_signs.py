"""Rules of choice at half turns, for signs, and for branches."""

from __future__ import annotations

from types import ModuleType

import numpy as np
import pytest

from tests.support.kernels import LAWS, load

pytestmark = pytest.mark.smoke

EPS = float(np.finfo(float).eps)
AXES = [
    [1.0, 0, 0], [-1.0, 0, 0], [0, 1.0, 0], [0, -1.0, 0], [0, 0, 1.0], [0, 0, -1.0],
    [0.6, 0.8, 0], [-0.6, 0.8, 0], [0, -0.6, 0.8], [0.6, 0, -0.8], [-1 / 3, 2 / 3, -2 / 3],
]  # fmt: skip
AXIS = pytest.mark.parametrize("axis", AXES, ids=str)
FINITE = pytest.mark.parametrize("order", [n for n in LAWS if n > 1])  # n = 1 has no vector at π


def half_turn(axis: np.ndarray, shift: float, moment: np.ndarray) -> np.ndarray:
    """Return the dual quaternion of the angle π + ε shift about a line; its real scalar is exactly 0."""
    return np.concatenate([[0.0], axis, [-shift / 2], moment])


def expected(order: int, axis: np.ndarray, shift: float, moment: np.ndarray, branch: int = 0) -> np.ndarray:
    tangent = np.tan((np.pi + 2 * np.pi * branch) / (2 * order))
    slope = (1 + tangent**2) * shift / (2 * order)
    return np.concatenate([tangent * axis, slope * axis + tangent * moment])


def branches(order: int) -> list[int]:
    return [k for k in range(order) if 2 * k + 1 != order]


@FINITE
@AXIS
@pytest.mark.parametrize("zero", [0.0, -0.0])
def test_half_turn_keeps_the_given_vector_part(order: int, axis: list[float], zero: float) -> None:
    kernel, u = load(order), np.array(axis)
    m = np.cross([1.0, -2.0, 0.5], u)
    q = half_turn(u, 0.7, m)
    q[0] = zero
    for branch in branches(order):
        wanted = expected(order, u, 0.7, m, branch)
        for got in (kernel.from_quaternion(q, branch), kernel.from_quaternion(np.stack([q, q]), branch)[1]):
            np.testing.assert_allclose(got, wanted, rtol=1e-13, atol=1e-13 * abs(wanted).max())


@FINITE
@AXIS
def test_at_pi_matrices_give_the_axis_with_first_component_positive(order: int, axis: list[float]) -> None:
    """Use 2 u uᵀ − I, which is symmetric to the last bit: its quaternion has a scalar part of exactly 0."""
    kernel, u = load(order), np.array(axis)
    leading = u[np.flatnonzero(u)[0]]
    side = np.sign(leading) * u
    turn = 2 * np.outer(u, u) - np.eye(3)
    matrix = np.eye(4)
    matrix[:3, :3] = turn
    dual = np.stack([turn, np.zeros((3, 3))])
    for branch in branches(order):
        wanted = expected(order, side, 0.0, np.zeros(3), branch)
        for function, given in ((kernel.from_pose, matrix), (kernel.from_tensor, dual)):
            for got in (function(given, branch), function(given[None], branch)[0]):
                np.testing.assert_allclose(got, wanted, rtol=1e-13, atol=1e-14)


@pytest.mark.parametrize("shape", [(6,), (4, 6)])
def test_the_identity_has_no_other_branches(kernel: ModuleType, order: int, shape: tuple[int, ...]) -> None:
    zero = np.zeros(shape)
    forms = [
        lambda k: kernel.from_quaternion(kernel.quaternion(zero), k),
        lambda k: kernel.from_quaternion(-kernel.quaternion(zero), k),
        lambda k: kernel.from_tensor(kernel.tensor(zero), k),
        lambda k: kernel.from_pose(kernel.pose(zero), k),
        lambda k: kernel.shadow(zero, k),
    ]
    for form in forms:
        for k in (0, order, -order):
            np.testing.assert_array_equal(form(k), zero)
        for k in range(1, order):
            assert np.isnan(form(k)).all()
    np.testing.assert_array_equal(kernel.principal(zero), zero)
    np.testing.assert_array_equal(kernel.compose(zero, zero), zero)


@pytest.mark.parametrize("size", [1e-100, 1e-155, 1e-162, 1e-200, 1e-300])
def test_tiny_scalar_part_gives_half_a_turn(kernel: ModuleType, order: int, size: float) -> None:
    """Expect the side of the given vector part, whatever the sign of the scalar part; at n = 1 they are poles."""
    u = np.array([2.0, -1, 2]) / 3
    for sign in (1, -1):
        q = np.array([sign * size, *u, 0, 0, 0, 0])
        length = sign / size if order == 1 else np.tan(np.pi / (2 * order))
        np.testing.assert_allclose(kernel.from_quaternion(q)[:3], length * u, rtol=8 * EPS)
