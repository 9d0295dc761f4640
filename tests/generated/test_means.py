"""Means of poses and first-order covariances: laws over charts. Draws are in tests/docs/test_covariances.py."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from types import ModuleType

import numpy as np
import pytest

import dualcay
from dualcay import between_covariance, compose_covariance, inverse_covariance, mean, transform_point_covariance
from dualcay import exponential as exp

NAMES = ("cayley1", "cayley2", "cayley5", "exponential", "lambert", "sine4", "scaled3", "wiener_milenkovic")
EPS = np.finfo(float).eps
N = 9


def charts(table: str = "") -> list[ModuleType]:
    return [importlib.import_module(".".join(filter(None, ("dualcay", table, name)))) for name in NAMES]


def clouds() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return exponential coordinates of clouds (7, N, 6), up to 0.49 π about their middle, weights, and lengths."""
    rng, lengths = np.random.default_rng(1), np.array([1, 1, 1, 1, 1e-3, 1e3, 1e6])[:, None]
    spread = np.array([1e-9, 1e-3, 0.3, 0.49 * np.pi, 1, 1, 1])[:, None, None]
    turns = rng.normal(size=(7, N, 3))
    turns *= spread / np.linalg.norm(turns, axis=-1).max(axis=-1)[:, None, None]
    steps = np.concatenate([turns, lengths[..., None] * rng.normal(size=(7, N, 3))], axis=-1)
    middle = exp.random((7, 1), max_angle=1.2, rng=2)
    return exp.body_retract(middle, steps), rng.uniform(0.2, 1, (7, N)), lengths


X, W, LENGTHS = clouds()
BOUND = 16 * EPS
"""Rounding of a mean, relative to its cloud: 12 of a step, over the least slope (α/2) cot(α/2), 0.77 at α = 0.49 π."""


def apart(a: np.ndarray, b: np.ndarray) -> float:
    """Return the largest difference of matrices, of positions relative to the length of their cloud."""
    return float((abs(exp.pose(a) - exp.pose(b)).max(axis=(-1, -2)) / (1 + LENGTHS[:, 0])).max())


def test_steps_from_the_mean_cancel_and_the_pose_is_that_of_every_chart() -> None:
    truth = mean(exp, X, W)
    rest = np.einsum("bk,bki->bi", W / W.sum(axis=1, keepdims=True), exp.body_local(X, truth[:, None]))
    assert (abs(rest) <= BOUND * (1 + LENGTHS)).all()
    for module in charts()[::4]:
        v = dualcay.convert(X, exp, module)
        m = mean(module, v, W)
        assert apart(dualcay.convert(m, module, exp), truth) < BOUND
        np.testing.assert_array_equal(m, module.principal(m))
        if module.CHART.branches != 1:
            assert apart(dualcay.convert(mean(module, module.shadow(v), W), module, exp), truth) < 8 * BOUND
    for table in charts("rotation")[::4]:  # rotations are the real part
        real = mean(table, table.from_exponential(X[..., :3]), W)
        np.testing.assert_allclose(table.to_exponential(real), truth[:, :3], rtol=0, atol=BOUND)


def test_rotations_up_to_a_quarter_turn_about_any_middle_have_their_mean_there() -> None:
    """Weights differ by up to 1e10, so that means are far from the middle, and some middles are half turns."""
    rng, half = np.random.default_rng(5), dualcay.rotation.exponential
    turns, weights = rng.normal(size=(500, 4, 3)), rng.uniform(0.1, 1, (500, 4)) ** 10
    turns *= 0.498 * np.pi / np.linalg.norm(turns, axis=-1, keepdims=True)
    middle = half.random((500, 1), max_angle=np.pi, rng=6)
    v = half.principal(half.body_retract(middle, turns))
    m = mean(half, v, weights)
    rest = np.einsum("bk,bki->bi", weights / weights.sum(axis=1, keepdims=True), half.body_local(v, m[:, None]))
    assert abs(rest).max() <= BOUND
    assert half.angle(half.between(m, middle[:, 0])).max() < np.pi / 2
    beyond = np.outer(np.pi + np.array([-0.5, -0.5, 1.003]), np.eye(3)[0])  # their sum is below half a turn
    np.testing.assert_allclose(mean(half, beyond), (0.001 - np.pi) * np.eye(3)[0], rtol=0, atol=BOUND)


