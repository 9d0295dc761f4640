"""Motions whose twist is smooth only between knots: steps end there."""

from __future__ import annotations

import itertools
from collections.abc import Callable

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from dualcay import cayley2, exponential, propagate

RTOL = 1e-10
FORMS = [(frame, method) for frame in ("space", "body") for method in ("lie", "chart")]


def twist(t: float) -> np.ndarray:
    return np.array([np.sin(3 * t), 0.7 * np.cos(2 * t), 0.4, 0.3 * np.cos(t), -0.2, 0.1 * np.sin(4 * t)])


def multiplied(function: Callable[[float], np.ndarray], pieces: np.ndarray, frame: str) -> np.ndarray:
    """Return the last pose by 16 steps of order 4 with two Gauss points in each piece, and one extrapolation."""

    def product(parts: int) -> np.ndarray:
        pose = np.eye(4)
        for begin, end in itertools.pairwise(pieces):
            h = (end - begin) / parts
            for middle in begin + h * (np.arange(parts) + 0.5):
                one, two = (function(middle + side * h * np.sqrt(3) / 6) for side in (-1, 1))
                linear = np.cross(two[:3], one[3:]) + np.cross(two[3:], one[:3])
                bracket = np.concatenate([np.cross(two[:3], one[:3]), linear])
                turn = h / 2 * (one + two) + (1 if frame == "space" else -1) * np.sqrt(3) / 12 * h**2 * bracket
                pose = exponential.pose(turn) @ pose if frame == "space" else pose @ exponential.pose(turn)
        return pose

    coarse, fine = product(16), product(32)
    return fine + (fine - coarse) / 15


@pytest.mark.parametrize("frame", ["space", "body"])
def test_sampled_twists_are_integrated_as_exactly_as_asked(frame: str) -> None:
    """Allow rtol once for each interval and each unit of the translation; steps across knots lose 30 times more."""
    for count in (21, 41):
        t = np.linspace(0, 10, count)
        samples = np.array([twist(time) for time in t])
        wanted = multiplied(CubicSpline(t, samples), t, frame)
        for method in ("lie", "chart"):
            found = propagate(cayley2, np.zeros(6), samples, t, frame=frame, method=method, rtol=RTOL)
            np.testing.assert_allclose(found.pose[-1], wanted, rtol=0, atol=RTOL * count)
            slope = (found(3.2 + 1e-4, 1) - found(3.2 - 1e-4, 1)) / 2e-4
            np.testing.assert_allclose(found(3.2, 2), slope, rtol=0, atol=1e-6)


@pytest.mark.parametrize(("frame", "method"), FORMS)
def test_a_callable_twist_may_jump_at_knots(frame: str, method: str) -> None:
    """Compare poses and derivatives with those of the pieces; the twist at a knot is that of the piece after."""
    knots = [2.7, 0.5, 1.1, 99.0]

    def pieces(t: float) -> np.ndarray:
        jumps = 1 + np.searchsorted([0.5, 1.1, 2.7], t, side="right")
        return jumps * np.array([0.1, -0.3, 0.2, 0.4, 0, 0.1]) + twist(t)

    ends = np.array([0, 0.5, 1.1, 2.7, 4.0])
    wanted = multiplied(pieces, ends, frame)
    found = propagate(cayley2, np.zeros(6), pieces, [0, 4.0], frame=frame, method=method, rtol=RTOL, knots=knots)
    np.testing.assert_allclose(found.pose[-1], wanted, rtol=0, atol=30 * RTOL)
    assert len(found._path.steps) < 80  # a step that ends beyond a jump is cut again and again: 160 and more
    h = 1e-4
    for time in (0.5 - 2 * h, 0.5 + 2 * h, 1.1 - 2 * h):
        slope = (found(time + h, 1) - found(time - h, 1)) / (2 * h)
        np.testing.assert_allclose(found(time, 2), slope, rtol=0, atol=1e-6)  # h² times a fourth derivative below 50


def test_knots_are_times_of_a_callable_twist() -> None:
    samples = np.zeros((2, 6))
    with pytest.raises(TypeError, match="knots are for a callable twist"):
        propagate(cayley2, np.zeros(6), samples, [0, 1], knots=[0.5])
    with pytest.raises(ValueError, match="knots must"):
        propagate(cayley2, np.zeros(6), twist, [0, 1], knots=[np.nan])
