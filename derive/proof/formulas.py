"""Formulas in the theorems for all n: coefficients of I, skew(v), v⊗v as functions of n, x, p_n, q_n."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ..algebra import Coefficient
from . import notation
from .statement import Premise, definition

Triple = tuple[Coefficient, Coefficient, Coefficient]
CoefficientsOfOrder = Callable[[Any, Any, Any, Any], Triple]
SYMBOLS = (notation.n, notation.x, notation.p, notation.q)


def tensor(n: Coefficient, x: Coefficient, p: Coefficient, q: Coefficient) -> Triple:
    """Return the coefficients of I, skew(v), v⊗v in R, CP23 (57) with skew(v)² = v⊗v − x I."""
    power = p * p + x * q * q
    return 1 - 2 * x * q * q / power, 2 * p * q / power, 2 * q * q / power


def tangent(n: Coefficient, x: Coefficient, p: Coefficient, q: Coefficient) -> Triple:
    """Return the coefficients of I, skew(v), v⊗v in dcay, CP23 (88)."""
    power = p * p + x * q * q
    bracket = (n * power / (1 + x) - p * q) / x
    return 2 * p * q / power, 2 * q * q / power, 2 * bracket / power


def tangent_inv(n: Coefficient, x: Coefficient, p: Coefficient, q: Coefficient) -> Triple:
    """Return the coefficients of I, skew(v), v⊗v in the inverse of dcay, CP23 (89)."""
    bracket = ((1 + x) * q - n * p) / x
    return p / (2 * q), (x - x - 1) / 2, bracket / (2 * n * q)


def defined(
    symbol: Any, formula: CoefficientsOfOrder, at: Any = SYMBOLS, v: Any = notation.v, numbers: tuple[int, ...] = ()
) -> Premise:
    """Return the definition of a symbol by a formula at (n, x, p_n, q_n), ``a I + b skew(v) + c v⊗v``."""
    a, b, c = formula(*at)
    rest = b * notation.skew(v) + c * notation.dyad(v, v)
    return definition(symbol, a * notation.I + rest, numbers, wrong=2 * a * notation.I + rest)