def test_the_mean_moves_with_its_poses_from_either_side() -> None:
    g, h = exp.random((2, 7, 1), max_angle=0.8, rng=3)
    m = mean(exp, X, W)
    for moved, wanted in (
        (exp.compose(g, X), exp.compose(g[:, 0], m)), (exp.compose(X, h), exp.compose(m, h[:, 0])),
        (exp.inverse(X), exp.inverse(m)),
    ):  # fmt: skip
        assert apart(mean(exp, moved, W), wanted) < 4 * BOUND


def test_weights_repeat_poses_and_leave_them_out() -> None:
    counts = np.arange(N) % 4
    repeated, weighted = (mean(exp, v, w, covariance=True) for v, w in ((X.repeat(counts, axis=1), None), (X, counts)))
    assert apart(repeated[0], weighted[0]) < 2 * BOUND
    size = abs(weighted[1]).max(axis=(-1, -2), keepdims=True)
    assert (abs(repeated[1] - weighted[1]) <= BOUND * size + BOUND * (1 + LENGTHS[..., None]) * np.sqrt(size)).all()
    holes = np.where(counts[:, None] > 0, X, np.nan)
    np.testing.assert_array_equal(mean(exp, holes, counts), weighted[0])
    assert apart(mean(exp, X, counts / 3 * 1e308), weighted[0]) < BOUND
    np.testing.assert_allclose(mean(exp, X[:, :1], covariance=True)[1], 0, atol=1e-9)  # one pose, to (1e6 · 32 eps)²


@pytest.mark.parametrize("table", ["", "rotation"])
def test_covariances_of_the_frames_belong_together_and_to_the_steps(table: str) -> None:
    for module in charts(table):
        v = dualcay.convert(X[2], exp, getattr(dualcay, module.__name__.split(".")[-1]))[:, : len(module.identity())]
        m, body = mean(module, v, W[2], covariance=True)
        steps = module.body_local(v, m)
        np.testing.assert_allclose(body, np.cov(steps.T, ddof=0, aweights=W[2]), rtol=1e-12, atol=1e-13)
        A, T = module.adjoint(m), module.body_tangent(m)
        T = dualcay.matrix6(T) if len(A) == 6 else T
        np.testing.assert_allclose(mean(module, v, W[2], covariance=True, frame="space")[1], A @ body @ A.T, atol=1e-13)
        chart = mean(module, v, W[2], covariance=True, frame="chart")[1]
        np.testing.assert_allclose(T @ chart @ T.T, body, rtol=0, atol=1e-12)


Change = Callable[[ModuleType, np.ndarray, np.ndarray], np.ndarray]
STEP: dict[str, tuple[Change, Change]] = {
    "body": (lambda m, v, d: m.body_retract(v, d), lambda m, w, v: m.body_local(w, v)),
    "space": (lambda m, v, d: m.retract(v, d), lambda m, w, v: m.local(w, v)),
    "chart": (lambda m, v, d: v + d, lambda m, w, v: w - v),
}
FUNCTIONS = {
    "compose": compose_covariance, "between": between_covariance, "inverse": inverse_covariance,
    "transform_point": transform_point_covariance,
}  # fmt: skip


