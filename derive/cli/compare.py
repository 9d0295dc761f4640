"""``dualcay compare``: what parameterizations are like, side by side, as tables, numbers, a page or a plot."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import click
import sympy

from ..codegen import catalogue
from ..codegen.lowered import lower_chart
from ..maps import PhiError
from ..maps.chart import Chart
from ..maps.families import alpha
from ..maps.stretch import POINTS, Stretch, best, bound, stretch
from ..output.tables import Column, Grid, columns
from . import options

ANGLES = {"π/2": math.pi / 2, "π": math.pi, "3π/2": 3 * math.pi / 2}
"""Where singular values are shown."""

COUNTED = ("pose", "from_pose", "tangent", "rate", "compose")
"""Functions whose operations are."""

FURTHEST = 4 * math.pi
NAME = "phi"


@dataclass(frozen=True)
class Compared:
    """A chart, and its figures."""

    chart: Chart

    @cached_property
    def edge(self) -> float:
        edge = self.chart.edge
        return math.inf if edge.is_infinite else float(edge.evalf(20))

    @property
    def range(self) -> float:
        """The |v| at the edge."""
        size = self.chart.phi.subs(alpha, self.chart.edge)
        return math.inf if size.is_infinite else float(size.evalf(20))

    @cached_property
    def stretches(self) -> dict[str, Stretch | None]:
        """At the angles shown; None where the chart has ended."""
        return {name: stretch(self.chart.phi, a) if a < self.edge else None for name, a in ANGLES.items()}

    @cached_property
    def operations(self) -> dict[str, int]:
        found = lower_chart(self.chart).operations
        return {name: found[name].total() for name in COUNTED}

    @property
    def switch(self) -> float:
        """Where motion needs another branch at the latest: T loses rank at 2π, or the chart ends."""
        return min(self.edge, 2 * math.pi)


def compare(
    orders: tuple[int, ...], families: tuple[str, ...], phi: str | None, plot: Path | None, form: str, max_n: int
) -> None:
    """Do what the command says; its parameters are the options."""
    options.require_cap(orders, max_n)
    try:
        if phi is None:
            charts = catalogue.charts(orders, families) or catalogue.charts((1, 2, 3, 4), catalogue.FAMILIES)
        else:
            own, *_ = catalogue.charts((), (), phi, NAME)
            charts = [*catalogue.charts(orders, families), own]
        compared = [Compared(chart) for chart in charts]
        click.echo(FORMS[form](compared), nl=False)
    except PhiError as error:
        raise click.BadParameter(str(error), param_hint="--phi") from None
    except ValueError as error:
        raise click.BadParameter(str(error), param_hint="--family") from None
    if plot is not None:
        _plot(compared, plot)


# --- words ------------------------------------------------------------------------------------------------------------


def _headings() -> list[str]:
    of_angles = [f"{name} {what}" for name in ANGLES for what in ("1/φ′", "across", "cond")]
    return ["chart", "φ", "edge/π", "|v| there", *of_angles, *COUNTED]


def _cells(row: Compared) -> list[str]:
    chart = row.chart
    cells = [chart.name, chart.parameter, _number(row.edge / math.pi), _number(row.range)]
    for found in row.stretches.values():
        cells += [_number(x) for x in (found.along, found.across, found.condition)] if found else ["-"] * 3
    return [*cells, *map(str, row.operations.values())]


def _number(value: float) -> str:
    return "∞" if math.isinf(value) else f"{value:.3g}"


def _text(compared: Sequence[Compared]) -> str:
    """Without singular values one by one, for which a line is too short."""
    headings = _headings()
    left_out = ("1/φ′", "across", "there")
    shown = [i for i, heading in enumerate(headings) if not heading.endswith(left_out)]
    rows = [[cells[i] for i in shown] for cells in map(_cells, compared)]
    first, *rest = (headings[i] for i in shown)
    named = [Column(first), *(Column(heading, number=True) for heading in rest)]
    return Grid("condition of Re T by angle, and operations", named, rows).text(columns())


def _json(compared: Sequence[Compared]) -> str:
    def numbers(found: Stretch | None) -> dict[str, float] | None:
        if found is None:
            return None
        return {"size": found.size, "along": found.along, "across": found.across, "condition": found.condition}

    def finite(value: float) -> float | None:
        return None if math.isinf(value) else value

    entries = [
        {
            "chart": row.chart.name,
            "phi": str(row.chart.phi),
            "edge": finite(row.edge),
            "range": finite(row.range),
            "branches": row.chart.branches or None,
            "singular_angles": [float(angle.evalf(17)) for angle in row.chart.singular_angles],
            "stretch": {name: numbers(found) for name, found in row.stretches.items()},
            "operations": row.operations,
        }
        for row in compared
    ]
    return json.dumps(entries, indent=2, ensure_ascii=False) + "\n"


PAGE = """# Parameterizations

