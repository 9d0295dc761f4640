"""Law of whole turns: a vector beside a whole turn has the pose to the condition of its own, or is not finite.

Exact vectors follow from the formula of a screw in 60 digits. The pose of an exact vector changes by κ per relative
change of its components; results of functions may be off by a few κ eps. Rounding moves a pose of norm 1 by eps too.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from functools import cache
from typing import Any

import mpmath
import numpy as np
import pytest

import dualcay
from derive import about
from tests.support import families, thorough
from tests.support.subjects import Subject, subject

DISTANCES = (1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-15, 1e-16, 0.0)
SCREWS = np.array([[0.6, 0, 0.8, 0.28, 0.2, 0.165], [0, 0, 1, 0, 0, 0.5], [2 / 7, -3 / 7, 6 / 7, 1, 2, 0.5]])
"""Axes with a pitch and a moment, in exponential coordinates of one radian."""

GATE = 64
"""Allowed error in eps of the condition: `families.GATE` for each of two steps, at angles up to 8 rad."""

LEFT = np.pi / 8


def turns_of(chart: Subject) -> range:
    """Return the numbers of whole turns that a chart reaches, up to 3; its edge counts if v is infinite there."""
    last = min(3, int(chart.edge / (2 * np.pi) + 0.01)) if chart.edge < np.inf else 3
    folded = chart.ends and abs(chart.edge - 2 * np.pi * last) < 0.1
    return range(1, last + 1 - folded)


NAMES = (*(f"cayley{n}" for n in about.ORDERS), *about.FAMILIES)
CHARTS = tuple(name for name in NAMES if turns_of(subject(name)))


def pose_of(screw: np.ndarray, angle: Any) -> np.ndarray:
    """Return the pose of exponential coordinates of one radian, at another angle, in 60 digits."""
    return _pose_of(tuple(screw.tolist()), float(angle))


@cache
def _pose_of(screw: tuple[float, ...], angle: float) -> np.ndarray:
    with mpmath.workdps(families.DIGITS):
        w, vo = ([mpmath.mpf(c) for c in part] for part in (screw[:3], screw[3:]))
        size = mpmath.sqrt(sum(c * c for c in w))
        K = mpmath.matrix([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]]) / size
        alpha = mpmath.mpf(angle) * size
        sine, versine = mpmath.sin(alpha), 1 - mpmath.cos(alpha)
        Q = mpmath.eye(3) + sine * K + versine * K**2
        T = mpmath.eye(3) * alpha + versine * K + (alpha - sine) * K**2
        rho = T * mpmath.matrix(vo) / size
        return np.array([[*(Q[i, j] for j in range(3)), rho[i]] for i in range(3)], float)


def turned(chart: Subject, screw: np.ndarray, angle: float, dtype: Any = float) -> np.ndarray:
    return np.asarray(chart.module.from_exponential((screw * angle).astype(dtype)))


def retract(chart: Subject, screw: np.ndarray, end: float, dtype: Any) -> np.ndarray:
    return chart.module.retract(turned(chart, screw, end - LEFT, dtype), (screw * LEFT).astype(dtype))


def body_retract(chart: Subject, screw: np.ndarray, end: float, dtype: Any) -> np.ndarray:
    return chart.module.body_retract(turned(chart, screw, end + LEFT, dtype), (screw * -LEFT).astype(dtype))


def interpolate(chart: Subject, screw: np.ndarray, end: float, dtype: Any) -> np.ndarray:
    first, second = (turned(chart, screw, end - share * LEFT, dtype) for share in (2, 1))
    return chart.module.interpolate(first, second, dtype(2))


def from_rest(chart: Subject, screw: np.ndarray, end: float, dtype: Any) -> np.ndarray:
    half = turned(chart, screw, end / 2, dtype)
    return chart.module.interpolate(0 * half, half, dtype(2))


def convert(chart: Subject, screw: np.ndarray, end: float, dtype: Any) -> np.ndarray:
    source = next(c for c in (subject("cayley2"), subject("cayley4"), subject("cayley8")) if c.edge > end - 0.1)
    return dualcay.convert(turned(source, screw, end, dtype), source.module, chart.module)


FUNCTIONS = (retract, body_retract, interpolate, from_rest, convert)


def wrong(chart: Subject, found: np.ndarray, exact: np.ndarray, end: float, screw: np.ndarray) -> float:
    """Return the error of a vector's pose over the allowed one; 0 for a vector that is not finite."""
    pose = chart.module.pose(found)
    if not (np.isfinite(found).all() and np.isfinite(pose).all()):
        return 0.0
    length = np.linalg.norm(screw[3:])
    allowed = GATE * np.finfo(found.dtype).eps * max(1.0, end * length) * max(1.0, end / np.pi)
    return float(abs(pose[..., :3, :] - exact).max() / allowed)


