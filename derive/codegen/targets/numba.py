"""Print a program as compiled loops: cores on scalars, of few outputs each, and the loops which run them.

A loop with more than nine stores is no longer vectorised by LLVM, so a larger result is computed in parts. Constants
are made of the type of the arguments: beside a bare integer Numba computes float32 in double precision.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from ..programs.program import Operand, Program
from . import infix
from .expression import WIDTH

MOST_OUTPUTS = 9
"""Stores in a loop which LLVM still vectorises."""

_POSE_ROTATION = (0, 1, 2, 4, 5, 6, 8, 9, 10)
_POSE_TRANSLATION = (3, 7, 11, 12, 13, 14, 15)

_TABLES = frozenset({"cs", "table"})
"""Arguments which are constants, the same for every pose."""

DIALECT = infix.python(prefix="", literal=lambda value: f"_m{-value}" if value < 0 else f"_{value}")


@dataclass(frozen=True, slots=True)
class Part:
    """A core of few outputs, and the texts of the loops around it."""

    name: str
    summary: str
    arguments: tuple[str, ...]
    body: str
    row: str
    rows: str


def parts(program: Program) -> tuple[Part, ...]:
    """The cores of a program, each with the outputs it is for."""
    groups = _groups(program)
    return tuple(_part(program, f"{program.name}{i}", group) for i, group in enumerate(groups, 1))


def _groups(program: Program) -> list[tuple[int, ...]]:
    if program.name == "pose":
        return [_POSE_ROTATION, _POSE_TRANSLATION]
    count = len(program.outputs)
    return [tuple(range(first, min(first + MOST_OUTPUTS, count))) for first in range(0, count, MOST_OUTPUTS)]


def _part(program: Program, name: str, group: Sequence[int]) -> Part:
    selected = _select(program, group)
    arguments = tuple(argument for argument, _ in program.inputs)
    lines = [*_constants(selected, arguments[0]), infix.body(selected, dialect=DIALECT)]
    return Part(
        name=name,
        summary=f"operations {selected.summary()}",
        arguments=arguments,
        body="\n".join(lines),
        row=_call(name, program, group, "    ", ""),
        rows=_call(name, program, group, "        ", ", i"),
    )


def _select(program: Program, group: Sequence[int]) -> Program:
    """The program of some of the outputs only."""
    outputs = tuple(program.outputs[index] for index in group)
    needed: set[Operand] = set(outputs)
    steps = []
    for step in reversed(program.steps):
        if step.name in needed:
            needed.update(step.args)
            steps.append(step)
    return replace(program, steps=tuple(reversed(steps)), outputs=outputs)


def _constants(program: Program, argument: str) -> Iterator[str]:
    operands = {arg for step in program.steps for arg in step.args} | set(program.outputs)
    for value in sorted(int(operand) for operand in operands if not isinstance(operand, str)):
        yield f"    {DIALECT.literal(value)} = number({value}, {argument})"


def _call(name: str, program: Program, group: Sequence[int], indent: str, suffix: str) -> str:
    """``(out[0], out[1], …) = _name((v[0], …), …)``, over several lines."""
    stored = ", ".join(f"out[{index}{suffix}]" for index in group)
    lines = [f"{indent}(", *_wrapped(stored, indent), f"{indent}) = _{name}("]
    for argument, names in program.inputs:
        each = "" if argument in _TABLES else suffix
        loaded = ", ".join(f"{argument}[{index}{each}]" for index in range(len(names)))
        lines += _wrapped(f"({loaded}),", indent)
    return "\n".join([*lines, f"{indent})"])


def _wrapped(text: str, indent: str) -> list[str]:
    # an index and its comma stay together
    joined = text.replace(", i]", ",\0i]")
    lines = textwrap.wrap(joined, WIDTH - len(indent) - 4, break_long_words=False)
    return [f"{indent}    {line}".replace("\0", " ") for line in lines]
