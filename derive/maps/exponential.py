r"""Exponential of tensors and quaternions, and the chart ``v = α u`` with the logarithm as inverse map.

.. math:: \exp\tilde a = I + \frac{\sin|a|}{|a|}\,\tilde a + \frac{1 - \cos|a|}{|a|^2}\,\tilde a^2 \qquad
    \text{CP23 (17), (25)}

The tangent operator T of the chart is dexp. With Stumpff functions c_k and ``x = α²``:

.. math:: s = c_0(x/4) \quad w = \tfrac12 c_1(x/4) \quad f = c_1 \quad g = c_2 \quad h = c_3(x)
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import sympy

from ..algebra import Coefficient
from ..algebra.arithmetic import Arithmetic
from ..algebra.cayley_pairs import Pair
from . import stumpff
from .angle_chart import AngleChart
from .families import alpha
from .order_charts import Derivatives, half_angle
from .scalars import DependentScalars, scalar


class ExponentialScalars(DependentScalars):
    """Scalars at x = α²."""

    rate = 1
    ai = 2
    ratey = 0
    rateyy = 0

    _near = scalar(lambda at: at.m.less(at.x, stumpff.LIMIT), "nearby")

    @cached_property
    def _near_zero(self) -> stumpff.Stumpff:
        """Stumpff functions by series; beyond the limit, unused values at angle 0."""
        zeta = self.m.name("z", self.m.div(self.m.where(self._near, self.x, self.x - self.x), 4))
        return stumpff.Stumpff(zeta, self.m)

    # α² if beyond the limit, else an unused value beyond the limit
    _square = scalar(lambda at: at.m.where(at._near, stumpff.LIMIT + at.x, at.x), "xx")
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

    # (α² − root²)/2α, with the rounded root of x, and α² as the exact sum of squares before rounding to x
    _lost = scalar(lambda at: at._left / (2 * at._angle), "lost")

    @property
    def _left(self) -> Coefficient:
        """Difference ``α² − root²``, by terms that are exact up to α = 8.

        Beyond 8 the result is 0: the error may be a large angle, and a corrected R would be no rotation.
        """
        beside = self.m.name("beside", self._angle - 4)
        left = (self._square - 16) - 8 * beside - beside * beside
        return self._bounded(self.m.name("left", left + self.m.rounded_off(self.x)))

    def _bounded(self, left: Coefficient) -> Coefficient:
        return self.m.where(self.m.less(self._angle, 8), left, 0)

    s = scalar(lambda at: at.m.where(at._near, at._near_zero.C0, at._circular[0]))
    w = scalar(lambda at: at.m.where(at._near, at.m.div(at._near_zero.C1, 2), at._circular[1]))
    f = scalar(lambda at: at.m.where(at._near, at._near_zero.C0 * at._near_zero.C1, at._turned[0] / at._angle))
    g = scalar(lambda at: at.m.where(at._near, at.m.div(at._near_zero.CC1, 2), at._turned[1] / at._square))
    h = scalar(lambda at: at.m.where(at._near, at._near_zero.c3, (1 - at.f) / at._square))
    hy = scalar(lambda at: at.m.where(at._near, at._near_zero.slope, (at.g - 3 * at.h) / at._square))
    hyy = scalar(lambda at: at.m.where(at._near, at._near_zero.bend, (at.gy - 5 * at.hy) / at._square))


class PrincipalScalars(ExponentialScalars):
    """Scalars up to half a turn, the range of the logarithm."""

    def _bounded(self, left: Coefficient) -> Coefficient:
        return left


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

    @property
    def phi(self) -> sympy.Expr:
        return alpha

    @property
    def edge(self) -> sympy.Expr:
        return sympy.oo

    @property
    def remainder(self) -> float:
        return stumpff.REMAINDER

    def overflow(self, largest: float) -> tuple[str, float]:
        return "x overflows", float(largest**0.5)

    def scalars(self, x: Coefficient, m: Arithmetic) -> ExponentialScalars:
        return ExponentialScalars(x, m)

    def own_angle(self, at: ExponentialScalars, r: Coefficient) -> Coefficient:
        return r

    def phi_derivatives(self, angle: Coefficient, m: Arithmetic, mark: str = "") -> Derivatives:
        return angle, 1, 0
