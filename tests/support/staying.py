"""Tasks for tests of processes: two never end, one waits for another process; the module imports little."""

from __future__ import annotations

import os
import tempfile
import time
from collections.abc import Callable
from pathlib import Path


def stay(folder: Path) -> None:
    """Create a temporary file, write its name to ``folder/<pid>``, and sleep; on interrupt, create ``interrupted``."""
    _, name = tempfile.mkstemp()
    (folder / str(os.getpid())).write_text(name)
    try:
        while True:
            time.sleep(60)
    except KeyboardInterrupt:
        (folder / "interrupted").touch()


def meet(folder: Path) -> int:
    """Create a file in a folder, wait until a second process does so, and return the identity of this process."""
    (folder / str(os.getpid())).touch()
    until(lambda: len([*folder.iterdir()]) == 2)
    return os.getpid()


def until(reached: Callable[[], object]) -> None:
    """Wait until a condition holds, for as long as it takes: a busy machine fails no test."""
    while not reached():
        time.sleep(0.02)
