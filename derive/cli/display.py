"""Progress on stderr, and differences."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from ..output import Difference

FIRST_PAUSE = 10.0
"""Seconds before the first line of progress where there is no terminal; each further pause is twice as long."""

PAUSE_MAX = 60.0


@contextmanager
def progress(total: int) -> Iterator[Callable[[str], None]]:
    """Show a progress bar on a terminal, a line now and then elsewhere; each call names the step that begins."""
    with _bar(total) if sys.stderr.isatty() else _lines(total) as step:
        yield step


@contextmanager
def _bar(total: int) -> Iterator[Callable[[str], None]]:
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    with Progress(*columns, console=Console(stderr=True, highlight=False), transient=True) as bar:
        task = bar.add_task("", total=total, completed=-1)

        def step(line: str) -> None:
            bar.update(task, description=line, advance=1)

        yield step


@contextmanager
def _lines(total: int) -> Iterator[Callable[[str], None]]:
    """Print lines from a thread, since one step may be long."""
    begun, ended, lines, stream = time.monotonic(), threading.Event(), ["beginning"], sys.stderr

    def report() -> None:
        pause = FIRST_PAUSE
        while not ended.wait(pause):
            done = max(len(lines) - 2, 0)
            print(f"{time.monotonic() - begun:.0f} s: {done}/{total}  {lines[-1]}", file=stream, flush=True)
            pause = min(2 * pause, PAUSE_MAX)

    thread = threading.Thread(target=report, daemon=True)
    thread.start()
    try:
        yield lines.append
    finally:
        ended.set()
        thread.join()


def differences(found: list[Difference], command: str) -> None:
    """Print each difference as a diff, and the command that accepts them."""
    for difference in found:
        reason = f" ({difference.reason})" if difference.reason else ""
        click.echo(f"{difference.kind}: {difference.path}{reason}")
        click.echo(difference.diff, nl=False)
    click.echo(f"{len(found)} file(s) differ; accept with:  {command}", err=True)
