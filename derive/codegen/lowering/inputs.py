"""Arguments of programs and their component names; a trailing ``o`` marks a dual part, as ° does in the formulas."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...algebra import Vector
from ..programs.trace import Trace
from ..programs.value import Number


def dual_vector(trace: Trace, argument: str, letter: str) -> tuple[Number, ...]:
    """Six components: real part, then dual part."""
    return trace.inputs(argument, [f"{letter}{i}{mark}" for mark in ("", "o") for i in (1, 2, 3)])


def vector(trace: Trace, argument: str, letter: str) -> Vector:
    """Three real components."""
    return Vector(*trace.inputs(argument, [f"{letter}{i}" for i in (1, 2, 3)]))


def flat(rows: Iterable[Iterable[Number]]) -> Iterator[Number]:
    """Entries of a matrix in C order."""
    for row in rows:
        yield from row
