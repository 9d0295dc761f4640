"""Tasks for tests of processes: one never ends on its own, one waits for another process; the module imports little."""

from __future__ import annotations

import os
import tempfile
import time
from pathlib import Path


def stay(folder: Path) -> None:
    """Create a temporary file, write its name to ``folder/<pid>``, and sleep; on interrupt, create ``interrupted``."""
    _, name = tempfile.mkstemp()
    (folder / str(os.getpid())).write_text(name)
    try:
        time.sleep(60)
    except KeyboardInterrupt:
        (folder / "interrupted").touch()


def meet(folder: Path) -> bool:
    """Create a file in a folder, and tell whether a second process does so within a minute."""
    (folder / str(os.getpid())).touch()
    end = time.monotonic() + 60
    while len([*folder.iterdir()]) < 2 and time.monotonic() < end:
        time.sleep(0.02)
    return len([*folder.iterdir()]) == 2
