r"""Cayley map of a symbolic order n: p_n and q_n as binomial sums, and the maps in terms of them.

.. math::
    p_n = \sum_{k \ge 0} (-1)^k \binom{n}{2k} x^k \qquad q_n = \sum_{k \ge 0} (-1)^k \binom{n}{2k + 1} x^k \qquad
    \text{CP23 (51), (52)}

The formulas are CP23 (55), (57), (88) and (89) as printed. The theorems for every n prove them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Any, Self

import sympy
from sympy.printing.precedence import PRECEDENCE

from ..algebra.latex import latex
from .cayley import Cayley
from .chart_formulas import Map, factored
from .elementary import alpha
from .formula import IsotropicMap
from .polynomials import x

k, choose = sympy.Symbol("k", integer=True, nonnegative=True), sympy.binomial


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


def p_sum(n: sympy.Expr) -> sympy.Expr:
    return power_sum((-1) ** k * choose(n, 2 * k), n / 2)


def q_sum(n: sympy.Expr) -> sympy.Expr:
    return power_sum((-1) ** k * choose(n, 2 * k + 1), (n - 1) / 2)


def c_sum(n: sympy.Expr) -> sympy.Expr:
    return power_sum(n * choose(n - 1, k) - (-1) ** k * choose(2 * n, 2 * k + 1) / 2, n - 1, 1)


def d_sum(n: sympy.Expr) -> sympy.Expr:
    term = choose(n, 2 * k + 1) - choose(n, 2 * k - 1) - n * choose(n, 2 * k)
    return power_sum((-1) ** k * term, (n + 1) / 2, 1)


@dataclass(frozen=True)
class AnyOrder(Cayley):
    """Cayley map of a symbolic order n ≥ 1, with formulas but without kernels."""

    order: Any

    def __post_init__(self) -> None:
        n = self.order
        if n.is_integer is False or n.is_positive is False or n.has_free(x, alpha):
            raise ValueError(f"the order n must be an integer >= 1, or an expression in symbols for one, got {n}")
        object.__setattr__(self, "name", f"cayley_{n}")

    p = property(lambda m: p_sum(m.n))
    q = property(lambda m: q_sum(m.n))
    c = property(lambda m: c_sum(m.n))
    d = property(lambda m: d_sum(m.n))

    @property
    def singular_angles(self) -> tuple[sympy.Expr, ...]:
        """No tuple for a symbolic n: ValueError. The angles are 2πk < nπ, and nπ."""
        raise ValueError("the number of singular angles depends on n: put a number in its place, by subs")

    poles = singular_angles

    @property
    def limits(self) -> tuple[tuple[sympy.Expr, ...], tuple[sympy.Expr, ...]]:
        tangent, tangent_inv = super().limits
        return tuple(map(factored, tangent)), tuple(map(factored, tangent_inv))

    def _isotropic(self, closed_form: Callable[..., Any]) -> IsotropicMap:
        n, p, q, norm, name = self.n, self.p, self.q, (1 + x) ** self.n, closed_form.__name__
        f, g, half = 2 * p * q / norm, 2 * q**2 / norm, sympy.Rational(1, 2)
        printed = {
            "tensor": (1 - x * g, f, g),
            "tangent": (f, g, 2 * (n * (1 + x) ** (n - 1) - p * q) / (x * norm)),
            "tangent_inv": (half * p / q, -half, half * ((1 + x) * q - n * p) / (n * x * q)),
        }
        return self._formula(IsotropicMap, name, *printed[name])

    def _aligned(self, letters: Iterable[tuple[str, str]]) -> str:
        return super()._aligned(((latex(self.n), r"\text{order, an integer} \ge 1"), *letters))

    @property
    def _lost(self) -> str:
        return f"2*pi*k for 0 < 2*k < {self.n}"

    def _formula(self, kind: type[Map], name: str, *coefficients: sympy.Expr) -> Map:
        return replace(super()._formula(kind, name, *coefficients), at_zero=self._at_zero[name])
