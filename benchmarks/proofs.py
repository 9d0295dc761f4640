"""Processor time of proving, printing and checking by order.

Checking means validation on exact numbers, without replay on floats or compiled tests. Each row runs in a fresh
process, so that nothing is cached. Importing the toolkit does not count.
"""

from __future__ import annotations

import statistics
import subprocess
import sys

from rich.console import Console
from rich.table import Table

from derive.codegen.targets import TARGETS

CASES = (
    ("numpy", (1, 2, 3, 4, 5, 6, 7, 8), 8.0),
    ("numpy", (16,), None),
    ("numpy", (64,), 8.0),
    ("c", (3,), None),
)
"""Rows of the table: target, orders, and limit in seconds."""

REPEATS = 3

ROAD = """
import os, sys
from contextlib import nullcontext
from derive.codegen.build import build
from derive.codegen.targets import TARGETS
from derive.maps import Cayley
def spent_now():
    return sum(os.times()[:4])
marks = []
def report(line):
    marks.append((spent_now(), line))
start = spent_now()
kind = type(TARGETS[sys.argv[1]])
target = type(kind.__name__, (kind,), {"replay": lambda *_: 0, "test": lambda *_: 0})()
build([Cayley(int(n)) for n in sys.argv[2:]], target, lambda _: nullcontext(report))
end = spent_now()
spent = dict.fromkeys(("proving", "printing", "checking"), 0.0)
for (t, line), (after, _) in zip(marks, [*marks[1:], (end, "")]):
    spent[line.split(": ")[1].replace("checked", "proving")] += after - t
print(*spent.values(), end - start)
"""


def run(target: str, orders: tuple[int, ...]) -> list[float]:
    """Return seconds of proving, of printing, of checking and in total: medians of fresh processes."""
    rows = []
    for _ in range(REPEATS):
        command = [sys.executable, "-c", ROAD, target, *map(str, orders)]
        done = subprocess.run(command, capture_output=True, text=True, check=True)
        rows.append([float(word) for word in done.stdout.split()])
    return [statistics.median(column) for column in zip(*rows, strict=True)]


def judged(seconds: float, limit: float | None) -> str:
    """Return the limit as text, with a mark if it is exceeded."""
    return "" if limit is None else f"{limit:.1f}" + ("" if seconds <= limit else "  FALLS SHORT")


def main() -> None:
    """Print the table, and mark exceeded limits."""
    stages = ("proving", "printing", "checking", "all (s)")
    table = Table("target", "n", "functions", *stages, "limit")
    for target, orders, limit in CASES:
        functions = sum(len(rows.public) for rows in TARGETS[target].tables)
        seconds = run(target, orders)
        label = str(orders[0]) if len(orders) == 1 else f"{orders[0]}-{orders[-1]}"
        found = (f"{value:.2f}" for value in seconds)
        table.add_row(target, label, str(functions), *found, judged(seconds[-1], limit))
    Console().print(table)


if __name__ == "__main__":
    main()
