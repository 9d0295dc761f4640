"""Replace files of a folder; a process killed at any moment leaves the old files, the new files, or a notice.

All new files are staged first. One rename marks them ready; then they move to their places one by one. After a kill,
the next run that finds ready files moves the rest. Meanwhile a notice replaces the file that a user of the folder
reads first. Loss of power is not covered.
"""

from __future__ import annotations

import os
import shutil
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

STAGED, READY, LOCK = ".dualcay-staged", ".dualcay-ready", ".dualcay-lock"
LEFTOVERS = frozenset({STAGED, READY, LOCK})
"""Names that a killed process can leave in a folder, until the next process writes there."""


@contextmanager
def locked(folder: Path) -> Iterator[None]:
    """Wait until no other process holds the folder, then hold it; Windows has no such lock."""
    if sys.platform == "win32":
        yield
        return
    import fcntl

    path = folder / LOCK
    while True:
        handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o644)
        fcntl.flock(handle, fcntl.LOCK_EX)
        if os.fstat(handle).st_nlink:
            break
        os.close(handle)  # the previous holder removed this file: wait for the new one
    try:
        yield
    finally:
        path.unlink(missing_ok=True)
        os.close(handle)


def encoded(content: str | bytes) -> bytes:
    """Return the bytes of a file."""
    return content.encode("utf-8") if isinstance(content, str) else content


def exchange(folder: Path, texts: Mapping[str, str | bytes], notices: Mapping[str, str]) -> None:
    """Replace files of a locked folder; ``notices`` are temporary texts of some files until all others are in place."""
    body = {name: text for name, text in texts.items() if name not in notices}
    staged = folder / STAGED
    try:
        for step, files in enumerate((notices, body, {name: texts[name] for name in notices})):
            for name, text in files.items():
                path = staged / str(step) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(encoded(text))
        staged.rename(folder / READY)
    except BaseException:
        shutil.rmtree(staged, ignore_errors=True)
        raise
    finish(folder)


def finish(folder: Path) -> None:
    """Move ready files to their places in a locked folder, and delete staged files."""
    if (folder / STAGED).exists():
        shutil.rmtree(folder / STAGED)
    ready = folder / READY
    if not ready.exists():
        return
    for step in sorted(ready.iterdir()):
        for path in sorted(path for path in step.rglob("*") if path.is_file()):
            place = folder / path.relative_to(step)
            place.parent.mkdir(parents=True, exist_ok=True)
            os.replace(path, place)
    shutil.rmtree(ready)
