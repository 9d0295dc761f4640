"""All programs of a chart: the geometry it shares with every other one, its scalars, and what is better its own."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Set
from dataclasses import dataclass
from fractions import Fraction
from functools import cache

from ..maps.chart import Chart
from ..proof import Proved
from .lowering.scalars import scalar_programs
from .programs.program import Call, Program
from .signatures import KERNELS

WORTH = 0.92
"""The share of a function's operations that its own program must stay below, to be worth its lines."""

LINES = 2
"""So many operations of an own program, each a line or two, may be printed for one that is saved."""



@cache
def geometry() -> Mapping[str, Program]:
    """The programs that all charts share, by name; scalars of the chart are calls in them."""
    return {name: row.traced() for name, row in KERNELS.items()}


@dataclass(frozen=True)
class Lowered:
    """The programs of one chart: the scalars that geometry asks for, and functions that do without geometry's program.

    ``operations`` counts those of every function, its scalars included.
    """

    scalars: Mapping[str, Program]
    own: Mapping[str, Program]
    operations: Mapping[str, Counter[str]]


def lower(proved: Proved) -> Lowered:
    """Every program of a proved chart."""
    return lower_chart(proved.formulas)


def lower_chart(chart: Chart) -> Lowered:
    """A function has a program of its own where knowing the chart saves operations worth mentioning.

    So it does where scalars are constant (h = 0 for n = 1) or equal (g = h for n = 2). A constant that is no integer,
    or becomes none, leaves no choice: a call could not return it in every number type.
    """
    scalars = scalar_programs(chart)
    own, counted, called = {}, {}, set()
    for name, shared in geometry().items():
        functions = {call.function for call in shared.calls}
        if not functions <= scalars.keys():
            continue
        program = KERNELS[name].traced(chart)
        operations = sum((scalars[call.function].operations for call in shared.calls), shared.operations)
        needed = any(_is_fractional(scalars[function]) for function in functions) or _divides_constants(shared, scalars)
        if needed or is_worth(program.operations.total(), operations.total()):
            own[name], operations = program, program.operations
        else:
            called |= functions
        counted[name] = operations
    return Lowered({name: program for name, program in scalars.items() if name in called}, own, counted)


def _divides_constants(program: Program, scalars: Mapping[str, Program], given: Set[str] = frozenset()) -> bool:
    """Whether integers which scalars return are divided, by a program or what it calls: that would make a float."""
    constants = set(given)
    for statement in program.statements:
        fixed = [not isinstance(arg, str) or arg in constants for arg in statement.args]
        if isinstance(statement, Call):
            called = scalars[statement.function]
            names = [name for _, group in called.inputs for name in group]
            if _divides_constants(called, scalars, {name for name, known in zip(names, fixed) if known}):
                return True
            pairs = zip(statement.names, called.outputs, strict=True)
            constants.update(name for name, output in pairs if not isinstance(output, str))
        elif all(fixed):
            if statement.op == "div":
                return True
            constants.add(statement.name)
    return False


def is_worth(own: int, shared: int) -> bool:
    """Whether a program of so many operations is worth its lines, where geometry's takes so many."""
    return own < WORTH * shared and shared - own > own / LINES


def _is_fractional(program: Program) -> bool:
    """Whether a scalar program returns a constant that is no integer."""
    return any(isinstance(output, Fraction) and output.denominator != 1 for output in program.outputs)