def cases(chart: Subject, dtype: Any, count: int = len(FUNCTIONS)) -> Iterator[tuple[float, str]]:
    """Yield the share of the allowed error, and the case, of the first functions beside every whole turn."""
    for k, e, side, screw in itertools.product(turns_of(chart), DISTANCES, (1, -1), SCREWS):
        end = 2 * np.pi * k - side * e
        for function in FUNCTIONS[: count if k == 1 else 3]:
            found = function(chart, screw, end, dtype)
            yield wrong(chart, found, pose_of(screw, end), end, screw), f"{function.__name__}, {k} turns, {side * e}"


@pytest.mark.parametrize("name", thorough.sampled(CHARTS, CHARTS[::3]))
def test_vectors_beside_whole_turns_have_the_pose_or_are_not_finite(name: str) -> None:
    worst = max(cases(subject(name), np.float64))
    assert worst[0] <= 1, worst


POLES = {
    k: [name for name in CHARTS if k in turns_of(subject(name)) and abs(subject(name).edge - 2 * np.pi * k) < 0.1]
    for k in (1, 2)
}
"""Charts whose vectors are infinite at k whole turns: these hold every pose beside the turn to all digits."""


@pytest.mark.parametrize(("dtype", "distances"), [(np.float64, DISTANCES[:7]), (np.float32, DISTANCES[:3])])
@pytest.mark.parametrize("turns", POLES)
def test_convert_loses_nothing_between_charts_infinite_at_a_whole_turn(turns: int, dtype: Any, distances: Any) -> None:
    """Translate across the axis by 4: rounding of the angle would move the pose by eps/e."""
    for source, target in itertools.product(map(subject, POLES[turns]), repeat=2):
        for e, count in itertools.product(distances, (1, 30)):
            pose = dualcay.exponential.pose(np.array([0.6 * e, 0, 0.8 * e, 0, 0, 0]))
            pose[:3, 3] = 1, 2, 3
            v = np.tile(source.module.from_pose(pose, turns).astype(dtype), (count, 1))
            found = dualcay.convert(v if count > 1 else v[0], source.module, target.module)
            off = target.module.pose(found.astype(float)) - source.module.pose(v.astype(float))
            error = np.nan_to_num(abs(off), nan=0).max()  # a vector that is not finite is allowed
            assert error < GATE * np.finfo(dtype).eps * 4, (source.module, target.module, e, count)


@pytest.mark.parametrize("name", thorough.sampled(CHARTS, CHARTS[::3]))
def test_batches_in_single_precision_are_as_exact(name: str) -> None:
    """Rows of a batch run in float32; its steps have the axis of v to rounding alone."""
    chart = subject(name)
    for k, screw in itertools.product(turns_of(chart), SCREWS):
        ends = 2 * np.pi * k - np.array([*DISTANCES[:5], *np.negative(DISTANCES[:5])] * 3)
        start = np.array([turned(chart, screw, end - LEFT, np.float32) for end in ends])
        step = np.tile((screw * LEFT).astype(np.float32), (len(ends), 1))
        for row, end in zip(chart.module.retract(start, step), ends, strict=True):
            assert wrong(chart, row, pose_of(screw, end), end, screw) <= 1, (k, end, row)


CHAINS = [*itertools.product(CHARTS, (np.float64, np.float32))]


@pytest.mark.parametrize("case", thorough.sampled(CHAINS, CHAINS[::3]), ids=str)
def test_chains_of_steps_close(case: tuple[str, Any]) -> None:
    """A thousand steps lead through whole turns; each adds the rounding of a vector, whose angle is up to 12 rad.

    At the whole turn the axis may be off by the sum of them, over the angle of one step.
    """
    name, dtype = case
    chart = subject(name)
    for screw, count in zip(SCREWS[:2], (25, 1), strict=True):
        step = np.tile((screw * (2 * np.pi * len(turns_of(chart)) / 1000)).astype(dtype), (count, 1))
        v = np.zeros_like(step)
        for _ in range(500 if chart.edge < 7 else 1000):
            v = chart.module.retract(v, step)
        for _ in range(250):  # back, away from the edge
            v = chart.module.retract(v, -step)
        done = 250 if chart.edge < 7 else 750
        pose = chart.module.pose(v)[0, :3]
        off = abs(pose - pose_of(step[0].astype(float), done)).max()
        assert not off > 1000 * 64 * np.finfo(dtype).eps, off


@pytest.mark.parametrize("name", thorough.sampled(CHARTS, CHARTS[::3]))
def test_translation_across_the_axis_at_a_whole_turn_is_not_finite(name: str) -> None:
    """The pose 2π about one axis and back to a parallel one is a translation across both: no v keeps the axis."""
    chart = subject(name)
    if chart.edge < 6.5:
        return  # v is infinite there
    first, second = np.array([0, 0, 1, 0, 0, 0.0]), np.array([0, 0, 1, 0, -1, 0.0])
    found = chart.module.retract(turned(chart, first, 1.5 * np.pi), second * (np.pi / 2))
    pose = chart.module.pose(found)
    exact = pose_of(second, np.pi / 2)
    exact[:, 3] += exact[:, :3] @ pose_of(first, 1.5 * np.pi)[:, 3]
    exact[:, :3] = np.eye(3)
    assert not np.isfinite(pose).all() or abs(pose[:3] - exact).max() < 1e-12
