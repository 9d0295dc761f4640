"""The axis of a vector and the angle about it, from the scalars of a chart."""

from __future__ import annotations

from abc import abstractmethod

from ..algebra import Coefficient
from ..algebra.arithmetic import Arithmetic
from .branches import NOISE
from .dependent import DependentScalars
from .parameterized import Parameterized


class QuaternionChart(Parameterized):
    """A chart that reads angle and axis off its quaternion ``s + w v``."""

    @abstractmethod
    def scalars(self, x: Coefficient, m: Arithmetic) -> DependentScalars: ...

    def back(self, x: Coefficient, fi: Coefficient, m: Arithmetic) -> tuple[Coefficient, Coefficient]:
        return fi, self.scalars(x, m).hi

    def at_angle(self, x: Coefficient, fi: Coefficient, angle: Coefficient, m: Arithmetic) -> DependentScalars:
        """With the f_i given, of which h_i is made: then T⁻¹ along the axis is φ′, whatever f_i is off by."""
        at = self.scalars(x, m)
        at.fi = fi
        return at

    def direction(self, x: Coefficient, y: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        """The sign of sin α on v; where it is 0 at half a turn that of w, at a whole one that of the translation."""
        return self._direction(self.scalars(x, m), y, m)

    def _direction(self, at: DependentScalars, y: Coefficient, m: Arithmetic) -> Coefficient:
        # at half a turn, where w > 0, s is 0 but for rounding beside 1: then the side that v is on stands
        kept = m.name("kept", m.where(m.less(at.w, 0), 0, NOISE))
        turned = m.name("turned", m.where(m.less(kept + at.s, kept), -at.w, at.w))
        backwards = m.both(m.equal(at.w, 0), m.less(y, 0))
        one = m.name("one", at.s - at.s + 1)  # or NaN, where x has overflowed and v/|v| is nothing
        return m.name("sign", one * m.where(m.either(m.less(turned, 0), backwards), -1, 1))

    def natural(
        self, x: Coefficient, y: Coefficient, r: Coefficient, m: Arithmetic
    ) -> tuple[Coefficient, Coefficient, Coefficient]:
        at = self.scalars(x, m)
        sign = self._direction(at, y, m)
        return m.name("angle", 2 * m.atan2(r * m.abs(at.w), m.abs(at.s))), at.rate, sign
