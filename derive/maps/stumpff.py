r"""Stumpff functions: sine and cosine of an angle divided by its powers, without loss of digits at any angle.

.. math::
    c_k(\xi) = \sum_{j \ge 0} \frac{(-\xi)^j}{(2j + k)!} \qquad
    c_0 = \cos\alpha \quad c_1 = \frac{\sin\alpha}{\alpha} \quad c_2 = \frac{1 - \cos\alpha}{\alpha^2} \quad
    c_3 = \frac{\alpha - \sin\alpha}{\alpha^3} \qquad \xi = \alpha^2

The functions are analytic in ξ, with ``c_k = 1/k! − ξ c_(k+2)`` and ``2 c_k′ = k c_(k+2) − c_(k+1)``. Below `LIMIT` a
truncated series gives the functions of the half angle. Sums of positive terms then give the functions of the angle:

.. math::
    c_3(4\zeta) = \tfrac14 (c_3 + c_1 c_2) \quad c_4(4\zeta) = \tfrac18 c_3 (1 + c_1) \quad
    c_5(4\zeta) = \tfrac1{16} (c_5 + c_4 + c_2 c_3)

    c_6(4\zeta) = \tfrac1{32} (2 c_5 + c_3^2) \quad c_7(4\zeta) = \tfrac1{64} (c_7 + c_6 + c_3 c_4 + \tfrac12 c_5)

Beyond `LIMIT`, sine and cosine give the functions without loss of digits.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from math import factorial
from operator import add, sub

from ..algebra import Coefficient
from ..algebra.arithmetic import Arithmetic
from .scalars import scalar

LIMIT = 6
"""Largest ξ for the series; the angle there is 2.4."""

TERMS = 9
"""Number of terms in the series of c₇ at ξ/4."""

REMAINDER = (LIMIT / 4) ** TERMS / factorial(2 * TERMS + 7)
"""Bound of the truncation error: the first omitted term of an alternating series with decreasing terms."""

UNIT = 17
"""Factorial that is the unit of later terms, so that floats of 53 bits hold all denominators."""


def series(zeta: Coefficient, m: Arithmetic) -> Coefficient:
    """Return the truncated series ``c₇ = 1/7! − ζ/9! + ζ²/11! − …``."""
    unit = factorial(UNIT)
    first = [m.reciprocal(zeta, factorial(k)) for k in range(7, UNIT, 2)]
    later = [m.reciprocal(zeta, factorial(k) // unit) for k in range(UNIT + 2, 2 * TERMS + 6, 2)]
    return _in_pairs([*first, m.reciprocal(zeta, unit) * _in_pairs([1, *later], zeta, m)], zeta, m)


def _in_pairs(
    terms: Sequence[Coefficient],
    power: Coefficient,
    m: Arithmetic,
    letter: str = "z",
    join: Callable[[Coefficient, Coefficient], Coefficient] = sub,
) -> Coefficient:
    """Return ``t₀ − ζ t₁ + ζ² t₂ − …`` as sums of pairs: fewer operations in a row than by Horner's rule.

    The power is ζ at first, then ζ² with the sums of pairs as terms, and so on; the letter names it.
    """
    if len(terms) == 1:
        return terms[0]
    pairs = [join(a, power * b) for a, b in zip(terms[::2], terms[1::2], strict=False)]
    return _in_pairs([*pairs, *terms[2 * len(pairs) :]], m.name(2 * letter, power * power), m, 2 * letter, add)


class Stumpff:
    """Stumpff functions c₃ … c₇ of an angle below the limit, from C₀ … C₇ of the half angle, at ``ζ = ξ/4``."""

    def __init__(self, zeta: Coefficient, m: Arithmetic) -> None:
        self.zeta = zeta
        self.m = m

    C7 = scalar(lambda at: series(at.zeta, at.m))
    C5 = scalar(lambda at: at.m.reciprocal(at.zeta, 120) - at.zeta * at.C7)
    C3 = scalar(lambda at: at.m.reciprocal(at.zeta, 6) - at.zeta * at.C5)
    C1 = scalar(lambda at: 1 - at.zeta * at.C3)
    CC1 = scalar(lambda at: at.C1 * at.C1)
    C0 = scalar(lambda at: at.m.sqrt(1 - at.zeta * at.CC1))
    C01 = scalar(lambda at: 1 + at.C0)
    C2 = scalar(lambda at: at.CC1 / at.C01)  # C₁²/(1 + C₀), by sin² + cos² = 1
    CC3 = scalar(lambda at: at.C3 * at.C3)
    # by sin² + cos² = 1; used only in sums with larger terms
    C4 = scalar(lambda at: (4 * at.C3 - at.C2 - 2 * (at.zeta * at.CC3)) / (2 * at.C01))
    # by sin² + cos² = 1
    C6 = scalar(lambda at: at.m.div(4 * at.C5 + 2 * at.CC3 - at.C4 - 2 * (at.C2 * at.C4), 4))

    c3 = cached_property(lambda at: at.m.div(at.C3 + at.C1 * at.C2, 4))
    c4 = scalar(lambda at: at.m.div(at.C3 * (1 + at.C1), 8))
    c5 = scalar(lambda at: at.m.div(at.C5 + at.C4 + at.C2 * at.C3, 16))
    c6 = scalar(lambda at: at.m.div(2 * at.C5 + at.C3 * at.C3, 32))
    c7 = cached_property(lambda at: at.m.div(at.C7 + at.C6 + at.C3 * at.C4 + at.m.div(at.C5, 2), 64))
    slope = property(lambda at: 3 * at.c5 - at.c4)  # 2 c₃′
    bend = property(lambda at: 15 * at.c7 - 7 * at.c6 + at.c5)  # 4 c₃″
