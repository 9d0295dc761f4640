"""Runs of the command ``dualcay``, in this process or in a new one."""

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
    """Result of one run of the command line."""

    returncode: int
    stdout: str
    stderr: str


def dualcay(*arguments: str, cwd: Path = ROOT) -> Done:
    """Run the entry point in this process, with captured output; exceptions that it does not catch are raised."""
    out, err = (io.TextIOWrapper(io.BytesIO(), "utf-8", newline="\n") for _ in range(2))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sys, "argv", ["dualcay", *arguments])
        patch.setenv("NO_COLOR", "1")
        patch.setattr("derive.cli.display.FIRST_PAUSE", 3600.0)  # no progress lines
        patch.setattr("derive.cli.charts.cores", lambda: 1)  # other processes would not see what tests replace
        patch.chdir(cwd)
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            code = main()
    texts = []
    for stream in (out, err):
        stream.seek(0)
        texts.append(stream.read())
    return Done(code, *texts)


def in_a_process(*arguments: str, code: str | None = None, errors: str = "strict", **variables: str) -> Done:
    """Run ``python -m derive``, or given code, in a new process with these environment variables."""
    start = ["-m", "derive"] if code is None else ["-c", code]
    env = {**os.environ, "PYTHONPATH": str(ROOT), "NO_COLOR": "1", **variables}
    command = [sys.executable, *start, *arguments]
    done = subprocess.run(command, cwd=ROOT, env=env, capture_output=True, encoding="utf-8", errors=errors, check=False)
    assert "Traceback" not in done.stderr
    return Done(done.returncode, done.stdout, done.stderr)
