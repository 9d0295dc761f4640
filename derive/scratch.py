"""Temporary folders, which the next run removes if their process was killed.

This module loads only the standard library: worker processes need it before they load other libraries.
"""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

NEW, PREFIX = ".dualcay-new-", ".dualcay-scratch-"
"""Beginnings of the names of folders, before and after their process has locked them."""


@contextmanager
def scratch() -> Iterator[Path]:
    """Provide an empty temporary folder; first remove those of processes that were killed.

    Its process locks the folder. The system drops the lock when the process ends, however it ends. Windows has no such
    lock: there the folder of a killed process stays.
    """
    if sys.platform == "win32":
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as name:
            yield Path(name)
        return
    import fcntl

    _sweep()
    new = Path(tempfile.mkdtemp(prefix=NEW))
    handle = os.open(new, os.O_RDONLY)
    with suppress(OSError):  # a file system without locks: nothing there is swept
        fcntl.flock(handle, fcntl.LOCK_EX)
    folder = new.rename(new.with_name(new.name.replace(NEW, PREFIX)))
    try:
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)
        os.close(handle)


def _sweep() -> None:
    """Remove the folders that no process holds."""
    if sys.platform != "win32":
        import fcntl

        for folder in Path(tempfile.gettempdir()).glob(f"{PREFIX}*"):
            with suppress(OSError):  # its process lives, or it is another user's
                handle = os.open(folder, os.O_RDONLY | os.O_NOFOLLOW)
                try:
                    fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
                    shutil.rmtree(folder)
                finally:
                    os.close(handle)
