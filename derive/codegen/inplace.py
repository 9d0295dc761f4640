"""Print a program as NumPy calls which write where the register allocation says: no temporary is ever made.

A statement keeps the name it has in the infix form, ``x = add(add(v11, v22, k1), v33, k1)``: a call returns where it
wrote.  Scratch registers are ``k1, k2, ...``, mask registers ``mask1, ...``, outputs ``o1, ...``, and ``n2`` is 2.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import chain

from . import infix
from .expression import WIDTH, fill
from .program import Operand, Program, Step
from .registers import Placement, place

_FUNCTIONS = {
    "add": "add", "sub": "sub", "mul": "mul", "div": "div", "neg": "neg", "sqrt": "sqrt", "tan": "tan",
    "atan2": "atan2", "lt": "m.less", "eq": "m.equal", "and": "m.both", "or": "m.either", "where": "m.where",
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class TwoForms:
    """What the template shows of a program: its infix form, its in-place form, and what that needs."""

    plain: str
    blocks: str
    registers: int
    masks: int
    numbers: tuple[int, ...]


def two_forms(program: Program) -> TwoForms:
    """Print both forms of a program."""
    placement = place(program)
    numbers = tuple(sorted({int(c) for c in _operands(program) if not isinstance(c, str)}))
    blocks = body(program, placement, numbers)
    return TwoForms(infix.body(program), blocks, placement.registers, placement.masks, numbers)


def body(program: Program, placement: Placement, numbers: tuple[int, ...], indent: str = "    ") -> str:
    """Source lines of the in-place form: unpacked arguments, outputs and registers, then one line a statement."""
    return "\n".join(line for text in _statements(program, placement, numbers) for line in _wrap(text, indent))


def _operands(program: Program) -> set[Operand]:
    return {arg for step in program.steps for arg in step.args} | set(program.outputs)


def _statements(program: Program, placement: Placement, numbers: tuple[int, ...]) -> Iterator[str]:
    used = _operands(program)
    for argument, names in program.inputs:
        yield _unpacked([name if name in used else "_" for name in names], argument)
    fixed = {
        "out": [f"o{i}" for i in range(1, len(program.outputs) + 1)],
        "scratch": [f"k{i}" for i in range(1, placement.registers + 1)],
        "masks": [f"mask{i}" for i in range(1, placement.masks + 1)],
        "numbers": [_number(value) for value in numbers],
    }
    if taken := used.intersection(chain(*fixed.values())):
        raise ValueError(f"program {program.name!r} uses names of registers: {', '.join(map(str, taken))}")
    yield from (_unpacked(names, argument) for argument, names in fixed.items() if names)
    printer = _Calls({step.name: step for step in program.steps}, placement)
    read = {arg for step in program.steps for arg in step.args}
    for step in placement.statements:
        named = step.name in read and not step.inline
        yield (f"{step.name} = " if named else "") + printer.call(step)
    yield from (f"copy({printer.place(source)}, o{index})" for source, index in placement.copies)


def _unpacked(names: list[str], argument: str) -> str:
    return f"{', '.join(names)}{',' * (len(names) == 1)} = {argument}"


def _number(value: int) -> str:
    return f"n{value}" if value >= 0 else f"n_minus_{-value}"


@dataclass(frozen=True, slots=True)
class _Calls:
    """Texts of the NumPy calls of a program; inline operands are calls inside the call that reads them."""

    steps: Mapping[str, Step]
    placement: Placement

    def call(self, step: Step) -> str:
        kind, index = self.placement.places[step.name]
        return f"{_FUNCTIONS[step.op]}({', '.join(map(self.operand, step.args))}, {kind}{index})"

    def place(self, operand: Operand) -> str:
        """Where an output stands that is written a second time."""
        if isinstance(operand, str) and operand in self.steps:
            kind, index = self.placement.places[operand]
            return f"{kind}{index}"
        return self.operand(operand)

    def operand(self, operand: Operand) -> str:
        if not isinstance(operand, str):
            return _number(int(operand))
        step = self.steps.get(operand)
        if step is None or not step.inline:
            return operand
        kind, index = self.placement.places[operand]
        return f"{kind}{index}" if kind == "o" else self.call(step)


def _wrap(statement: str, indent: str) -> Iterator[str]:
    """Lines of a statement; a long call breaks inside its brackets, a long list of names goes into brackets."""
    if len(indent + statement) <= WIDTH:
        yield indent + statement
    elif statement.endswith(")"):
        head, _, inner = statement[:-1].partition("(")
        yield f"{indent}{head}("
        yield from fill(inner, indent + "    ")
        yield f"{indent})"
    else:
        names, argument = statement.split(" = ")
        yield f"{indent}("
        yield from fill(f"{names},", indent + "    ")
        yield f"{indent}) = {argument}"
