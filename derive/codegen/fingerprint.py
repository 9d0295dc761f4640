"""What tells whether two packages hold the same programs, whatever their targets."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Mapping, Sequence
from functools import cache

from .facts import Facts
from .lowered import Lowered, geometry
from .programs.program import Call, Program, Statement
from .rows import Table

DIGITS = 16


def fingerprint(facts: Facts, lowered: Lowered) -> str:
    """Hexadecimal digits of a digest of all that a chart computes for a table: programs, arrays, tables of branches."""
    lines = [*_of_geometry(lowered.table), *_lines(lowered.scalars)]
    rows = lowered.table.kernels.values()
    lines += [f"{row.name} {row.arguments} {row.results} {row.constants}" for row in rows]
    lines += [f"{facts.turns} {facts.returns}"]
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()[:DIGITS]


@cache  # the same for all charts
def _of_geometry(table: Table) -> Sequence[str]:
    return tuple(_lines(geometry(table)))


def _lines(programs: Mapping[str, Program]) -> Iterator[str]:
    for name, program in programs.items():
        yield f"{name} {program.inputs} -> {program.outputs}"
        yield from map(_line, program.statements)


def _line(statement: Statement) -> str:
    """A set has no order of its own."""
    if isinstance(statement, Call):
        return f"{statement.names} {statement.function} {statement.args} {statement.rest} {sorted(statement.truths)}"
    return f"{statement.name} {statement.op} {statement.args}"
