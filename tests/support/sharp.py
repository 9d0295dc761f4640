"""Floats whose root and tangent are rounded once, whatever a platform's library makes of them."""

from __future__ import annotations

import math

import mpmath

from derive.algebra.arithmetic import Plain


class Sharp(Plain):
    """The arithmetic of formulas, and what a printed program calls."""

    sqrt = staticmethod(math.sqrt)

    @staticmethod
    def tan(angle: float) -> float:
        with mpmath.workdps(40):
            return float(mpmath.tan(angle))
