"""``dualcay generate``, ``show`` and ``compare``: kernels, formulas and figures of charts."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import click
import sympy

from .. import about
from ..algebra.latex import latex
from ..codegen import Package, build, catalogue
from ..maps.chart import Chart
from ..maps.named import described
from ..output.shown import Grid, columns, figures
from ..workers import cores
from . import display, options


def generate(
    orders: tuple[int, ...], families: tuple[str, ...], phi: str | None, name: str | None, target: str,
    output: Path | None, check: bool, force: bool, max_n: int,
) -> None:  # fmt: skip
    """Run the command; parameters are its options."""
    options.require_cap(orders, max_n)
    if (phi is None) != (name is None):
        raise click.UsageError("--phi and --name belong together")
    with options.refusals("--family" if phi is None else "--name"):
        charts = catalogue.charts(orders, families, phi, name) or catalogue.committed()
    if phi is not None and (known := described(charts[0])):
        click.echo(f"dualcay: phi = {phi} is the chart {known}: its programs and proofs are used", err=True)
    with options.refusals("-o"):
        folder = build.place(output, target)
    with options.refusals():
        if check:
            if found := build.check_charts(folder, charts, target, display.progress, max_n):
                display.differences(found, options.without_check())
            raise click.exceptions.Exit(1 if found else 0)
        package = build.generate_charts(charts, target, folder, force, display.progress, cores())
    click.echo(summary(package, folder).text(columns()), nl=False)
    if not_compiled := [module.name for module in package.modules if module.counts.tested is None]:
        click.echo(f"no C compiler found (set CC), so validated as text only: {', '.join(not_compiled)}", err=True)


def summary(package: Package, folder: Path) -> Grid:
    """Return a table of the written modules: a row for each, with its numbers of proofs, checked calls and lines."""
    rows = []
    for module in package.modules:
        proofs, counts = module.proved.proofs, module.counts
        general = sum(proof.scope == "all n" for proof in proofs)
        called = (counts.validated, counts.replayed or "-", counts.tested or "-")
        rows.append((module.name, *map(str, (general, len(proofs) - general, *called, module.text.count("\n")))))
    headings = ("module", "theorems", "proofs at n", "calls validated", "replayed", "compiled", "lines")
    return figures(f"kernels in {folder}", headings, rows)


def show(
    orders: tuple[int, ...], families: tuple[str, ...], phi: str | None, what: tuple[str, ...], form: str,
    output: Path | None, max_n: int,
) -> None:  # fmt: skip
    """Run the command; parameters are its options."""
    chosen = bool(orders or families or phi is not None)
    if what == (about.SHEET,):
        from ..pages.sheet_files import WRITERS

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


def compare(
    orders: tuple[int, ...], families: tuple[str, ...], phi: str | None, plot: Path | None, form: str, max_n: int
) -> None:
    """Run the command; parameters are its options."""
    from ..pages import comparison
    from ..pages.comparison_forms import FORMS, draw

    options.require_cap(orders, max_n)
    if plot is not None:
        _require_plot(plot)
    with options.refusals("--family"):
        chosen = comparison.charts(orders, families, phi)
        with display.progress(len(chosen)) as step:
            rows = comparison.compared(chosen, step)
        click.echo(FORMS[form](rows), nl=False)
    for refusal in filter(None, (row.refusal for row in rows)):
        click.echo(f"dualcay: {refusal}", err=True)
    if plot is not None:
        draw(rows, plot)


def _require_plot(file: Path) -> None:
    try:
        from matplotlib.backend_bases import FigureCanvasBase
    except ImportError:
        raise click.UsageError("--plot needs matplotlib: pip install matplotlib") from None
    endings = FigureCanvasBase.get_supported_filetypes()
    if file.suffix[1:].lower() not in endings:
        raise click.BadParameter(f"expected an ending out of {', '.join(endings)}, got {file.name!r}")
    options.require_writable(file)
