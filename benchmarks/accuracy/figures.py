"""Figures docs/accuracy_*.svg: error against angle, of our kernels and other libraries."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from rich.console import Console
from rich.progress import Progress

from benchmarks.accuracy import curves, peers
from benchmarks.style import STYLE, WIDTH
from derive.output.files import put_picture

FLOOR = 1e-2  # smallest error drawn; smaller ones are drawn here

# Colours of Okabe and Ito; lines and markers differ as well. Our curves are solid, others dashed.
Styles = dict[str, tuple[str, str]]
STYLES: Styles = {
    "n = 1": ("#56B4E9", "o"),
    "n = 2": ("#0072B2", "s"),
    "n = 3": ("#009E73", "^"),
    "n = 8": ("#000000", "D"),
    "exponential": ("#8C6BB1", "*"),
    "SciPy": ("#E69F00", "v"),
    "pytransform3d": ("#D55E00", "P"),
    "jaxlie": ("#CC79A7", "X"),
    "pinocchio": ("#7F7F7F", "d"),
}


def is_ours(label: str) -> bool:
    """Return whether a curve belongs to a kernel of this project."""
    return label not in peers.MAKERS


X_AXES = {
    "small": ("rotation angle α", "log"),
    "whole": ("rotation angle α", "linear"),
    "to pi": ("distance to half a turn, π − α", "log"),
}


@dataclass(frozen=True)
class Picture:
    """Contents of one file: a row for each part, a column for each panel."""

    file: str
    parts: dict[str, str]
    panels: tuple[str, str]
    caption: str


PICTURES = (
    Picture(
        "accuracy_exponential.svg",
        {"Q": "rotation Q", "ρ": "displacement ρ"},
        ("small", "whole"),
        "Forward maps. Ours v → pose, the others' exponential map at the same screws with translations of size one; "
        "each against its own exact map of its own rounded argument.",
    ),
    Picture(
        "accuracy_logarithm.svg",
        {"log": "rotational part", "log°": "translational part"},
        ("small", "to pi"),
        "Inverse maps. All from the same matrix of doubles; errors over what rounding its entries does to the exact "
        "result.",
    ),
    Picture(
        "accuracy_tangent.svg",
        {"T": "T", "T⁻¹": "T⁻¹"},
        ("small", "whole"),
        "Tangent operators. Ours dcay and its inverse, the others' left Jacobian of the exponential map and its "
        "inverse, the larger error of both parts. SciPy has neither, jaxlie the inverse only; the inverses of jaxlie "
        "and pinocchio are those of their logarithms, up to π.",
    ),
)


def panel(axes: Axes, found: curves.Curves, name: str, part: str, styles: Styles = STYLES) -> None:
    """Draw all curves of one part over one range of angles."""
    angles = curves.TO_PI if name == "to pi" else curves.ANGLES[name]
    for i, (label, (colour, marker)) in enumerate(styles.items()):
        row = found.get((name, part, label))
        if row is not None:
            ours = is_ours(label)
            axes.plot(
                angles,
                np.where(np.isnan(row), np.nan, np.clip(row, FLOOR, 1e17)),
                color=colour,
                linestyle="-" if ours else (0, (4, 1.5)),
                linewidth=1.4,
                marker=marker,
                markersize=4.5,
                markevery=(i, 8),
                label=label,
                zorder=3 if ours else 2,
            )
    label, scale = X_AXES[name]
    axes.set_xscale(scale)
    axes.set_yscale("log")
    axes.set_xlabel(label)
    axes.grid(True, which="major")
    axes.axhline(1, color="0.4", linewidth=0.8, zorder=1)
    if name == "whole":
        axes.set_xlim(0, 2 * np.pi)
        axes.set_xticks(np.arange(5) * np.pi / 2, ["0", "π/2", "π", "3π/2", "2π"])


def picture(found: curves.Curves, what: Picture, path: Path) -> None:
    figure = Figure(figsize=(WIDTH, 7), layout="constrained")
    grid = figure.subplots(2, 2, sharey=True)
    for row, (part, label) in zip(grid, what.parts.items(), strict=True):
        for axes, name in zip(row, what.panels, strict=True):
            panel(axes, found, name, part)
        row[0].set_ylabel(f"error of {label} (eps)")
    handles = {label: line for axes in grid.flat for line, label in zip(*axes.get_legend_handles_labels(), strict=True)}
    order = [label for label in STYLES if label in handles]
    names = [f"dualcay, {label}" if is_ours(label) else label for label in order]
    lines = [handles[label] for label in order]
    figure.legend(lines, names, loc="outside lower center", ncols=4, frameon=False, handlelength=3.2)
    put_picture(path, figure)


def missing(console: Console) -> None:
    """Print which libraries are left out."""
    for name, version in peers.versions(*peers.MAKERS).items():
        if version is None:
            console.print(f"{name} is not installed and left out of the figures (extras bench, peers)", highlight=False)


def draw(folder: Path, bar: Progress, console: Console) -> curves.Drawn:
    """Compute and draw all figures."""
    matplotlib.use("Agg")
    missing(console)
    row = bar.add_task("angles", total=sum(map(len, curves.ANGLES.values())))
    found = curves.curves(lambda done, total: bar.update(row, completed=done, total=total))
    with matplotlib.rc_context(STYLE):
        for what in PICTURES:
            picture(found, what, folder / what.file)
    used = ", ".join(f"{name} {version}" for name, version in peers.versions(*peers.MAKERS).items() if version)
    note = f"Errors below {FLOOR:g} eps are drawn there. Compared: {used}."
    captions = [(what.file, f"{what.caption} {note}") for what in PICTURES]
    return curves.Drawn(captions, curves.standing(found, curves.searched()))
