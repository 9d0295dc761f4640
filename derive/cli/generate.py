"""``dualcay generate``: write kernels, or check the kernels on disk."""

from __future__ import annotations

from pathlib import Path

import click

from ..codegen import Package, catalogue, publish
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
        folder = publish.place(output, target)
    with options.refusals():
        if check:
            if found := publish.check_charts(folder, charts, target, display.progress, max_n):
                display.differences(found, options.without_check())
            raise click.exceptions.Exit(1 if found else 0)
        package = publish.generate_charts(charts, target, folder, force, display.progress, cores())
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
