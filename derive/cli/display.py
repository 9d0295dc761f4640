"""What a person sees beside the results: progress and messages, on stderr, and differences."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

import click
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

if TYPE_CHECKING:
    from ..codegen import Difference, Package

SPARSE = 10.0
"""Seconds before the first line of progress where there is no terminal; each pause is then twice as long, up to a
minute: what watches a run takes long silence for its end."""
LONGEST_PAUSE = 60.0


@contextmanager
def progress(total: int) -> Iterator[Callable[[str], None]]:
    """A progress bar on a terminal's stderr, a line now and then elsewhere; each call names the step that begins."""
    screen = Console(stderr=True, highlight=False, soft_wrap=True)
    with _bar(screen, total) if screen.is_terminal else _lines(total) as step:
        yield step


@contextmanager
def _bar(screen: Console, total: int) -> Iterator[Callable[[str], None]]:
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    with Progress(*columns, console=screen, transient=True) as bar:
        task = bar.add_task("", total=total)
        done = -1

        def step(line: str) -> None:
            nonlocal done
            done += 1
            bar.update(task, description=line, completed=done)

        yield step


@contextmanager
def _lines(total: int) -> Iterator[Callable[[str], None]]:
    """Lines from a thread of their own, since one step may be long."""
    begun, ended = time.monotonic(), threading.Event()
    done, current = -1, "beginning"

    def step(line: str) -> None:
        nonlocal done, current
        done, current = done + 1, line

    def report() -> None:
        pause = SPARSE
        while not ended.wait(pause):
            print(f"{time.monotonic() - begun:.0f} s: {max(done, 0)}/{total}  {current}", file=stream, flush=True)
            pause = min(2 * pause, LONGEST_PAUSE)

    stream = sys.stderr
    thread = threading.Thread(target=report, daemon=True)
    thread.start()
    try:
        yield step
    finally:
        ended.set()
        thread.join()


def not_compiled(package: Package) -> None:
    """Say which modules no compiler has seen: as text they compute their formulas, but their tests did not run."""
    names = [module.name for module in package.modules if module.tested is None]
    if names:
        found = f"no C compiler found (set CC), so validated as text only: {', '.join(names)}"
        click.echo(found, err=True)


def differences(found: list[Difference], command: str) -> None:
    """Print each difference as a diff, and the command that accepts them."""
    for difference in found:
        reason = f" ({difference.reason})" if difference.reason else ""
        click.echo(f"{difference.kind}: {difference.path}{reason}")
        if difference.diff:
            click.echo(difference.diff, nl=False)
    click.echo(f"{len(found)} file(s) differ; accept with:  {command}", err=True)
