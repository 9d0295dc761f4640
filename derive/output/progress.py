"""Progress bars on stderr, on a terminal and in a notebook."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext

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
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
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
    """Provide a function that reports nothing."""
    return nullcontext(no_op)
