r"""Chart ``v = α u`` with the logarithm as inverse map; its scalars are Stumpff functions c_k, CP23 (17), (25).

.. math::
    c_k(\xi) = \sum_{j \ge 0} \frac{(-\xi)^j}{(2j + k)!} \qquad
    c_0 = \cos\alpha \quad c_1 = \frac{\sin\alpha}{\alpha} \quad c_2 = \frac{1 - \cos\alpha}{\alpha^2} \quad
    c_3 = \frac{\alpha - \sin\alpha}{\alpha^3} \qquad \xi = \alpha^2

    s = c_0(x/4) \quad w = \tfrac12 c_1(x/4) \quad f = c_1 \quad g = c_2 \quad h = c_3(x)

The functions are analytic in ξ, with ``c_k = 1/k! − ξ c_(k+2)`` and ``2 c_k′ = k c_(k+2) − c_(k+1)``. Below `LIMIT` a
truncated series gives the functions of the half angle. Sums of positive terms then give the functions of the angle:

.. math::
    c_3(4\zeta) = \tfrac14 (c_3 + c_1 c_2) \quad c_4(4\zeta) = \tfrac18 c_3 (1 + c_1) \quad
    c_5(4\zeta) = \tfrac1{16} (c_5 + c_4 + c_2 c_3)

    c_6(4\zeta) = \tfrac1{32} (2 c_5 + c_3^2) \quad c_7(4\zeta) = \tfrac1{64} (c_7 + c_6 + c_3 c_4 + \tfrac12 c_5)

Beyond `LIMIT`, sine and cosine give the functions without loss of digits.

Other charts that compute the angle α from ``|v|`` have the same branches: branch k is ``v_k = φ(α + 2πk) u``. It exists
where ``|α + 2πk|`` is less than the edge, and is NaN elsewhere.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import factorial
from operator import add, sub
from typing import Any, ClassVar

import mpmath
import sympy

from ..algebra import Coefficient, Quaternion
from ..algebra.arithmetic import Arithmetic, Pair
from . import order_charts
from .elementary import alpha
from .order_charts import Derivatives, half_angle, half_cosine, half_sine, kept_inside
from .real_constants import number, times
from .scalars import DependentScalars, QuaternionChart, scalar

TURNS_MAX = 2
"""Number of whole turns that are listed for a chart without an edge."""

PART_OF_TURN = Fraction(3217, 512)
"""Number of 12 bits, off 2π by 3e-6 of it: floats hold its multiples, so a turn back loses few digits of an angle."""


class AngleChart(QuaternionChart):
    """Chart that computes its angle from ``|v|`` to go from branch to branch."""

    order = 1
    branches = 0

    @property
    def algebraic(self) -> bool:
        return False

    @property
    def singular_angles(self) -> tuple[sympy.Expr, ...]:
        """Whole turns, then the edge, if any."""
        turns = TURNS_MAX if self.edge.is_infinite else int(sympy.ceiling(self.edge / (2 * sympy.pi))) - 1
        whole = tuple(2 * sympy.pi * k for k in range(1, turns + 1))
        return whole if self.edge.is_infinite else (*whole, self.edge)

    @abstractmethod
    def own_angle(self, at: Any, r: Coefficient) -> Coefficient:
        """Return α for a length r, from the scalars at ``r²``."""

    @abstractmethod
    def phi_derivatives(self, angle: Coefficient, m: Arithmetic, mark: str = "") -> Derivatives:
        """Return φ, φ′ and φ″ at an angle, NaN beyond the edge; `mark` is a suffix for names."""

    def coefficient(self, angle: Coefficient, m: Arithmetic) -> Pair:
        r, slope, _ = self.phi_derivatives(angle, m)
        return m.name("r", r), m.name("slope", slope)

    def gain(self, q: Quaternion, size: Coefficient, m: Arithmetic) -> Coefficient:
        """Return ``φ/sin(α/2)``; α follows from sine and cosine of α/2."""
        sign, cosine = half_cosine(q, size, m)
        if self.edge <= sympy.pi:
            cosine = m.name("size_of_cos", m.abs(cosine))
        still, _, sine = half_sine(q, cosine, m)
        r, _, _ = self.phi_derivatives(m.name("angle", 2 * m.atan2(sine, cosine)), m)
        at_rest = times(number(2 * self.phi.diff(alpha).subs(alpha, 0)), cosine, m, "rest")
        gain = m.where(still, at_rest, r) / m.where(still, cosine * cosine, sine)
        return kept_inside(self, m.name("gain", sign * gain), q, m)

    # --- branches ---------------------------------------------------------------------------------------------------

    def unfolded(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        return self.own_angle(self.scalars(x, m), r)

    def turned(self, r: Coefficient, turn: Sequence[Coefficient], m: Arithmetic) -> Derivatives:
        share, most = turn
        at = self.scalars(m.name("rr", r * r), m)
        angle = m.name("own", self.own_angle(at, r))
        after = self.phi_derivatives(m.name("alphak", angle + most + share * most), m, "k")
        return order_charts.by_length(self.phi_derivatives(angle, m), after, m)

    def beyond(self, x: Coefficient, table: Sequence[Coefficient], m: Arithmetic) -> tuple[Any, Coefficient, Pair]:
        """Return whether α > π, x there, and the turn back, which leaves all digits of the principal angle."""
        selected, place, _ = order_charts.beyond(x, table, m)
        at, r = self.scalars(x, m), m.name("rx", m.sqrt(place))
        s, sine = at.s, m.name("sine", at.w * r)
        sign = m.name("side", m.where(m.less(s, 0), -1, 1))
        reduced = 2 * m.atan2(sign * sine, sign * s)
        back = m.name("back", -self.own_angle(at, r))
        return selected, place, (m.name("share", m.div(reduced, back)), back)

    def turn(self, branch: int) -> tuple[Any, Any]:
        """Return the share of a turn's larger part that is missing, and this part, which floats hold exactly."""
        part = mpmath.mpf(PART_OF_TURN.numerator) / PART_OF_TURN.denominator
        return 2 * mpmath.pi / part - 1, branch * part

    def returns(self) -> tuple[tuple[Any, Any, Any], ...]:
        """Return one row, of x at α = π and a turn of 0 that `beyond` replaces; none if the edge is at most π."""
        if self.edge <= sympy.pi:
            return ()
        return ((order_charts.square(self.phi, sympy.pi), *self.turn(0)),)


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


