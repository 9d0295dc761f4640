"""The plot of ``dualcay compare``: |v|, singular values and condition against the angle."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from pathlib import Path

import click

from ..maps.any_phi.stretch import Stretch, stretch
from .compared import Compared

FURTHEST = 4 * math.pi


def write(compared: Sequence[Compared], file: Path) -> None:
    """Draw it, a panel for each."""
    try:
        import matplotlib
    except ImportError:
        raise click.UsageError("--plot needs matplotlib: pip install 'dualcay[bench]'") from None
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(2, 2, figsize=(11, 8), sharex=True, layout="constrained")
    panels: dict[str, Callable[[Stretch, float], float]] = {
        "|v|/φ′(0)": lambda s, first: s.size * first,
        "along the axis, 1/φ′ (by that at 0)": lambda s, first: s.along / first,
        "across, 2 sin(α/2)/φ (by that at 0)": lambda s, first: s.across / first,
        "condition of Re T": lambda s, first: s.condition,
    }
    styles = ["-", "--", "-.", ":"]
    for index, row in enumerate(compared):
        end = min(row.edge, FURTHEST)
        angles = [end * k / 300 for k in range(300)]
        found = [stretch(row.chart.phi, angle) for angle in angles]
        for axis, value in zip(axes.flat, panels.values(), strict=True):
            values = [value(s, found[0].along) for s in found]
            axis.plot(angles, values, styles[index // 10 % 4], label=row.chart.name, color=f"C{index % 10}")
    for axis, title in zip(axes.flat, panels, strict=True):
        axis.set_title(title)
        axis.set_xlim(0, 2 * math.pi)
        axis.set_xticks([k * math.pi / 2 for k in range(5)], ["0", "π/2", "π", "3π/2", "2π"])
        axis.grid(alpha=0.3)
        axis.set_ylim(*LIMITS[title])
    axes[1, 1].set_yscale("log")
    for axis in axes[1]:
        axis.set_xlabel("α")
    figure.legend(*axes[0, 0].get_legend_handles_labels(), loc="outside right upper")
    figure.savefig(file, dpi=110, metadata={"Software": None} if file.suffix == ".png" else None)
    pyplot.close(figure)


LIMITS = {
    "|v|/φ′(0)": (0, 8),
    "along the axis, 1/φ′ (by that at 0)": (0, 3),
    "across, 2 sin(α/2)/φ (by that at 0)": (0, 1.5),
    "condition of Re T": (0.9, 30),
}
