"""``dualcay generate``: write kernels, or check the ones on disk."""

from __future__ import annotations

from pathlib import Path

import click

from ..codegen import Package, catalogue, generate_charts
from ..codegen.compiler import check_charts as check_folder
from ..codegen.compiler import expected
from ..maps import PhiError
from ..maps.named import described
from ..output.tables import Column, Grid, columns
from ..workers import cores
from . import display, options

WRITTEN, CHECKED = 4, 2
"""Lines of progress for each module: what is checked is proved and printed, and not executed."""

FEW = 3
"""Charts that are not worth processes: the first, with all of the geometry, takes as long as the others."""

HEADINGS = ("theorems", "proofs at n", "calls validated", "replayed", "compiled", "lines")


def generate(
    orders: tuple[int, ...],
    families: tuple[str, ...],
    phi: str | None,
    name: str | None,
    target: str,
    output: Path | None,
    check: bool,
    force: bool,
    max_n: int,
) -> None:
    """Do what the command says; its parameters are the options."""
    options.require_cap(orders, max_n)
    if (phi is None) != (name is None):
        raise click.UsageError("--phi and --name belong together")
    try:
        charts = catalogue.charts(orders, families, phi, name) or catalogue.committed()
    except PhiError as error:
        raise click.BadParameter(str(error), param_hint="--phi") from None
    except ValueError as error:
        raise click.BadParameter(str(error), param_hint="--family" if phi is None else "--name") from None
    if phi is not None and (known := described(charts[0])):
        click.echo(f"dualcay: phi = {phi} is the chart {known}: its programs and proofs are used", err=True)
    if output is None and not catalogue.has_place(target):
        raise click.UsageError(f"name a folder with -o: only {catalogue.TARGET} kernels have a place, in a checkout")
    folder = output or catalogue.COMMITTED
    try:
        printed, unmade = expected(folder, charts, target, max_n) if check else (charts, {})
        with display.progress((CHECKED if check else WRITTEN) * len(printed)) as step:
            if check:
                found = check_folder(folder, printed, unmade, target, step)
            else:
                processes = cores() if len(charts) > FEW else 1
                package = generate_charts(charts, target, folder, force=force, progress=step, processes=processes)
    except PhiError as error:
        raise click.BadParameter(str(error), param_hint="--phi") from None
    if not check:
        click.echo(written(package, folder).text(columns()), nl=False)
        display.not_compiled(package)
    elif found:
        display.differences(found, options.unchecked())
        raise click.exceptions.Exit(1)


def written(package: Package, folder: Path) -> Grid:
    """What was proved and written, a row per module."""
    rows = []
    for module in package.modules:
        proofs = module.proved.proofs
        general = sum(proof.scope == "all n" for proof in proofs)
        lines = module.text.count("\n")
        counts = (general, len(proofs) - general, module.validated, module.replayed or "-", module.tested or "-", lines)
        rows.append((module.name, *map(str, counts)))
    return Grid(f"kernels in {folder}", [Column("module"), *(Column(name, number=True) for name in HEADINGS)], rows)
