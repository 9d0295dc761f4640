"""``dualcay compare``: parameterizations side by side."""

from __future__ import annotations

from pathlib import Path

import click

from ..pages import comparison
from ..pages.comparison_forms import FORMS, draw
from . import display, options


def compare(
    orders: tuple[int, ...], families: tuple[str, ...], phi: str | None, plot: Path | None, form: str, max_n: int
) -> None:
    """Run the command; parameters are its options."""
    options.require_cap(orders, max_n)
    with options.refusals("--family"):
        chosen = comparison.charts(orders, families, phi)
        with display.progress(len(chosen)) as step:
            rows = comparison.compared(chosen, step)
        click.echo(FORMS[form](rows), nl=False)
    for refusal in filter(None, (row.refusal for row in rows)):
        click.echo(f"dualcay: {refusal}", err=True)
    if plot is not None:
        try:
            draw(rows, plot)
        except ImportError:
            raise click.UsageError("--plot needs matplotlib: pip install 'dualcay[bench]'") from None