Made by `dualcay compare --format markdown`; nothing here is typed by hand but these words.

A chart is v = φ(α) u. Along the axis Re T multiplies rates by 1/φ′, across it by 2 sin(α/2)/φ; their quotient is the
condition number of Re T. Where φ′ = 0 or sin(α/2) = 0 one of them is infinite or 0: these are the singular angles.

{shape}

![figures against the angle](parameterizations.png)

What is computed, in operations for one pose:

{cost}

* **n = 2 is conformal** (`cayley2`, `scaled2`, `wiener_milenkovic`): both singular values are equal at every angle, so
  the condition number is 1 up to the edge at 2π, and the inverse of T is a scaled transpose.
* **n ≥ 3 carries v beyond 2π, not kinematics**: T loses rank at 2π in every chart that gets there, so motion needs
  another branch before. So it does in the exponential. What is gained is that v stays finite and changes slowly at π.
* **Shadows lose digits** near the edge of a chart, where φ′ is 0 or infinite, and near 2π, where one pose has vectors
  in all directions: errors are those of the result times its condition, and the condition is what grows.
* **Which to take**: n = 2 for attitude and motion that may go over to its shadow (no trigonometry, no singular T below
  2π); the exponential where v has to be an angle; n = 3, 4 where v should stay finite and smooth well beyond π; n = 1
  where rotations stay well below π and composition has to be cheap; sine charts where |v| has to be bounded.

## Which φ keeps Re T nearest to a rotation?

The greatest of the singular values and of their inverses, over |α| ≤ A, is M. No φ has a smaller one than
√(A/2 / sin(A/2)): with 1/φ′ ≤ M it is φ(A) ≥ A/M, and with φ(A)/(2 sin(A/2)) ≤ M it is A/M ≤ 2 M sin(A/2). The angle
itself, divided by that M, reaches it; with φ′(0) = 1 it is approached by slopes that fall at once to 1/M, and reached
by none. Of the scaled charts 2n tan(α/2n) the limit n → ∞, the exponential, is best of those tried, with the square of
that M; odd polynomials go below it. Their coefficients were found by golden sections, M by evaluation at {points}
angles.

{best}
"""


def _markdown(compared: Sequence[Compared]) -> str:
    headings = _headings()
    cut = len(headings) - len(COUNTED)
    rows = [_cells(row) for row in compared]
    ends = [[*row[:cut], _singular(one)] for row, one in zip(rows, compared, strict=True)]
    shape = _table([*headings[:cut], "singular angles/π"], ends)
    cost = _table([headings[0], *COUNTED], [[r[0], *r[cut:]] for r in rows])
    return PAGE.format(shape=shape, cost=cost, points=POINTS, best="\n".join(_best()))


def _singular(row: Compared) -> str:
    return ", ".join(_number(float((angle / sympy.pi).evalf(10))) for angle in row.chart.singular_angles)


def _table(headings: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    lines = [headings, ["---"] * len(headings), *rows]
    return "\n".join(f"| {' | '.join(cell.replace('|', '&#124;') for cell in line)} |" for line in lines)


def _best() -> Iterator[str]:
    rows = []
    for name, angle in ANGLES.items():
        rows.append([name, "any (bound)", "", f"{bound(angle):.5f}"])
        rows += [[name, found.kind, f"`{found.phi}`", f"{found.worst:.5f}"] for found in best(angle)]
    yield _table(["A", "among", "--phi", "M"], rows)


FORMS = {"text": _text, "json": _json, "markdown": _markdown}


# --- plot -------------------------------------------------------------------------------------------------------------


def _plot(compared: Sequence[Compared], file: Path) -> None:
    """|v|, singular values and condition against the angle."""
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
