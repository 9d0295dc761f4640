"""Mutants of straight-line programs: printed, put into their module, and validated."""

from __future__ import annotations

import dataclasses
import hashlib
import random
from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import road
from .mutant import EQUIVALENT, KILLED, SURVIVED, Fate, Mutant
from .python import Edit

if TYPE_CHECKING:
    from derive.codegen.programs.program import Call, Operand, Program, Statement, Step

TARGET = "numpy"
FORMS = ("both forms", "plain form", "in-place form")
OPPOSITE = {"add": "sub", "sub": "add", "mul": "div", "div": "mul", "and": "or", "or": "and", "lt": "eq", "eq": "lt"}
ORDERED = {"sub": (0, 1), "div": (0, 1), "lt": (0, 1), "atan2": (0, 1), "where": (1, 2)}
DROPPED = {"neg": (0,), "abs": (0,), "sqrt": (0,), "tan": (0,), "where": (1, 2)}
MASKS = ("lt", "eq", "and", "or")
PRIME = (1 << 61) - 1
POINTS = 3
MOST = 1024
"""Ways that the comparisons of two programs may go, if all of them are to be tried."""

Changed = tuple[str, str, "Program"]
"""Operator, change in words, and the changed program."""


def program_mutants(program: Program) -> Iterator[Changed]:
    """All mutants of a program: operation, operand, constant, order of outputs."""
    for index, statement in enumerate(program.statements):
        changes = _changed if hasattr(statement, "op") else _called
        for operator, changed in changes(program, index, statement):  # type: ignore[operator]
            words = f"{_words(statement)} → {_words(changed)}"
            statements = (*program.statements[:index], changed, *program.statements[index + 1 :])
            yield operator, words, _with_statements(program, statements)
    for i in range(len(program.outputs)):
        for operator, words, outputs in _outputs(program.outputs, i):
            changed_program = dataclasses.replace(program, outputs=outputs)
            yield operator, words, _with_statements(changed_program, program.statements)


def _words(statement: Statement) -> str:
    arguments = ", ".join(map(str, statement.args))
    if hasattr(statement, "op"):
        return f"{statement.name} = {statement.op}({arguments})"
    return f"{', '.join(statement.names)} = c.{statement.function}({arguments})"


def _made(statement: Statement) -> Sequence[str]:
    return (statement.name,) if hasattr(statement, "op") else statement.names


def _called(program: Program, index: int, call: Call) -> Iterator[tuple[str, Call]]:
    """Another argument, or two that are swapped."""
    for i, operand in enumerate(call.args):
        for operator, other in _others(program, index, operand):
            yield operator, dataclasses.replace(call, args=(*call.args[:i], other, *call.args[i + 1 :]))
    for i in range(len(call.names) - 1):
        names = (*call.names[:i], call.names[i + 1], call.names[i], *call.names[i + 2 :])
        if not call.truths & set(names[i : i + 2]):
            yield "operands swapped", dataclasses.replace(call, names=names)


def _changed(program: Program, index: int, step: Step) -> Iterator[tuple[str, Step]]:
    replace = dataclasses.replace
    if step.op in OPPOSITE:
        yield "operation", replace(step, op=OPPOSITE[step.op])
    for i in DROPPED.get(step.op, ()):
        yield "operation", replace(step, op="add", args=(step.args[i], 0))
    if step.op in ORDERED:
        i, j = ORDERED[step.op]
        args = list(step.args)
        args[i], args[j] = args[j], args[i]
        yield "operands swapped", replace(step, args=tuple(args))
    for i, operand in enumerate(step.args):
        for operator, other in _others(program, index, operand):
            yield operator, replace(step, args=(*step.args[:i], other, *step.args[i + 1 :]))


def _others(program: Program, index: int, operand: Operand) -> Iterator[tuple[str, Operand]]:
    """A constant by one more or less, or of the other sign; for a value those named before and after it."""
    if not isinstance(operand, str):
        others = dict.fromkeys((operand + 1, operand - 1, -operand))
        yield from (("constant", other) for other in others if other != operand)
        return
    masks = {step.name for step in program.steps if step.op in MASKS}.union(*(call.truths for call in program.calls))
    names = [name for _, group in program.inputs for name in group]
    for statement in program.statements[:index]:
        names += [] if getattr(statement, "inline", False) else _made(statement)
    alike = [name for name in names if (name in masks) == (operand in masks)]
    here = alike.index(operand) if operand in alike else len(alike)
    for other in dict.fromkeys((*alike[here - 1 : here], *alike[here + 1 : here + 2])):
        yield "operand", other


def _outputs(outputs: Sequence[Operand], i: int) -> Iterator[tuple[str, str, tuple[Operand, ...]]]:
    if i and outputs[i] != outputs[i - 1]:
        swapped = (*outputs[: i - 1], outputs[i], outputs[i - 1], *outputs[i + 1 :])
        yield "order of outputs", f"outputs {i - 1} and {i} swapped", swapped
    if not isinstance(outputs[i], str):
        yield "constant", f"output {i}: {outputs[i]} + 1", (*outputs[:i], outputs[i] + 1, *outputs[i + 1 :])  # type: ignore[operator]