def by_differences(module: ModuleType, name: str, frame: str, given: list[np.ndarray]) -> np.ndarray:
    """Return the derivative of a function by steps of its arguments; its error is near 1e-10."""
    function, h, columns = getattr(module, name), 1e-5, []
    for place, argument in enumerate(given):
        moved = STEP["chart" if name == "transform_point" and place else frame][0]
        for d in h * np.eye(len(argument)):
            ends = [function(*given[:place], moved(module, argument, step), *given[place + 1 :]) for step in (d, -d)]
            columns.append(STEP["chart" if name == "transform_point" else frame][1](module, *ends) / (2 * h))
    return np.stack(columns, axis=-1)


@pytest.mark.parametrize("table", ["", "rotation"])
@pytest.mark.parametrize("frame", STEP)
@pytest.mark.parametrize("name", FUNCTIONS)
def test_covariances_are_those_of_differences(name: str, frame: str, table: str) -> None:
    rng = np.random.default_rng(6)
    for module in charts(table):
        n = len(module.identity())
        v, w = module.random((2, 3), max_angle=1.0, rng=rng)
        w = rng.normal(size=(3, 3)) if name == "transform_point" else w
        given = [v] if name == "inverse" else [v, w[:1]]  # one w for three v
        root = rng.normal(size=(size := sum(a.shape[-1] for a in given), size))
        P = root @ root.T
        spreads = [P[:n, :n], P[n:, n:], P[:n, n:]][: 2 * len(given) - 1]
        found = FUNCTIONS[name](module, *given, *spreads, frame=frame)
        np.testing.assert_array_equal(found, found.mT)
        for i, one in enumerate(v):
            J = by_differences(module, name, frame, [one, w[0]][: len(given)])
            np.testing.assert_allclose(found[i], J @ P @ J.T, rtol=0, atol=1e-8 * abs(found[i]).max())


def test_arguments_that_have_no_mean_or_no_covariance_are_refused() -> None:
    module, turn = dualcay.rotation.cayley2, np.eye(3)[0] * np.tan(np.array([0, 0.6, 1.2, 1.8])[:, None] * np.pi / 4)
    three = np.concatenate([turn[:2], -turn[1:2]])  # at 0 and ±0.6 π: the middle is the first
    assert np.allclose(mean(module, turn[[0, 1]]), [np.tan(0.3 * np.pi / 4), 0, 0])
    batch = np.stack([np.zeros((3, 3)), three])
    for error, text, arguments in (
        (ValueError, r"v\[[12]\] is too far from the others", (three,)),
        (ValueError, r"v\[1, [12]\] is too far", (batch,)),
        (ValueError, "is too far", (np.diag([1, 0, 0])[:2],)),  # half a turn apart
        (ValueError, r"v\[1\] must be finite", (turn * [[1], [np.nan], [1], [1]],)),
        (ValueError, r"v must have shape \(..., N, 3\) with at least one pose, got \(3,\)", (turn[0],)),
        (ValueError, r"v must have shape .*, got \(0, 3\)", (turn[:0],)),
        (ValueError, r"weights must have shape \(..., 4\), got \(3,\)", (turn, np.ones(3))),
        (ValueError, "weights must be finite, at least 0", (turn, [1, 1, -1, 1])),
        (ValueError, "not all 0", (turn, np.zeros(4))), (TypeError, "v must be real", (turn * 1j,)),
    ):  # fmt: skip
        with pytest.raises(error, match=text):
            mean(module, *arguments)
    with pytest.raises(ValueError, match="frame must be one of 'body', 'space', 'chart', got 'world'"):
        mean(module, turn, frame="world")
    with pytest.raises(ValueError, match="covariance1 must be symmetric"):
        compose_covariance(module, turn[0], turn[0], np.eye(3), np.tri(3))


@pytest.mark.parametrize("dtype", [np.float32, np.longdouble])
def test_results_have_the_precision_of_the_data(dtype: type) -> None:
    v = X[2].astype(dtype)
    m, P = mean(exp, v, covariance=True)
    assert m.dtype == P.dtype == compose_covariance(exp, m, m, P, P).dtype == dtype
    assert (abs(exp.body_local(v, m).mean(axis=0)) < 64 * np.finfo(dtype).eps).all()
