"""Cost of `PoseSpline` beside SciPy's `RotationSpline` through the same rotations at the same times, in one run."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation, RotationSpline

from benchmarks import timing
from dualcay import PoseSpline, cayley2, exponential
from dualcay.rotation import cayley2 as rotations

SIZES, KNOTS = (1, 100, 10_000, 100_000), 50
"""Numbers of times in one call, and of poses that the curves pass."""

HEAD = ["quantity", "times", "poses, ns", "rotations, ns", "RotationSpline, ns"]


def curves(count: int) -> tuple[PoseSpline, PoseSpline, Callable[[Any, int], Any]]:
    """Return the curves through poses, through their rotations, and SciPy's through these."""
    steps = np.random.default_rng(2011).normal(size=(count, 6)) * np.repeat([0.3, 1.0], 3)
    poses, t = exponential.pose(np.cumsum(steps, axis=0)), np.arange(float(count))
    theirs = RotationSpline(t, Rotation.from_matrix(poses[:, :3, :3]))
    return PoseSpline(cayley2, t, poses), PoseSpline(rotations, t, poses[:, :3, :3]), theirs


def section(sizes: tuple[int, ...] = SIZES, rounds: int = 7) -> str:
    """Measure matrices, twists and accelerations, and return the section with its table."""
    poses, real, theirs = curves(KNOTS)
    rows = []
    quantities: dict[str, tuple[Callable[[Any], Any], ...]] = {
        "pose": (poses.pose, real.pose, lambda t: theirs(t, 0).as_matrix()),
        "twist": (poses.twist, real.twist, lambda t: theirs(t, 1)),
        "acceleration": (poses.acceleration, real.acceleration, lambda t: theirs(t, 2)),
        "v̈": (lambda t: poses(t, 2), lambda t: real(t, 2)),
    }
    for size in sizes:
        t = np.random.default_rng(3).uniform(0, KNOTS - 1, size)
        for name, functions in quantities.items():
            times = timing.medians([partial(function, t) for function in functions], rounds)
            rows.append([name, f"{size:,}", *(f"{1e9 * seconds / size:,.0f}" for seconds in times), "–"][: len(HEAD)])
    return timing.markdown("Splines", HEAD, rows) + "\n" + (
        f"All curves pass {KNOTS} poses, or their rotations. A row gives the nanoseconds for each of some random times "
        "in one call. Ours are in the chart `cayley2`. SciPy's curve has rotations alone.\n"
    )
