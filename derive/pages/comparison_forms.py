"""Parameterizations side by side, as tables, JSON, a page or a plot."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import TypeAlias

import sympy

from ..output import render
from ..output.files import put_picture
from ..output.shown import columns, figures
from .comparison import (
    ANGLES,
    COUNTED,
    MEASURED,
    NEAREST,
    TIMED,
    Compared,
    Stretch,
    measurements,
    number,
    stretch,
)  # fmt: skip

PANELS: Mapping[str, tuple[Callable[[Stretch, float], float], tuple[float, float]]] = {
    "|v|/φ′(0)": (lambda found, at_0: found.size * at_0, (0, 8)),
    "along the axis, 1/φ′ (by that at 0)": (lambda found, at_0: found.along / at_0, (0, 3)),
    "across, 2 sin(α/2)/φ (by that at 0)": (lambda found, at_0: found.across / at_0, (0, 1.5)),
    "condition of Re T": (lambda found, at_0: found.condition, (0.9, 30)),
}
"""Panels of the plot by title: a function of the stretch and the singular value at 0, and the limits of the axis."""

Table: TypeAlias = tuple[Sequence[str], Sequence[Sequence[str]]]
"""Headings, and a row for each chart."""


def measured(compared: Sequence[Compared], what: str) -> Table:
    """Return a table of ``errors`` in eps by function and angle, or of ``nanoseconds`` by number of poses."""
    functions, place = (MEASURED, "") if what == "errors" else (TIMED, "N = ")
    found = {row.chart.name: row.measured[what] for row in compared if row.measured}
    places = {(f, at): None for f in functions for values in found.values() for at in values[f]}
    rows = [[chart, *(number(values[f].get(at)) for f, at in places)] for chart, values in found.items()]
    return ["chart", *(f"{f} {place}{at}" for f, at in places)], rows


def cost(compared: Sequence[Compared]) -> Table:
    return ["chart", *COUNTED], [[row.chart.name, *map(number, row.operations.values())] for row in compared]


def _text(compared: Sequence[Compared]) -> str:
    """Return the tables as text, with condition numbers only, since a line is too short for all singular values."""
    headings, rows = ["chart", "φ", "edge/π", *(f"{name} cond" for name in ANGLES), *COUNTED], []
    for row, (name, *counts) in zip(compared, cost(compared)[1], strict=True):
        conditions = [number(found.condition if found else None) for found in row.stretches.values()]
        rows.append([name, row.chart.parameter, number(row.edge / math.pi), *conditions, *counts])
    tables = (
        ("condition of Re T by angle, and operations", (headings, rows)),
        ("errors in eps by angle, as measured", measured(compared, "errors")),
        ("nanoseconds for a pose of N, as measured", measured(compared, "nanoseconds")),
    )
    return "".join(figures(title, *table).text(columns()) for title, table in tables if table[1])


def _json(compared: Sequence[Compared]) -> str:
    entries = [
        {
            "chart": row.chart.name,
            "phi": str(row.chart.written),
            "edge": row.edge if row.edge < math.inf else None,
            "range": row.range if row.range < math.inf else None,
            "branches": row.chart.branches or None,
            "singular_angles": [float(angle.evalf(17)) for angle in row.chart.singular_angles],
            "stretch": {
                name: {**asdict(found), "condition": found.condition} if found else None
                for name, found in row.stretches.items()
            },
            "operations": row.operations,
            "measured": row.measured,
        }
        for row in compared
    ]
    return json.dumps(entries, indent=2, ensure_ascii=False) + "\n"


def _page(compared: Sequence[Compared]) -> str:
    nearest = measurements(NEAREST) or {"points": 0, "rows": []}
    return render(
        "report/parameterizations.md.j2",
        reach=_table(*_reach(compared)),
        stretches=_table(*_stretches(compared)),
        cost=_table(*cost(compared)),
        errors=_table(*measured(compared, "errors")),
        times=_table(*measured(compared, "nanoseconds")),
        points=nearest["points"],
        best=_table(["A", "among", "--phi", "M"], nearest["rows"]),
    )


def _reach(compared: Sequence[Compared]) -> Table:
    rows = []
    for row in compared:
        singular = (number(float((angle / sympy.pi).evalf(10))) for angle in row.chart.singular_angles)
        sizes = (number(row.edge / math.pi), number(row.range))
        rows.append([row.chart.name, row.chart.parameter, *sizes, ", ".join(singular)])
    return ["chart", "φ", "edge/π", "|v| there", "singular angles/π"], rows


def _stretches(compared: Sequence[Compared]) -> Table:
    headings = ["chart", *(f"{name} {what}" for name in ANGLES for what in ("1/φ′", "across", "cond"))]
    rows = []
    for row in compared:
        found = ((at.along, at.across, at.condition) if at else (None,) * 3 for at in row.stretches.values())
        rows.append([row.chart.name, *(number(cell) for cells in found for cell in cells)])
    return headings, rows


def _table(headings: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    lines = [headings, ["---"] * len(headings), *rows]
    return "\n".join(f"| {' | '.join(cell.replace('|', '&#124;') for cell in line)} |" for line in lines)


def draw(compared: Sequence[Compared], file: Path) -> None:
    """Plot the figures of `PANELS` against the angle, with Matplotlib."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(2, 2, figsize=(8.2, 7), sharex=True, layout="constrained")
    for index, row in enumerate(compared):
        angles = [min(row.edge, 4 * math.pi) * k / 300 for k in range(300)]
        found = [stretch(row.chart.phi, angle) for angle in angles]
        style = {"linestyle": ("-", "--", "-.", ":")[index // 10 % 4], "color": f"C{index % 10}"}
        for axis, (figure_of, _) in zip(axes.flat, PANELS.values(), strict=True):
            axis.plot(angles, [figure_of(at, found[0].along) for at in found], label=row.chart.name, **style)
    for axis, (title, (_, limits)) in zip(axes.flat, PANELS.items(), strict=True):
        axis.set(title=title, xlim=(0, 2 * math.pi), ylim=limits)
        axis.set_xticks([k * math.pi / 2 for k in range(5)], ["0", "π/2", "π", "3π/2", "2π"])
        axis.grid(alpha=0.3)
    axes[1, 1].set_yscale("log")
    for axis in axes[1]:
        axis.set_xlabel("α")
    figure.legend(*axes[0, 0].get_legend_handles_labels(), loc="outside lower center", ncols=5, frameon=False)
    with matplotlib.rc_context({"svg.hashsalt": "dualcay"}):  # equal data give equal bytes
        put_picture(file, figure)
    pyplot.close(figure)


FORMS: Mapping[str, Callable[[Sequence[Compared]], str]] = {"text": _text, "json": _json, "markdown": _page}
