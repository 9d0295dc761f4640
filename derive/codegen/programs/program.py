"""Straight-line programs: what a formula is lowered to (see ``trace``), and what printers turn into source."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from fractions import Fraction

Constant = int | Fraction
Operand = str | int | Fraction
"""The name of an input or step, or an exact constant."""


ARITHMETIC = ("add", "sub", "mul", "div", "neg")
FUNCTIONS = ("abs", "sqrt", "tan", "atan2", "expm1", "log1p")
SELECTION = ("lt", "eq", "and", "or", "where")


@dataclass(frozen=True, slots=True)
class Step:
    """One assignment ``name = op(*args)``; an ``inline`` step is used once and printed inside its only reader."""

    name: str
    op: str
    args: tuple[Operand, ...]
    inline: bool


@dataclass(frozen=True, slots=True)
class Call:
    """Several values at once from a function that this program does not hold, ``f, g, h = pose(x)``.

    ``rest`` names an argument of the program, of any length, whose components follow ``args``; ``truths`` are those of
    the names that are truth values.
    """

    names: tuple[str, ...]
    function: str
    args: tuple[Operand, ...]
    rest: str = ""
    truths: frozenset[str] = frozenset()


Statement = Step | Call


def results(statement: Statement) -> tuple[str, ...]:
    """Return the names to which a statement gives values."""
    return (statement.name,) if isinstance(statement, Step) else tuple(n for n in statement.names if n != "_")


def all_results(call: Call) -> tuple[str, ...]:
    """Return a name for every result of a call; results that are not read need a place too."""
    first = results(call)[0]
    return tuple(f"{first}_{i}" if name == "_" else name for i, name in enumerate(call.names))


@dataclass(frozen=True, slots=True)
class Program:
    """Assignments in order, from named inputs (grouped by argument) to outputs in C order.

    Of what is ``corrected`` afterwards rounding makes no difference.
    """

    name: str
    inputs: tuple[tuple[str, tuple[str, ...]], ...]
    statements: tuple[Statement, ...]
    outputs: tuple[Operand, ...]
    corrected: frozenset[str] = frozenset()

    @property
    def steps(self) -> tuple[Step, ...]:
        """The operations, without the calls."""
        return tuple(statement for statement in self.statements if isinstance(statement, Step))

    @property
    def calls(self) -> tuple[Call, ...]:
        """The calls of functions held elsewhere."""
        return tuple(statement for statement in self.statements if isinstance(statement, Call))

    @property
    def operations(self) -> Counter[str]:
        """How often each operation occurs, calls not looked into."""
        return Counter(step.op for step in self.steps)

    @property
    def constants(self) -> tuple[int, ...]:
        """The integers that are operands or results."""
        return tuple(sorted({int(operand) for operand in self.operands if not isinstance(operand, str)}))

    @property
    def operands(self) -> set[Operand]:
        """What some statement or output reads."""
        read = {arg for statement in self.statements for arg in statement.args}
        return read | set(self.outputs)


def summary(operations: Counter[str]) -> str:
    """An operation count as printed in headers: ``67: 24 +, 31 *, 2 /``."""
    symbols = {"add": "+", "sub": "+", "neg": "neg", "mul": "*", "div": "/"}
    counts: Counter[str] = Counter()
    for op, count in operations.items():
        counts[symbols.get(op, op)] += count
    order = ["+", "*", "/", "neg", *FUNCTIONS, *SELECTION]
    parts = ", ".join(f"{counts[key]} {key}" for key in order if counts[key])
    return f"{operations.total()}: {parts}" if parts else "0"
