"""The formulas of one order are the theorem's: equal as functions of x, decided in Q(x)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from typing import Any, Protocol

import sympy
from sympy.polys.fields import field

from ..maps import polynomials
from .formulas import Formulas
from .identity import Check, Claim, Proof, decide
from .marks import R, Shifted, c, d, dcay, dcay_inv, n, p, q, q_hat
from .statement import Equation

METHOD = "instance of the theorem for all n, residues in Q(x)"
Checks = Callable[[], Iterator[Check]]


class Coefficients(Protocol):
    """A map given by its coefficients."""

    @property
    def coefficients(self) -> tuple[sympy.Expr, ...]:
        """SymPy expressions in x."""


class CayleyFormulas(Protocol):
    """What a proof needs of a Cayley map: its order and its formulas as SymPy expressions in x."""

    @property
    def order(self) -> int: ...
    @property
    def p(self) -> sympy.Expr: ...
    @property
    def q(self) -> sympy.Expr: ...
    @property
    def c(self) -> sympy.Expr: ...
    @property
    def d(self) -> sympy.Expr: ...
    @property
    def quaternion(self) -> Coefficients: ...
    @property
    def tensor(self) -> Coefficients: ...
    @property
    def tangent(self) -> Coefficients: ...
    @property
    def tangent_inv(self) -> Coefficients: ...


LETTERS = {
    "p": p, "q": q, "c": c, "d": d, "quaternion": q_hat, "tensor": R, "tangent": dcay, "tangent_inv": dcay_inv,
}  # fmt: skip
"""The letters of the theorems for what a Cayley map has, by name."""


def instances(cayley: CayleyFormulas) -> tuple[Proof, ...]:
    """Prove that each formula of a Cayley map is that of the theorems at its order.

    Parameters
    ----------
    cayley : CayleyFormulas
        Such as ``derive.Cayley(7)``.

    Returns
    -------
    tuple of Proof
        Of scope "n = 7": the polynomials, the quaternion (its coefficients squared, free of the root), the orthogonal
        tensor, the tangent operator and its inverse.
    """
    order, at = cayley.order, at_order(cayley.order)

    def polynomial_checks() -> Iterator[Check]:
        yield from at.same(("p", "q", "c", "d"), (cayley.p, cayley.q, cayley.c, cayley.d), at.polynomials)

    def quaternion() -> Iterator[Check]:
        s, t = cayley.quaternion.coefficients
        yield from at.same(("scalar^2", "scalar * vector", "vector^2"), (s * s, s * t, t * t), at.squares)

    def isotropic(name: str) -> Checks:
        return lambda: at.same(BASIS, getattr(cayley, name).coefficients, at.tensors[name])

    table: tuple[tuple[tuple[str, ...], Checks], ...] = (
        (("p", "q", "c", "d"), polynomial_checks),
        (("quaternion",), quaternion),
        *(((name,), isotropic(name)) for name in ("tensor", "tangent", "tangent_inv")),
    )
    owner = f"Cayley({order})"
    return tuple(same_as_theorem(order, [(a, f"{owner}.{a}") for a in names], checks) for names, checks in table)


class AtOrder:
    """The theorems' formulas at one order, elements of Q(x)."""

    def __init__(self, order: int) -> None:
        self.functions, self.x = field("x", sympy.ZZ)
        p_n, q_n = (self.functions.one * value for value in polynomials.pair(order, self.x))
        power = (1 + self.x) ** order
        brackets = ((order * power / (1 + self.x) - p_n * q_n) / self.x, ((1 + self.x) * q_n - order * p_n) / self.x)
        self.polynomials = (p_n, q_n, *brackets)
        self.squares = (p_n * p_n / power, p_n * q_n / power, q_n * q_n / power)
        self.tensors = {
            name: getattr(Formulas(), name)(order, self.x, p_n, q_n) for name in ("tensor", "tangent", "tangent_inv")
        }

    def same(self, names: Sequence[str], stated: Sequence[Any], expected: Sequence[Any]) -> Iterator[Check]:
        for name, value, theorem in zip(names, stated, expected, strict=True):
            found = self.functions.from_expr(value) if isinstance(value, sympy.Expr) else value
            yield name, found - theorem


@lru_cache(maxsize=2)
def at_order(order: int) -> AtOrder:
    """The theorems' formulas at an order, kept for what is asked of it next."""
    return AtOrder(order)


BASIS = ("of I", "of skew(v)", "of v⊗v")


def same_as_theorem(order: int, stated: Sequence[tuple[str, str]], checks: Checks) -> Proof:
    """Decide that what the code has under a name is what the theorems call by a letter."""
    code = (sympy.Symbol(name, commutative=LETTERS[letter].is_commutative) for letter, name in stated)
    right = (Shifted(LETTERS[letter], n, sympy.Integer(order)) for letter, _ in stated)
    claim = tuple(map(Equation, code, right))
    return decide(Claim(", ".join(name for _, name in stated), claim, METHOD), checks, f"n = {order}")
