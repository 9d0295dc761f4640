r"""Charts of order n with θ = α/2n: ``q̂ = (cos θ + σ v)ⁿ``, ``σ = sin θ/|v|``; CP23 (60) with ``a = cos θ/σ``.

A subclass defines φ as a function of θ. Branches differ by turns ``kπ/n`` of θ, reduced to |θ| < π/2.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence

from ..algebra import Coefficient, Quaternion
from ..algebra.arithmetic import Arithmetic
from . import branches
from .branches import Derivatives
from .gains import half_cosine, half_sine, has_ladder
from .polynomials import Pair
from .scalars import QuaternionChart


class OrderChart(branches.BranchesOfOrder, QuaternionChart):
    """Chart v = φ(α) u of order n: φ is a function of θ = α/2n with its edge at θ = π/2."""

    @abstractmethod
    def phi_derivatives(self, sine: Coefficient, cosine: Coefficient, m: Arithmetic, mark: str = "") -> Derivatives:
        """Return φ and its first two derivatives by θ, from sine and cosine of θ; `mark` is a suffix for names."""

    @abstractmethod
    def cosine(self, x: Coefficient, m: Arithmetic) -> Pair:
        """Return cos θ and ``σ = sin θ/|v|`` at x."""

    @abstractmethod
    def over_sine(self, cosine: Coefficient, m: Arithmetic) -> Pair:
        """Return numerator and denominator of ``φ/sin θ``."""

    def coefficient(self, angle: Coefficient, m: Arithmetic) -> Pair:
        """Return φ and φ′ at the angle reduced to (−nπ, nπ], where cos θ ≥ 0."""
        return self._folded(*double_angle(m.name("t", m.tan(m.div(angle, 4 * self.order))), m), m)

    def _folded(self, sine: Coefficient, cosine: Coefficient, m: Arithmetic) -> Pair:
        further = m.name("further", cosine)
        side = m.name("side", m.where(m.less(further, 0), -1, 1))
        r, slope, _ = self.phi_derivatives(m.name("sin", side * sine), m.name("cos", side * further), m)
        return m.name("r", r), m.name("slope", m.div(slope, 2 * self.order))

    # --- inverse map ------------------------------------------------------------------------------------------------

    def gain(self, q: Quaternion, size: Coefficient, m: Arithmetic, positive: bool = False) -> Coefficient:
        """Return ``φ/sin(α/2)``, by half-angle formulas where n is a power of two."""
        negative, cosine = half_cosine(q, m, positive)
        sign = m.where(negative, -1, 1)
        found = self._by_halves if has_ladder(self.order) else self._by_angle
        above, below = found(q, cosine, size, m)
        return m.name("gain", m.div(sign * above, below))

    def _by_halves(self, q: Quaternion, cosine: Coefficient, size: Coefficient, m: Arithmetic) -> Pair:
        below = size
        c = cosine if self.order == 1 else m.name("cos0", m.div(cosine, size))
        for step in range(1, self.order.bit_length()):
            c = m.name(f"cos{step}", m.sqrt(m.div(1 + c, 2)))
            below = below * (2 * c)
        above, root = self.over_sine(c, m)
        return above, below * root

    def _by_angle(self, q: Quaternion, cosine: Coefficient, size: Coefficient, m: Arithmetic) -> Pair:
        still, _, sine = half_sine(q, cosine, m)
        t = m.name("t", m.tan(m.div(m.atan2(sine, cosine), 2 * self.order)))
        of_angle, cos = double_angle(t, m)
        above, below = self.over_sine(m.name("costheta", cos), m)
        at_rest, below_rest = self.over_sine(1, m)
        return (
            m.where(still, at_rest, of_angle * above),
            m.where(still, self.order * cosine * below_rest, sine * below),
        )

    # --- branches ---------------------------------------------------------------------------------------------------

    def unfolded(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        c, sigma = self.cosine(x, m)
        return 2 * self.order * m.atan2(r * sigma, c)

    def turned(self, r: Coefficient, turn: Sequence[Coefficient], m: Arithmetic) -> Derivatives:
        (cosine, sine), rr = turn, m.name("rr", r * r)
        c, sigma = self.cosine(rr, m)
        s = m.name("s", r * sigma)
        further = m.name("further", c * cosine - s * sine)
        side = m.name("side", m.where(m.less(further, 0), -1, 1))
        sine_k, cosine_k = m.name("sk", side * (s * cosine + c * sine)), m.name("ck", side * further)
        return branches.by_length(self.phi_derivatives(s, c, m), self.phi_derivatives(sine_k, cosine_k, m, "k"), m)


def double_angle(t: Coefficient, m: Arithmetic) -> Pair:
    """Return sine and cosine of twice the angle whose tangent is t."""
    tt = m.name("tt", t * t)
    below = m.name("below", 1 + tt)
    return 2 * t / below, (1 - tt) / below
