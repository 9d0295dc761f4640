"""Proofs that the formulas of one order are instances of the theorems, as functions of x."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import lru_cache, partial
from typing import Any, Protocol

import sympy

from ..maps import polynomials
from .evaluation import NoValueError
from .formulas import Formulas
from .identity import Check, Claim, Proof, decide
from .notation import R, Shifted, c, d, dcay, dcay_inv, n, p, q, q_hat, text, x
from .statement import Equation
from .vector_ring import Ring

METHOD = "instance of the theorem for all n, residues in Q(x), for the quaternion in Q(sqrt(1 + x))"
Stated = Callable[[], Sequence[Any]]
"""Function without arguments that returns the coefficients computed by the code."""


class Coefficients(Protocol):
    """Quaternion, tensor or tangent operator given by its coefficients."""

    @property
    def coefficients(self) -> tuple[sympy.Expr, ...]:
        """Coefficients as SymPy expressions in x."""


class CayleyFormulas(Protocol):
    """Attributes of a Cayley map that proofs use: its order, and its formulas as SymPy expressions in x."""

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


SYMBOLS = {
    "p": p, "q": q, "c": c, "d": d, "quaternion": q_hat, "tensor": R, "tangent": dcay, "tangent_inv": dcay_inv,
}  # fmt: skip
"""Symbol in the theorems of each formula, by its attribute name in a Cayley map."""


def instances(cayley: CayleyFormulas) -> tuple[Proof, ...]:
    """Prove that the formulas of a Cayley map equal the theorems' formulas at its order.

    Parameters
    ----------
    cayley : CayleyFormulas
        Map to check, e.g. ``derive.Cayley(7)``.

    Returns
    -------
    tuple of Proof
        Proofs of scope "n = 7": polynomials, quaternion, orthogonal tensor, tangent operator and its inverse.
    """

    def stated(name: str) -> tuple[sympy.Expr, ...]:
        found = getattr(cayley, name)
        if isinstance(found, sympy.Expr):
            return (found,)
        return tuple(found.coefficients)

    def proof(*names: str) -> Proof:
        named = {f"Cayley({cayley.order}).{name}": (SYMBOLS[name], partial(stated, name)) for name in names}
        return same_as_theorem(at_order(cayley.order), named)

    return (proof("p", "q", "c", "d"), *map(proof, ("quaternion", "tensor", "tangent", "tangent_inv")))


class AtOrder:
    """Formulas of the theorems at one order. Odd orders need sqrt(1 + x) for the quaternion."""

    def __init__(self, order: int) -> None:
        self.order = order
        self.ring = Ring(root=1)
        self.x, root = self.ring.square("v"), self.ring.square_root() ** order
        p_n, q_n = map(self.ring.element, polynomials.pair(order, self.x))
        power = (1 + self.x) ** order
        tensors = {R: Formulas.tensor, dcay: Formulas.tangent, dcay_inv: Formulas.tangent_inv}
        self.values: Mapping[sympy.Expr, tuple[Any, ...]] = {
            p: (p_n,),
            q: (q_n,),
            c: ((order * power / (1 + self.x) - p_n * q_n) / self.x,),
            d: (((1 + self.x) * q_n - order * p_n) / self.x,),
            q_hat: (p_n / root, q_n / root),
            **{symbol: formula(order, self.x, p_n, q_n) for symbol, formula in tensors.items()},
        }

    def same(self, name: sympy.Expr, stated: Sequence[Any], term: sympy.Expr) -> Iterator[Check]:
        """Yield stated coefficients minus the theorems' coefficients for the symbol in `term`, at this order."""
        symbol, index, order = term.args
        if (index, order) != (n, self.order):
            raise NoValueError(f"{text(term)} is not at n = {self.order}")
        for place, (value, theorem) in enumerate(zip(stated, self.values[symbol], strict=True), 1):
            label = f", coefficient {place}" if len(stated) > 1 else ""
            found = self.ring.lift(value, {x: self.x}) if isinstance(value, sympy.Expr) else value
            yield f"{name}{label}", found - theorem


@lru_cache(maxsize=2)
def at_order(order: int) -> AtOrder:
    """Return the formulas of the theorems at an order; the last two orders are cached."""
    return AtOrder(order)


def same_as_theorem(at: AtOrder, named: Mapping[str, tuple[sympy.Expr, Stated]]) -> Proof:
    """Decide whether named formulas of the code equal the theorems' formulas for their symbols."""
    code = {name: sympy.Symbol(name, commutative=symbol.is_commutative) for name, (symbol, _) in named.items()}
    claim = tuple(
        Equation(code[name], Shifted(symbol, n, sympy.Integer(at.order))) for name, (symbol, _) in named.items()
    )

    def checks() -> Iterator[Check]:
        for equation in claim:
            _, stated = named[equation.left.name]
            yield from at.same(equation.left, stated(), equation.right)

    return decide(Claim(", ".join(named), claim, METHOD), checks, f"n = {at.order}")