class ExponentialScalars(DependentScalars):
    """Scalars at x = α²."""

    rate = 1
    ai = 2
    ratey = 0
    rateyy = 0
    principal = False  # True if α is at most π

    _near = scalar(lambda at: at.m.less(at.x, LIMIT), "nearby")

    @cached_property
    def _near_zero(self) -> Stumpff:
        """Stumpff functions by series; beyond the limit, unused values at angle 0."""
        zeta = self.m.name("z", self.m.div(self.m.where(self._near, self.x, self.x - self.x), 4))
        return Stumpff(zeta, self.m)

    # α² if beyond the limit, else an unused value beyond the limit
    _square = scalar(lambda at: at.m.where(at._near, LIMIT + at.x, at.x), "xx")
    _angle = scalar(lambda at: at.m.sqrt(at._square), "alpha")  # α beyond the limit

    _circular = cached_property(lambda at: half_angle(at._angle, at._angle, at.m))

    @cached_property
    def _turned(self) -> Pair:
        """Values of ``sin α`` and ``1 − cos α``, corrected for the rounding error of the root α = √x."""
        t = self.m.name("thalf", self.m.tan(self.m.div(self._angle, 2)))
        tt = self.m.name("tthalf", t * t)
        below = self.m.name("belowhalf", 1 + tt)
        sine = self.m.name("sine", 2 * t / below)
        # near half a turn, terms as large as t would cancel in the derivative of 2 tt/below
        versine = self.m.name("versine", self.m.where(self.m.less(tt, 16), 2 * tt / below, 2 - 2 / below))
        return sine + self._lost * (1 - versine), versine + self._lost * sine

    @cached_property
    def _lost(self) -> Coefficient:
        """Rounding error ``(α² − root²)/2α`` of the root, by terms that are exact up to α = 8; α² is not rounded to x.

        Beyond 8 the result is 0: the error may be a large angle, and a corrected R would be no rotation.
        """
        beside = self.m.name("beside", self._angle - 4)
        left = (self._square - 16) - 8 * beside - beside * beside
        left = self.m.name("left", left + self.m.rounded_off(self.x))
        left = left if self.principal else self.m.where(self.m.less(self._angle, 8), left, 0)
        return self.m.name("lost", left / (2 * self._angle))

    s = scalar(lambda at: at.m.where(at._near, at._near_zero.C0, at._circular[0]))
    w = scalar(lambda at: at.m.where(at._near, at.m.div(at._near_zero.C1, 2), at._circular[1]))
    f = scalar(lambda at: at.m.where(at._near, at._near_zero.C0 * at._near_zero.C1, at._turned[0] / at._angle))
    g = scalar(lambda at: at.m.where(at._near, at.m.div(at._near_zero.CC1, 2), at._turned[1] / at._square))
    h = scalar(lambda at: at.m.where(at._near, at._near_zero.c3, (1 - at.f) / at._square))
    hy = scalar(lambda at: at.m.where(at._near, at._near_zero.slope, (at.g - 3 * at.h) / at._square))
    hyy = scalar(lambda at: at.m.where(at._near, at._near_zero.bend, (at.gy - 5 * at.hy) / at._square))


class PrincipalScalars(ExponentialScalars):
    """Scalars up to half a turn, the range of the logarithm."""

    principal = True


class StepScalars(ExponentialScalars):
    """Scalars of a step, whose f and g come from its quaternion: errors are those of the angle |δ|."""

    f, g = DependentScalars.f, DependentScalars.g


@dataclass(frozen=True)
class Exponential(AngleChart):
    """Chart v = α u, without an edge."""

    name: str = "exponential"
    selection: tuple[str, str] = ("--family", "exponential")
    title: str = "Exponential map"
    vector: ClassVar[str] = "Euler dual vector"
    operator: ClassVar[str] = "dexp"

    @property
    def phi(self) -> sympy.Expr:
        return alpha

    @property
    def edge(self) -> sympy.Expr:
        return sympy.oo

    @property
    def remainder(self) -> float:
        return REMAINDER

    def overflow(self, largest: float) -> tuple[str, float]:
        return "x overflows", float(largest**0.5)

    def scalars(self, x: Coefficient, m: Arithmetic) -> ExponentialScalars:
        return ExponentialScalars(x, m)

    def own_angle(self, at: ExponentialScalars, r: Coefficient) -> Coefficient:
        return r

    def phi_derivatives(self, angle: Coefficient, m: Arithmetic, mark: str = "") -> Derivatives:
        return angle, 1, 0
