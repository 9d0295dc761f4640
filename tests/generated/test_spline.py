"""Splines of poses: laws over charts, kinds and boundaries."""

from __future__ import annotations

import copy
import importlib
import pickle
import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import dualcay
from dualcay import PoseSpline, SplineJacobians, cayley1, cayley2, exponential, propagate
from dualcay.rotation import cayley2 as rotations
from tests.support import thorough
from tests.support.errors import close

Function = Callable[[np.ndarray], np.ndarray]

EPS = np.finfo(float).eps
STEP = 1e-3  # of differences: error of order STEP⁴ = 1e-12 times a fifth derivative, rounding 1e-13
DIFFERENCE = 1e-7  # relative bound; fifth derivatives are up to 1e4 times the largest value

NAMES = ("cayley1", "cayley2", "cayley5", "exponential", "lambert", "scaled2", "rotation.cayley1",
         "rotation.exponential")  # fmt: skip
ROWS = [("interpolating", "natural"), ("interpolating", "clamped"), ("interpolating", "periodic"),
        ("bspline", "natural"), ("bspline", "periodic")]  # fmt: skip
TABLE = pytest.mark.parametrize(("name", "row"), thorough.in_turn(NAMES, ROWS))

TWISTS = np.linspace(0, 0.3, 12).reshape(2, 6)

T = np.array([0, 0.7, 1.5, 2.9, 3.4, 4.6, 5.5])  # s; the last time closes a curve


def poses(size: int = 6, seed: int = 1) -> np.ndarray:
    """Return poses up to 40 degrees apart, and some lengths; the last is the first."""
    w = np.random.default_rng(seed).normal(size=(len(T), 6)) * [0.13, 0.13, 0.13, 1, 1, 1]
    w[-1] = w[0]
    return exponential.pose(w) if size == 6 else exponential.pose(w)[:, :3, :3]


def size_of(module: Any) -> int:
    return len(module.identity())


def spline(module: Any, row: tuple[str, str], given: np.ndarray) -> PoseSpline:
    """Return a spline of a kind and a boundary through, or near, given poses."""
    twists = TWISTS[:, : size_of(module)] if row[1] == "clamped" else None
    given = given[:-1] if row == ("bspline", "periodic") else given
    return PoseSpline(module, T, given, kind=row[0], boundary=row[1], twists=twists)


def made(name: str, row: tuple[str, str]) -> tuple[Any, np.ndarray, PoseSpline]:
    """Return the module of a name, poses, and their spline."""
    module = importlib.import_module(f"dualcay.{name}")
    given = poses(size_of(module))
    return module, given, spline(module, row, given)


def blocks_of(J: SplineJacobians) -> tuple[np.ndarray, ...]:
    return J.pose, J.twist, J.acceleration


def derivative(function: Function, t: np.ndarray) -> np.ndarray:
    """Return the derivative by five points."""
    near, far = (function(t + k * STEP) - function(t - k * STEP) for k in (1, 2))
    return (8 * near - far) / (12 * STEP)


def inner(found: PoseSpline) -> np.ndarray:
    """Return times within the spans, away from knots."""
    return (found.knots[:-1, None] + np.diff(found.knots)[:, None] * [0.1, 0.45, 0.8]).ravel()


@TABLE
def test_a_spline_is_smooth_at_its_knots_and_meets_its_conditions(name: str, row: tuple[str, str]) -> None:
    """Allow 1e3 roundings: an acceleration is a sum of some hundred products of factors and twists."""
    module, given, found = made(name, row)
    functions = [found.pose, found.twist, found.acceleration]
    bound = 1e3 * EPS
    for function in functions:
        before = function(np.nextafter(found.knots[1:-1], -1))
        close(function(found.knots[1:-1]), before, bound)
    jerk = [derivative(found.acceleration, found.knots[1:-1] + side * 3 * STEP) for side in (1, -1)]
    assert abs(jerk[0] - jerk[1]).max() > 1e-3  # control: the third derivative jumps
    ends = found.knots[[0, -1]]
    if row[0] == "interpolating":
        close(found.pose(T), given, 1e-13)  # rounding, and Newton's last error squared
    if row[1] == "periodic":
        for function in functions:
            close(*function(ends), bound)
            close(function(ends[1] + inner(found)), function(inner(found)), 10 * bound)
    elif row == ("interpolating", "natural"):
        close(found.acceleration(ends), np.zeros((2, size_of(module))), bound)
    elif row[1] == "clamped":
        close(found.twist(ends), TWISTS[:, : size_of(module)], bound)


