"""Programs of a proved chart: geometry programs that all charts share, and the chart's own scalar programs."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, lru_cache

from ..maps.chart import Chart
from ..proof import Proved
from .lowering.scalar_programs import scalar_programs
from .programs.program import Program
from .programs.trace import written_out
from .rows import Table
from .signatures import POSES, ROTATIONS


@cache
def geometry(table: Table = POSES) -> Mapping[str, Program]:
    """Return the geometry programs of a table by name. Geometry programs that they call are written out."""
    return {name: written_out(row.traced()) for name, row in table.kernels.items()}


@cache
def printed_geometry(table: Table = POSES) -> Mapping[str, Program]:
    """Return the shared geometry programs by name, in print order: each follows the programs that it calls."""
    found: dict[str, Program] = {}

    def add(program: Program) -> None:
        for called in program.called:
            add(called)
        found.setdefault(program.name, program)

    for row in table.kernels.values():
        add(row.traced())
    return found


def shared_with_poses(table: Table) -> frozenset[str]:
    """Return the names of helper programs that are equal for a table and for poses; empty for poses."""
    found, poses = printed_geometry(table), printed_geometry(POSES)
    same = (name for name in found.keys() - table.kernels.keys() if found[name] == poses.get(name))
    return frozenset() if table is POSES else frozenset(same)


@dataclass(frozen=True, slots=True)
class ChartPrograms:
    """Scalar programs of one chart that the functions of a ``table`` call."""

    table: Table
    scalars: Mapping[str, Program]
    operations: Mapping[str, Counter[str]]  # operations of each function, its scalars included


@lru_cache(maxsize=8)
def lower_chart(chart: Chart, table: Table = POSES) -> ChartPrograms:
    """Return the scalar programs that a table's functions call, and the operation counts of the functions."""
    scalars, counted, called = scalar_programs(chart), {}, set()
    for name, program in geometry(table).items():
        functions = {call.function for call in program.calls}
        if functions <= scalars.keys():
            called |= functions
            counted[name] = sum((scalars[call.function].operations for call in program.calls), program.operations)
    return ChartPrograms(table, {name: program for name, program in scalars.items() if name in called}, counted)


@dataclass(frozen=True, slots=True)
class Lowered:
    """Proved chart with its programs for poses and for rotations alone."""

    proved: Proved
    poses: ChartPrograms
    rotations: ChartPrograms

    @property
    def chart(self) -> Chart:
        return self.proved.formulas

    @property
    def name(self) -> str:
        return self.chart.name


def lower(proved: Proved) -> Lowered:
    """Lower a proved chart: trace its formulas as programs."""
    return Lowered(proved, lower_chart(proved.formulas, POSES), lower_chart(proved.formulas, ROTATIONS))
