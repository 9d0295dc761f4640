"""Compile and run the differential test of a C header; read extension modules as a compiler does."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sysconfig
from collections.abc import Iterable
from pathlib import Path

from ...maps.chart import Chart
from ...workers import SlowError, run, scratch
from .batches import ValidationFailed

TYPES = ("double", "float")
COMPILERS = ("cc", "gcc", "clang")
SECONDS = 300
"""Processor time that the compiler, and then the test, may take."""

FLAGS = ("-std=c99", "-DDUALCAY_CORE=static inline")
"""Flags without an optimisation, with cores that are not inlined: compilation takes most of the time, and an eighth.

Tests compile with -O2 and inlined cores.
"""


def compiler() -> list[str] | None:
    """Return the command of a C compiler: the value of CC, else the first one found, else None."""
    named = shlex.split(os.environ.get("CC", ""))
    for command in [named] if named else [[name] for name in COMPILERS]:
        if shutil.which(command[0]):
            return command
    return None


def test(folder: Path, chart: Chart) -> int | None:
    """Run the differential test of a chart in both real types; return the agreeing calls, None without a compiler."""
    command = compiler()
    if command is None:
        return None
    source = folder / f"test_{chart.name}.c"
    with scratch() as build:
        return sum(_run(command, source, real, build / real) for real in TYPES)


def require_modules(folder: Path, sources: Iterable[str]) -> None:
    """Require extension modules that a compiler understands in all types, where one is found with Python's headers."""
    import numpy as np

    command, headers = compiler(), [sysconfig.get_path("include"), np.get_include()]
    if command is None or not Path(headers[0], "Python.h").is_file():
        return
    flags = ["-std=c99", "-fsyntax-only", "-Werror=implicit", *(f"-isystem{header}" for header in headers)]
    for source in sources:
        for real in ("float", "long double"):
            _compile(command, folder / source, real, flags)
        _compile(command, folder / source, "double", [*flags, "-DDUALCAY_IS_MODULE"])


def _compile(command: list[str], source: Path, real: str, flags: Iterable[str]) -> None:
    made = _limited([*command, *flags, f"-DDUALCAY_REAL={real}", str(source), "-lm"], source, real)
    if made.returncode:
        raise ValidationFailed(f"{source.name} does not compile ({real}):\n{made.stderr.strip()}")


def _limited(command: list[str], source: Path, real: str) -> subprocess.CompletedProcess[str]:
    """Run a command within `SECONDS` of processor time."""
    try:
        return run(command, SECONDS)
    except SlowError as error:
        raise ValidationFailed(f"{source.name} ({real}): {error}") from None


def _run(command: list[str], source: Path, real: str, program: Path) -> int:
    _compile(command, source, real, [*FLAGS, "-o", str(program)])
    ran = _limited([str(program)], source, real)
    found = re.search(r": (\d+) calls agree", ran.stdout)
    if ran.returncode or not found:
        lines = [line for line in ran.stdout.splitlines() if "FAILED" in line]
        raise ValidationFailed(f"{source.name} ({real}), exit {ran.returncode}:\n" + "\n".join(lines))
    return int(found.group(1))
