"""Elements of prime fields, in which rational functions are compared at random points; bounds of their degrees."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import sympy


@dataclass(frozen=True)
class Residue:
    """Element of a prime field."""

    value: int
    prime: int

    def _of(self, other: Any) -> int:
        if isinstance(other, Residue):
            return other.value
        return int(other.numerator * pow(other.denominator, -1, self.prime))

    def _new(self, value: int) -> Residue:
        return Residue(value % self.prime, self.prime)

    def __add__(self, other: Any) -> Residue:
        return self._new(self.value + self._of(other))

    def __sub__(self, other: Any) -> Residue:
        return self._new(self.value - self._of(other))

    def __mul__(self, other: Any) -> Residue:
        return self._new(self.value * self._of(other))

    def __truediv__(self, other: Any) -> Residue:
        return self._new(self.value * pow(self._of(other), -1, self.prime))

    def __rsub__(self, other: Any) -> Residue:
        return -self + other

    def __rtruediv__(self, other: Any) -> Residue:
        return self._new(self._of(other)) / self

    def __neg__(self) -> Residue:
        return self._new(-self.value)

    __radd__, __rmul__ = __add__, __mul__


@dataclass(frozen=True)
class Degree:
    """Bounds of the degrees of numerator and denominator."""

    above: int = 1
    below: int = 0

    def __add__(self, other: Any) -> Degree:
        o = degree_of(other)
        return Degree(max(self.above + o.below, o.above + self.below), self.below + o.below)

    def __mul__(self, other: Any) -> Degree:
        o = degree_of(other)
        return Degree(self.above + o.above, self.below + o.below)

    def __truediv__(self, other: Any) -> Degree:
        o = degree_of(other)
        return Degree(self.above + o.below, self.below + o.above)

    def __rtruediv__(self, other: Any) -> Degree:
        return degree_of(other) / self

    def __neg__(self) -> Degree:
        return self

    __radd__ = __sub__ = __rsub__ = __add__
    __rmul__ = __mul__


def degree_of(other: Any) -> Degree:
    """Return the degree of an operand; numbers have degree 0."""
    return other if isinstance(other, Degree) else Degree(0)


@cache
def _fraction(expression: sympy.Expr, symbol: sympy.Symbol, order: int) -> tuple[list[int], list[int]]:
    """Return the coefficients of numerator and denominator of a derivative, from the highest power down."""
    parts = sympy.fraction(sympy.cancel(sympy.diff(expression, symbol, order)))
    above, below = (sympy.Poly(part, symbol).all_coeffs() for part in parts)
    whole = sympy.ilcm(*(c.q for c in (*above, *below)))
    return [int(c * whole) for c in above], [int(c * whole) for c in below]


class Lifting:
    """Evaluation of rational functions of one symbol, and of their derivatives, at numbers of any kind."""

    def derivatives(self, expression: sympy.Expr, symbol: sympy.Symbol, at: Any, order: int) -> list[Any]:
        parts = (_fraction(expression, symbol, k) for k in range(order + 1))
        return [_horner(above, at) / _horner(below, at) for above, below in parts]


def _horner(coefficients: Sequence[int], at: Any) -> Any:
    value = 0 * at
    for coefficient in coefficients:
        value = value * at + coefficient
    return value
