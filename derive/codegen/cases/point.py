"""Functions at given numbers: formulas at a point, numbers in place of elements of the exact ring."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any

import mpmath
import sympy

from ...maps.families import alpha
from ..rows import Function
from .exact import ALGEBRAIC, Flat, Formulas, evaluated
from .maps_at import MAPS
from .vectors import Vectors


@dataclass(frozen=True, slots=True)
class Numbers:
    """Numbers in place of elements of the exact ring, with what formulas ask of a ring."""

    chart: Vectors

    def derivatives(self, expression: sympy.Expr, symbol: sympy.Symbol, value: Any, order: int) -> Sequence[Any]:
        """A formula at an exact number and its derivatives, rounded to the working precision."""
        if _of_angle(expression):
            return self.chart.derivatives(expression, value, order)
        return _derivatives(expression, symbol, mpmath.mpf(value), order, mpmath.mp.dps)


def value(chart: Vectors, row: Function, branch: int | None, arguments: Sequence[Flat]) -> Flat:
    """What a function returns at given numbers."""
    zero = mpmath.mpf(0)
    if row.source in ALGEBRAIC:
        return evaluated(row, Formulas(chart.chart, Numbers(chart)), arguments, zero)
    return row.part(MAPS[row.source](chart, branch or 0, *row.embedded(arguments, zero)))


@lru_cache(maxsize=256)  # a tree is walked to tell
def _of_angle(expression: sympy.Expr) -> bool:
    return alpha in expression.free_symbols


@lru_cache(maxsize=1024)  # points differ in other components more often than in x
def _derivatives(expression: sympy.Expr, symbol: sympy.Symbol, value: Any, order: int, digits: int) -> tuple[Any, ...]:
    at, found = sympy.Rational(_fraction(value)), []
    for _ in range(order + 1):
        found.append(mpmath.mpf(expression.xreplace({symbol: at}).evalf(digits + 5)))
        expression = _derivative(expression, symbol)
    return tuple(found)


@lru_cache(maxsize=256)
def _derivative(expression: sympy.Expr, symbol: sympy.Symbol) -> sympy.Expr:
    return expression.diff(symbol)


def _fraction(value: Any) -> Fraction:
    sign, mantissa, exponent, _ = mpmath.mpf(value)._mpf_
    magnitude = Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    return -magnitude if sign else magnitude
