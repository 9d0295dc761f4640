"""Arithmetic on floats with correctly rounded root and tangent, independent of the platform's library."""

from __future__ import annotations

import math

import mpmath

from derive.algebra.arithmetic import Arithmetic


class Sharp(Arithmetic):
    """Arithmetic of formulas, with the functions that a printed program calls."""

    sqrt = staticmethod(math.sqrt)

    @staticmethod
    def reciprocals(like: float, *integers: int) -> tuple[float, ...]:
        return tuple(1 / integer for integer in integers)

    @staticmethod
    def tan(angle: float) -> float:
        with mpmath.workdps(40):
            return float(mpmath.tan(angle))
