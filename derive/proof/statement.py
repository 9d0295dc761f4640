"""Equations between SymPy expressions, and premises of theorems.

The printed equation is the decided one: text, LaTeX and values all come from its two sides.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

import sympy

from ..algebra.latex import Typeset
from .notation import latex, text


@dataclass(frozen=True)
class Equation(Typeset):
    """Equation ``left = right``. Theorems with the right side `wrong`, by default twice the right side, must fail."""

    left: sympy.Expr
    right: sympy.Expr
    numbers: tuple[int, ...] = ()  # of the equation in CP23
    wrong: sympy.Expr | None = field(default=None, compare=False)

    def __post_init__(self) -> None:
        if isinstance(self.right, int):
            object.__setattr__(self, "right", sympy.Integer(self.right))

    @cached_property
    def symbols(self) -> frozenset[sympy.Symbol]:
        """Symbols on both sides."""
        return frozenset(self.left.free_symbols | self.right.free_symbols)

    @cached_property
    def text(self) -> str:
        """Equation as plain text."""
        return f"{text(self.left)} = {text(self.right)}"

    @cached_property
    def latex(self) -> str:
        """Equation as LaTeX, without delimiters."""
        return f"{latex(self.left)} = {latex(self.right)}"

    def __str__(self) -> str:
        return self.text

    def _typeset(self) -> str:
        return self.latex

    def replaced(self, changes: Mapping[sympy.Expr, sympy.Expr]) -> Equation:
        """Return the equation with symbols or terms replaced on both sides, all at once."""
        wrong = None if self.wrong is None else self.wrong.xreplace(changes)
        return Equation(self.left.xreplace(changes), self.right.xreplace(changes), wrong=wrong)

    def altered(self) -> Equation:
        """Return a false equation: the right side is `wrong` if given, else doubled, or 1 in place of 0."""
        other = 2 * self.right if self.right != 0 else sympy.Integer(1)
        return replace(self, right=other if self.wrong is None else self.wrong, numbers=())


@dataclass(frozen=True)
class Premise:
    """Equation that a theorem assumes: a definition, or a claim of another theorem."""

    equation: Equation
    theorem: str = ""
    instance: tuple[tuple[sympy.Expr, sympy.Expr], ...] = ()  # pairs: symbol there, expression that replaces it

    def __str__(self) -> str:
        at = ", ".join(f"{text(old)} -> {text(new)}" for old, new in self.instance)
        source = f"theorem {self.theorem!r}{f' at {at}' if at else ''}" if self.theorem else "definition"
        return f"{self.equation.text} ({source})"

    def altered(self) -> Premise:
        """Return the premise with a false equation."""
        return replace(self, equation=self.equation.altered())


def definition(
    left: sympy.Expr, right: sympy.Expr | int, numbers: tuple[int, ...] = (), wrong: sympy.Expr | None = None
) -> Premise:
    """Return the definition of a symbol or a term."""
    return Premise(Equation(left, right, numbers, wrong))
