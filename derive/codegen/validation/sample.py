"""What of a further chart is executed: geometry that another chart of the package has shown to be right only as needed.

Geometry is the same for all charts and stands once in a package. Whichever chart runs a program of it first runs it on
all cases. Of a later chart as many functions are run as read every result of its own scalars, and those that it says
have nothing to do. So what a chart costs does not grow with the number of functions.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence, Set
from dataclasses import dataclass, field

from ...maps.chart import Chart
from ..cases import Batch, batches
from ..lowered import Lowered, geometry, lower_chart
from ..programs.program import Program
from ..rows import Function, Table

TABLE = "table"
"""The argument of a program that takes a turn, or all returns, of the chart."""


Choose = Callable[[Lowered, Sequence[Batch]], Sequence[tuple[Batch, bool]]]
"""Which of the batches of a lowered chart are executed, and whether in every layout."""


def everything(lowered: Lowered, given: Sequence[Batch]) -> Sequence[tuple[Batch, bool]]:
    """All batches, in every layout."""
    return [(batch, True) for batch in given]


@dataclass(frozen=True, slots=True)
class Seen:
    """Programs of geometries that have been executed on all cases, by table; grows as charts are validated."""

    by_table: dict[str, set[str]] = field(default_factory=dict)

    def programs(self, table: Table) -> set[str]:
        """Those of the geometry of a table."""
        return self.by_table.setdefault(table.name, set())

    def new(self, lowered: Lowered, given: Sequence[Batch]) -> list[tuple[Batch, bool]]:
        """The batches of a lowered chart that are still to be executed, and whether in every layout."""
        programs = self.programs(lowered.table)
        wanted, shown = {*_readers(lowered), *_standing(lowered)}, programs
        unseen = [bool(_executed(batch, lowered) - shown) for batch in given]
        for batch in given:
            programs.update(_executed(batch, lowered))
        pairs = zip(given, unseen, strict=True)
        return [(batch, new) for batch, new in pairs if new or _samples(batch, wanted, lowered.table)]

    def leave(self, chart: Chart, tables: Sequence[Table]) -> None:
        """Leave a chart to another process: all that is new in it is executed there."""
        for table in tables:
            self.new(lower_chart(chart, table), batches(chart, table))


def its_own(lowered: Lowered) -> set[str]:
    """Functions of a chart that together read every result of its scalar programs."""
    return set(_readers(lowered))


def _samples(batch: Batch, wanted: Set[str], table: Table) -> bool:
    """Whether a batch is of a wanted function: on the principal branch, on others where it takes their turns itself."""
    return batch.function in wanted and (_principal(batch) or _takes_table(batch.row, table))


def _principal(batch: Batch) -> bool:
    return not any(batch.branch)


def _takes_table(row: Function, table: Table) -> bool:
    return TABLE in dict(geometry(table)[row.kernel].inputs)


def _executed(batch: Batch, lowered: Lowered) -> set[str]:
    """What a call of a function on a branch runs: its program, a turn after it, or nothing at all."""
    row, table = batch.row, lowered.table
    programs = {row.kernel}
    if row.branch and _takes_table(row, table) and _principal(batch):
        return {f"{batch.function}: v stands"}
    if row.branch and not _takes_table(row, table) and not _principal(batch):
        programs |= table.kernels.keys() - table.public.keys()
    return {name if name in lowered.operations else f"{name}: v stands" for name in programs}


def _readers(lowered: Lowered) -> Iterator[str]:
    """Functions that together read every result of every scalar program."""
    read: set[tuple[str, int]] = set()
    table = lowered.table
    for name in table.kernels:
        shared = name in table.public and name in lowered.operations
        found = set(_results(geometry(table)[name])) if shared else set()
        if found - read:
            read |= found
            yield name


def _standing(lowered: Lowered) -> Set[str]:
    """Functions that have nothing to do for this chart: v is its own result."""
    return {name for name, row in lowered.table.public.items() if row.kernel not in lowered.operations}


def _results(program: Program) -> Iterator[tuple[str, int]]:
    """The results of scalar programs that a program reads, by place."""
    operands = program.operands
    for call in program.calls:
        yield from ((call.function, place) for place, name in enumerate(call.names) if name in operands)
