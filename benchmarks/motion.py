"""Work of the kinematic equations of CP23: pose error of a tumbling body against evaluations and time.

SciPy's DOP853 integrates each equation at several tolerances. The right-hand sides are straight-line programs of Python
floats, traced from the formulas, so that times compare equations and not their texts.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import matplotlib
import numpy as np
from matplotlib.figure import Figure
from scipy.integrate import solve_ivp

from benchmarks import timing
from benchmarks.style import BLUE, FOLDER, GOLD, GREEN, GREY, ORANGE, PINK, STYLE, WIDTH
from derive.algebra import Vector
from derive.codegen.programs.trace import Trace
from derive.codegen.targets import expression
from derive.motion_equations import MotionEquation, motion_equation
from derive.output.files import put_picture
from tests.support import motions

FILE = FOLDER / "motion_equations.svg"

EQUATIONS = {
    "tensor (70)": motion_equation("70"), "quaternion (75)": motion_equation("75"),
    "exponential (83)": motion_equation("83"), **{f"n = {n} (90)": motion_equation("90", n) for n in (1, 2, 3, 5)},
}  # fmt: skip
STYLES = dict(zip(EQUATIONS, [(GREY, "s"), (ORANGE, "D"), (PINK, "X"), (GOLD, "v"), (BLUE, "o"), (GREEN, "^"),
                              ("#7A5BB5", "P")], strict=True))  # fmt: skip
TOLERANCES = tuple(10.0**-k for k in range(4, 13))
END, ROUNDS = 20.0, 5
ERRORS = 1e-6, 1e-9
"""Pose errors for which the table gives the work."""

TICKS = (1000, 2000, 5000, 10000), (5, 10, 20, 50)
"""Marks on the axes of evaluations and of milliseconds."""

FLOATS = SimpleNamespace(
    sqrt=math.sqrt, tan=math.tan, sin=math.sin, cos=math.cos, stack=list, where=lambda c, a, b: a if c else b,
    reciprocals=lambda like, *integers: [1 / integer for integer in integers],
)


@dataclass(frozen=True)
class Run:
    """Run at one tolerance: evaluations of the right-hand side, time, and the largest pose error of all steps."""

    evaluations: int
    milliseconds: float
    error: float


def straight_line(equation: MotionEquation) -> Callable[[float, np.ndarray], Sequence[float]]:
    """Return the right-hand side for the space twist of the tumbling body, as a function of Python floats."""
    trace = Trace()
    y = trace.inputs("y", [f"y{i}" for i in range(equation.states)])
    w = trace.inputs("omega", [f"w{i}" for i in range(6)])
    trace.name_rest("t")
    half = equation.states // 2
    rate = equation.rate(equation.kind.dual(y[:half], y[half:]), Vector.dual(w[:3], w[3:]), trace)
    known: dict[str, Any] = {}
    exec(f"def rate(m, y, omega):\n{expression.body(trace.program('rate', [*rate.re, *rate.du]))}", known)
    function = known["rate"]
    return lambda t, y: function(FLOATS, y.tolist(), motions.space_twist(t, FLOATS))


def runs(equation: MotionEquation, tolerances: Sequence[float] = TOLERANCES, end: float = END) -> list[Run]:
    """Return a run for each tolerance."""
    rhs, start = straight_line(equation), motions.start(equation)

    def solve(rtol: float) -> Any:
        return solve_ivp(rhs, (0, end), start, "DOP853", rtol=rtol, atol=rtol / 10)

    found = [solve(rtol) for rtol in tolerances]
    seconds = timing.medians([lambda rtol=rtol: solve(rtol) for rtol in tolerances], ROUNDS)  # type: ignore[misc]
    return [
        Run(solved.nfev, 1e3 * taken, float(abs(motions.reached(equation, solved.y) - poses).max()))
        for solved, taken in zip(found, seconds, strict=True)
        for poses in [np.stack([motions.pose(t) for t in solved.t])]
    ]


def work(found: Sequence[Run], error: float) -> tuple[str, str]:
    """Return evaluations and milliseconds for an error, between the measured ones; dashes beyond them."""
    order = sorted(found, key=lambda run: run.error)
    errors = np.log([run.error for run in order])
    if not errors[0] <= math.log(error) <= errors[-1]:
        return "–", "–"
    values = ([run.evaluations for run in order], [run.milliseconds for run in order])
    evaluations, time = (float(np.exp(np.interp(math.log(error), errors, np.log(each)))) for each in values)
    return f"{evaluations:.0f}", f"{time:.1f}"


def drawn(measured: Mapping[str, Sequence[Run]]) -> Figure:
    """Draw evaluations and time against the pose error."""
    figure = Figure(figsize=(WIDTH, 3.8), layout="constrained")
    panels = figure.subplots(1, 2, sharey=True)
    for axes, amount, ticks in zip(panels, ("evaluations", "milliseconds"), TICKS, strict=True):
        for name, found in measured.items():
            colour, marker = STYLES[name]
            values = [getattr(run, amount) for run in found]
            label = f"{name}, {EQUATIONS[name].states} states"
            axes.loglog(values, [run.error for run in found], marker=marker, ms=5, color=colour, label=label)
        axes.grid(color=GREY, alpha=0.25)
        axes.minorticks_off()
        axes.set_xticks(ticks, map(str, ticks))
    panels[0].set(xlabel="evaluations of the right-hand side", ylabel="largest error of the pose")
    panels[1].set(xlabel="milliseconds")
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=4, frameon=False)
    return figure


def section(tolerances: Sequence[float] = TOLERANCES, end: float = END, picture: Path = FILE) -> str:
    """Measure all equations, draw the picture, and return the section with the table."""
    measured = {name: runs(equation, tolerances, end) for name, equation in EQUATIONS.items()}
    matplotlib.use("Agg")
    with matplotlib.rc_context(STYLE):
        put_picture(picture, drawn(measured))
    rows = [
        [name, str(EQUATIONS[name].states), *(part for error in ERRORS for part in work(found, error))]
        for name, found in measured.items()
    ]
    head = ["equation", "states", *(f"{what} at {error:.0e}" for error in ERRORS for what in ("evaluations", "ms"))]
    return timing.markdown("Kinematic equations of CP23", head, rows) + "\n" + (
        f"![Pose error against evaluations and time](figures/{picture.name})\n\n"
        f"A body tumbles for {end:g} s with rotation angles up to 2.63 rad, so no vector comes near a pole. SciPy's "
        "DOP853 integrates each equation for the twist in space, at tolerances from "
        f"{max(tolerances):.0e} to {min(tolerances):.0e}. The error is that of the largest entry of the homogeneous "
        "matrix, over all steps; the right-hand sides are straight-line programs of Python floats, in which "
        "the exponential computes both its series and its closed form. "
        "`derive.motion_equation` returns the equations.\n"
    )
