"""JSON: the programs of a chart as data, for printers of further languages and for other tools.

A file holds all programs that the functions of a chart run: rounded operations in order, with calls of other programs.
"""

from __future__ import annotations

import itertools
import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial
from pathlib import Path
from typing import Any

import mpmath

from ...maps.chart import Chart
from ..descriptions import about, sections
from ..lowering.scalar_programs import SCALARS, Scalar, table_names
from ..package import Data, Facts, Target, returns
from ..programs.program import BESIDE, Assignment, Operand, Program
from ..rows import Array, Function, Table, inside
from ..signatures import RETURNED, ROTATIONS, STAYED, TABLE, ChartPrograms, way
from ..validation import listings
from ..validation.calls import require_calls
from .c import copy_of, programs, scalars
from .python import formulas_of

SCHEMA = "program.schema.json"
OWN = "chart."
"""Prefix of the programs that differ from chart to chart; a shared program may have the same name."""
WIDTH = 120
OPERATIONS = {
    "add": "add", BESIDE: "add", "sub": "subtract", "mul": "multiply", "div": "divide", "neg": "negate", "abs": "abs",
    "sqrt": "sqrt", "tan": "tan", "atan2": "atan2", "expm1": "expm1", "log1p": "log1p", "lt": "less", "eq": "equal",
    "and": "and", "or": "or", "where": "select",
}  # fmt: skip
"""Names of operations in files, by their names in programs."""


class Json(Target):
    """Target of programs as data."""

    name = "json"
    extension = "json"
    entry = SCHEMA
    comment = "//"

    def shared(self) -> Mapping[str, Callable[[], Data]]:
        return {SCHEMA: partial(dict, operations=json.dumps(sorted(set(OPERATIONS.values()))))}

    def module(self, facts: Facts) -> Data:
        return {"members": members(listed(facts, facts.lowered.poses))}

    def companions(self, facts: Facts) -> dict[str, tuple[str, Data]]:
        data = {"members": members(listed(facts, facts.lowered.rotations))}
        return {inside(ROTATIONS, f"{facts.chart.name}.json"): (inside(ROTATIONS, "chart.json"), data)}

    def require_complete(self, texts: Mapping[str, str]) -> None:
        """Require calls and descriptions of every public function."""
        for table in self.tables:
            require_calls(table)
            sections(table)

    def validate(self, folder: Path, chart: Chart, geometry: bool) -> int:
        files = {table: inside(table, f"{chart.name}.json") for table in self.tables}
        return listings.validate(files, lambda file, _: json.loads((folder / file).read_text("utf-8")), chart, geometry)


def listed(facts: Facts, lowered: ChartPrograms) -> dict[str, Any]:
    """Return the chart, its numbers, its programs and its public functions as data."""
    chart, table = facts.chart, lowered.table
    numbers = {name: decimal(text) for name, text in numbers_of(chart).items()}
    return {
        "chart": chart.name,
        "kind": "rotations" if table is ROTATIONS else "poses",
        "title": chart.title,
        "parameter": chart.parameter,
        "order": chart.order,
        "branches": chart.branches,
        "singular angles": facts.singular_angles,
        "turns": [list(map(decimal, pair)) for pair in facts.turns],
        "numbers": numbers,
        "programs": dict(_programs(chart, lowered, numbers)),
        "functions": {name: _function(name, lines, facts, table) for section in sections(table)
                      for name, lines in section.functions.items()},
        "aliases": table.aliases(chart),
    }  # fmt: skip


def numbers_of(chart: Chart) -> dict[str, str]:
    """Return the numbers of a chart as decimals by name."""
    return dict(zip(table_names(chart), itertools.chain(*returns(chart)), strict=True))


def decimal(text: str) -> dict[str, str]:
    return {"decimal": text, "float": float(mpmath.mpf(text)).hex()}


def _rational(text: str) -> dict[str, str]:
    return {"rational": str(Fraction(text)), "float": float(text).hex()}


