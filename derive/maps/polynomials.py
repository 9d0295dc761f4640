r"""Polynomials p_n, q_n of the higher-order Cayley maps, and their laws.

The polynomials satisfy ``(1 + iX)ⁿ = p_n + i X q_n`` with ``x = X²``. CP23 writes p_n(X), q_n(X). Both are even
in X; here they are functions of x:

.. math::
    p_1 = q_1 = 1, \quad p_{n+1} = p_n - x\,q_n, \quad q_{n+1} = q_n + p_n \qquad \text{CP23 (56)}

The recurrence is the definition; `derive.algebra.arithmetic` evaluates it at any number. The binomial sums CP23 (51),
(52), the addition law and the closed forms of c_n and d_n are theorems. `any_order` computes them independently.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any, TypeAlias

import sympy

from ..algebra import Coefficient, Dual, dual_part, real_part
from ..algebra.arithmetic import Pair, pair, pair_by_squaring, require_order

x = sympy.Symbol("x")
"""Square ``v · v`` of the parameter vector, a dual number."""

RING, RING_X = sympy.ring(x, sympy.ZZ)
"""Ring Z[x] of the polynomials, and its generator."""

FIELD = RING.to_field()
"""Field Q(x) of the coefficients of the maps."""

Triple: TypeAlias = tuple[Coefficient, Coefficient, Coefficient]


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
