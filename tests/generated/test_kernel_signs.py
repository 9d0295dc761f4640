"""Rules of choice at half turns, for signs, and for branches."""

from __future__ import annotations

from types import ModuleType

import numpy as np
import pytest

from tests.support.kernels import LAWS, load
from tests.support.oracle import oracle_of

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


# Vectors at exact multiples of 2π: |v|² = 3 for n = 3, |v|² = 1 for n = 4 and 8.
AT_FULL_TURNS = [
    (3, [1.0, 1.0, 1.0]), (3, [1.0, -1.0, 1.0]), (4, [0.0, 1.0, 0.0]), (4, [0.0, 0.0, -1.0]),
    (8, [-1.0, 0.0, 0.0]), (8, [0.0, 1.0, 0.0]),
]  # fmt: skip


@pytest.mark.parametrize(("order", "real"), AT_FULL_TURNS)
@pytest.mark.parametrize("dual", [[1.0, 2.0, -0.5], [-1.0, -2.0, 0.5], [0.3, -0.4, 0.2]])
def test_full_turns_are_translations_along_the_axis(order: int, real: list[float], dual: list[float]) -> None:
    """Expect ρ = 2n/(1 + x) (u·v°) u for any component of v° across u: T has rank one."""
    kernel = load(order)
    v = np.array([*real, *dual])
    x = v[:3] @ v[:3]
    rho = 2 * order / (1 + x) * (v[:3] @ v[3:]) / x * v[:3]
    size = np.linalg.norm(rho)
    for given, pick in ((v, lambda a: a), (np.stack([v, -v]), lambda a: a[0])):
        np.testing.assert_allclose(pick(kernel.pose(given))[:3, 3], rho, atol=1e-14)
        angle, line = kernel.to_screw(given)
        np.testing.assert_allclose(pick(angle), [0, size], atol=1e-14)
        np.testing.assert_allclose(pick(line)[:3], rho / size, atol=1e-14)
        principal = pick(kernel.principal(given))
        np.testing.assert_allclose(principal, [0, 0, 0, *(rho / (2 * order))], atol=1e-14)
        for k in range(order):
            shadow = pick(kernel.shadow(given, k))
            if np.linalg.norm(shadow[:3]) < 1e3:
                np.testing.assert_allclose(kernel.pose(shadow), kernel.pose(v), atol=1e-12)
                # Branches count turns in the direction of the translation.
                wanted = oracle_of(order).shadow(v, k).astype(float)
                np.testing.assert_allclose(shadow, wanted, rtol=1e-13, atol=1e-13)


@pytest.mark.parametrize("batch", [False, True])
@pytest.mark.parametrize("size", [1e-100, 1e-155, 1e-162, 1e-200, 1e-300])
def test_lengths_do_not_underflow(kernel: ModuleType, order: int, size: float, batch: bool) -> None:
    """Expect correct axis, angle and shadows for vectors with underflow in v·v, with and without rotation."""
    re, du = np.array([2.0, -1, 2]) / 3, np.array([2.0, 2, -1])
    u = np.concatenate([re, du / 3])
    for v, expected, rotation in (
        (size * np.concatenate([re, du / 3]), u, size),
        (size * np.concatenate([np.zeros(3), re]), np.concatenate([re, np.zeros(3)]), 0.0),
    ):
        given = np.stack([v] * 30) if batch else v
        angle, axis = kernel.to_screw(given)
        np.testing.assert_allclose(np.atleast_2d(axis)[0], expected, atol=8 * EPS)
        # zeros must be exact; a tiny pitch would come from rounding
        wanted = [2 * order * rotation, 0.0 if rotation else 2 * order * size]
        np.testing.assert_allclose(np.atleast_2d(angle)[0], wanted, rtol=8 * EPS, atol=8 * EPS * size)
        for k in range(1, order):
            if 2 * k != order:
                tangent = np.tan(np.pi * k / order)
                shadow = np.atleast_2d(kernel.shadow(given, k))[0]
                np.testing.assert_allclose(shadow[:3], tangent * re, rtol=1e-13)
        back = kernel.from_quaternion(kernel.quaternion(given), check=True)
        np.testing.assert_allclose(back, given, rtol=8 * EPS, atol=0 if size > 1e-290 else 1e-320)


@pytest.mark.parametrize("size", [1e-100, 1e-155, 1e-162, 1e-200, 1e-300])
def test_tiny_scalar_part_gives_half_a_turn(kernel: ModuleType, order: int, size: float) -> None:
    """Expect the side of the given vector part, whatever the sign of the scalar part; at n = 1 they are poles."""
    u = np.array([2.0, -1, 2]) / 3
    for sign in (1, -1):
        q = np.array([sign * size, *u, 0, 0, 0, 0])
        length = sign / size if order == 1 else np.tan(np.pi / (2 * order))
        np.testing.assert_allclose(kernel.from_quaternion(q)[:3], length * u, rtol=8 * EPS)
