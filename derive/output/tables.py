"""Tables as plain text: ruled if they fit the width, otherwise with a line for each cell."""

from __future__ import annotations

import io
import shutil
import textwrap
from collections.abc import Collection, Iterator, Sequence
from typing import NamedTuple

from rich.console import Console
from rich.measure import Measurement
from rich.table import Table

WIDTH = 120
"""Largest width of a table, and the width in files and pipes."""

class Column(NamedTuple):
    """Column of a table, aligned to the right for numbers; its width is fixed, or a share (``ratio``) of the rest."""

    heading: str
    number: bool = False
    width: int | None = None
    ratio: int | None = None


class Grid(NamedTuple):
    """Table without a fixed width; the first cell of a row is the name of the row.

    The table becomes lines on a screen narrower than ``least``, by default the width of the longest words. ``ruled``
    puts rules between rows. Rows named in ``remarks`` comment on the row before, and their cells get no heading.
    """

    title: str
    columns: Sequence[Column]
    rows: Sequence[Sequence[str]]
    least: int | None = None
    ruled: bool = False
    remarks: Collection[str] = ()

    def text(self, width: int = WIDTH) -> str:
        """Return the table as text within a width."""
        output, table = io.StringIO(), self._table()
        screen = Console(file=output, width=width, highlight=False, color_system=None, markup=False, emoji=False)
        least = Measurement.get(screen, screen.options.update(width=10**6), table).minimum
        if width < (least if self.least is None else self.least):
            return "\n".join(self._lines(width)) + "\n"
        screen.print(table)
        return "\n".join(line.rstrip() for line in output.getvalue().splitlines()) + "\n"

    def _table(self) -> Table:
        table = Table(title=self.title, title_justify="left", show_lines=self.ruled)
        for heading, number, width, ratio in self.columns:
            table.add_column(heading, justify="right" if number else "left", width=width, ratio=ratio, overflow="fold")
        for row in self.rows:
            table.add_row(*row)
        return table

    def _lines(self, width: int) -> Iterator[str]:
        yield from textwrap.wrap(self.title, width)
        headings = [column.heading for column in self.columns[1:]]
        for name, *cells in self.rows:
            yield from textwrap.wrap(name, width, subsequent_indent="  ")
            for heading, cell in zip(headings, cells, strict=True):
                line = " ".join([*([] if name in self.remarks else [f"{heading}:"]), *cell.split()])
                yield from textwrap.wrap(line, width, initial_indent="  ", subsequent_indent="    ")


def figures(title: str, headings: Sequence[str], rows: Sequence[Sequence[str]]) -> Grid:
    """Return a table whose columns, except the first, are numbers."""
    return Grid(title, [Column(headings[0]), *(Column(heading, number=True) for heading in headings[1:])], rows)


def columns() -> int:
    """Return the width of the screen (or ``COLUMNS``), at most `WIDTH`; `WIDTH` without a screen."""
    return min(shutil.get_terminal_size((WIDTH, 0)).columns, WIDTH)
