"""Compile and run the differential test of a C header, and count the calls that agree."""

from __future__ import annotations

import os
import re
import shlex
import shutil
from pathlib import Path

from ...maps.chart import Chart
from ...scratch import scratch
from ...workers import SlowError, run
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


def _run(command: list[str], source: Path, real: str, program: Path) -> int:
    flags = [*FLAGS, f"-DDUALCAY_REAL={real}", str(source), "-o", str(program), "-lm"]
    try:
        made = run([*command, *flags], SECONDS)
        if made.returncode:
            raise ValidationFailed(f"{source.name} does not compile ({real}):\n{made.stderr.strip()}")
        ran = run([str(program)], SECONDS)
    except SlowError as error:
        raise ValidationFailed(f"{source.name} ({real}): {error}") from None
    found = re.search(r": (\d+) calls agree", ran.stdout)
    if ran.returncode or not found:
        lines = [line for line in ran.stdout.splitlines() if "FAILED" in line]
        raise ValidationFailed(f"{source.name} ({real}), exit {ran.returncode}:\n" + "\n".join(lines))
    return int(found.group(1))
