"""Cost of `dualcay.propagate` beside SciPy's bare integration of the quaternion equation (75), in one run."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from benchmarks import timing
from benchmarks.motion import END, FLOATS, straight_line
from derive.motion_equations import motion_equation
from dualcay import cayley2, propagate
from tests.support import motions

TOLERANCES, ROUNDS, COUNTS = (1e-8, 1e-10, 1e-12), 7, (2, 101)
"""Relative tolerances; interleaved rounds; numbers of output times."""


def best(functions: tuple[Callable[[], Any], ...], rounds: int) -> list[float]:
    """Return the shortest time of each function in milliseconds, over interleaved rounds."""
    times: list[list[float]] = [[] for _ in functions]
    for _ in range(rounds):
        for function, found in zip(functions, times, strict=True):
            start = time.perf_counter()
            function()
            found.append(1e3 * (time.perf_counter() - start))
    return [min(found) for found in times]


def twist(t: float) -> list[float]:
    """Return the twist of the tumbling body in space, as Python floats."""
    found: list[float] = motions.space_twist(t, FLOATS)
    return found


def section(tolerances: tuple[float, ...] = TOLERANCES, end: float = END, rounds: int = ROUNDS) -> str:
    """Measure both at each tolerance, and return the section with its table."""
    equation = motion_equation("75")
    right_side, start = straight_line(equation), motions.state(equation, np.zeros(6))
    rows = []
    for tolerance in tolerances:
        accuracy = {"rtol": tolerance, "atol": tolerance / 100}
        for count in COUNTS:
            times = np.linspace(0, end, count)

            def ours(times: np.ndarray = times, accuracy: dict[str, float] = accuracy) -> Any:
                return propagate(cayley2, np.zeros(6), twist, times, **accuracy)

            def bare(times: np.ndarray = times, accuracy: dict[str, float] = accuracy) -> Any:
                return solve_ivp(right_side, times[[0, -1]], start, "DOP853", t_eval=times, **accuracy)

            errors = (
                np.abs(pose - motions.pose(end)).max()
                for pose in (ours().pose[-1], motions.reached(equation, bare().y[:, -1]))
            )
            mine, theirs = best((ours, bare), rounds)
            figures = [f"{mine:.1f}", f"{theirs:.1f}", f"{mine / theirs:.2f}", *(f"{error:.0e}" for error in errors)]
            rows.append([f"{tolerance:.0e}", str(count), *figures])
    head = ["rtol", "output times", "propagate, ms", "solve_ivp (75), ms", "ratio", "error", "error of (75)"]
    return timing.markdown("Propagation of a pose", head, rows) + "\n" + (
        f"A body tumbles for {end:g} s; the twist is a function of Python floats in both. `propagate` returns v, poses "
        "and branches, and can be called at any time; SciPy's DOP853 returns the quaternions at the output times. "
        "The right-hand side of (75) is a straight-line program. The error is that of the largest entry of the last "
        "homogeneous matrix.\n"
    )
