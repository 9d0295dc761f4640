r"""Branches and inverse maps of charts that compute the angle α from ``|v|``, such as the exponential.

Branch k is ``v_k = φ(α + 2πk) u``. The branch exists where ``|α + 2πk|`` is less than the edge, and is NaN elsewhere.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import mpmath
import sympy

from ..algebra import Coefficient, Quaternion
from ..algebra.arithmetic import Arithmetic
from ..algebra.cayley_pairs import Pair
from . import order_charts
from .elementary import alpha
from .order_charts import Derivatives, half_cosine, half_sine, kept_inside
from .real_constants import number, times
from .scalars import QuaternionChart

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
