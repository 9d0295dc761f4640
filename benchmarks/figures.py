"""Pictures of the README and the site: ``python -m benchmarks.figures``.

======== ====================================================================================================
accuracy error against angle, of our kernels and other libraries: the main panels of docs/accuracy.md
charts   |v| against the angle, chart by chart, and where each is singular
screw    a body on a screw motion, by ``from_screw``
motion   size and deviation of v along a tumbling motion with its switches, for docs/explanation/motion.md
======== ====================================================================================================

Each example in examples/ draws one more. `benchmarks.style` has what they have in common.
"""

from __future__ import annotations

import importlib
import itertools
import math
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from rich.console import Console

from benchmarks.accuracy import curves, figures
from benchmarks.accuracy.__main__ import progress
from benchmarks.style import BLUE, FOLDER, GOLD, GREEN, GREY, ORANGE, PINK, STYLE, WIDTH
from derive.codegen import catalogue
from derive.output.files import put, put_picture
from derive.pages.comparison import Compared, stretch
from derive.workers import scratch
from dualcay import cayley2
from dualcay.rotation import cayley2 as mrp
from dualcay.rotation import exponential

SCRIPTS = sorted((Path(__file__).parents[1] / "examples").glob("*.py"))
EXAMPLES = [script.stem for script in SCRIPTS if "--figure" in script.read_text(encoding="utf-8")]

STYLES = {
    "n = 2": (BLUE, "s"), "n = 3": (GREEN, "^"),
    "SciPy": (GOLD, "v"), "pytransform3d": (ORANGE, "P"), "jaxlie": (PINK, "X"), "pinocchio": (GREY, "d"),
}  # fmt: skip
PANELS = {
    "v to pose: translation": ("small", "ρ"),
    "pose to v: rotation": ("to pi", "log"),
    "twist to rate: T⁻¹": ("small", "T⁻¹"),
}


def accuracy(found: curves.Curves) -> Figure:
    figure = Figure(figsize=(WIDTH, 3.4), layout="constrained")
    for axes, (title, (name, part)) in zip(figure.subplots(1, 3, sharey=True), PANELS.items(), strict=True):
        figures.panel(axes, found, name, part, STYLES)
        axes.grid(color=GREY, alpha=0.25)
        axes.set_title(title)
        axes.set_yticks(10.0 ** np.arange(-2, 15, 4))
    figure.axes[0].set_ylabel("error (units of 2.2e−16)")
    names = {label: f"dualcay, {label}" if label.startswith("n =") else label for label in STYLES}
    lines = {line.get_label(): line for axes in figure.axes for line in axes.get_lines()}
    shown = [label for label in STYLES if label in lines]
    figure.legend([lines[label] for label in shown], [names[label] for label in shown], loc="outside lower center",
                  ncols=len(shown), frameon=False, handlelength=2.6)  # fmt: skip
    return figure


CHARTS = {
    "cayley1": (BLUE, "-"), "cayley2": (GREEN, "-"), "cayley3": (ORANGE, "-"), "cayley4": (PINK, "-"),
    "exponential": (GREY, "-"), "lambert": (GOLD, "--"), "sine4": (BLUE, "--"),
}  # fmt: skip
HIGHEST, LAST = 11.0, 4 * math.pi


def charts() -> Figure:
    figure = Figure(figsize=(WIDTH, 3.8), layout="constrained")
    axes = figure.subplots()
    committed = {chart.name: Compared(chart) for chart in catalogue.committed()}
    for name, look in CHARTS.items():
        draw_chart(axes, committed[name], *look)
    axes.set_xticks([k * math.pi for k in range(5)], ["0", "π", "2π", "3π", "4π"])
    axes.set(xlim=(0, LAST), ylim=(0, HIGHEST), xlabel="rotation angle α", ylabel="|v| / φ′(0)")
    axes.plot([], [], "o", color=GREY, mfc="none", ms=8, mew=1.8, label="T is singular")
    axes.plot([], [], ":", color=GREY, label="|v| is infinite")
    axes.legend(frameon=False, loc="lower right")
    return figure


def draw_chart(axes: Axes, chart: Compared, colour: str, line: str) -> None:
    """Draw the curve of a chart with its name, circles where T is singular, and a line where |v| is infinite."""
    end = min(chart.edge, LAST)
    first = stretch(chart.chart.phi, 0.0).along
    angles = np.linspace(0, end * (1 - 1e-9), 401)
    sizes = np.array([stretch(chart.chart.phi, angle).size * first for angle in angles])
    seen = sizes <= HIGHEST
    axes.plot(angles[seen], sizes[seen], line, color=colour)
    axes.annotate(chart.chart.name, (angles[seen][-1], sizes[seen][-1]), (0, 7), textcoords="offset points",
                  color=colour, ha="center", annotation_clip=False)  # fmt: skip
    if math.isinf(chart.range) and chart.edge <= LAST:
        axes.axvline(chart.edge, color=colour, ls=":", lw=1.2)
    for singular in (float(angle.evalf(17)) for angle in chart.chart.singular_angles):
        size = np.interp(singular, angles, sizes)
        if singular <= LAST and size <= HIGHEST:
            axes.plot(singular, size, "o", color=colour, mfc="none", ms=8, mew=1.8, clip_on=False)


