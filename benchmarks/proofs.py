"""Time of the road by order: prove, emit, validate, replay on floats, with python-flint and with SymPy alone.

Of the NumPy target, and of C, whose text an interpreter executes; there the replay is the compiler's test.

Each row is a fresh process, so that nothing is cached; the import of the toolkit is not counted.

Limits were set when a module had 19 functions; they grow with their number, which the table names.
"""

from __future__ import annotations

import importlib.util
import statistics
import subprocess
import sys

from rich.console import Console
from rich.table import Table

from derive.codegen.targets import TARGETS

CASES = (
    ("numpy", (1, 2, 3, 4, 5, 6, 7, 8), 4.0, None),
    ("numpy", (16,), None, None),
    ("numpy", (64,), 3.0, 30.0),
    ("c", (3,), None, None),
)
"""Target, orders, most seconds of the processor that ``SET_FOR`` functions of these may take with python-flint and with
SymPy alone, replay apart."""

SET_FOR = 19
"""How many functions a module had when the limits were set."""

REPEATS = 3

ROAD = """
import os, sys
if sys.argv[1] == "sympy":
    sys.modules["flint"] = None
from derive.codegen import build
from derive.codegen.targets import TARGETS
def spent_now():
    return sum(os.times()[:4])
marks = []
start = spent_now()
build(map(int, sys.argv[3:]), TARGETS[sys.argv[2]], lambda line: marks.append((spent_now(), line)))
end = spent_now()
spent = dict.fromkeys(("proving", "emitting", "validating", "replaying"), 0.0)
for (t, line), (after, _) in zip(marks, [*marks[1:], (end, "")]):
    spent[line.split(": ")[1]] += after - t
print(*spent.values(), end - start - spent["replaying"])
"""


def run(backend: str, target: str, orders: tuple[int, ...]) -> list[float]:
    """Seconds proving, emitting, validating, replaying, and in all but the replay: medians of fresh processes."""
    rows = []
    for _ in range(REPEATS):
        command = [sys.executable, "-c", ROAD, backend, target, *map(str, orders)]
        done = subprocess.run(command, capture_output=True, text=True, check=True)
        rows.append([float(word) for word in done.stdout.split()])
    return [statistics.median(column) for column in zip(*rows, strict=True)]


def judged(seconds: float, limit: float | None, functions: int) -> str:
    """The limit for so many functions, and whether it is passed."""
    if limit is None:
        return ""
    most = limit * functions / SET_FOR
    return f"{most:.1f}" + ("" if seconds <= most else "  FALLS SHORT")


def main() -> None:
    """Print the table, and which limit falls short."""
    backends = [name for name in ("flint", "sympy") if name == "sympy" or importlib.util.find_spec("flint")]
    stages = ("proving", "emitting", "validating", "replaying", "all but that (s)")
    table = Table("target", "n", "backend", "functions", *stages, "limit")
    for target, orders, *limits in CASES:
        functions = sum(len(rows.public) for rows in TARGETS[target].tables)
        for backend in backends:
            seconds = run(backend, target, orders)
            verdict = judged(seconds[-1], limits[backend == "sympy"], functions)
            label = str(orders[0]) if len(orders) == 1 else f"{orders[0]}-{orders[-1]}"
            table.add_row(target, label, backend, str(functions), *(f"{value:.2f}" for value in seconds), verdict)
    Console().print(table)


if __name__ == "__main__":
    main()
