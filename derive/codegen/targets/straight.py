"""Straight-line programs for languages whose functions take plain numbers: steps that are printed line by line.

A target of such a language has a dialect and a template folder. `validate` reads the printed programs again and runs
them on exact numbers.
"""

from __future__ import annotations

import struct
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import mpmath

from ...maps.chart import Chart
from ..descriptions import about, sections
from ..lowering.scalar_programs import SCALARS
from ..package import Facts, Target, turns
from ..programs.program import Assignment, Program
from ..programs.renaming import lower_case
from ..rows import Array, Function, Table
from ..signatures import Way, way
from ..validation import listings, straight_text
from ..validation.calls import require_calls
from ..validation.straight_text import Grammar
from .c import NAMES, programs
from .expression import WIDTH, Dialect, Text, fill, wrapped
from .json import constants, decimal, numbers_of, wiring


@dataclass(frozen=True, slots=True)
class Step:
    """Value with its name, or call of a program with the names of its results; unread results have the name ``_``."""

    names: tuple[str, ...]
    text: str = ""
    called: str = ""
    groups: tuple[tuple[str, ...] | str, ...] = ()  # arguments of a call: numbers, and numbers of a list
    of_chart: bool = False  # True if each chart has a program of this name

    @property
    def arguments(self) -> list[str]:
        """Arguments one by one."""
        return [text for group in self.groups for text in ([group] if isinstance(group, str) else group)]


@dataclass(frozen=True, slots=True)
class Printed:
    """Program with its steps as texts in a language."""

    name: str
    given: tuple[tuple[str, tuple[str, ...]], ...]  # arguments; unread components have the name ``_``
    numbers: Mapping[str, str]  # numbers of the chart that it reads, as decimals by name
    steps: tuple[Step, ...]
    results: tuple[str, ...]
    truths: tuple[bool, ...]  # whether each result is true or false, not a number

    @property
    def components(self) -> list[str]:
        """Components of all arguments one by one."""
        return [name for _, names in self.given for name in names]


def printed(
    program: Program, dialect: Dialect, reserved: Collection[str] = (), numbers: Mapping[str, str] | None = None
) -> Printed:
    """Return a program in a dialect, without the words of the language among its names."""
    scalar = SCALARS.get(program.name)
    program = lower_case(program, reserved)
    read, numbers = program.operands, numbers or {}
    known = {name: numbers[name] for _, names in program.inputs for name in names if name in numbers and name in read}
    given = tuple(
        (argument, tuple(name if name in read else "_" for name in names if name not in numbers))
        for argument, names in program.inputs
    )
    steps, results = _steps(program, dialect)
    truths = [name in scalar.truths for name in scalar.results] if scalar else [False] * len(results)
    given = tuple(row for row in given if row[1])
    return Printed(program.name, given, known, tuple(steps), tuple(results), tuple(truths))


def _steps(program: Program, dialect: Dialect) -> tuple[list[Step], list[str]]:
    inlined: dict[str, Text] = {}
    found = []

    def text(operand: object) -> str:
        return dialect.passed(dialect.operand(operand, inlined)[0])  # type: ignore[arg-type]

    for statement in program.statements:
        if isinstance(statement, Assignment):
            expression = dialect.expression(statement, inlined)
            if statement.inline:
                inlined[statement.name] = expression
            else:
                found.append(Step((statement.name,), expression[0]))
            continue
        groups = (tuple(map(text, group)) if isinstance(group, tuple) else text(group) for group in statement.groups)
        shared = bool(statement.result)
        found.append(Step(statement.names, "", statement.function, tuple(groups), not shared))
    return found, list(map(text, program.outputs))


@dataclass(frozen=True, slots=True)
class Public:
    """Public function for its template: arrays with descriptions, constants of its program, and its programs."""

    row: Function
    lines: tuple[str, ...]  # description
    way: Way
    constants: tuple[str, ...]
    table: Table

    def about(self, array: Array) -> str:
        return about(array, self.table)


