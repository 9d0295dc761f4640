"""Mutants of straight-line programs: printed into the NumPy package in place of the original, then validated."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from typing import Any
from unittest import mock

from derive.codegen import catalogue
from derive.codegen.build import build
from derive.codegen.programs.program import Assignment, Call, Operand, Program, Statement
from derive.codegen.signatures import lower_chart, printed_geometry
from derive.codegen.targets import TARGETS, expression, python
from derive.maps import Cayley
from derive.maps.chart import Chart

from .mutant import KILLED, SURVIVED, Mutant, Verdict

OPPOSITE = {
    "add": "sub", "beside": "sub", "sub": "add", "mul": "div", "div": "mul", "and": "or", "or": "and", "lt": "eq",
    "eq": "lt",
}  # fmt: skip
ORDERED = {"sub": (0, 1), "div": (0, 1), "lt": (0, 1), "atan2": (0, 1), "where": (1, 2)}
DROPPED = {"neg": (0,), "abs": (0,), "sqrt": (0,), "tan": (0,), "where": (1, 2)}
TRUTHS = ("lt", "eq", "and", "or")
GEOMETRY_CHARTS = (Cayley(3), Cayley(2))  # charts used in the validation of a changed geometry program

Changed = tuple[str, str, Program]
"""Type of a change: operator, change in words, and changed program."""


def mutants() -> Iterator[Mutant]:
    """Yield the mutants of the geometry programs, then of the scalar programs that committed charts print."""
    yield Mutant("programs", "none", "unchanged", partial(_trial, GEOMETRY_CHARTS, None, None))
    for program in printed_geometry().values():
        yield from _mutants("geometry", GEOMETRY_CHARTS, program)
    for chart in (chart for chart in catalogue.committed() if not chart.base):  # a multiple prints none of its own
        for program in lower_chart(chart).scalars.values():
            yield from _mutants(chart.name, (chart,), program)


def _mutants(owner: str, charts: Sequence[Chart], program: Program) -> Iterator[Mutant]:
    for operator, change, changed in changes(program):
        trial = partial(_trial, charts, program, changed)
        yield Mutant(f"{owner}.{program.name}", operator, change, trial)


def _trial(charts: Sequence[Chart], program: Program | None, changed: Program | None) -> Verdict:
    """Build the charts with one program replaced by its mutant."""
    with replaced(program, changed):
        try:
            build(charts, TARGETS["numpy"])
        except Exception as error:
            return Verdict(KILLED, f"validation {type(error).__name__}: {error}")
    return Verdict(SURVIVED)


@contextmanager
def replaced(program: Program | None, changed: Program | None) -> Iterator[None]:
    """Print a program as its mutant. Scalar programs are changed before they are split into helpers."""

    def other(given: Program) -> Program:
        return changed if changed and given == program else given

    def split(programs: Mapping[str, Program]) -> Any:
        return with_helpers({name: other(given) for name, given in programs.items()})

    def body(given: Program, *arguments: Any, **options: Any) -> str:
        return print_body(other(given), *arguments, **options)

    with_helpers, print_body = python.with_helpers, expression.body
    with mock.patch.object(python, "with_helpers", split), mock.patch.object(expression, "body", body):
        yield


def changes(program: Program) -> Iterator[Changed]:
    """Yield every change of an operation, an operand, a constant or the order of outputs."""
    for index, statement in enumerate(program.statements):
        changed = _step_changes if isinstance(statement, Assignment) else _call_changes
        others = changed(program, index, statement)  # type: ignore[operator]
        for operator, other in ((operator, other) for operator, other in others if other != statement):
            statements = (*program.statements[:index], other, *program.statements[index + 1 :])
            yield operator, f"{_words(statement)} → {_words(other)}", replace(program, statements=statements)
    for i, (first, second) in enumerate(zip(program.outputs, program.outputs[1:])):
        if first != second:
            outputs = (*program.outputs[:i], second, first, *program.outputs[i + 2 :])
            yield "order of outputs", f"outputs {i} and {i + 1} swapped", replace(program, outputs=outputs)


def _step_changes(program: Program, index: int, step: Assignment) -> Iterator[tuple[str, Assignment]]:
    if step.op in OPPOSITE:
        yield "operation", replace(step, op=OPPOSITE[step.op])
    for i in DROPPED.get(step.op, ()):
        yield "operation dropped", replace(step, op="add", args=(step.args[i], 0))
    if step.op in ORDERED:
        i, j = ORDERED[step.op]
        args = list(step.args)
        args[i], args[j] = args[j], args[i]
        yield "operands swapped", replace(step, args=tuple(args))
    yield from _operand_changes(program, index, step)


def _call_changes(program: Program, index: int, call: Call) -> Iterator[tuple[str, Call]]:
    yield from _operand_changes(program, index, call)
    for i, pair in enumerate(zip(call.names, call.names[1:])):
        if not call.truths & set(pair):
            yield "results swapped", replace(call, names=(*call.names[:i], *pair[::-1], *call.names[i + 2 :]))


def _operand_changes(program: Program, index: int, statement: Any) -> Iterator[tuple[str, Any]]:
    for i, operand in enumerate(statement.args):
        for operator, other in _others(program, index, operand):
            yield operator, replace(statement, args=(*statement.args[:i], other, *statement.args[i + 1 :]))


def _others(program: Program, index: int, operand: Operand) -> Iterator[tuple[str, Operand]]:
    """Yield replacements: neighbours of a constant, or the names just before and after a name."""
    if not isinstance(operand, str):
        yield from (("constant", other) for other in {operand + 1, operand - 1, -operand} - {operand})
        return
    truths = {step.name for step in program.steps if step.op in TRUTHS}.union(*(call.truths for call in program.calls))
    names = [name for _, group in program.inputs for name in group]
    for statement in program.statements[:index]:
        names += [statement.name] * (not statement.inline) if isinstance(statement, Assignment) else statement.names
    alike = [name for name in names if (name in truths) == (operand in truths)]
    here = alike.index(operand) if operand in alike else len(alike)
    for other in (*alike[max(here - 1, 0) : here], *alike[here + 1 : here + 2]):
        yield "operand", other


def _words(statement: Statement) -> str:
    arguments = ", ".join(map(str, statement.args))
    if isinstance(statement, Assignment):
        return f"{statement.name} = {statement.op}({arguments})"
    return f"{', '.join(statement.names)} = {statement.function}({arguments})"
