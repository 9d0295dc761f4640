"""Numbers in place of the symbols of the exact ring: formulas at a point."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import lru_cache
from typing import Any

import mpmath
import sympy

from ...algebra import Dual
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

    def lift(self, expression: sympy.Expr, values: Mapping[sympy.Symbol, Any]) -> Any:
        """An algebraic expression at exact numbers, rounded to the working precision."""
        exact = tuple((symbol, _fraction(value)) for symbol, value in values.items())
        return mpmath.mpf(_evaluated(expression, exact, mpmath.mp.dps + 5))

    def in_angle(self, expression: sympy.Expr, square: Dual) -> Dual:
        """A function of α and its slope by x at an exact number x."""
        return self.chart.lifted(expression, square)


@lru_cache(maxsize=256)  # points differ in other components more often than in x
def _evaluated(expression: sympy.Expr, values: tuple[tuple[sympy.Symbol, Fraction], ...], digits: int) -> sympy.Float:
    return expression.xreplace({symbol: sympy.Rational(value) for symbol, value in values}).evalf(digits)


def _fraction(value: Any) -> Fraction:
    sign, mantissa, exponent, _ = mpmath.mpf(value)._mpf_
    magnitude = Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    return -magnitude if sign else magnitude
