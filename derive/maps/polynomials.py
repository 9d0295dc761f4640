r"""Polynomials p_n, q_n of the higher-order Cayley maps, and their laws.

The polynomials satisfy ``(1 + iX)ⁿ = p_n + i X q_n`` with ``x = X²``. CP23 writes p_n(X), q_n(X). Both are even
in X; here they are functions of x:

.. math::
    p_1 = q_1 = 1, \quad p_{n+1} = p_n - x\,q_n, \quad q_{n+1} = q_n + p_n \qquad \text{CP23 (56)}

The recurrence is the definition. The binomial sums CP23 (51), (52), the addition law and the closed forms of c_n and
d_n are theorems. Functions of this module and of `any_order` compute them independently.
"""

from __future__ import annotations

import operator
from functools import lru_cache
from typing import Any, TypeAlias

import sympy

from ..algebra import Coefficient, Dual, dual_part, real_part

x = sympy.Symbol("x")
"""Square ``v · v`` of the parameter vector, a dual number."""

RING, RING_X = sympy.ring(x, sympy.ZZ)
"""Ring Z[x] of the polynomials, and its generator."""

FIELD = RING.to_field()
"""Field Q(x) of the coefficients of the maps."""

Pair: TypeAlias = tuple[Coefficient, Coefficient]
Triple: TypeAlias = tuple[Coefficient, Coefficient, Coefficient]


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


def brackets(n: int, at: Coefficient) -> Pair:
    """Return (c_n, d_n) from the pair at ``at + ε``: ``c_n = 2 (p q′ − q p′)``, ``d_n = q − 2 q′ − 2 p′``.

    Unlike the alternating sums of `any_order.AnyOrder`, the formulas lose no digits on shadows at high order.
    """
    p, q = pair_by_squaring(n, Dual(at, 1))
    return brackets_of(real_part(p), real_part(q), dual_part(p), dual_part(q))


def brackets_of(p: Coefficient, q: Coefficient, dp: Coefficient, dq: Coefficient) -> Pair:
    """Return (c_n, d_n) from p_n, q_n and their derivatives."""
    return 2 * (p * dq - q * dp), q - 2 * dq - 2 * dp


@lru_cache(maxsize=256)
def ring_pair(n: int) -> tuple[Any, Any]:
    """Return p_n and q_n as elements of `RING`, by the recurrence."""
    p, q = pair(n, RING_X)
    return RING(p), RING(q)


@lru_cache(maxsize=256)
def ring_brackets(n: int) -> tuple[Any, Any]:
    """Return c_n and d_n as elements of `RING`, the brackets of CP23 (88) and (89) divided exactly by x."""
    p, q = ring_pair(n)
    brackets = n * (1 + RING_X) ** (n - 1) - p * q, (1 + RING_X) * q - n * p
    return brackets[0].exquo(RING_X), brackets[1].exquo(RING_X)


def horner(polynomial: Any, x: Coefficient) -> Coefficient:
    """Return the value of an element of Z[x] at a number x, by Horner's rule."""
    value: Coefficient = 0
    for power in range(max(polynomial.degree(), 0), -1, -1):
        value = value * x + int(polynomial.get((power,), 0))
    return value


def rational(value: Any) -> sympy.Expr:
    """Return an element of `FIELD` as a reduced fraction in x; powers of ``1 + x`` in the denominator stay factored."""
    element = FIELD(value)
    numerator, denominator, power = element.numer, element.denom, 0
    while denominator.evaluate(0, -1) == 0:
        denominator, power = denominator.exquo(1 + RING_X), power + 1
    if denominator.evaluate(0, 0) < 0:
        numerator, denominator = -numerator, -denominator
    return numerator.as_expr() / (denominator.as_expr() * (1 + x) ** power)


def singular_angles(n: int) -> tuple[sympy.Expr, ...]:
    """Return the angles ``2πk``, ``1 ≤ k ≤ ⌊(n−1)/2⌋``, where dcay_n loses rank, then ``nπ``, where v → ∞."""
    poles = tuple(2 * sympy.pi * k for k in range(1, (require_order(n) - 1) // 2 + 1))
    return (*poles, n * sympy.pi)


def poles(n: int) -> tuple[sympy.Expr, ...]:
    """Return the poles of dcay_n⁻¹, ``Re|v| = tan(kπ/n)`` for ``1 ≤ k ≤ ⌊(n−1)/2⌋``, where ``q_n = 0``."""
    return tuple(sympy.tan(sympy.pi * k / n) for k in range(1, (require_order(n) - 1) // 2 + 1))
