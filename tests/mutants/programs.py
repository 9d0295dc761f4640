"""Mutants of straight-line programs: printed, put into their module, and validated."""

from __future__ import annotations

import dataclasses
import hashlib
import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import road
from .mutant import EQUIVALENT, KILLED, SURVIVED, Fate, Mutant
from .python import Edit

if TYPE_CHECKING:
    from derive.codegen.programs.program import Operand, Program, Step

TARGET = "numpy"
FORMS = ("both forms", "plain form", "in-place form")
OPPOSITE = {"add": "sub", "sub": "add", "mul": "div", "div": "mul", "and": "or", "or": "and", "lt": "eq", "eq": "lt"}
ORDERED = {"sub": (0, 1), "div": (0, 1), "lt": (0, 1), "atan2": (0, 1), "where": (1, 2)}
DROPPED = {"neg": (0,), "sqrt": (0,), "tan": (0,), "where": (1, 2)}
MASKS = ("lt", "eq", "and", "or")
PRIME = (1 << 61) - 1
POINTS = 3

Changed = tuple[str, str, "Program"]
"""Operator, change in words, and the changed program."""


def program_mutants(program: Program) -> Iterator[Changed]:
    """All mutants of a program: operation, operand, constant, order of outputs."""
    for index, step in enumerate(program.steps):
        for operator, changed in _changed(program, index, step):
            words = f"{_words(step)} → {_words(changed)}"
            yield operator, words, _with_steps(program, (*program.steps[:index], changed, *program.steps[index + 1 :]))
    for i in range(len(program.outputs)):
        for operator, words, outputs in _outputs(program.outputs, i):
            yield operator, words, _with_steps(dataclasses.replace(program, outputs=outputs), program.steps)


def _words(step: Step) -> str:
    return f"{step.name} = {step.op}({', '.join(map(str, step.args))})"


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
    ops = {step.name: step.op for step in program.steps}
    names = [name for _, group in program.inputs for name in group]
    names += [step.name for step in program.steps[:index] if not step.inline]
    alike = [name for name in names if (ops.get(name) in MASKS) == (ops.get(operand) in MASKS)]
    here = alike.index(operand) if operand in alike else len(alike)
    for other in dict.fromkeys((*alike[here - 1 : here], *alike[here + 1 : here + 2])):
        yield "operand", other


def _outputs(outputs: Sequence[Operand], i: int) -> Iterator[tuple[str, str, tuple[Operand, ...]]]:
    if i and outputs[i] != outputs[i - 1]:
        swapped = (*outputs[: i - 1], outputs[i], outputs[i - 1], *outputs[i + 1 :])
        yield "order of outputs", f"outputs {i - 1} and {i} swapped", swapped
    if not isinstance(outputs[i], str):
        yield "constant", f"output {i}: {outputs[i]} + 1", (*outputs[:i], outputs[i] + 1, *outputs[i + 1 :])  # type: ignore[operator]


def _with_steps(program: Program, steps: Sequence[Step]) -> Program:
    """The program with these steps, less those that no output needs."""
    needed = {output for output in program.outputs if isinstance(output, str)}
    kept = []
    for step in reversed(steps):
        if step.name in needed:
            kept.append(step)
            needed.update(arg for arg in step.args if isinstance(arg, str))
    return dataclasses.replace(program, steps=tuple(reversed(kept)))


def same_value(first: Program, second: Program) -> bool:
    """Whether two programs agree whatever square root, tangent, arc tangent and comparisons may be.

    They are evaluated at random points of a prime field, those functions as hashes of their arguments: programs that
    differ agree by chance with a probability below 1e-50.
    """
    draw = random.Random(PRIME)
    for _ in range(POINTS):
        point = {name: draw.randrange(1, PRIME) for _, group in first.inputs for name in group}
        if evaluated(first, point) != evaluated(second, point):
            return False
    return True


def evaluated(program: Program, point: Mapping[str, int]) -> list[int]:
    """The outputs at a point of the prime field."""
    values: dict[str, int] = dict(point)

    def value(operand: Operand) -> int:
        if isinstance(operand, str):
            return values[operand]
        fraction = Fraction(operand)
        return fraction.numerator * pow(fraction.denominator, -1, PRIME) % PRIME

    for step in program.steps:
        values[step.name] = _operation(step.op, [value(arg) for arg in step.args])
    return [value(output) for output in program.outputs]


def _operation(op: str, args: list[int]) -> int:
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
    if op == "where" and args[1] == args[2]:
        return args[1]
    if op in ("eq", "and", "or"):
        args = sorted(args)
    return int.from_bytes(hashlib.sha256(repr((op, args)).encode()).digest()[:7], "big")


@dataclass(frozen=True)
class Programs:
    """Every program of the committed orders; in both printed forms, or in one of them alone."""

    name: str = "programs"
    what: str = "straight-line programs of the NumPy modules of the committed orders: by validation alone"
    checks: None = None

    def edit(self, mutant: Mutant) -> Edit | None:
        return None

    def mutants(self, folder: Path) -> Iterator[Mutant]:
        for n in sorted(road.COMMITTED):
            for program in self._programs(n):
                for index, (operator, change, _) in enumerate(program_mutants(program)):
                    for form in FORMS:
                        place = f"cayley{n}.{program.name}, {form}"
                        yield Mutant(place, 0, operator, change, (n, program.name, index, form))

    @staticmethod
    def _programs(n: int) -> list[Program]:
        found: list[Program] = []
        target = road.targets()[TARGET]

        def noted(program: Program) -> Any:
            found.append(program)
            return target.printer(program)

        road.build(n, road.unvalidated(target, printer=noted))
        return found

    def is_one(self, mutant: Mutant) -> bool:
        return True

    def limit(self, knowledge: Any) -> float:
        return 60

    def trial(self, mutant: Mutant | None, knowledge: Any) -> Fate:
        n, name, index, form = mutant.site if mutant else (3, "", 0, "")
        target = road.targets()[TARGET]
        pair: list[Program] = []

        def printer(program: Program) -> Any:
            if program.name != name:
                return target.printer(program)
            changed = next(islice(program_mutants(program), index, None))[2]
            pair[:] = program, changed
            return _printed(target, program, changed, form)

        try:
            road.build(n, dataclasses.replace(target, printer=printer))
        except Exception as error:
            return Fate(KILLED, "validation", type(error).__name__)
        if pair and same_value(*pair):
            return Fate(EQUIVALENT, by="equal in a prime field, functions and comparisons uninterpreted")
        return Fate(SURVIVED)


def _printed(target: Any, program: Program, changed: Program, form: str) -> Any:
    """What the template gets: the change in both forms, or in one with the other as it was."""
    after = target.printer(changed)
    if form == "both forms":
        return after
    before = target.printer(program)
    if form == "plain form":
        return dataclasses.replace(before, plain=after.plain)
    return dataclasses.replace(after, plain=before.plain)
