r"""Scalars that follow from others, whatever the chart: from q̂, from h with its slope, and from ``ρ = 1/φ′``.

.. math::
    f = 2 s w \quad g = 2 w^2 \quad f + x h = \rho \qquad
    s_y = -\tfrac12 \rho w \quad w_y = \tfrac12 s h - w^3 \quad f_y = h - \rho g \quad g_y = f h - g^2

    f_i = \frac{s}{w} \quad h_i = \frac{g - f_i h}{\rho} \qquad
    f_{iy} = -\frac{h}{g} \quad h_{iy} = \frac{g_y - f_{iy} h - f_i h_y - h_i \rho_y}{\rho}

and the derivatives of these. They follow from ``s² + x w² = 1``, from ``2 dα/dx = ρ/φ``, and from ``T T⁻¹ = I``. No
difference of nearly equal terms is among them that matters: where two cancel, what they stand before is small.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from functools import cached_property

from ..algebra import Coefficient
from ..algebra.arithmetic import Arithmetic


class DependentScalars(ABC):
    """The scalars of a chart, of which a subclass gives s, w, and h and ρ with their slopes."""

    def __init__(self, x: Coefficient, m: Arithmetic) -> None:
        self.x = x
        self.m = m

    @property
    @abstractmethod
    def s(self) -> Coefficient: ...
    @property
    @abstractmethod
    def w(self) -> Coefficient: ...
    @property
    @abstractmethod
    def h(self) -> Coefficient: ...
    @property
    @abstractmethod
    def hy(self) -> Coefficient: ...
    @property
    @abstractmethod
    def rate(self) -> Coefficient:
        """``ρ = 1/φ′``, the coefficient of T along the axis."""

    @property
    @abstractmethod
    def ratey(self) -> Coefficient: ...
    @property
    @abstractmethod
    def hyy(self) -> Coefficient: ...
    @property
    @abstractmethod
    def rateyy(self) -> Coefficient: ...

    @cached_property
    def ww(self) -> Coefficient:
        return self.m.name("ww", self.w * self.w)

    @cached_property
    def sy(self) -> Coefficient:
        return self.m.name("sy", -self.m.div(self.rate * self.w, 2))

    @cached_property
    def wy(self) -> Coefficient:
        return self.m.name("wy", self.m.div(self.s * self.h, 2) - self.w * self.ww)

    @cached_property
    def wyy(self) -> Coefficient:
        bend = self.m.div(self.sy * self.h + self.s * self.hy, 2)
        return self.m.name("wyy", bend - 3 * (self.ww * self.wy))

    @cached_property
    def f(self) -> Coefficient:
        return self.m.name("f", 2 * (self.s * self.w))

    @cached_property
    def g(self) -> Coefficient:
        return self.m.name("g", 2 * self.ww)

    @cached_property
    def fy(self) -> Coefficient:
        return self.m.name("fy", self.h - self.rate * self.g)

    @cached_property
    def gy(self) -> Coefficient:
        return self.m.name("gy", self.f * self.h - self.g * self.g)

    @cached_property
    def fi(self) -> Coefficient:
        return self.m.name("fi", self.m.div(self.s, self.w))

    @cached_property
    def hi(self) -> Coefficient:
        return self.m.name("hi", (self.g - self.fi * self.h) / self.rate)

    @cached_property
    def fiy(self) -> Coefficient:
        return self.m.name("fiy", -(self.h / self.g))

    @cached_property
    def hiy(self) -> Coefficient:
        change = self.gy - self.fiy * self.h - self.fi * self.hy - self.hi * self.ratey
        return self.m.name("hiy", change / self.rate)

    @cached_property
    def fyy(self) -> Coefficient:
        return self.m.name("fyy", self.hy - self.ratey * self.g - self.rate * self.gy)

    @cached_property
    def gyy(self) -> Coefficient:
        return self.m.name("gyy", self.fy * self.h + self.f * self.hy - 2 * (self.g * self.gy))

    @cached_property
    def fiyy(self) -> Coefficient:
        return self.m.name("fiyy", -((self.hy + self.fiy * self.gy) / self.g))

    @cached_property
    def hiyy(self) -> Coefficient:
        of_f = self.fiyy * self.h + 2 * (self.fiy * self.hy) + self.fi * self.hyy
        change = self.gyy - of_f - 2 * (self.hiy * self.ratey) - self.hi * self.rateyy
        return self.m.name("hiyy", change / self.rate)

    @property
    def ray(self) -> tuple[Coefficient, Coefficient, Coefficient]:
        return self.s, self.w, 1
