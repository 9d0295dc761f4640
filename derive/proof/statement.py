"""Statements as values: equations between SymPy expressions, and what a theorem takes as given.

What is printed is what is decided: text and LaTeX of an equation come from its two sides, and so do its values.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

import sympy

from .notation import Shifted, latex, text


@dataclass(frozen=True)
class Equation:
    """left = right.

    Attributes
    ----------
    left, right : Expr
        In the symbols and marks of :mod:`~derive.proof.notation`.
    numbers : tuple of int
        Its numbers in CP23, where it is one of that paper's equations as it stands (or as corrected).
    wrong : Expr, optional
        A right side that matters to whatever rests on the equation, for controls; by default the double.
    """

    left: sympy.Expr
    right: sympy.Expr
    numbers: tuple[int, ...] = ()
    wrong: sympy.Expr | None = field(default=None, compare=False)

    @cached_property
    def symbols(self) -> frozenset[sympy.Symbol]:
        """The symbols on both sides."""
        return frozenset(self.left.free_symbols | self.right.free_symbols)

    @cached_property
    def text(self) -> str:
        """As plain text."""
        return f"{text(self.left)} = {text(self.right)}"

    @cached_property
    def latex(self) -> str:
        """As LaTeX, without delimiters."""
        return f"{latex(self.left)} = {latex(self.right)}"

    def __str__(self) -> str:
        return self.text

    def replaced(self, changes: Mapping[sympy.Expr, sympy.Expr]) -> Equation:
        """The equation with symbols (or terms) replaced on both sides, all at once."""
        wrong = None if self.wrong is None else self.wrong.xreplace(changes)
        return Equation(self.left.xreplace(changes), self.right.xreplace(changes), wrong=wrong)

    def altered(self) -> Equation:
        """Another equation: the right side doubled, or 1 where it is 0, or what is kept for this."""
        other = 2 * self.right if self.right != 0 else sympy.Integer(1)
        return replace(self, right=other if self.wrong is None else self.wrong, numbers=())

    def variants(self, sides: Iterable[str] = ("left", "right")) -> Iterator[Equation]:
        """`altered`, and every integer of these sides increased by one."""
        yield self.altered()
        for side in sides:
            expression = getattr(self, side)
            for changed in _increased(expression):
                if changed != expression:
                    yield replace(self, numbers=(), **{side: changed})


@dataclass(frozen=True)
class Premise:
    """What a theorem takes as given.

    Attributes
    ----------
    equation : Equation
    theorem : str
        The name of the theorem that proves it; empty for a definition.
    instance : tuple of (Expr, Expr)
        What was put for the symbols of that theorem's equation.
    """

    equation: Equation
    theorem: str = ""
    instance: tuple[tuple[sympy.Expr, sympy.Expr], ...] = ()

    @property
    def source(self) -> str:
        """Why it may be used."""
        at = ", ".join(f"{text(old)} -> {text(new)}" for old, new in self.instance)
        return f"theorem {self.theorem!r}{f' at {at}' if at else ''}" if self.theorem else "definition"

    def __str__(self) -> str:
        return f"{self.equation.text} ({self.source})"

    def altered(self) -> Premise:
        """The premise with another equation in its place."""
        return replace(self, equation=self.equation.altered())


def definition(
    left: sympy.Expr, right: sympy.Expr | int, numbers: tuple[int, ...] = (), wrong: sympy.Expr | None = None
) -> Premise:
    """What a symbol or a mark stands for."""
    return Premise(Equation(left, sympy.Integer(right) if isinstance(right, int) else right, numbers, wrong))


def _increased(expression: sympy.Expr) -> Iterator[sympy.Expr]:
    """The expression with one of its integers increased by one, for each of them."""
    if expression.is_Integer:
        yield expression + (1 if expression != -1 else 2)  # no power of 0
    if isinstance(expression, Shifted):  # a name for a value
        return
    for place, argument in enumerate(expression.args):
        named = expression.is_Pow and not expression.exp.is_Integer and not argument.is_commutative  # (1 + v)^n
        if isinstance(argument, sympy.Expr) and not named:
            for changed in _increased(argument):
                yield expression.func(*expression.args[:place], changed, *expression.args[place + 1 :])