def _with_statements(program: Program, statements: Sequence[Statement]) -> Program:
    """The program with these statements, less those that no output needs."""
    needed = {output for output in program.outputs if isinstance(output, str)}
    kept = []
    for statement in reversed(statements):
        if needed.intersection(_made(statement)):
            kept.append(statement)
            needed.update(arg for arg in statement.args if isinstance(arg, str))
    return dataclasses.replace(program, statements=tuple(reversed(kept)))


def same_value(first: Program, second: Program) -> bool:
    """Whether two programs agree whatever square root, tangent, arc tangent may be, and whichever way comparisons go.

    They are evaluated at random points of a prime field, those functions as hashes of their arguments, with every
    comparison true and false in turn: programs that differ agree by chance with a probability below 1e-50. Where there
    are too many comparisons for that, they have not been shown to agree.
    """
    draw = random.Random(PRIME)
    for _ in range(POINTS):
        point = {name: draw.randrange(1, PRIME) for _, group in first.inputs for name in group}
        ways: list[dict[Hashable, bool]] = [{}]
        for count, way in enumerate(ways):  # which grows as comparisons are met
            decide = partial(_decided, way, ways)
            if count == MOST or evaluated(first, point, decide) != evaluated(second, point, decide):
                return False
    return True


def _decided(way: dict[Hashable, bool], ways: list[dict[Hashable, bool]], comparison: Hashable) -> bool:
    """How a comparison goes on one of the ways; one that is met first is true, and false on another way."""
    if comparison not in way:
        ways.append({**way, comparison: False})
        way[comparison] = True
    return way[comparison]


def evaluated(program: Program, point: Mapping[str, int], decide: Callable[[Hashable], bool]) -> list[int]:
    """The outputs at a point of the prime field, when comparisons go as is decided."""
    values: dict[str, int] = dict(point)

    def value(operand: Operand) -> int:
        if isinstance(operand, str):
            return values[operand]
        fraction = Fraction(operand)
        return fraction.numerator * pow(fraction.denominator, -1, PRIME) % PRIME

    for statement in program.statements:
        args = [value(arg) for arg in statement.args]
        if hasattr(statement, "op"):
            values[statement.name] = _operation(statement.op, args, decide)
        else:
            for i, name in enumerate(statement.names):
                called = f"{statement.function} {i}", tuple(args)
                values[name] = decide(called) if name in statement.truths else _hashed(*called)
    return [value(output) for output in program.outputs]


def _operation(op: str, args: list[int], decide: Callable[[Hashable], bool]) -> int:
    if op == "add":
        return (args[0] + args[1]) % PRIME
    if op == "sub":
        return (args[0] - args[1]) % PRIME
    if op == "mul":
        return args[0] * args[1] % PRIME
    if op == "div" and args[1]:
        return args[0] * pow(args[1], -1, PRIME) % PRIME
    if op == "neg":
        return -args[0] % PRIME
    if op == "where":
        return args[1] if args[0] else args[2]
    if op in ("and", "or"):
        return all(args) if op == "and" else any(args)
    if op in ("eq", "lt"):
        return decide((op, tuple(sorted(args) if op == "eq" else args)))
    return _hashed(op, tuple(args))


def _hashed(function: str, args: tuple[int, ...]) -> int:
    return int.from_bytes(hashlib.sha256(repr((function, args)).encode()).digest()[:7], "big")


@dataclass(frozen=True)
class Programs:
    """The programs of the geometry and of the charts with names; in both printed forms, or in one of them alone."""

    name: str = "programs"
    what: str = "straight-line programs of the geometry and of the charts with names: by validation alone"
    checks: None = None
    unchanged: tuple[str, ...] = ("derive.codegen",)

    def edit(self, mutant: Mutant) -> Edit | None:
        return None

    def mutants(self, folder: Path) -> Iterator[Mutant]:
        for which, printer, program in road.programs():
            owner = "geometry" if which is None else road.chart(which).name
            for index, (operator, change, _) in enumerate(program_mutants(program)):
                for form in FORMS:
                    place = f"{owner}.{program.name}, {form}"
                    yield Mutant(place, 0, operator, change, (which, printer, program.name, index, form))

    def is_one(self, mutant: Mutant) -> bool:
        return True

    def limit(self, mutant: Mutant | None, knowledge: Any) -> float:
        return 60

    def trial(self, mutant: Mutant | None, knowledge: Any, former: Fate | None = None) -> Fate:
        which, printer, name, index, form = mutant.site if mutant else (3, "two_forms", "", 0, "")
        pair: list[Program] = []

        def change(original: Any, program: Program) -> Any:
            changed = next(islice(program_mutants(program), index, None))[2]
            pair[:] = program, changed
            return _printed(original, program, changed, form)

        try:
            with road.printed_otherwise(printer, which, name, change):
                for one in road.GEOMETRY if which is None else (which,):
                    road.build(one, road.targets()[TARGET])
        except Exception as error:
            return Fate(KILLED, "validation", type(error).__name__)
        if pair and same_value(*pair):
            return Fate(EQUIVALENT, by="equal in a prime field, functions uninterpreted, whichever way comparisons go")
        return Fate(SURVIVED)


def _printed(print_it: Any, program: Program, changed: Program, form: str) -> Any:
    """What the template gets: the change in both forms, or in one with the other as it was."""
    after = print_it(changed)
    if form == "both forms":
        return after
    before = print_it(program)
    if form == "plain form":
        return dataclasses.replace(before, plain=after.plain)
    return dataclasses.replace(after, plain=before.plain)
