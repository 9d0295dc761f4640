"""Time of the road by order: prove, emit, validate, replay on floats, with python-flint and with SymPy alone.

Each row is a fresh process, so that nothing is cached; the import of the toolkit is not counted.
"""

from __future__ import annotations

import importlib.util
import statistics
import subprocess
import sys

from rich.console import Console
from rich.table import Table

CASES = (((1, 2, 3, 4, 5, 6, 7, 8), 4.0, None), ((16,), None, None), ((64,), 3.0, 30.0))
"""Orders, and the most seconds of the processor they may take with python-flint and with SymPy alone, replay apart."""

REPEATS = 3

ROAD = """
import sys, time
if sys.argv[1] == "sympy":
    sys.modules["flint"] = None
from derive.codegen import build
from derive.codegen.targets import TARGETS
marks = []
start = time.process_time()
build(map(int, sys.argv[2:]), TARGETS["numpy"], lambda line: marks.append((time.process_time(), line)))
end = time.process_time()
spent = dict.fromkeys(("proving", "emitting", "validating", "replaying"), 0.0)
for (t, line), (after, _) in zip(marks, [*marks[1:], (end, "")]):
    spent[line.split(": ")[1]] += after - t
print(*spent.values(), end - start - spent["replaying"])
"""


def run(backend: str, orders: tuple[int, ...]) -> list[float]:
    """Seconds proving, emitting, validating, replaying, and in all but the replay: medians of fresh processes."""
    rows = []
    for _ in range(REPEATS):
        command = [sys.executable, "-c", ROAD, backend, *map(str, orders)]
        done = subprocess.run(command, capture_output=True, text=True, check=True)
        rows.append([float(word) for word in done.stdout.split()])
    return [statistics.median(column) for column in zip(*rows, strict=True)]


def main() -> None:
    """Print the table, and which limit falls short."""
    backends = [name for name in ("flint", "sympy") if name == "sympy" or importlib.util.find_spec("flint")]
    table = Table("n", "backend", "proving", "emitting", "validating", "replaying", "all but that (s)", "limit")
    for orders, *limits in CASES:
        for backend in backends:
            seconds = run(backend, orders)
            limit = limits[backend == "sympy"]
            verdict = "" if limit is None else f"{limit:g}" + ("" if seconds[-1] <= limit else "  FALLS SHORT")
            label = str(orders[0]) if len(orders) == 1 else f"{orders[0]}-{orders[-1]}"
            table.add_row(label, backend, *(f"{value:.2f}" for value in seconds), verdict)
    Console().print(table)


if __name__ == "__main__":
    main()
