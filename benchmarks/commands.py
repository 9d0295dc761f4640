"""Processor time of commands, measured and written into pages by ``python -m benchmarks.commands [NAME ...]``.

A page holds the number behind a comment with the name of the command, such as ``<!-- own-phi -->18 s``.
"""

from __future__ import annotations

import re
import resource
import shlex
import subprocess
import sys
from pathlib import Path

from derive.output import files
from derive.workers import scratch

ROOT = Path(__file__).parents[1]
PAGES = (ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs" / "howto").glob("*.md")))
COMMANDS = {
    "own-phi": "generate --phi 'alpha/(1 + alpha**2/40)' --name mine -o kernels",
    "one-chart": "generate -n 3 -o kernels",
    "one-chart-array-api": "generate -n 3 --target array-api -o kernels",
    "one-chart-c": "generate -n 3 --target c -o kernels",
    "two-charts-c": "generate -n 2,3 --target c -o kernels",
    "two-charts-matlab": "generate -n 2,3 --target matlab -o kernels",
}
"""Commands of `dualcay` by name."""
PLACE = re.compile(r"(<!-- ([\w-]+) -->)(\d+) s\b")


def seconds(command: str) -> float:
    """Return the processor time of a command and of the processes that it starts, in an empty folder."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with scratch() as folder:
        call = [sys.executable, "-m", "derive", *shlex.split(command)]
        subprocess.run(call, cwd=folder, check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def write(found: dict[str, float]) -> None:
    """Write measured times in whole seconds into the pages."""
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        told = PLACE.sub(lambda at: f"{at[1]}{found[at[2]]:.0f} s" if at[2] in found else at[0], text)
        if told != text:
            files.write(page.parent, {page.name: told}, force=True)


if __name__ == "__main__":
    write({name: seconds(COMMANDS[name]) for name in sys.argv[1:] or COMMANDS})
