"""Print a program as NumPy calls which write where the register allocation says: no temporary is ever made.

A statement keeps the name it has in the infix form, ``x = add(add(v11, v22, k1), v33, k1)``: a call returns where it
wrote.  Scratch registers are ``k1, k2, ...``, mask registers ``mask1, ...``, outputs ``o1, ...``, and ``n2`` is 2.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import chain

from . import infix
from .expression import WIDTH, fill
from .program import Call, Operand, Program, Step
from .registers import Placement, place, results

_FUNCTIONS = {
    "add": "add", "sub": "sub", "mul": "mul", "div": "div", "neg": "neg", "sqrt": "sqrt", "tan": "tan",
    "atan2": "atan2", "lt": "m.less", "eq": "m.equal", "and": "m.both", "or": "m.either", "where": "m.where",
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class TwoForms:
    """What the template shows of a program: its infix form, its in-place form, and what that needs.

    ``lent`` are the functions it calls, with how many registers of numbers and of masks it lends them.
    """

    plain: str
    blocks: str
    registers: int
    masks: int
    numbers: tuple[int, ...]
    lent: tuple[tuple[str, int, int], ...]


def two_forms(program: Program) -> TwoForms:
    """Print both forms of a program of a geometry, which calls scalar programs of a chart ``c``."""
    return _forms(program, infix.body(program), _arguments(program), ())


def two_scalar_forms(program: Program) -> TwoForms:
    """Print both forms of a scalar program: its parameters are components, its result is where it stands."""
    placement = place(program)
    standing = [_Calls(program, placement).place(output) for output in program.outputs]
    result = f"return {', '.join(standing)}{',' * (len(standing) == 1)}"
    return _forms(program, infix.body(program, alone=True), (), (result,), placement)


def _forms(
    program: Program, plain: str, before: Iterable[str], after: tuple[str, ...], placement: Placement | None = None
) -> TwoForms:
    placed = placement or place(program)
    end = after or tuple(f"copy({_Calls(program, placed).place(source)}, o{i})" for source, i in placed.copies)
    lines = (*before, *_registers(program, placed, lent=bool(after)), *_calls(program, placed), *end)
    blocks = "\n".join(line for text in lines for line in _wrap(text, "    "))
    lent = tuple((call.function, *_counts(placed, call)) for call in program.calls)
    return TwoForms(plain, blocks, placed.registers, placed.masks, program.constants, lent)


def _counts(placement: Placement, call: Call) -> tuple[int, int]:
    kinds = [kind for kind, _ in placement.free[results(call)[0]]]
    return kinds.count("k"), kinds.count("mask")


def _arguments(program: Program) -> Iterator[str]:
    used = program.operands
    for argument, names in program.inputs:
        if names:
            yield infix.unpacked([name if name in used else "_" for name in names], argument)


def _registers(program: Program, placement: Placement, lent: bool) -> Iterator[str]:
    """Names of outputs, registers and constants; what a call may need besides is spare."""
    fixed = {
        "out": [f"o{i}" for i in range(1, len(program.outputs) + 1)],
        "scratch": [f"k{i}" for i in range(1, placement.registers + 1)],
        "masks": [f"mask{i}" for i in range(1, placement.masks + 1)],
        "numbers": [_number(value) for value in program.constants],
    }
    if taken := program.operands.intersection(chain(*fixed.values())):
        raise ValueError(f"program {program.name!r} uses names of registers: {', '.join(map(str, taken))}")
    more = {"scratch": "_" if lent else "*spare", "masks": "_" if lent else "*spare_masks"}
    for argument, names in fixed.items():
        rest = ["*_" if lent else more[argument]] if argument in more and (program.calls or (lent and names)) else []
        if names or rest:
            yield infix.unpacked([*names, *rest], argument)


def _calls(program: Program, placement: Placement) -> Iterator[str]:
    printer = _Calls(program, placement)
    read = {arg for statement in program.statements for arg in statement.args}
    for statement in placement.statements:
        if isinstance(statement, Call):
            yield infix.unpacked(statement.names, printer.lend(statement))
        else:
            named = statement.name in read and not statement.inline
            yield (f"{statement.name} = " if named else "") + printer.call(statement)


def _number(value: int) -> str:
    return f"n{value}" if value >= 0 else f"n_minus_{-value}"


class _Calls:
    """Texts of the NumPy calls of a program; inline operands are calls inside the call that reads them."""

    def __init__(self, program: Program, placement: Placement) -> None:
        self.steps = {step.name: step for step in program.steps}
        self.places = placement.places
        self.free = placement.free

    def call(self, step: Step) -> str:
        return f"{_FUNCTIONS[step.op]}({', '.join(map(self.operand, step.args))}, {self.place(step.name)})"

    def lend(self, call: Call) -> str:
        """The call of a scalar program, which gets places for its results and the registers that are free."""
        free = [f"{kind}{index}" for kind, index in self.free[results(call)[0]]]
        scratch = [name for name in free if name.startswith("k")] + ["*spare"]
        masks = [name for name in free if name.startswith("mask")] + ["*spare_masks"]
        groups = [_tuple([self.place(name) for name in call.names]), _tuple(scratch), _tuple(masks)]
        rest = [f"*{call.rest}"] if call.rest else []
        return f"c.{call.function}({', '.join([*groups, *map(self.operand, call.args), *rest])})"

    def place(self, operand: Operand) -> str:
        """Where a value stands, for an output that is written a second time."""
        if isinstance(operand, str) and operand in self.places:
            kind, index = self.places[operand]
            return f"{kind}{index}"
        return self.operand(operand)

    def operand(self, operand: Operand) -> str:
        if not isinstance(operand, str):
            return _number(int(operand))
        step = self.steps.get(operand)
        if step is None or not step.inline:
            return operand
        return self.place(operand) if self.places[operand][0] == "o" else self.call(step)


def _tuple(items: list[str]) -> str:
    return f"({', '.join(items)}{',' * (len(items) == 1)})"


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
