"""``dualcay compare``: what parameterizations are like, side by side, as tables, numbers, a page or a plot."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from pathlib import Path

import click

from ..codegen import catalogue
from ..maps import PhiError
from ..maps.any_phi.stretch import Stretch
from ..output.tables import Column, Grid, columns
from . import compare_page, compare_plot, options
from .compared import ANGLES, COUNTED, Compared, errors, number, times

NAME = "phi"


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
        compare_plot.write(compared, plot)


def _text(compared: Sequence[Compared]) -> str:
    """Without singular values one by one, for which a line is too short."""
    headings = ["chart", "φ", "edge/π", *(f"{name} cond" for name in ANGLES), *COUNTED]
    rows = []
    for row in compared:
        conditions = [number(found.condition if found else None) for found in row.stretches.values()]
        counts = map(number, row.operations.values())
        rows.append([row.chart.name, row.chart.parameter, number(row.edge / math.pi), *conditions, *counts])
    tables = (
        ("condition of Re T by angle, and operations", (headings, rows)),
        ("errors in eps by angle, as measured", errors(compared)),
        ("nanoseconds for a pose of N, as measured", times(compared)),
    )
    return "".join(_grid(title, *table) for title, table in tables if table[1])


def _grid(title: str, headings: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    first, *rest = headings
    return Grid(title, [Column(first), *(Column(name, number=True) for name in rest)], rows).text(columns())


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
            "measured": row.measured,
        }
        for row in compared
    ]
    return json.dumps(entries, indent=2, ensure_ascii=False) + "\n"


FORMS = {"text": _text, "json": _json, "markdown": compare_page.page}
