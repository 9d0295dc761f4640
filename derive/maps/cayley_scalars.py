r"""The scalars of the Cayley map of order n at one ``x = v · v``, in closed form, with their slopes.

.. math::
    f = \frac{2 p q}{N} \quad g = \frac{2 q^2}{N} \quad h = \frac{2 c}{N} \quad
    f_i = \frac{p}{q} \quad h_i = \frac{d}{n q} \qquad N = p^2 + x q^2 = (1 + x)^n

in which c_n and d_n are the brackets of CP23 (88) and (89) divided by x. One source serves all uses: elements of Q(x)
give the formulas, ``Fraction`` and mpmath numbers values, `Dual` numbers dual values, traced numbers programs.
A slope, marked y, is ``2 d/dx``: the factor of ``v · v°`` in the dual part, since ``x° = 2 v · v°``. Slopes of slopes
are marked yy; with ``e = 2n/(1 + x)``, the slope of N over N, no division by x is left in any of them.
N is written ``p² + x q²``, whose rounding error does not grow with n, and ``(N/N)/N`` stands for 1/N, where powers of
1 + x are not divided out before: NaN where N has overflowed and 1/N would be finite and wrong. Only x is needed, never
|v|: a pure translation is no special case.
"""

from __future__ import annotations

from functools import cached_property

from ..algebra import Coefficient
from . import polynomials
from .cayley_polynomials import CayleyPolynomials
from .gains import has_ladder


