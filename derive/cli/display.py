"""Progress on stderr, and differences of files on stdout."""

from __future__ import annotations

import time
from contextlib import AbstractContextManager, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING

import click

from ..output.shown import Step, bar, one_line, watched

if TYPE_CHECKING:
    from ..output import Difference

FIRST_PAUSE = 10.0
"""Seconds before the first line of progress without a terminal; each further pause is twice the previous one."""

PAUSE_MAX = 60.0


def progress(total: int) -> AbstractContextManager[Step]:
    """Provide a function that reports the next step: in a progress bar on a terminal, in occasional lines elsewhere."""
    return bar(total) if watched() else nullcontext(_lines(total))


def _lines(total: int) -> Step:
    begun, pause, done = time.monotonic(), FIRST_PAUSE, -1
    due = begun + pause

    def step(line: str) -> None:
        nonlocal pause, due, done
        done, now = done + 1, time.monotonic()
        if now >= due:
            click.echo(f"{now - begun:.0f} s: {done}/{total}  {one_line(line)}", err=True)
            pause = min(2 * pause, PAUSE_MAX)
            due = now + pause

    return step


def differences(found: list[Difference], place: Path, command: str) -> None:
    if not found:
        click.echo(f"{place}: up to date", err=True)
        return
    for difference in found:
        reason = f" ({difference.reason})" if difference.reason else ""
        click.echo(f"{difference.kind}: {difference.path}{reason}")
        click.echo(difference.diff, nl=False)
    click.echo(f"{len(found)} file(s) differ; accept with:  {command}", err=True)
