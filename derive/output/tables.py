"""Tables as plain text: ruled where they fit, otherwise a line for each cell."""

from __future__ import annotations

import io
import shutil
import textwrap
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass

from rich.console import Console, JustifyMethod
from rich.measure import Measurement
from rich.table import Table

WIDTH = 120
"""Largest width of a table, and its width in files and pipes."""

INDENT = "  "


@dataclass(frozen=True)
class Column:
    """A column: numbers are aligned to the right; a width is fixed, or a share (``ratio``) of the rest."""

    heading: str
    number: bool = False
    width: int | None = None
    ratio: int | None = None


@dataclass(frozen=True)
class Grid:
    """A table before it has a width.

    Parameters
    ----------
    title, columns, rows
        The first cell of a row is its name.
    least : int, optional
        Smallest width of a ruled table; by default that of its longest words.
    ruled : bool
        Rules between rows.
    remarks : collection of str
        Names of rows that comment on the row before: their cells get no heading.
    """

    title: str
    columns: Sequence[Column]
    rows: Sequence[Sequence[str]]
    least: int | None = None
    ruled: bool = False
    remarks: Collection[str] = ()

    def text(self, width: int = WIDTH) -> str:
        """Return the table within a width."""
        screen = Console(file=io.StringIO(), width=width, highlight=False, color_system=None, markup=False, emoji=False)
        table = self._table()
        least = Measurement.get(screen, screen.options.update(width=10**6), table).minimum
        if width < (least if self.least is None else self.least):
            return "\n".join(self._lines(width)) + "\n"
        screen.print(table)
        output = screen.file
        assert isinstance(output, io.StringIO)
        return "\n".join(line.rstrip() for line in output.getvalue().splitlines()) + "\n"

    def _table(self) -> Table:
        table = Table(title=self.title, title_justify="left", show_lines=self.ruled)
        for column in self.columns:
            justify: JustifyMethod = "right" if column.number else "left"
            table.add_column(column.heading, justify=justify, width=column.width, ratio=column.ratio)
        for row in self.rows:
            table.add_row(*row)
        return table

    def _lines(self, width: int) -> Iterator[str]:
        yield from textwrap.wrap(self.title, width)
        headings = [column.heading for column in self.columns[1:]]
        for name, *cells in self.rows:
            yield from textwrap.wrap(name, width, subsequent_indent=INDENT)
            for heading, cell in zip(headings, cells, strict=True):
                line = " ".join([*([] if name in self.remarks else [f"{heading}:"]), *cell.split()])
                yield from textwrap.wrap(line, width, initial_indent=INDENT, subsequent_indent=2 * INDENT)


def columns() -> int:
    """Return the width of the screen (or ``COLUMNS``), at most `WIDTH`; `WIDTH` without a screen."""
    return min(shutil.get_terminal_size((WIDTH, 0)).columns, WIDTH)
