"""Write files into copies of folders; in each copy, the process is killed before another step.

    python killed.py TEXTS NOTICES FOLDER ROOT [FOLDER ROOT ...]

ROOT/0, ROOT/1, ... become copies of FOLDER. A process writes TEXTS with NOTICES (both JSON) into each copy. It is
killed before the first step in the first copy, before the second step in the second, and not in the last. A step is a
change of a file or a folder that Python's audit hook reports, or the middle of writing a text.
"""

from __future__ import annotations

import itertools
import json
import os
import shutil
import signal
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from derive.output import write

EVENTS = {"os.rename", "os.mkdir", "os.remove", "os.rmdir", "fcntl.flock", "half"}


def killed(step: int, folder: Path, texts: dict[str, str], notices: dict[str, str]) -> bool:
    """Write in a child process; return whether the process reached the step and was killed."""
    child = os.fork()
    if not child:
        _kill_at(step)
        write(folder, texts, notices=notices)
        os._exit(0)
    status = os.waitpid(child, 0)[1]
    assert status in (0, signal.SIGKILL), status
    return status != 0


def _kill_at(step: int) -> None:
    steps = itertools.count()
    write_bytes = Path.write_bytes

    def hook(event: str, arguments: Sequence[Any]) -> None:
        opened = event == "open" and arguments[2] & (os.O_WRONLY | os.O_RDWR)
        if (opened or event in EVENTS) and next(steps) == step:
            os.kill(os.getpid(), signal.SIGKILL)

    def in_two_halves(path: Path, content: bytes) -> int:
        write_bytes(path, content[: len(content) // 2])
        hook("half", ())
        return write_bytes(path, content)

    Path.write_bytes = in_two_halves  # type: ignore[assignment, method-assign]
    sys.addaudithook(hook)


def main(texts: str, notices: str, *folders: str) -> None:
    for old, root in zip(folders[::2], folders[1::2], strict=True):
        for step in itertools.count():
            folder = Path(root) / str(step)
            shutil.copytree(old, folder, symlinks=True)
            if not killed(step, folder, json.loads(texts), json.loads(notices)):
                break


if __name__ == "__main__":
    main(*sys.argv[1:])