@TABLE
def test_twist_acceleration_and_rates_are_derivatives(name: str, row: tuple[str, str]) -> None:
    module, _, found = made(name, row)
    t = inner(found)
    pose, rate = found.pose(t), derivative(found.pose, t)
    body = np.linalg.inv(pose) @ rate
    twist = np.stack([body[:, 2, 1], body[:, 0, 2], body[:, 1, 0]], axis=-1)
    if size_of(module) == 6:
        twist = np.concatenate([twist, body[:, :3, 3]], axis=-1)
    close(found.twist(t, frame="body"), twist, DIFFERENCE)
    for frame in ("space", "body"):
        motion = derivative(lambda t, frame=frame: found.twist(t, frame), t)  # type: ignore[misc]
        close(found.acceleration(t, frame), motion, DIFFERENCE)
    v, v_dot, v_ddot = (found(t, order) for order in range(3))
    close(v_dot, derivative(found, t), DIFFERENCE)
    close(v_ddot, derivative(lambda t: found(t, 1), t), DIFFERENCE)
    close(module.twist(v, v_dot), found.twist(t), 1e3 * EPS)
    close(module.twist_dot(v, v_dot, v_ddot), found.acceleration(t), 1e4 * EPS)


@TABLE
def test_jacobians_are_derivatives_by_the_control_poses(name: str, row: tuple[str, str]) -> None:
    """Move all control poses in one random direction."""
    module, _, found = made(name, row)
    n, t = size_of(module), np.array([0.1, 2.0, 5.3])
    again = {"kind": "bspline", "boundary": "periodic" if row[1] == "periodic" else "natural"}
    np.testing.assert_array_equal(PoseSpline(module, found.knots, found.controls, **again).pose(t), found.pose(t))
    flat, steps = exponential if n == 6 else dualcay.rotation.exponential, np.random.default_rng(4).normal(size=(9, n))
    matrix, vector = (flat.pose, flat.from_pose) if n == 6 else (flat.tensor, flat.from_tensor)

    def moved(s: np.ndarray) -> np.ndarray:
        """Return pose step, body twist and body acceleration."""
        controls = found.controls @ matrix(s * steps[: len(found.controls)])
        curve = PoseSpline(module, found.knots, controls, **again)
        own = vector(np.linalg.inv(found.pose(t)) @ curve.pose(t))
        return np.stack([own, curve.twist(t, "body"), curve.acceleration(t, "body")])

    J = found.jacobians(t)
    for blocks, wanted in zip(blocks_of(J), derivative(moved, np.zeros(1)), strict=True):
        close(np.einsum("tkij,tkj->ti", blocks, steps[J.index]), wanted, DIFFERENCE)


@TABLE
def test_a_change_of_frame_moves_the_whole_curve(name: str, row: tuple[str, str]) -> None:
    if row[1] == "clamped":
        row = ("interpolating", "natural")  # given twists are in the space frame
    module, given, one = made(name, row)
    frame = exponential.pose([0.3, 2, -1, 5, 1, 4])[: len(given[0]), : len(given[0])]
    other, t = spline(module, row, frame @ given), inner(one)
    close(other.pose(t), frame @ one.pose(t), 1e-12)  # offsets of some lengths
    for name in ("twist", "acceleration"):
        close(getattr(other, name)(t, "body"), getattr(one, name)(t, "body"), 1e-11)