def public(table: Table) -> list[Public]:
    """Return the public functions of a table in the order of print."""
    rows = table.all_public
    found = ((name, lines) for section in sections(table) for name, lines in section.functions.items())
    return [Public(_small(rows[name]), lines, way(rows[name], table), constants(rows[name], table), table)
            for name, lines in found]  # fmt: skip


def _small(row: Function) -> Function:
    """Return a row whose arrays have no names in capital letters."""
    given, made = (
        tuple(a.called(NAMES.get(a.name, a.name)) for a in arrays) for arrays in (row.arguments, row.results)
    )
    return replace(row, arguments=given, results=made)


def called(tables: Sequence[Table]) -> list[str]:
    """Return the names of the scalar programs that shared programs call, in the order of their table."""
    found = {call.function for table in tables for program in programs(table).values() for call in program.calls
             if not call.result}  # fmt: skip
    return [name for name in SCALARS if name in found]


def own(facts: Facts, tables: Sequence[Table]) -> dict[str, Program]:
    """Return the scalar programs of a chart, and those that only the shared programs name."""
    known = {**facts.lowered.rotations.scalars, **facts.lowered.poses.scalars}
    return {name: known.get(name) or SCALARS[name].placeholder(name) for name in called(tables)}


def double(decimal: str) -> str:
    """Return the shortest decimal of the nearest double."""
    return repr(float(mpmath.mpf(decimal)))


def single(decimal: str) -> str:
    """Return the shortest decimal of the nearest number of 24 bits."""
    with mpmath.workprec(24):
        exact = float(+mpmath.mpf(decimal))
    shorter = (float(f"{exact:.{digits}g}") for digits in range(1, 10))
    return repr(next(number for number in shorter if struct.unpack("f", struct.pack("f", number)) == (exact,)))


def broken(head: str, texts: Sequence[str], tail: str, indent: str, mark: str = "") -> str:
    """Return a statement with a list or a value between its head and tail; a long one has lines of its own.

    Lines break after commas or before operators, with a ``mark`` of the language at the end of each.
    """
    whole = f"{indent}{head}{', '.join(texts)}{tail}"
    if len(whole) <= WIDTH:
        return whole
    inner = indent + "    "
    lines = wrapped((f"{text}," for text in texts), inner) if len(texts) > 1 else fill(texts[0], inner)
    lines[-1] = lines[-1].removesuffix(",")
    return f"{mark}\n".join([(indent + head).rstrip(" "), *lines, f"{indent}{tail}"])


class Straight(Target):
    """Target of a language whose functions take plain numbers."""

    dialect: Dialect
    grammar: Grammar
    reserved: Collection[str] = ()

    def printed(self, program: Program, numbers: Mapping[str, str] | None = None) -> Printed:
        return printed(program, self.dialect, self.reserved, numbers)

    def require_complete(self, texts: Mapping[str, str]) -> None:
        """Require calls and descriptions of every public function."""
        for table in self.tables:
            require_calls(table)
            sections(table)

    def texts(self, chart: Chart, table: Table) -> Sequence[str]:
        """Return the files that hold the programs of a chart, those that all charts share included."""
        raise NotImplementedError

    def validate(self, folder: Path, chart: Chart, geometry: bool) -> int:
        """Read the printed programs again, and run them in the way that the table of functions says."""

        def data(file: str, table: Table) -> dict[str, Any]:
            numbers = numbers_of(chart)
            near = {name: float(double(text)) for name, text in numbers.items()}
            text = "\n".join((folder / name).read_text("utf-8") for name in self.texts(chart, table))
            rows = table.all_public.items()
            return {
                "programs": straight_text.read(text, self.grammar, near),
                "functions": {name: {"branch": row.branch, **wiring(row, table, chart)} for name, row in rows},
                "branches": chart.branches,
                "turns": [list(map(decimal, pair)) for pair in turns(chart)],
                "numbers": {name: decimal(text) for name, text in numbers.items()},
            }

        files = {table: self.texts(chart, table)[0] for table in self.tables}
        return listings.validate(files, data, chart, geometry)
