r"""Cayley map of a symbolic order n: p_n and q_n as binomial sums, and the maps in terms of them.

.. math::
    p_n = \sum_{k \ge 0} (-1)^k \binom{n}{2k} x^k \qquad q_n = \sum_{k \ge 0} (-1)^k \binom{n}{2k + 1} x^k \qquad
    \text{CP23 (51), (52)}

The formulas are CP23 (55), (57), (88) and (89) as printed. The theorems for every n prove them.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Self

import sympy
from sympy.printing.precedence import PRECEDENCE

from .cayley import Cayley
from .chart import Map, factored
from .families import alpha
from .formula import IsotropicMap, QuaternionMap
from .polynomials import x

k = sympy.Symbol("k", integer=True, nonnegative=True)


class PowerSum(sympy.Sum):  # type: ignore[misc]  # SymPy is untyped
    """Sum of powers of x that becomes a polynomial once its bounds are numbers; SymPy finds its limits at x = 0."""

    precedence = PRECEDENCE["Mul"]  # SymPy's LaTeX brackets the powers of sums alone

    def __new__(cls, summand: sympy.Expr, *limits: Any) -> Any:
        found = super().__new__(cls, summand, *limits)
        if isinstance(found, cls) and all(bound.is_Integer for bound in found.limits[0][1:]):
            return sympy.expand(sympy.Sum(*found.args).doit())
        return found

    def doit(self, **hints: Any) -> Self:
        """Return the sum itself: SymPy's closed forms of it have cases and hypergeometric functions."""
        return self

    def _shift(self, symbol: sympy.Symbol) -> sympy.Expr:
        """Return the exponent of a symbol less the index, an integer for the symbol of the powers."""
        return sympy.expand(symbol * self.function.diff(symbol) / self.function) - self.limits[0][0]

    def _terms(self, symbol: sympy.Symbol, below: int) -> sympy.Expr:
        """Return the terms with powers of a symbol below the given one."""
        ((index, first, _),) = self.limits
        places = range(int(first), int(below - self._shift(symbol)))
        return sum((self.function.subs(index, place) for place in places), sympy.Integer(0))

    def _eval_subs(self, old: Any, new: Any) -> Any:
        if new == 0 and old.is_Symbol and self._shift(old).is_Integer:  # SymPy would keep 0**k
            return self._terms(old, 1)
        return super()._eval_subs(old, new)

    def _eval_is_meromorphic(self, symbol: sympy.Symbol, at: sympy.Expr) -> bool:
        return True

    def _eval_nseries(self, symbol: sympy.Symbol, n: int, logx: Any, cdir: Any = 0) -> sympy.Expr:
        return self._terms(symbol, n) + sympy.Order(symbol**n)

    def _eval_as_leading_term(self, symbol: sympy.Symbol, logx: Any = None, cdir: Any = 0) -> sympy.Expr:
        return self._terms(symbol, 1) or self


def power_sum(coefficient: sympy.Expr, last: sympy.Expr, first: int = 0) -> sympy.Expr:
    """Return ``Σ coefficient x^(k − first)`` for k from `first` to the integer part of `last`."""
    return PowerSum(coefficient * x ** (k - first), (k, first, sympy.floor(last)))


@dataclass(frozen=True)
class AnyOrder(Cayley):
    """Cayley map of a symbolic order n ≥ 1, with formulas but without kernels."""

    order: Any

    def __post_init__(self) -> None:
        n = self.order
        if n.is_integer is False or n.is_positive is False or n.has_free(x, alpha):
            raise ValueError(f"the order n must be an integer >= 1, or an expression in symbols for one, got {n}")
        object.__setattr__(self, "name", f"cayley_{n}")

    @property
    def p(self) -> sympy.Expr:
        """Polynomial p_n as a sum, CP23 (51)."""
        return power_sum((-1) ** k * sympy.binomial(self.order, 2 * k), self.order / 2)

    @property
    def q(self) -> sympy.Expr:
        """Polynomial q_n as a sum, CP23 (52)."""
        return power_sum((-1) ** k * sympy.binomial(self.order, 2 * k + 1), (self.order - 1) / 2)

    @property
    def c(self) -> sympy.Expr:
        """Bracket ``[n (1+x)ⁿ⁻¹ − p q]/x`` of dcay_n as a sum."""
        n, choose = self.order, sympy.binomial
        return power_sum(n * choose(n - 1, k) - (-1) ** k * choose(2 * n, 2 * k + 1) / 2, n - 1, 1)

    @property
    def d(self) -> sympy.Expr:
        """Bracket ``[(1+x) q − n p]/x`` of dcay_n⁻¹ as a sum."""
        n, choose = self.order, sympy.binomial
        term = choose(n, 2 * k + 1) - choose(n, 2 * k - 1) - n * choose(n, 2 * k)
        return power_sum((-1) ** k * term, (n + 1) / 2, 1)

    @property
    def poles(self) -> tuple[sympy.Expr, ...]:
        """No tuple for a symbolic n, whose number of poles depends on n: ValueError."""
        raise ValueError("the number of poles depends on n: put a number in its place, by subs")

    @property
    def singular_angles(self) -> tuple[sympy.Expr, ...]:
        """No tuple for a symbolic n: ValueError. The angles are 2πk < nπ, and nπ."""
        raise ValueError("the number of singular angles depends on n: put a number in its place, by subs")

    @property
    def limits(self) -> tuple[tuple[sympy.Expr, ...], tuple[sympy.Expr, ...]]:
        """Coefficients of T and of T⁻¹ at α = 0."""
        tangent, tangent_inv = super().limits
        return tuple(map(factored, tangent)), tuple(map(factored, tangent_inv))

    @property
    def quaternion(self) -> QuaternionMap:
        """Unit dual quaternion, CP23 (50), (55)."""
        root = (1 + x) ** (self.order / 2)
        return self._formula(QuaternionMap, "quaternion", self.p / root, self.q / root)

    @property
    def tensor(self) -> IsotropicMap:
        """Orthogonal dual tensor, CP23 (57)."""
        f, g = self._rotation
        return self._formula(IsotropicMap, "tensor", 1 - x * g, f, g)

    @property
    def tangent(self) -> IsotropicMap:
        """Tangent operator dcay_n, CP23 (88); it takes v̇ to the space twist."""
        n, norm = self.order, (1 + x) ** self.order
        bracket = n * (1 + x) ** (n - 1) - self.p * self.q
        return self._formula(IsotropicMap, "tangent", *self._rotation, 2 * bracket / (x * norm))

    @property
    def tangent_inv(self) -> IsotropicMap:
        """Inverse tangent operator dcay_n⁻¹, CP23 (89); it takes the space twist to v̇."""
        p, q, half = self.p, self.q, sympy.Rational(1, 2)
        bracket = (1 + x) * q - self.order * p
        return self._formula(IsotropicMap, "tangent_inv", half * p / q, -half, half * bracket / (self.order * x * q))

    @property
    def _rotation(self) -> tuple[sympy.Expr, sympy.Expr]:
        norm = (1 + x) ** self.order
        return 2 * self.p * self.q / norm, 2 * self.q**2 / norm

    @property
    def _lost(self) -> str:
        return f"2*pi*k for 0 < 2*k < {self.order}"

    def _formula(self, kind: type[Map], name: str, *coefficients: sympy.Expr) -> Map:
        return replace(super()._formula(kind, name, *coefficients), at_zero=self._at_zero[name])
