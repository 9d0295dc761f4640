"""Angle of a quaternion and gain of a Cayley map, the factor in ``v = gain · vec q``, for values and programs.

The gain is ``tan(α/2n)/sin(α/2)`` with the sign of the scalar part. For n a power of two,
half-angle formulas replace trigonometric functions.
"""

from __future__ import annotations

import math
from typing import Any

from ..algebra import Coefficient, Quaternion
from ..algebra.arithmetic import Arithmetic


def gain(n: int, q: Quaternion, size: Coefficient, m: Arithmetic, positive: bool = False) -> Coefficient:
    """Return ``tan(α/2n)/|vec q|`` with the sign of the scalar part, for a quaternion of norm `size`.

    Only n = 2, 4, 8, … need `size`. The gain is infinite at α = nπ: for n = 1 at half a turn.
    """
    if n == 1:
        return m.div(1, q.scalar)
    negative, cosine = half_cosine(q, m, positive)
    sign = m.where(negative, -1, 1)
    if has_ladder(n):
        return m.div(sign, _ladder(n, cosine, size, m))
    still, square, sine = half_sine(q, cosine, m)
    if not (positive or isinstance(size, int)):  # NaN instead of 1/∞ = 0 where the square overflows
        sine = m.name("sinq", square / sine)
    tangent = m.tan(m.div(m.atan2(sine, cosine), n))
    return sign * (m.where(still, 1, tangent) / m.where(still, n * cosine, sine))


def half_cosine(q: Quaternion, m: Arithmetic, positive: bool) -> tuple[Any, Coefficient]:
    """Return whether the scalar part is negative, and its absolute value."""
    negative = False if positive else m.name("negative", m.less(q.scalar, 0))
    cosine = m.name("cos", m.where(negative, -q.scalar, q.scalar))
    return negative, cosine


def half_sine(q: Quaternion, cosine: Coefficient, m: Arithmetic) -> tuple[Any, Coefficient, Coefficient]:
    """Return whether the vector part is 0, its square, and its length (a stand-in for a zero vector)."""
    square = m.name("ss", q.vector.dot(q.vector))
    still = m.name("still", m.equal(square, 0))
    # avoid the root of 0: its derivative is infinite, and 0 · ∞ would spoil the gradient
    sine = m.name("sin", m.sqrt(m.where(still, cosine, square)))
    return still, square, sine


def has_ladder(n: int) -> bool:
    """Return whether n is a power of two: then log2(n) half-angle formulas lead from α/2 to α/2n."""
    return n & (n - 1) == 0


def _ladder(n: int, cosine: Coefficient, size: Coefficient, m: Arithmetic) -> Coefficient:
    """Return ``size · sin(α/2)/tan(α/2n)`` for n = 2^m, from ``size · cos(α/2)``."""
    divisor: Coefficient = 1
    c = cosine if n == 2 else m.name("cos1", m.div(cosine, size))
    unit = size if n == 2 else 1
    step = 1
    while n > 2:
        n //= 2
        step += 1
        c = m.name(f"cos{step}", m.sqrt(m.div(1 + c, 2)))
        divisor = divisor * (2 * c)
    total = divisor * (unit + c)
    return total if unit is size else total * size


def near_pole(
    n: int, angle: Coefficient, sine: Coefficient, cosine: Coefficient, m: Arithmetic
) -> tuple[Any, Coefficient, Coefficient]:
    """Return whether |α| is near the pole nπ, the distance ``nπ − |α|`` if so or |α| if not, and the sign of α.

    ``sine >= 0`` and ``cosine`` belong to α/2, up to a common factor. They give all digits of the distance, by its
    half tangent ``−tan(α/2)`` for even n, ``cot(α/2)`` for odd n. The rounded angle gives few digits near the pole.
    """
    side = m.name("sideof", m.where(m.less(angle, 0), -1, 1))
    size = m.name("size", m.abs(angle))
    next_to = m.name("nextto", m.less(m.abs(size - round(n * math.pi)), 1))
    above, below = (cosine, sine) if n % 2 else (-sine, cosine)
    divisor = m.name("divisor", m.where(next_to, below, 1))
    left = 2 * side * m.atan2(above / divisor, 1)
    return next_to, m.name("rest", m.where(next_to, left, size)), side
