"""Equations between SymPy expressions, premises of theorems, and decisions of statements in an exact ring.

The printed equation is the decided one: text, LaTeX and values all come from its two sides. A statement is proved if
every residue is 0 and no multiplier may be 0.
"""

from __future__ import annotations

import textwrap
import time
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, Literal, NamedTuple

import sympy

from ..algebra.latex import Typeset
from .notation import latex, text


@dataclass(frozen=True)
class Equation(Typeset):
    """Equation ``left = right``. With `wrong` as its right side, by default twice the right side, it must fail."""

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
    return Premise(Equation(left, right, numbers, wrong))


ALL_ORDERS = "all n"
NO_VALUE = "no value"
Check = tuple[str, Any]
"""Label of a check, and left side minus right side."""


@dataclass(frozen=True)
class Multiplier:
    """Power of a polynomial by which both sides were multiplied before the comparison."""

    expression: sympy.Expr
    power: int
    nonzero: bool  # certified as no zero divisor at any order; otherwise the comparison proves nothing

    @property
    def text(self) -> str:
        """Polynomial as plain text."""
        return text(self.expression)

    def __str__(self) -> str:
        return self.text if self.power == 1 else f"({self.text})^{self.power}"


class Residue(NamedTuple):
    """Label of a check, and left side minus right side; the value is 0 exactly if the sides are equal."""

    label: str
    value: Any


Checks = Iterable[Check | Multiplier]
"""Checks of a statement, and the factors by which differences were multiplied."""


@dataclass(frozen=True)
class Proof(Typeset):
    """Outcome of deciding one statement."""

    name: str  # by which other theorems cite it
    claim: tuple[Equation, ...]
    premises: tuple[Premise, ...] = field(repr=False)  # definitions, and equations proved by other theorems
    conditions: tuple[Equation, ...] = field(repr=False)  # definitions in cited theorems, not contradicted or repeated
    scope: str  # "all n", or one order, as in "n = 7"
    status: Literal["proved", "failed"]
    method: str
    seconds: float = field(compare=False)
    multipliers: tuple[Multiplier, ...] = field(compare=False, repr=False)  # factors of all denominators
    residues: tuple[Residue, ...] = field(compare=False, repr=False)  # all checked differences

    @property
    def title(self) -> str:
        """Name, and the scope unless it is all orders."""
        return self.name if self.scope == ALL_ORDERS else f"{self.name} [{self.scope}]"

    @property
    def statement(self) -> str:
        """Claim in plain text."""
        return "; ".join(equation.text for equation in self.claim)

    @property
    def equation(self) -> sympy.Eq:
        """Claim as an equation of SymPy; several equations are one between tuples of their sides."""
        sides = zip(*((equation.left, equation.right) for equation in self.claim), strict=True)
        left, right = (side[0] if len(side) == 1 else sympy.Tuple(*side) for side in sides)
        return sympy.Eq(left, right, evaluate=False)

    @property
    def latex(self) -> str:
        """Claim in LaTeX."""
        return r";\; ".join(equation.latex for equation in self.claim)

    @property
    def equations(self) -> tuple[int, ...]:
        """Numbers of CP23's equations in the claim."""
        return tuple(sorted({number for equation in self.claim for number in equation.numbers}))

    @property
    def proved(self) -> bool:
        """Tell whether the statement is proved."""
        return self.status == "proved"

    @property
    def failures(self) -> tuple[Residue, ...]:
        """Residues other than 0."""
        return tuple(residue for residue in self.residues if residue.value != 0)

    def cells(self) -> dict[str, str]:
        """Return the row in a table of proofs."""
        start = {"theorem": self.name, "scope": self.scope, "status": self.status}
        return {**start, "statement": f"$\\displaystyle {self.latex}$", "method": self.method}

    def __getstate__(self) -> dict[str, Any]:
        """Return the fields; a residue other than 0 becomes text, since elements of exact rings have no copies."""
        residues = tuple(Residue(r.label, 0 if r.value == 0 else str(r.value)) for r in self.residues)
        return {**vars(self), "residues": residues}

    def __str__(self) -> str:
        return f"{self.status} [{self.scope}] {self.statement} ({self.method})"

    def __repr__(self) -> str:
        return f"<Proof [{self.scope}] {textwrap.shorten(self.name, 80, placeholder=' …')}: {self.status}>"

    def _typeset(self) -> str:
        return rf"\text{{{self.status} [{self.scope}]:}}\quad {self.latex}"


def decide(
    name: str,
    claim: tuple[Equation, ...],
    method: str,
    checks: Callable[[], Checks],
    scope: str = ALL_ORDERS,
    premises: tuple[Premise, ...] = (),
    conditions: tuple[Equation, ...] = (),
) -> Proof:
    """Decide a statement by the residues and multipliers that `checks` yields.

    The statement is proved if residues exist, all are exactly zero, and all multipliers are certified. An operation
    without a result (a division by zero, a symbol without a value) counts as a residue that is not zero.
    """
    start = time.perf_counter()
    residues: list[Residue] = []
    multipliers: dict[sympy.Expr, Multiplier] = {}
    try:
        for check in checks():
            if isinstance(check, Multiplier):
                known = multipliers.get(check.expression, check)
                multipliers[check.expression] = max(check, known, key=lambda m: m.power)
            else:
                residues.append(Residue(*check))
    except ZeroDivisionError as error:
        residues.append(Residue("quotient", error))
    except ArithmeticError as error:
        residues.append(Residue(NO_VALUE, f"{type(error).__name__}: {error}"))
    certified = all(multiplier.nonzero for multiplier in multipliers.values())
    holds = bool(residues) and certified and all(residue.value == 0 for residue in residues)
    return Proof(
        name, claim, premises, conditions, scope, "proved" if holds else "failed", method,
        time.perf_counter() - start, tuple(multipliers.values()), tuple(residues),
    )  # fmt: skip
