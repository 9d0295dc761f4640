"""``dualcay generate``, ``show`` and ``compare``: kernels, formulas and figures of charts."""

from __future__ import annotations

import json
from pathlib import Path

import click

from .. import about
from ..codegen import Package, build, catalogue
from ..maps.named import described
from ..output.shown import Grid, columns, figures
from ..pages import formulas
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
            found = build.check_charts(folder, charts, target, display.progress, max_n)
            display.differences(found, folder, options.without_check())
            raise click.exceptions.Exit(1 if found else 0)
        package = build.generate_charts(charts, target, folder, force, display.progress, cores())
    click.echo(summary(package, folder).text(columns()), nl=False)
    if not_compiled := [module.name for module in package.modules if module.counts.tested is None]:
        click.echo(f"no C compiler found (set CC), so validated as text only: {', '.join(not_compiled)}", err=True)


def summary(package: Package, folder: Path) -> Grid:
    """Return a table of the written modules: proofs, checked calls and lines, without columns of zeros."""
    columns = {
        "proofs": [len(module.proved.proofs) for module in package.modules],
        "calls validated": [module.counts.validated for module in package.modules],
        "replayed": [module.counts.replayed for module in package.modules],
        "compiled": [module.counts.tested or 0 for module in package.modules],
        "lines": [module.text.count("\n") for module in package.modules],
    }
    shown = {heading: numbers for heading, numbers in columns.items() if any(numbers)}
    rows = [[module.name, *(str(numbers[i] or "") for numbers in shown.values())]
            for i, module in enumerate(package.modules)]  # fmt: skip
    return figures(f"kernels in {folder}", ["module", *shown], rows)


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
    for chart in charts:
        if missing := ", ".join(name for name in what if not hasattr(chart, name)):
            raise click.BadParameter(f"only Cayley maps have {missing}, not {chart.name}", param_hint="--what")
    if form == "json":
        click.echo(json.dumps([formulas.as_json(chart, what) for chart in charts], indent=2))
        return
    for chart in charts:
        click.echo("\n".join(formulas.lines(chart, form, what)))


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
