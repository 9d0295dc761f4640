"""The axis of a vector and the angle about it, from the scalars of a chart."""

from __future__ import annotations

from abc import abstractmethod

from ..algebra import Coefficient
from ..algebra.arithmetic import Arithmetic
from .dependent import DependentScalars
from .parameterized import Parameterized


class OwnAxis(Parameterized):
    """A chart that reads angle and axis off its quaternion ``s + w v``."""

    @abstractmethod
    def scalars(self, x: Coefficient, m: Arithmetic) -> DependentScalars: ...

    def direction(self, x: Coefficient, y: Coefficient, m: Arithmetic) -> Coefficient:
        """The sign of sin α on v; where it is 0 at half a turn that of w, at a whole one that of the translation."""
        return self._direction(self.scalars(x, m), y, m)

    def _direction(self, at: DependentScalars, y: Coefficient, m: Arithmetic) -> Coefficient:
        turned = m.name("turned", m.where(m.name("sneg", m.less(at.s, 0)), m.name("mw", -at.w), at.w))
        backwards = m.both(m.equal(at.w, 0), m.less(y, 0))
        one = m.name("one", at.s - at.s + 1)  # or NaN, where x has overflowed and v/|v| is nothing
        return m.name("sign", one * m.where(m.either(m.less(turned, 0), backwards), -1, 1))

    def natural(
        self, x: Coefficient, y: Coefficient, r: Coefficient, m: Arithmetic
    ) -> tuple[Coefficient, Coefficient, Coefficient]:
        at = self.scalars(x, m)
        sign = self._direction(at, y, m)
        s = m.where(m.name("sneg", m.less(at.s, 0)), -at.s, at.s)
        w = m.where(m.less(at.w, 0), m.name("mw", -at.w), at.w)
        return m.name("angle", 2 * m.atan2(r * w, s)), at.rate, sign
