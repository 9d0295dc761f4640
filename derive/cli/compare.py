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
    """Raise an error if a plot cannot be drawn or written, before any work."""
    try:
        from matplotlib.backend_bases import FigureCanvasBase
    except ImportError:
        raise click.UsageError("--plot needs matplotlib: pip install matplotlib") from None
    endings = FigureCanvasBase.get_supported_filetypes()
    if file.suffix[1:].lower() not in endings:
        raise click.BadParameter(f"expected an ending out of {', '.join(endings)}, got {file.name!r}")
    options.require_writable(file)