@pytest.mark.parametrize("row", ROWS)
def test_rotations_are_those_of_the_poses(row: tuple[str, str]) -> None:
    whole, real = spline(cayley2, row, poses()), spline(rotations, row, poses(3))
    t = inner(real)
    close(real.pose(t), whole.pose(t)[:, :3, :3], 1e-12)
    for name in ("twist", "acceleration"):
        close(getattr(real, name)(t), getattr(whole, name)(t)[:, :3], 1e-11)


def test_charts_of_many_turns_take_steps_beyond_half_a_turn() -> None:
    """Alternate by 1.6 rad: control poses are up to three times as far apart, and steps keep their branch."""
    w = np.zeros((9, 6))
    w[1::2, :3] = np.random.default_rng(5).normal(size=(4, 3)) * 0.9
    found = PoseSpline(exponential, np.arange(9.0), w)
    close(found.pose(np.arange(9)), exponential.pose(w), 1e-13)


@pytest.mark.parametrize("name", NAMES)
def test_a_fit_recovers_a_spline_and_is_the_least(name: str) -> None:
    (module, _, true), rng = made(name, ROWS[0]), np.random.default_rng(2)
    t = np.sort(np.append(inner(true), T))
    samples = true.pose(t)
    found = PoseSpline.fit(module, t, samples, true.knots)
    close(found.controls, true.controls, 1e-11)  # rounding times the condition, 1e4
    weights = np.ones(len(t))
    weights[4] = 0  # an outlier that must not count
    samples[4] = samples[9]
    found = PoseSpline.fit(module, t, samples, true.knots, weights)
    close(found.controls, true.controls, 1e-11)
    noisy = module.body_retract(true(t), 0.02 * rng.normal(size=(len(t), size_of(module))))
    weights = rng.uniform(1, 5, (len(t), size_of(module)))
    found = PoseSpline.fit(module, t, noisy, true.knots, weights)
    scale = module.body_tangent(module.identity()).flat[0]

    def cost(controls: np.ndarray) -> float:
        curve = PoseSpline(module, true.knots, controls, kind="bspline")
        apart = module.compose(module.inverse(noisy), curve(t))
        return float(np.sum(weights * (scale * apart) ** 2))

    steps = [module.from_exponential(1e-3 * rng.normal(size=(len(found.controls), size_of(module)))) for _ in range(9)]
    matrix = module.pose if size_of(module) == 6 else module.tensor
    assert min(cost(found.controls @ matrix(step)) for step in steps) > cost(found.controls)


def test_shapes_axes_copies_and_a_motion() -> None:
    found = PoseSpline(cayley2, T, exponential.from_pose(poses()).T, axis=1)  # read as vectors of cayley2
    assert found.twist(np.full((2, 3), 1.0)).shape == (2, 3, 6)
    assert found.jacobians(1.0).pose.shape == (4, 6, 6)
    assert found(np.empty((0, 2))).shape == (0, 2, 6)
    for again in (copy.deepcopy(found), pickle.loads(pickle.dumps(found))):
        np.testing.assert_array_equal(again.acceleration(1.1), found.acceleration(1.1))
    motion = propagate(cayley2, np.zeros(6), [0, 0, 1.0, 0.1, 0, 0], np.arange(9.0))
    through = PoseSpline(cayley2, motion.t, motion.v)  # v changes its branch on the way
    assert motion.switches.size
    close(through.pose(motion.t), motion.pose, 1e-13)


def turn(*angles: float) -> np.ndarray:
    return np.outer(angles, np.eye(6)[2])


