"""All programs of a chart: the geometry it shares with every other one, its scalars, and what is better its own."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

from ..maps.chart import Chart
from ..proof import Proved
from .program import Program
from .signatures import KERNELS
from .lowering.point import Geometry
from .lowering.scalars import scalar_programs

WORTH = 1.0
"""A function has a program of its own in a chart when that takes less than this share of the operations."""


@cache
def geometry() -> Mapping[str, Program]:
    """The programs that all charts share, by name; scalars of the chart are calls in them."""
    return {name: row.recipe(Geometry()) for name, row in KERNELS.items() if row.recipe}


@dataclass(frozen=True)
class Lowered:
    """The programs of one chart: its scalars, and the functions whose whole program is shorter than geometry's.

    Where scalars are constant (h = 0 for n = 1) or equal (g = h for n = 2), geometry that knows them does less.
    """

    scalars: Mapping[str, Program]
    own: Mapping[str, Program]

    def operations(self, name: str) -> Counter[str]:
        """How often each operation occurs in a function, its scalars included."""
        if name in self.own:
            return self.own[name].operations
        program = geometry()[name]
        return sum((self.scalars[call.function].operations for call in program.calls), program.operations)

    def counted(self) -> dict[str, Counter[str]]:
        """The operations of every function, by name."""
        programs = geometry().items()
        held = (name for name, program in programs if all(call.function in self.scalars for call in program.calls))
        return {name: self.operations(name) for name in held}


def lower(proved: Proved) -> Lowered:
    """Every program of a proved chart."""
    return lower_chart(proved.formulas)


def lower_chart(chart: Chart) -> Lowered:
    shared = Lowered(scalar_programs(chart), {})
    own = {}
    for name, operations in shared.counted().items():
        program = KERNELS[name].recipe(Geometry(chart))
        if program.operations.total() < WORTH * operations.total():
            own[name] = program
    return Lowered(shared.scalars, own)
