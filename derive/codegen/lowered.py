"""Programs of a chart: geometry programs that all charts share, and the chart's own scalar programs."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, lru_cache

from ..maps.chart import Chart
from ..proof import Proved
from .lowering.scalars import scalar_programs
from .programs.program import Program
from .programs.trace import written_out
from .rows import Table
from .signatures import POSES


def geometry(table: Table = POSES) -> Mapping[str, Program]:
    """Return a table's programs by name, for analyses, with called geometry programs written out.

    Scalar programs remain calls.
    """
    return _written_out(table)


@cache
def _written_out(table: Table) -> Mapping[str, Program]:
    return {name: written_out(row.traced()) for name, row in table.kernels.items()}


def printed_geometry(table: Table = POSES) -> Mapping[str, Program]:
    """Return the shared geometry programs by name, in print order: each follows the programs that it calls."""
    return _printed(table)


@cache
def _printed(table: Table) -> Mapping[str, Program]:
    found: dict[str, Program] = {}
    for row in table.kernels.values():
        _add(found, row.traced())
    return found


def shared_with_poses(table: Table) -> frozenset[str]:
    """Return the names of helper programs that a table shares with poses, which define them; empty for poses."""
    found, poses = printed_geometry(table), printed_geometry(POSES)
    same = (name for name in found.keys() - table.kernels.keys() if found[name] == poses.get(name))
    return frozenset() if table is POSES else frozenset(same)


def _add(found: dict[str, Program], program: Program) -> None:
    """Add a program, after the programs that it calls."""
    for called in program.called:
        _add(found, called)
    found.setdefault(program.name, program)


@dataclass(frozen=True)
class Lowered:
    """Scalar programs of one chart that the functions of a ``table`` call.

    ``operations`` counts the operations of every function that the chart has, including its scalars.
    """

    table: Table
    scalars: Mapping[str, Program]
    operations: Mapping[str, Counter[str]]


def lower(proved: Proved) -> Lowered:
    """Return the scalar programs and operation counts of a proved chart."""
    return lower_chart(proved.formulas)


def lower_chart(chart: Chart, table: Table = POSES) -> Lowered:
    """Return the scalar programs that a table's functions call, and the operation counts of the functions."""
    return _lowered(chart, table)


@lru_cache(maxsize=8)  # not on `lower_chart`: a default argument would make two cache keys
def _lowered(chart: Chart, table: Table) -> Lowered:
    scalars, counted, called = scalar_programs(chart), {}, set()
    for name, program in geometry(table).items():
        functions = {call.function for call in program.calls}
        if functions <= scalars.keys():
            called |= functions
            counted[name] = sum((scalars[call.function].operations for call in program.calls), program.operations)
    return Lowered(table, {name: program for name, program in scalars.items() if name in called}, counted)
