r"""Scalars of every chart, computed from s, w, and from h and ``ρ = 1/φ′`` with their slopes.

.. math::
    f = 2 s w \quad g = 2 w^2 \quad f + x h = \rho \qquad
    s_y = -\tfrac12 \rho w \quad w_y = \tfrac12 s h - w^3 \quad f_y = h - \rho g \quad g_y = f h - g^2

    f_i = \frac{s}{w} \quad h_i = \frac{g - f_i h}{\rho} \qquad
    f_{iy} = -\frac{h}{g} \quad h_{iy} = \frac{g_y - f_{iy} h - f_i h_y - h_i \rho_y}{\rho}

Second slopes are derivatives of these. All follow from ``s² + x w² = 1``, ``2 dα/dx = ρ/φ`` and ``T T⁻¹ = I``. Where
two terms cancel, a small factor multiplies the difference. No digits are lost.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable
from functools import cached_property
from typing import Any

from ..algebra import Coefficient
from ..algebra.arithmetic import Arithmetic, Pair
from .chart import Chart
from .polynomials import Triple
from .real_constants import NOISE, near_turn


class scalar:
    """Scalar of a class with an arithmetic ``m``, computed once by its formula; its default name is the attribute's."""

    def __init__(self, formula: Callable[[Any], Coefficient], name: str = "") -> None:
        self.formula = formula
        self.name = name

    def __set_name__(self, owner: type, attribute: str) -> None:
        self.attribute = attribute
        self.name = self.name or attribute

    def __get__(self, at: Any, owner: type | None = None) -> Any:
        if at is None:
            return self
        value = at.m.name(self.name, self.formula(at))
        at.__dict__[self.attribute] = value
        return value


class DependentScalars:
    """Scalars of a chart. A subclass provides s, w, and both h and ρ (``rate``) with first and second slopes."""

    s: Any
    w: Any
    h: Any
    hy: Any
    hyy: Any
    rate: Any
    ratey: Any
    rateyy: Any

    def __init__(self, x: Coefficient, m: Arithmetic) -> None:
        self.x = x
        self.m = m

    ww = scalar(lambda at: at.w * at.w)
    sy = scalar(lambda at: -at.m.div(at.rate * at.w, 2))
    wy = scalar(lambda at: at.m.div(at.s * at.h, 2) - at.w * at.ww)

    wyy = scalar(lambda at: at.m.div(at.sy * at.h + at.s * at.hy, 2) - 3 * (at.ww * at.wy))
    f = scalar(lambda at: 2 * (at.s * at.w))
    g = scalar(lambda at: 2 * at.ww)
    fy = scalar(lambda at: at.h - at.rate * at.g)
    gy = scalar(lambda at: at.f * at.h - at.g * at.g)
    fi = scalar(lambda at: at.m.div(at.s, at.w))
    ai = scalar(lambda at: at.m.div(2, at.rate))
    hi = scalar(lambda at: (at.g - at.fi * at.h) / at.rate)
    fiy = scalar(lambda at: -(at.h / at.g))

    hiy = scalar(lambda at: (at.gy - at.fiy * at.h - at.fi * at.hy - at.hi * at.ratey) / at.rate)
    fyy = scalar(lambda at: at.hy - at.ratey * at.g - at.rate * at.gy)
    gyy = scalar(lambda at: at.fy * at.h + at.f * at.hy - 2 * (at.g * at.gy))
    fiyy = scalar(lambda at: -((at.hy + at.fiy * at.gy) / at.g))

    @cached_property
    def hiyy(self) -> Coefficient:
        of_f = self.fiyy * self.h + 2 * (self.fiy * self.hy) + self.fi * self.hyy
        change = self.gyy - of_f - 2 * (self.hiy * self.ratey) - self.hi * self.rateyy
        return self.m.name("hiyy", change / self.rate)

    @property
    def ray(self) -> Triple:
        return self.s, self.w, 1


class QuaternionChart(Chart):
    """Chart whose angle and axis follow from its quaternion ``s + w v``."""

    @abstractmethod
    def scalars(self, x: Coefficient, m: Arithmetic) -> DependentScalars: ...

    def back(self, x: Coefficient, fi: Coefficient, m: Arithmetic) -> Pair:
        return fi, self.scalars(x, m).hi

    def at_known(self, x: Coefficient, fi: Coefficient, known: Coefficient, m: Arithmetic) -> DependentScalars:
        """Return scalars with the given f_i, and h_i from f_i; T⁻¹ along the axis is φ′ for any error of f_i.

        Next to a whole turn, f_i gives g as well.
        """
        at = self.scalars(x, m)
        at.fi = fi
        at.g = m.name("gn", m.where(near_turn(fi, at.ai, m), m.div(2, x + fi * fi), at.g))
        return at

    def natural(self, x: Coefficient, y: Coefficient, r: Coefficient, m: Arithmetic) -> Triple:
        """Return the principal angle, ``dα/dr``, and the sign of sin α on the branch of v.

        The sign for sin α = 0 is the sign of w at half a turn, or of the translation along v at a whole turn.
        """
        at = self.scalars(x, m)
        # at half a turn s is 0 up to rounding; for w > 0 keep the direction of v
        kept = m.name("kept", m.where(m.less(at.w, 0), 0, NOISE))
        turned = m.name("turned", m.where(m.less(m.beside(kept, at.s), kept), -at.w, at.w))
        backwards = m.both(m.equal(at.w, 0), m.less(y, 0))
        one = m.name("one", at.s - at.s + 1)  # NaN where x overflows
        sign = m.name("sign", one * m.where(m.either(m.less(turned, 0), backwards), -1, 1))
        return m.name("angle", 2 * m.atan2(r * m.abs(at.w), m.abs(at.s))), at.rate, sign
