"""All programs of a chart: the geometry it shares with every other one, its scalars, and what is better its own."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache

from ..maps.chart import Chart
from ..proof import Proved
from .lowering.scalars import scalar_programs
from .programs.program import Program
from .signatures import KERNELS

WORTH = 0.92
"""The share of a function's operations that its own program must stay below, to be worth its lines."""


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

    So it does where scalars are constant (h = 0 for n = 1) or equal (g = h for n = 2). A constant that is no integer
    leaves no choice: a call could not return it in every number type.
    """
    scalars = scalar_programs(chart)
    own, counted, called = {}, {}, set()
    for name, shared in geometry().items():
        functions = {call.function for call in shared.calls}
        if not functions <= scalars.keys():
            continue
        program = KERNELS[name].traced(chart)
        operations = sum((scalars[call.function].operations for call in shared.calls), shared.operations)
        fractional = any(_is_fractional(scalars[function]) for function in functions)
        if fractional or program.operations.total() < WORTH * operations.total():
            own[name], operations = program, program.operations
        else:
            called |= functions
        counted[name] = operations
    return Lowered({name: program for name, program in scalars.items() if name in called}, own, counted)


def _is_fractional(program: Program) -> bool:
    """Whether a scalar program returns a constant that is no integer."""
    return any(isinstance(output, Fraction) and output.denominator != 1 for output in program.outputs)