class CayleyScalars(CayleyPolynomials):
    """What the Cayley map of an order makes of x; every value is computed, and named, when it is asked for."""

    # --- norm -------------------------------------------------------------------------------------------------

    @cached_property
    def _qq(self) -> Coefficient:
        return self.m.name("qq", self.q * self.q)

    @cached_property
    def norm(self) -> Coefficient:
        """``N = p² + x q² = (1 + x)ⁿ``."""
        return self.m.name("N", self.p * self.p + self.x * self._qq)

    @cached_property
    def root(self) -> Coefficient:
        """``(1 + x)^(n/2)``, positive: for an even order the norm of half the order, no square root taken."""
        if self.order % 2:
            return self.m.name("root", self.m.sqrt(self.norm))
        p, q = self._half
        root = p * p + self.x * (q * q)
        return self.m.name("root", root if self._expanded or self.order % 4 == 0 else root * self._shrinking)

    @cached_property
    def _half(self) -> tuple[Coefficient, Coefficient]:
        """p and q of half the order."""
        half = self.order // 2
        if self._expanded:
            p, q = polynomials.ring_pair(half)
            return self._horner("ph", p), self._horner("qh", q)
        first, second = self._chain[half]
        return first.value, second.value

    def _over(self, numerator: int, norm: Coefficient) -> Coefficient:
        if self._expanded:
            return numerator * (self.m.div(norm, norm) / norm)
        return self.m.div(numerator, norm)

    @cached_property
    def _twice_inverse_norm(self) -> Coefficient:
        return self.m.name("r", self._over(2, self.norm))

    @cached_property
    def _growth(self) -> Coefficient:
        """``2 N′/N = 2n/(1 + x)``."""
        return self.m.name("e", 2 * self.order / self._beyond_one)

    # --- q̂ = s + w v, CP23 (50), (55) -------------------------------------------------------------------------

    @cached_property
    def _inverse_root(self) -> Coefficient:
        return self.m.name("r", self._over(1, self.root))

    @cached_property
    def s(self) -> Coefficient:
        return self.m.name("s", self.p * self._inverse_root)

    @cached_property
    def w(self) -> Coefficient:
        return self.m.name("w", self.q * self._inverse_root)

    @cached_property
    def sy(self) -> Coefficient:
        """``2 s′ = −n w/(1 + x)``."""
        return self.m.name("sy", self.w * self.m.name("minus_e", -self.order / (1 + self.x)))

    @cached_property
    def wy(self) -> Coefficient:
        """``2 w′ = 2 q′/√N − n w/(1 + x)``."""
        return self.m.name("wy", 2 * self.dq * self._inverse_root + self.sy)

    @property
    def ray(self) -> tuple[Coefficient, Coefficient, Coefficient]:
        """(p, q, size) with ``p + q v`` the quaternion times its size, which only half angles ask for."""
        return self.p, self.q, self.root if self.order > 1 and has_ladder(self.order) else 1

    # --- R = I + f skew(v) + g skew(v)², T = f I + g skew(v) + h v⊗v, CP23 (57), (88) --------------------------

    @cached_property
    def f(self) -> Coefficient:
        return self.m.name("f", self.p * self.q * self._twice_inverse_norm)

    @cached_property
    def g(self) -> Coefficient:
        return self.m.name("g", self._qq * self._twice_inverse_norm)

    @cached_property
    def h(self) -> Coefficient:
        return self.m.name("h", self.c * self._twice_inverse_norm)

    @property
    def rate(self) -> Coefficient:
        """``2n/(1 + x)``."""
        return self._growth

    @property
    def ratey(self) -> Coefficient:
        """``−4n/(1 + x)²``."""
        return self.m.name("ey", -self._falling)

    @cached_property
    def _growing_g(self) -> Coefficient:
        return self.m.name("eg", self._growth * self.g)

    @cached_property
    def _falling(self) -> Coefficient:
        """``−2 e′ = e²/n``."""
        return self.m.name("ee", 2 * self._growth / self._beyond_one)

    @cached_property
    def fy(self) -> Coefficient:
        """``2 f′ = h − 2n g/(1 + x)``."""
        return self.m.name("fy", self.h - self._growing_g)

    @cached_property
    def gy(self) -> Coefficient:
        """``2 g′ = 8 q q′/N − 2n g/(1 + x)``."""
        return self.m.name("gy", self._rising - self._growing_g)

    @cached_property
    def _rising(self) -> Coefficient:
        """``8 q q′/N``."""
        return self.m.name("qr", 4 * self.dq * (self.q * self._twice_inverse_norm))

    @cached_property
    def hy(self) -> Coefficient:
        """``2 h′ = 4 c′/N − 2n h/(1 + x)``."""
        return self.m.name("hy", self._bending - self._growth * self.h)

    @cached_property
    def _bending(self) -> Coefficient:
        """``4 c′/N``."""
        return self.m.name("cr", 2 * self.dc * self._twice_inverse_norm)

    @cached_property
    def fyy(self) -> Coefficient:
        """``2 fy′ = hy − e gy + (e²/n) g``."""
        return self.m.name("fyy", self.hy - self._growing_gy + self._falling_g)

    @cached_property
    def _growing_gy(self) -> Coefficient:
        return self.m.name("egy", self._growth * self.gy)

    @cached_property
    def _falling_g(self) -> Coefficient:
        return self.m.name("eeg", self._falling * self.g)

    @cached_property
    def gyy(self) -> Coefficient:
        """``2 gy′ = 16 (q q″ + q′²)/N − e (gy + 8 q q′/N) + (e²/n) g``."""
        bend = 8 * ((self.q * self.ddq + self.dq * self.dq) * self._twice_inverse_norm)
        return self.m.name("gyy", bend - (self._growing_gy + self._growth * self._rising) + self._falling_g)

    @cached_property
    def hyy(self) -> Coefficient:
        """``2 hy′ = 8 c″/N − e (hy + 4 c′/N) + (e²/n) h``."""
        bend = 4 * (self.ddc * self._twice_inverse_norm)
        return self.m.name("hyy", bend - self._growth * (self.hy + self._bending) + self._falling * self.h)

    # --- T⁻¹ = (fi I − skew(v) + hi v⊗v)/2, CP23 (89) ----------------------------------------------------------

    @cached_property
    def _inverse_q(self) -> Coefficient:
        return self.m.name("iq", self.m.div(1, self.q))

    @cached_property
    def _bracket(self) -> Coefficient:
        return self.m.name("diq", self.d * self._inverse_q)

    @cached_property
    def _log_slope(self) -> Coefficient:
        """``q′/q``."""
        return self.m.name("dqiq", self.dq * self._inverse_q)

    @cached_property
    def fi(self) -> Coefficient:
        return self.m.name("fi", self.p * self._inverse_q)

    @cached_property
    def hi(self) -> Coefficient:
        return self.m.name("hi", self.m.div(self._bracket, self.order))

    @cached_property
    def fiy(self) -> Coefficient:
        """``2 fi′ = −c/q²``."""
        return self.m.name("fiy", -(self.c * (self._inverse_q * self._inverse_q)))

    @cached_property
    def hiy(self) -> Coefficient:
        """``2 hi′ = 2 (d′ − d q′/q)/(n q)``."""
        change = 2 * self.dd - 2 * self.dq * self._bracket
        return self.m.name("hiy", self.m.div(change * self._inverse_q, self.order))

    @cached_property
    def fiyy(self) -> Coefficient:
        """``2 fiy′ = (4 c q′/q − 2 c′)/q²``."""
        change = 4 * self.c * self._log_slope - 2 * self.dc
        return self.m.name("fiyy", change * self._inverse_q * self._inverse_q)

    @cached_property
    def hiyy(self) -> Coefficient:
        """``2 hiy′ = 4 (d″ − d q″/q)/(n q) − 4 (q′/q) hiy``."""
        bend = self.m.div(4 * ((self.ddd - self.ddq * self._bracket) * self._inverse_q), self.order)
        return self.m.name("hiyy", bend - 4 * self._log_slope * self.hiy)