def _programs(chart: Chart, lowered: ChartPrograms, numbers: Mapping[str, Any]) -> Iterator[tuple[str, Data]]:
    """Yield the programs by name, each after the programs that it calls."""
    table = lowered.table
    for name, program in scalars(lowered).items():
        known = {"formula": "; ".join(formulas_of(name, chart))} if name in lowered.scalars else {}
        yield f"{OWN}{name}", {**known, **_program(program, numbers, _truths(SCALARS[name]))}
    for name, program in programs(table).items():
        yield name, _program(program, {})
    yield "copy", _program(copy_of(table), {})


def _truths(row: Scalar) -> list[int]:
    """Return the places of results that are true or false."""
    return [place for place, name in enumerate(row.results) if name in row.truths]


def _program(program: Program, numbers: Mapping[str, Any], truths: Sequence[int] = ()) -> dict[str, Any]:
    given = [name for _, names in program.inputs for name in names if name not in numbers]
    steps, results = list(map(_step, program.statements)), list(map(_operand, program.outputs))
    return {"given": given, "steps": steps, "results": results, "truths": truths}


def _step(statement: Any) -> list[Any]:
    """Return a result and its operation, or the results of a call and the program, followed by the operands."""
    operands = list(map(_operand, statement.args))
    if not isinstance(statement, Assignment):
        called = statement.function if statement.result else f"{OWN}{statement.function}"
        return [list(statement.names), called, *operands]
    if statement.op == "reciprocal":  # of an integer, as a number like the first operand
        return [statement.name, "divide", 1, operands[1]]
    return [statement.name, OPERATIONS[statement.op], *operands]


def _operand(operand: Operand) -> str | int:
    """Return a name, or a constant as an integer; raise ValueError for a fraction, which exact types cannot hold."""
    if isinstance(operand, str):
        return operand
    if Fraction(operand).denominator != 1:
        raise ValueError(f"constant {operand} is not an integer: divide instead")
    return int(operand)


def _function(name: str, lines: tuple[str, ...], facts: Facts, table: Table) -> dict[str, Any]:
    row = table.all_public[name]
    stated = {"domain": facts.domain.get(name, ""), "singular set": facts.singular.get(name, "")}
    return {
        "about": " ".join(lines),
        **{key: text for key, text in stated.items() if text},
        "arguments": [_array(array, table) for array in row.arguments],
        "branch": row.branch,
        "results": [_array(array, table) for array in row.results],
        **wiring(row, table, facts.chart),
    }


def wiring(row: Function, table: Table, chart: Chart) -> dict[str, Any]:
    """Return the programs that a public function of a chart runs, and the constants that the first of them takes."""
    runs = way(row, table)
    stayed = "stay" if chart.ends else "copy"
    program = {STAYED: stayed, RETURNED: "principal" if chart.branches != 1 else stayed}.get(runs.program, runs.program)
    turned = {"then": runs.then, "instead": runs.instead}
    return {
        "program": program,
        "constants": list(map(_rational, constants(row, table))),
        **{key: text for key, text in turned.items() if text},
    }


def constants(row: Function, table: Table) -> tuple[str, ...]:
    """Return the numbers of the table that the program takes, those of the side; by default 1."""
    inputs = {**table.kernels, **table.composed}[row.kernel].traced().inputs
    return row.constants if any(argument == TABLE for argument, _ in inputs) else ()


def _array(array: Array, table: Table) -> dict[str, Any]:
    return {"name": array.name, "shape": list(array.shape), "about": about(array, table)}


def members(data: Mapping[str, Any]) -> str:
    """Return the members of a JSON object as text, with a line for each short value."""
    return ",\n".join(f"{json.dumps(key)}: {_text(value, '')}" for key, value in data.items())


def _text(value: Any, indent: str) -> str:
    """Return a value as JSON: on one line if that is short, else a line for each member."""
    short = json.dumps(value, ensure_ascii=False)
    if len(indent + short) <= WIDTH or not isinstance(value, dict | list) or not value:
        return short
    inner = indent + " "
    if isinstance(value, dict):
        rows = [f"{inner}{json.dumps(key)}: {_text(one, inner)}" for key, one in value.items()]
        return "{\n" + ",\n".join(rows) + f"\n{indent}}}"
    return "[\n" + ",\n".join(inner + _text(one, inner) for one in value) + f"\n{indent}]"
