"""Straight-line programs: what a formula is lowered to (see ``trace``), and what printers turn into source."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from fractions import Fraction

Constant = int | Fraction
Operand = str | int | Fraction
"""The name of an input or step, or an exact constant."""


ARITHMETIC = ("add", "sub", "mul", "div", "neg")
FUNCTIONS = ("sqrt", "tan", "atan2")
SELECTION = ("lt", "eq", "and", "or", "where")


@dataclass(frozen=True, slots=True)
class Step:
    """One assignment ``name = op(*args)``; an ``inline`` step is used once and printed inside its only reader."""

    name: str
    op: str
    args: tuple[Operand, ...]
    inline: bool


@dataclass(frozen=True, slots=True)
class Program:
    """Named assignments in order, from named inputs (grouped by argument) to outputs in C order."""

    name: str
    inputs: tuple[tuple[str, tuple[str, ...]], ...]
    steps: tuple[Step, ...]
    outputs: tuple[Operand, ...]

    @property
    def operations(self) -> Counter[str]:
        """How often each operation occurs."""
        return Counter(step.op for step in self.steps)

    def summary(self) -> str:
        """The operation count as printed in headers: ``67: 24 +, 31 *, 2 /``."""
        symbols = {"add": "+", "sub": "+", "neg": "neg", "mul": "*", "div": "/"}
        counts: Counter[str] = Counter()
        for op, count in self.operations.items():
            counts[symbols.get(op, op)] += count
        order = ["+", "*", "/", "neg", *FUNCTIONS, *SELECTION]
        parts = ", ".join(f"{counts[key]} {key}" for key in order if counts[key])
        return f"{len(self.steps)}: {parts}" if parts else "0"
