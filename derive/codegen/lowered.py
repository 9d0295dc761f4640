"""All programs of a chart: the geometry it shares with every other one, its scalars, and what is better its own."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Set
from dataclasses import dataclass
from functools import cache, lru_cache
from types import MappingProxyType

from ..maps.chart import Chart
from ..proof import Proved
from .lowering.scalars import scalar_program, scalar_programs
from .programs.program import Call, Operand, Program, Step
from .rows import Table
from .signatures import POSES, ROTATIONS

WORTH = 0.92
"""The share of a function's operations that its own program must stay below, to be worth its lines."""

LINES = 3
"""So many operations of an own program, each a line or two, may be printed for one that is saved."""


def geometry(table: Table = POSES) -> Mapping[str, Program]:
    """The programs that all charts share, by name; scalars of the chart are calls in them."""
    return _traced(table)


@cache
def _traced(table: Table) -> Mapping[str, Program]:
    return {name: row.traced() for name, row in table.kernels.items()}


@dataclass(frozen=True)
class Lowered:
    """The programs of one chart: the scalars that geometry asks for, and functions that do without geometry's program.

    They are those of the functions of a ``table``. ``operations`` counts those of every function, its scalars included.
    """

    table: Table
    scalars: Mapping[str, Program]
    own: Mapping[str, Program]
    operations: Mapping[str, Counter[str]]


def lower(proved: Proved) -> Lowered:
    """Every program of a proved chart."""
    return lower_chart(proved.formulas)


def lower_chart(chart: Chart, table: Table = POSES) -> Lowered:
    """A function of the table has a program of its own where knowing the chart saves operations worth their lines.

    So it may where scalars that it reads are constant (h = 0 for n = 1, h_i = 1 for n = 2) or computed of the same (the
    angle, of any φ). Of rotations such savings count that poses have as well: slopes which calls return in vain are not
    worth lines.
    """
    return _lowered(chart, table)


@lru_cache(maxsize=8)  # behind the default: the cache would take the same table, given or not, for two
def _lowered(chart: Chart, table: Table) -> Lowered:
    saving = table.functions if table is POSES else lower_chart(chart).own
    scalars, own, counted, called = _scalars(chart), {}, {}, set()
    for name, shared in geometry(table).items():
        functions = {call.function for call in shared.calls}
        if not functions <= scalars.keys():
            continue
        operations = sum((scalars[call.function].operations for call in shared.calls), shared.operations)
        program = None
        if table.functions[name].source in saving and _may_save(shared, scalars):
            program = table.kernels[name].traced(chart)
        if program and is_worth(program.operations.total(), operations.total()):
            own[name], operations = program, program.operations
        else:
            called |= functions
        counted[name] = operations
    return Lowered(table, {name: program for name, program in scalars.items() if name in called}, own, counted)


def _may_save(shared: Program, scalars: Mapping[str, Program]) -> bool:
    """Whether knowing the chart can be worth lines: constants, what no one reads, what calls compute of the same."""
    called = [(scalars[call.function], _read(call, scalars[call.function])) for call in shared.calls]
    if any(not _constants(program).isdisjoint(read) for program, read in called):
        return True
    least = shared.operations.total() + max((_needed(program, read) for program, read in called), default=0)
    return is_worth(least, sum((program.operations.total() for program, _ in called), shared.operations.total()))


def _read(call: Call, program: Program) -> set[Operand]:
    """Of the results of a scalar program those that are read there."""
    return {output for name, output in zip(call.names, program.outputs, strict=True) if name != "_"}


def _needed(program: Program, outputs: Set[Operand]) -> int:
    """How many operations some outputs take."""
    needed, count = set(outputs), 0
    for step in reversed(program.steps):
        if step.name in needed:
            needed.update(step.args)
            count += 1
    return count


def _constants(program: Program) -> set[Operand]:
    """What does not depend on the inputs, elements among it that are made of ``x - x``."""
    found: set[Operand] = {output for output in program.outputs if not isinstance(output, str)}
    for step in program.steps:
        nothing = step.op == "sub" and step.args[0] == step.args[1]
        if nothing or all(arg in found for arg in step.args if isinstance(arg, str)):
            found.add(step.name)
    return found


@lru_cache(maxsize=4)  # every table asks for them
def _scalars(chart: Chart) -> Mapping[str, Program]:
    """The scalar programs of a chart, with elements for constants that geometry divides: those would become floats."""
    scalars = scalar_programs(chart)
    constant = {name for name, program in scalars.items() if not all(isinstance(o, str) for o in program.outputs)}
    elements: dict[str, set[int]] = {}
    for program in (program for table in (POSES, ROTATIONS) for program in geometry(table).values()):
        functions = {call.function for call in program.calls}
        if functions <= scalars.keys() and functions & constant:
            for function, place in _divided(program, scalars):
                elements.setdefault(function, set()).add(place)
    return scalars | {name: scalar_program(name, chart, places) for name, places in elements.items()}


Result = tuple[str, int]
"""A scalar function and the number of one of its results."""


def _divided(
    program: Program, scalars: Mapping[str, Program], given: Mapping[str, Set[Result]] = MappingProxyType({})
) -> set[Result]:
    """The integers among results of scalars that are divided by integers, here or in what is called.

    ``given`` are names that are such integers, and the results these were made of.
    """
    known, divided = dict(given), set[Result]()
    for statement in program.statements:
        selects = isinstance(statement, Step) and statement.op == "where"
        values = statement.args[1:] if selects else statement.args  # whatever is asked, integers are selected
        made_of = [known.get(arg) if isinstance(arg, str) else set[Result]() for arg in values]
        if isinstance(statement, Call):
            called = scalars[statement.function]
            names = [name for _, group in called.inputs for name in group]
            passed = {name: results for name, results in zip(names, made_of) if results is not None}
            divided |= _divided(called, scalars, passed)
            pairs = enumerate(zip(statement.names, called.outputs, strict=True))
            known |= {name: {(called.name, i)} for i, (name, output) in pairs if not isinstance(output, str)}
        elif all(results is not None for results in made_of):
            origin = set().union(*filter(None, made_of))
            known[statement.name] = origin
            divided |= origin if statement.op == "div" else set()
    return divided


def is_worth(own: int, shared: int) -> bool:
    """Whether a program of so many operations is worth its lines, where geometry's takes so many."""
    return own < WORTH * shared and shared - own > own / LINES
