"""Operations of formulas other than + − ×: exact division, roots, comparison, selection, names.

A formula with an `Arithmetic` argument computes values or records a program. The class itself computes with numbers. A
trace (``codegen.programs``) overrides every operation and records it, with the names of intermediate values.

Pairs (p_n, q_n) of numbers are values at x = X² of the polynomials in ``(1 + iX)ⁿ = p_n + i X q_n``, CP23 (56).
"""

from __future__ import annotations

import operator
from fractions import Fraction
from typing import Any, TypeAlias

from . import functions
from .dual import Coefficient


class Arithmetic:
    """Operations on numbers of any type; names are ignored."""

    def name(self, name: str, value: Coefficient, /) -> Coefficient:
        """Name a value and return it."""
        return value

    def name_rest(self, letter: str, /) -> None:
        """Set the letter that, with a number, names all further values."""

    def corrected(self, value: Coefficient, /) -> Coefficient:
        """Mark a value whose rounding error a later Newton step corrects, and return the value."""
        return value

    def rounded_off(self, value: Coefficient, /) -> Coefficient:
        """Return the rounding error of the additions recorded for a value; 0 without a record."""
        return 0

    def div(self, a: Coefficient, b: Coefficient, /) -> Coefficient:
        """Return a/b, as an exact fraction for integers."""
        return Fraction(a, b) if isinstance(a, int) and isinstance(b, int) else a / b

    def reciprocal(self, like: Coefficient, b: int, /) -> Coefficient:
        """Return 1/b as a number like another one; programs hold it as a constant."""
        return self.div(like - like + 1, b)

    def beside(self, size: Coefficient, term: Coefficient, /) -> Coefficient:
        """Return size + term, for comparison with the size: equal if the data's precision loses the term."""
        return size + term

    abs = staticmethod(abs)
    sqrt = staticmethod(functions.sqrt)
    tan = staticmethod(functions.tan)
    atan2 = staticmethod(functions.atan2)
    expm1 = staticmethod(functions.expm1)
    log1p = staticmethod(functions.log1p)
    less = staticmethod(operator.lt)
    equal = staticmethod(operator.eq)

    def both(self, a: Any, b: Any, /) -> Any:
        return a and b

    def either(self, a: Any, b: Any, /) -> Any:
        return a or b

    def where(self, condition: Any, a: Coefficient, b: Coefficient, /) -> Coefficient:
        """Return a where the condition holds, else b."""
        return a if condition else b


PLAIN = Arithmetic()


class Marked:
    """Arithmetic whose names end in a mark, for a formula inside another one."""

    def __init__(self, arithmetic: Arithmetic, mark: str) -> None:
        self._arithmetic = arithmetic
        self._mark = mark

    def name(self, name: str, value: Coefficient, /) -> Coefficient:
        return self._arithmetic.name(name + self._mark, value)

    def __getattr__(self, operation: str) -> Any:
        return getattr(self._arithmetic, operation)


Pair: TypeAlias = tuple[Coefficient, Coefficient]


def require_order(n: Any) -> int:
    """Return the order as an ``int``; TypeError if `n` is no integer or a ``bool``, ValueError if it is below 1."""
    try:
        order = operator.index(n)
    except TypeError:
        order = None
    if order is None or isinstance(n, bool):
        raise TypeError(f"the order n must be an integer >= 1, got {n!r} of type {type(n).__name__}")
    if order < 1:
        raise ValueError(f"the order n must be an integer >= 1, got {order}")
    return order


FIRST: Pair = (1, 1)
"""Pair (p_1, q_1)."""


def following(pair: Pair, at: Coefficient) -> Pair:
    """Return the pair of order n + 1 from the pair of order n, by the recurrence CP23 (56)."""
    p, q = pair
    return p - at * q, p + q


def pair(n: int, at: Coefficient) -> Pair:
    """Return (p_n, q_n) at any number `at` by the recurrence CP23 (56), in n − 1 steps."""
    result = FIRST
    for _ in range(require_order(n) - 1):
        result = following(result, at)
    return result


def multiply(first: Pair, second: Pair, at: Coefficient) -> Pair:
    """Return the pair of order m + n from the pairs of orders m and n: addition law, ``(1 + iX)ᵐ (1 + iX)ⁿ``."""
    (p, q), (r, s) = first, second
    return p * r - at * (q * s), p * s + q * r


def double(half: Pair, at: Coefficient) -> Pair:
    """Return the pair of order 2m by the doubling law ``p_2m = p_m² − x q_m²``, ``q_2m = 2 p_m q_m``."""
    p, q = half
    return p * p - at * (q * q), 2 * (p * q)


def pair_by_squaring(n: int, at: Coefficient) -> Pair:
    """Return (p_n, q_n) at any number `at` in about ``2 log2 n`` doublings and single steps."""
    result = FIRST
    for bit in f"{require_order(n):b}"[1:]:
        result = double(result, at)
        if bit == "1":
            result = following(result, at)
    return result
