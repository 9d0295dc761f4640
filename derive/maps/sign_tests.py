"""Exact zero tests and signs of real numbers of any type."""

from __future__ import annotations

import sympy

from ..algebra import Coefficient


def is_zero(value: Coefficient) -> bool:
    """Return whether a number is exactly zero; roots in SymPy numbers are rationalised and expanded first."""
    if isinstance(value, sympy.Expr):
        value = sympy.expand(sympy.radsimp(value))
    return bool(value == 0)


def orientation(*values: Coefficient) -> int:
    """Return the sign, 1 or −1, of the first non-zero value; 1 if there is none."""
    for value in values:
        if not is_zero(value):
            return 1 if value > 0 else -1
    return 1