GOOD = turn(0, 1, 2, 1)
BAD: list[tuple[dict[str, Any], type[Exception], str]] = [
    ({"module": np}, TypeError, "module must be a kernel module"),
    ({"kind": "linear"}, ValueError, "kind must be one of 'interpolating', 'bspline', got 'linear'"),
    ({"boundary": "free"}, ValueError, "boundary must be one of 'natural', 'clamped', 'periodic', got 'free'"),
    ({"t": [0, 1, 1, 2]}, ValueError, "t must increase, got 1 after 1 in row 2"),
    ({"t": [0, 2, 1, 3]}, ValueError, "t must increase, got 1 after 2 in row 2"),
    ({"t": [0, 1, np.nan, 3]}, ValueError, "t must be finite, got nan in row 2"),
    ({"t": [0, 1]}, ValueError, "t must have one time for each pose, got 2 times and 4 poses"),
    ({"poses_or_v": np.zeros((4, 3))}, ValueError, r"poses must have shape \(T, 4, 4\), or \(T, 6\) .*, got \(4, 3\)"),
    ({"poses_or_v": [*turn(0, 1), [np.inf] * 6, [0] * 6]}, ValueError, "poses must be finite, got inf in row 2"),
    ({"poses_or_v": turn(0, 1, 4.5, 5)}, ValueError, "poses must be at most half a turn apart: .* row 2"),
    ({"poses_or_v": turn(0, 1, 9, 5)}, ValueError, "poses must be at most half a turn apart: .* row 2"),
    ({"module": cayley1, "poses_or_v": exponential.pose(turn(0, 1, 1 + np.pi, 3))}, ValueError, "half a turn .* row 2"),
    ({"boundary": "periodic"}, ValueError, "the last pose of a closed curve must be the first, got another in row 3"),
    ({"twists": np.zeros((2, 6))}, ValueError, "twists belong to the boundary 'clamped'"),
    ({"boundary": "clamped", "twists": np.zeros(6)}, ValueError, r"twists must have shape \(2, 6\), got \(6,\)"),
    ({"kind": "bspline", "boundary": "clamped"}, ValueError, "the kind 'bspline' has no boundary 'clamped'"),
    ({"kind": "bspline", "t": np.arange(7)}, ValueError, "t must have N, N - 2 or N . 4 knots .*, got 7 for 4"),
]  # fmt: skip


@pytest.mark.parametrize(("given", "kind", "message"), BAD, ids=lambda one: one if isinstance(one, str) else "")
def test_wrong_arguments_are_named_with_their_row(given: dict[str, Any], kind: type[Exception], message: str) -> None:
    arguments: dict[str, Any] = {"module": exponential, "t": [0, 1, 2, 3], "poses_or_v": GOOD, **given}
    with pytest.raises(kind, match=message):
        PoseSpline(**arguments)


def test_steps_near_half_a_turn_warn_and_others_do_not() -> None:
    with pytest.warns(RuntimeWarning, match="row 2 is 3.1 rad from the row before: near half a turn"):
        PoseSpline(exponential, T[:4], turn(0, 1, 4.1, 4.5))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        PoseSpline(exponential, T[:4], turn(0, 2.9, -2.9, 0))  # the shorter way back over half a turn


FIT, SWING = PoseSpline.fit, exponential.pose(turn(0, 2.9, 0, 2.9, 0, 2.9))
LATER: list[tuple[Callable[[PoseSpline], Any], type[Exception], str]] = [
    (lambda found: found.twist(9.0), ValueError, r"t must be in \[0, 2.9\], got 9"),
    (lambda found: found.twist(1.0, "world"), ValueError, "frame must be one of"),
    (lambda found: found(1.0, 3), ValueError, "order must be 0, 1 or 2"),
    (lambda _: FIT(exponential, np.arange(5), turn(0, 1, 2, 1, 0), [0, 0.5, 1, 1.5, 2, 4]), ValueError,
     "fit needs more poses between t = 0 and 1, or fewer knots"),
    (lambda _: FIT(exponential, np.arange(4), GOOD, [0, 3], [1, -1, 1, 1]), ValueError, "negative, got -1 in row 1"),
    (lambda _: FIT(exponential, np.arange(4), GOOD, [0, 2]), ValueError, r"the knots \[0, 2\], got row 3 outside"),
    (lambda _: PoseSpline(cayley1, np.arange(6.0), SWING), ArithmeticError, "control poses would be too far apart"),
]  # fmt: skip


@pytest.mark.parametrize(("call", "kind", "message"), LATER, ids=lambda one: one if isinstance(one, str) else "")
def test_calls_and_fits_refuse_what_they_cannot_do(call: Any, kind: type[Exception], message: str) -> None:
    with pytest.raises(kind, match=message):
        call(PoseSpline(exponential, T[:4], GOOD))
