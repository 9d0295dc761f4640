"""Pairs (p_n, q_n) of numbers: values at x = X² of the polynomials in ``(1 + iX)ⁿ = p_n + i X q_n``, CP23 (56)."""

from __future__ import annotations

import operator
from typing import Any, TypeAlias

from .dual import Coefficient

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
