"""Numbers in place of the symbols of the exact ring: formulas at a point."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import lru_cache
from typing import Any

import mpmath
import sympy

from ...maps.families import alpha
from .vectors import Vectors

SYMBOLS = tuple(f"{letter}{i}" for letter in "vw" for i in range(1, 7))
"""The components that cases are about."""


class Point:
    """Numbers in place of the symbols of the exact ring, with what expectations ask of a ring."""

    def __init__(self, values: Mapping[str, Any], chart: Vectors) -> None:
        self.values = values
        self.chart = chart

    def symbol(self, name: str) -> Any:
        return self.values[name]

    def value_and_slope(self, expression: sympy.Expr, symbol: sympy.Symbol, value: Any) -> tuple[Any, Any]:
        """A formula and its derivative at an exact number, rounded to the working precision."""
        if alpha in expression.free_symbols:
            return self.chart.value_and_slope(expression, value)
        at, digits = _fraction(value), mpmath.mp.dps + 5
        both = (_evaluated(e, symbol, at, digits) for e in (expression, _derivative(expression, symbol)))
        found, slope = map(mpmath.mpf, both)
        return found, slope


@lru_cache(maxsize=256)  # points differ in other components more often than in x
def _evaluated(expression: sympy.Expr, symbol: sympy.Symbol, value: Fraction, digits: int) -> sympy.Float:
    return expression.xreplace({symbol: sympy.Rational(value)}).evalf(digits)


@lru_cache(maxsize=256)
def _derivative(expression: sympy.Expr, symbol: sympy.Symbol) -> sympy.Expr:
    return expression.diff(symbol)


def _fraction(value: Any) -> Fraction:
    sign, mantissa, exponent, _ = mpmath.mpf(value)._mpf_
    magnitude = Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    return -magnitude if sign else magnitude
