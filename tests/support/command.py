"""The command ``dualcay`` as a person runs it, in this process or in one of its own."""

from __future__ import annotations

import contextlib
import io
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

from derive.__main__ import main

ROOT = Path(__file__).parents[2]


@dataclass(frozen=True)
class Done:
    """What a run came to."""

    returncode: int
    stdout: str
    stderr: str


def dualcay(*arguments: str, cwd: Path = ROOT) -> Done:
    """Run the entry point here, on pipes of its own; what it does not catch, fails the test."""
    out, err = (io.TextIOWrapper(io.BytesIO(), "utf-8", newline="\n") for _ in range(2))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sys, "argv", ["dualcay", *arguments])
        patch.setenv("NO_COLOR", "1")
        patch.setattr("derive.cli.display.FIRST_PAUSE", 3600.0)  # no lines of progress
        patch.chdir(cwd)
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            code = main()
    texts = []
    for stream in (out, err):
        stream.seek(0)
        texts.append(stream.read())
    return Done(code, *texts)


def in_a_process(*arguments: str, code: str | None = None, errors: str = "strict", **variables: str) -> Done:
    """Run ``python -m derive``, or some code in its place, as a process with these environment variables."""
    start = ["-m", "derive"] if code is None else ["-c", code]
    env = {**os.environ, "PYTHONPATH": str(ROOT), "NO_COLOR": "1", **variables}
    command = [sys.executable, *start, *arguments]
    done = subprocess.run(
        command, cwd=ROOT, env=env, capture_output=True, encoding="utf-8", errors=errors, check=False
    )
    assert "Traceback" not in done.stderr
    return Done(done.returncode, done.stdout, done.stderr)
