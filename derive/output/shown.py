"""Results and progress on screens: lists of results, progress bars on stderr, and tables as plain text."""

from __future__ import annotations

import html
import io
import shutil
import sys
import textwrap
import threading
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager, nullcontext
from typing import NamedTuple, Protocol, TypeVar


class Shown(Protocol):
    """Result that fills one row of a table."""

    def cells(self) -> Mapping[str, str]:
        """Return texts by heading; a formula is LaTeX between ``$``, which notebooks and sites typeset."""


T = TypeVar("T", bound=Shown)


class Listing(list[T]):
    """List shown with a line for each result, and as a table in notebooks."""

    def __repr__(self) -> str:
        items = ",\n ".join(map(repr, self))
        return f"[{items}]"

    def _repr_html_(self) -> str:
        rows = [item.cells() for item in self]
        lines = [_row("th", rows[0])] if rows else []
        lines += [_row("td", row.values()) for row in rows]
        return "\n".join(['<table class="mathjax_process">', *lines, "</table>"])


def _row(kind: str, texts: Iterable[str]) -> str:
    cells = (f'<{kind} style="text-align: left">{_in_html(text)}</{kind}>' for text in texts)
    return f"<tr>{''.join(cells)}</tr>"


def _in_html(text: str) -> str:
    r"""Return a cell in HTML; a formula stands between ``\(`` and ``\)``, which MathJax finds in sites too."""
    return html.escape(rf"\({text[1:-1]}\)" if text.startswith("$") and text.endswith("$") else text)


UNSEEN = dict.fromkeys((
    *range(9), *range(11, 32), *range(127, 160), *range(0x202A, 0x202F), *range(0x2066, 0x206A), *range(0xD800, 0xE000),
), "\ufffd")  # fmt: skip
"""Signs that a terminal obeys, that turn the order of text, or that UTF-8 lacks, with the sign shown for each."""


def seen(text: str) -> str:
    """Return a text with another sign for each that may do more than be seen."""
    return text.translate(UNSEEN)


def one_line(text: str) -> str:
    """Return a text in one line, as `seen`."""
    return seen(" ".join(text.split()))


BAR_AFTER = 2.0
"""Seconds before a bar appears."""

Step = Callable[[str], None]
"""Function that reports the next step by a line of text."""

Progress = Callable[[int], AbstractContextManager[Step]]
"""Function that provides a `Step`, for a number of steps."""


def watched() -> bool:
    """Tell whether stderr is shown at once: on a terminal, or in a notebook."""
    shell = sys.modules["IPython"].get_ipython() if "IPython" in sys.modules else None
    return sys.stderr.isatty() or hasattr(shell, "kernel")


@contextmanager
def bar(total: int | None = None) -> Iterator[Step]:
    """Provide a function that reports the next of all steps, in a bar that appears after `BAR_AFTER` seconds.

    Nothing appears without a terminal or a notebook, or with ``TTY_INTERACTIVE=0`` in the environment.
    """
    if not watched():
        yield no_op
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    # In a notebook rich would need widgets; there a line that returns to its start serves as on a terminal.
    console = Console(stderr=True, highlight=False, force_terminal=True, force_jupyter=False)
    if not console.is_interactive:
        yield no_op
        return
    columns = (TextColumn("{task.description}", markup=False), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    shown = Progress(*columns, console=console, transient=True, redirect_stdout=False)
    task = shown.add_task("", total=total, completed=-1)
    later = threading.Timer(BAR_AFTER, shown.start)
    later.daemon = True
    later.start()
    try:
        yield lambda line: shown.update(task, description=line, advance=1)
    finally:
        later.cancel()
        later.join()
        shown.stop()


def no_op(line: str) -> None:
    """No-op progress callback."""


def silent(total: int) -> AbstractContextManager[Step]:
    return nullcontext(no_op)


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
        from rich.console import Console
        from rich.measure import Measurement
        from rich.table import Table

        output, table = io.StringIO(), Table(title=self.title, title_justify="left", show_lines=self.ruled)
        for heading, number, fixed, ratio in self.columns:
            table.add_column(heading, justify="right" if number else "left", width=fixed, ratio=ratio, overflow="fold")
        for row in self.rows:
            table.add_row(*row)
        screen = Console(file=output, width=width, highlight=False, color_system=None, markup=False, emoji=False)
        least = Measurement.get(screen, screen.options.update(width=10**6), table).minimum
        if width < (least if self.least is None else self.least):
            return "\n".join(self._lines(width)) + "\n"
        screen.print(table)
        return "\n".join(line.rstrip() for line in output.getvalue().splitlines()) + "\n"

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
