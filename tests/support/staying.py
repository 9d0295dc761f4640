"""Task that never ends on its own, for tests of processes that must be ended; the module imports little."""

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
