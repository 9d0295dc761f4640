"""NumPy functions in C: the headers of the target `c`, with a NumPy loop around every core.

The package is a separate distribution, ``dualcay-native``, with an extension module per chart; an inner folder holds
the modules for rotations alone. Modules of the target `numpy` check arguments and choose branches. The compiled
functions, if installed, replace the array operations of the modules; their last array holds the table's numbers.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from ... import about
from ...maps.chart import Chart
from ..package import Data, Facts, fingerprint
from ..programs.program import Program
from ..rows import Function, Table, inside
from ..signatures import TABLE, geometry
from ..validation import c_text, compiled
from . import c99
from .c import C

PACKAGE = "dualcay_native"  # import name of the built package
MOST_AXES = 3
UNROLLED = 36  # components in a loop that is written out; with 72, gcc 12 makes compose_jacobians 1.7 times as slow


@dataclass(frozen=True, slots=True)
class LoopArray:
    """Array of a loop: its name, its component axes, and the index of its first component step."""

    name: str
    shape: tuple[int, ...]
    steps: int

    @property
    def size(self) -> int:
        return math.prod(self.shape)

    @property
    def counts(self) -> str:
        return ", ".join(map(str, (*self.shape, 1, 1, 1)[:MOST_AXES]))


def loop(row: Function, program: Program) -> Data:
    """Return the loop around the core of a kernel: NumPy's signature, the arrays, and the arguments of the core."""
    table = next((len(names) for argument, names in program.inputs if argument == TABLE), 0)
    given = [(array.name.lower(), array.shape) for array in row.arguments] + [(TABLE, (table,))] * bool(table)
    *arguments, result = operands = list(_operands([*given, ("made", row.shape)]))
    *taken, made = (f"({','.join(map(str, array.shape))})" for array in operands)
    return {
        "name": row.name,
        "signature": f"{','.join(taken)}->{made}",
        "arguments": arguments,
        "result": result,
        "operands": operands,
        "passed": c99.filled(_passed(row, table)),
    }


def _operands(arrays: list[tuple[str, tuple[int, ...]]]) -> Iterator[LoopArray]:
    """Yield the arrays; among the steps, batch steps of all arrays precede component steps."""
    place = len(arrays)
    for name, shape in arrays:
        yield LoopArray(name, shape, place)
        place += len(shape)


def _passed(row: Function, table: int) -> Iterator[str]:
    """Yield the arguments, the numbers of the table, and the results, which are stored side by side."""
    for array in row.arguments:
        yield from (f"{array.name.lower()}.at + j", f"{array.name.lower()}.by")
    yield from (f"{TABLE}.at[{index} * {TABLE}.by + j]" for index in range(table))
    for start in itertools.accumulate((array.size for array in row.results[:-1]), initial=0):
        yield from (f"made.at + {start} * made.by + j", "made.by")


class Native(C):
    """Target of compiled NumPy functions."""

    name = "native"
    entry = "meson.build"

    def shared(self) -> Mapping[str, Callable[[], Data]]:
        headers = {name: make for name, make in super().shared().items() if name.endswith(".h")}
        further = [table.name for table in self.tables if table.name]
        return {
            **headers,
            "tiles.h": self.tiles,
            "direct.h": dict,
            **{inside(t, "loops.h"): partial(self.loops, t) for t in self.tables},
            "gufuncs.h": partial(dict, package=PACKAGE),
            **{inside(table, "__init__.py"): dict for table in self.tables},
            **{f"{name}/meson.build": partial(dict, place=f"{PACKAGE}/{name}") for name in further},
            "meson.build": partial(dict, version=about.__version__, place=PACKAGE, folders=further),
            "meson.options": dict,
            "pyproject.toml": dict,
        }

    def loops(self, table: Table) -> Data:
        found = [loop(table.kernels[name], program) for name, program in geometry(table).items()]
        return {"loops": found, "up": "../" * bool(table.name)}

    def tiles(self) -> Data:
        """Return sizes of arrays, the most arrays and axes of a loop, and the most components that are written out."""
        every = [each["operands"] for table in self.tables for each in self.loops(table)["loops"]]
        sizes = sorted({array.size for operands in every for array in operands})
        most = {"most": sizes[-1], "operands": max(map(len, every)), "axes": MOST_AXES}
        return {**most, "sizes": sizes, "unrolled": UNROLLED}

    def companions(self, facts: Facts) -> dict[str, tuple[str, Data]]:
        """Return the headers of the chart for further tables, and the extension modules for all tables."""
        found = super().companions(facts)
        for programs in (facts.lowered.poses, facts.lowered.rotations):
            data = {
                "name": facts.chart.name,
                "prefix": c_text.prefix(facts.chart, programs.table),
                "programs": fingerprint(facts, programs),
                "up": "../" * bool(programs.table.name),
            }
            found[inside(programs.table, f"{facts.chart.name}.c")] = ("module.c", data)
        return found

    def test(self, folder: Path, chart: Chart) -> int | None:
        """Run the differential test of the headers, after the extension modules are read by the compiler."""
        compiled.require_modules(folder, [inside(table, f"{chart.name}.c") for table in self.tables])
        return super().test(folder, chart)
