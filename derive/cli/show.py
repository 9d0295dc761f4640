"""``dualcay show``: the formulas of charts, or the formula sheet."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import click
import sympy

from .. import about
from ..algebra.latex import latex
from ..codegen import catalogue
from ..maps.chart import Chart
from ..pages.sheet_files import WRITERS
from . import options


def show(
    orders: tuple[int, ...], families: tuple[str, ...], phi: str | None, what: tuple[str, ...], form: str,
    output: Path | None, max_n: int,
) -> None:  # fmt: skip
    """Run the command; parameters are its options."""
    chosen = bool(orders or families or phi is not None)
    if what == (about.SHEET,):
        write = WRITERS.get(output.suffix) if output and form == "text" and not chosen else None
        if output is None or write is None:
            raise click.UsageError(f"the sheet needs -o with an ending {' or '.join(WRITERS)}, no chart, no --format")
        options.require_writable(output)
        write(output)
        return
    if output is not None:
        raise click.UsageError(f"-o names the file of the sheet: add --what {about.SHEET}")
    if not chosen:
        raise click.UsageError("Missing option '-n', '--family' or '--phi'.")
    options.require_cap(orders, max_n)
    with options.refusals("--family" if families else "-n"):
        charts = catalogue.charts(orders, families, phi, None if phi is None else "phi")
    found = [(chart, _formulas(chart, what)) for chart in charts]
    if form == "json":
        rows = ({**_label(chart), **{name: _terms(f) for name, f in given.items()}} for chart, given in found)
        click.echo(json.dumps(list(rows), indent=2))
        return
    for chart, given in found:
        click.echo("\n".join(_lines(chart, given, form)))


def _formulas(chart: Chart, what: tuple[str, ...]) -> dict[str, Any]:
    """Return the formulas with these names, by default all of the chart; a usage error for a name that it lacks."""
    if missing := ", ".join(name for name in what if not hasattr(chart, name)):
        raise click.BadParameter(f"only Cayley maps have {missing}, not {chart.name}", param_hint="--what")
    return {name: getattr(chart, name) for name in what or about.FORMULAS if hasattr(chart, name)}


def _label(chart: Chart) -> dict[str, Any]:
    """Return the order of a Cayley map, or name and φ of another chart."""
    return {"n": chart.order} if chart.selection[0] == "-n" else {"name": chart.name, "phi": _text(chart.written)}


def _terms(value: Any) -> str | dict[str, str]:
    """Return a polynomial as text, or the coefficients of another formula by basis element."""
    if isinstance(value, sympy.Expr):
        return _text(value)
    basis = ("1", "v") if value.name == "quaternion" else ("I", "skew(v)", "v⊗v")
    return dict(zip(basis, map(_text, value.coefficients), strict=True))


def _lines(chart: Chart, formulas: dict[str, Any], form: str) -> Iterator[str]:
    heading = ", ".join(f"{key} = {value}" for key, value in _label(chart).items())
    if form != "latex":
        yield heading if form == "text" else f"## {heading}\n"
    for name, value in formulas.items():
        if form == "text":
            terms = _terms(value)
            if isinstance(terms, str):
                yield f"  {name}_{chart.order} = {terms}"
            else:
                yield f"  {name} = {' + '.join(f'({factor}) {basis}' for basis, factor in terms.items())}"
            continue
        formula = f"{name}_{{{chart.order}}} = {latex(value)}" if isinstance(value, sympy.Expr) else value.latex()
        yield f"$${formula}$$\n" if form == "markdown" else formula


def _text(expression: sympy.Expr) -> str:
    return str(sympy.sstr(expression, order="rev-lex"))