def screw() -> Figure:
    """Draw frames along a screw about an axis that does not meet the origin."""
    angle, through, along = np.array([2.2 * np.pi, 3.4]), np.array([1.0, 0.4, 0]), np.array([0.28, 0, 0.96])
    line = np.concatenate([along, np.cross(through, along)])
    figure = Figure(figsize=(3.6, 3.6))
    axes: Any = figure.add_axes((0, 0, 1, 1), projection="3d")

    def poses(count: int) -> np.ndarray:
        turns = np.linspace(0, 1, count)[:, None] * angle
        return np.asarray(cayley2.pose(cayley2.from_screw(turns, line)))

    axes.plot(*poses(200)[:, :3, 3].T, color=GREY, lw=1.4)
    axes.plot(*(through + np.outer([-0.8, 4.2], along)).T, color=GREY, lw=1.4, ls=(0, (6, 3)))
    for pose in poses(10):
        for direction, colour in zip(pose[:3, :3].T, (ORANGE, GREEN, BLUE), strict=True):
            axes.quiver(*pose[:3, 3], *direction, length=0.6, color=colour, lw=2, arrow_length_ratio=0.25)
    limits = np.array([axes.get_xlim(), axes.get_ylim(), axes.get_zlim()])
    axes.set_box_aspect(np.ptp(limits, axis=1), zoom=1.3)
    axes.set_axis_off()
    axes.view_init(elev=15, azim=-75)
    return figure


def motion() -> Figure:
    """Draw |v| of two charts along a tumbling motion, and the deviation of v with and without J at the switches."""
    omega, times = np.array([0.3, 0.8, -0.5]), np.linspace(0, 16, 1601)
    figure = Figure(figsize=(WIDTH, 3.2), layout="constrained")
    sizes, deviations = figure.subplots(1, 2)
    poses = exponential.tensor(np.outer(times, omega)) @ exponential.tensor(np.array([0.4, -0.2, 0.9]))
    for chart, colour, name in ((mrp, BLUE, "|σ|, n = 2"), (exponential, ORANGE, "|rotation vector|")):
        sizes.plot(times, np.linalg.norm(chart.from_tensor(poses), axis=-1), color=colour, label=name)
    sizes.axhline(1, color=BLUE, ls=":", lw=1.2, label="half a turn")
    sizes.axhline(math.pi, color=ORANGE, ls=":", lw=1.2)
    sizes.set(xlabel="t (s)", ylabel="size of the vector", ylim=(0, 4.1))
    sizes.legend(frameon=False, ncols=2, loc="upper center")
    right, wrong = _deviations(mrp.from_tensor(poses))
    deviations.plot(times, wrong, color=PINK, ls="--", label="without J")
    deviations.plot(times, right, color=GREEN, label="with J")
    deviations.set(xlabel="t (s)", ylabel="deviation of σ₁, relative to t = 0", ylim=(0, None))
    deviations.legend(frameon=False)
    return figure


START = np.array([1.0, 0.3, 0.1])
"""Standard deviations of the components of σ at t = 0."""


def _deviations(vectors: np.ndarray) -> np.ndarray:
    """Return the standard deviation of σ₁ along a motion with J and without J at its switches, (2, times)."""
    start = vectors[0]
    right, wrong, carried = [], [], np.eye(3)
    for before, after in itertools.pairwise([start, *vectors]):
        last = min(before, mrp.shadow(before), key=lambda vector: np.linalg.norm(vector - after))
        carried = mrp.transition(after, last) @ carried
        for deviation, square in ((right, mrp.transition(after, start)), (wrong, carried)):
            deviation.append(np.linalg.norm(square[0] * START))
    return np.array([right, wrong])


def main() -> None:
    """Draw all pictures."""
    matplotlib.use("Agg")
    with matplotlib.rc_context(STYLE):
        for draw in (charts, screw, motion):
            put_picture(FOLDER / f"{draw.__name__}.svg", draw())
        for name in EXAMPLES:
            with scratch() as folder:
                picture = folder / f"{name}.svg"
                importlib.import_module(f"examples.{name}").main(["--figure", str(picture)])
                put(FOLDER / picture.name, picture.read_bytes())
        console = Console()
        figures.missing(console)
        with progress(console) as bar:
            row = bar.add_task("angles", total=None)
            found = curves.curves(lambda done, total: bar.update(row, completed=done, total=total))
        put_picture(FOLDER / "accuracy.svg", accuracy(found))


if __name__ == "__main__":
    main()
