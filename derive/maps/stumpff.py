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

from functools import cached_property
from math import factorial

from ..algebra import Coefficient
from ..algebra.arithmetic import Arithmetic
from .real_constants import SMALL
from .scalars import scalar

LIMIT = 6
"""Largest ξ for the series; the angle there is 2.4."""

TERMS = 9
"""Number of terms in the series of c₇ at ξ/4."""

REMAINDER = (LIMIT / 4) ** TERMS / factorial(2 * TERMS + 7)
"""Bound of the truncation error: the first omitted term of an alternating series with decreasing terms."""


def series(zeta: Coefficient, m: Arithmetic) -> Coefficient:
    """Return the truncated series ``7! c₇ = 1 − ζ/8·9 (1 − ζ/10·11 (1 − …))``; adjacent denominators are multiplied."""
    above: Coefficient = 1
    below = 1
    for step in range(TERMS - 1, 0, -1):
        divisor = (2 * step + 6) * (2 * step + 7)
        if below * divisor > SMALL:
            above, below = m.div(above, below), 1
        below *= divisor
        above = below - zeta * above
    return m.div(above, below)


class HalfAngle:
    """Stumpff functions c₀ … c₇ of the half angle, at ``ζ = ξ/4`` below the limit."""

    def __init__(self, zeta: Coefficient, m: Arithmetic) -> None:
        self.zeta = zeta
        self.m = m

    c7 = scalar(lambda at: at.m.div(series(at.zeta, at.m), 5040), "C7")
    c5 = scalar(lambda at: at.m.div(1 - 120 * (at.zeta * at.c7), 120), "C5")
    c3 = scalar(lambda at: at.m.div(1 - 6 * (at.zeta * at.c5), 6), "C3")
    c1 = scalar(lambda at: 1 - at.zeta * at.c3, "C1")
    square = scalar(lambda at: at.c1 * at.c1, "CC1")  # c₁²
    c0 = scalar(lambda at: at.m.sqrt(1 - at.zeta * at.square), "C0")
    _beside = scalar(lambda at: 1 + at.c0, "C01")
    c2 = scalar(lambda at: at.square / at._beside, "C2")  # c₁²/(1 + c₀), by sin² + cos² = 1
    _cube = scalar(lambda at: at.c3 * at.c3, "CC3")
    # by sin² + cos² = 1; used only in sums with larger terms
    c4 = scalar(lambda at: (4 * at.c3 - at.c2 - 2 * (at.zeta * at._cube)) / (2 * at._beside), "C4")
    # by sin² + cos² = 1
    c6 = scalar(lambda at: at.m.div(4 * at.c5 + 2 * at._cube - at.c4 - 2 * (at.c2 * at.c4), 4), "C6")


class WholeAngle:
    """Stumpff functions c₃ … c₇ of the whole angle, from the half angle."""

    def __init__(self, half: HalfAngle, m: Arithmetic) -> None:
        self.half = half
        self.m = m

    c3 = cached_property(lambda at: at.m.div(at.half.c3 + at.half.c1 * at.half.c2, 4))
    c4 = scalar(lambda at: at.m.div(at.half.c3 * (1 + at.half.c1), 8))
    c5 = scalar(lambda at: at.m.div(at.half.c5 + at.half.c4 + at.half.c2 * at.half.c3, 16))
    c6 = scalar(lambda at: at.m.div(2 * at.half.c5 + at.half.c3 * at.half.c3, 32))

    @cached_property
    def c7(self) -> Coefficient:
        total = self.half.c7 + self.half.c6 + self.half.c3 * self.half.c4 + self.m.div(self.half.c5, 2)
        return self.m.div(total, 64)
