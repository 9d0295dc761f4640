r"""Chart of any φ: scalars from ``a(x) = α/|v|`` near v = 0, and from φ at the angle beyond a limit.

.. math::
    w = \tfrac12 a\,c_1(\tfrac\xi4) \qquad \rho = a + 2 x a' \qquad h = a^3 c_3(\xi) + 2 a' \qquad
    \xi = \alpha^2 = x a^2

Beyond the limit, with ``ρ = 1/φ′``, theorems on every φ give ``h = (ρ − f)/x``, ``h_y = (ρ_y − 3h + ρ g)/x`` and
``h_yy = (ρ_yy − 5 h_y + ρ_y g + ρ g_y)/x``.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import mpmath
import sympy

from ...algebra import Coefficient
from ...algebra.arithmetic import Arithmetic
from .. import exponential
from ..angle import Angle
from ..elementary import Quotient, alpha, elementary
from ..exponential import AngleChart
from ..grammar import SYMBOLIC_ONLY, PhiError
from ..order_charts import Derivatives, half_angle
from ..real_constants import NOISE, plus
from ..scalars import DependentScalars, scalar
from .edges import PHI_DIGITS, Edge, edge_of
from .first_guess import guess
from .guesses import Guess, from_end
from .near_zero import Ratio, length_ratio, ratio
from .phi_values import Lengths, PhiValues
from .rounding import require_digits


class GeneralScalars(DependentScalars):
    """Scalars at x = φ²."""

    def __init__(self, chart: General, x: Coefficient, m: Arithmetic) -> None:
        super().__init__(x, m)
        self.chart = chart
        limit = chart.near.limit
        self.is_near = m.name("nearby", m.less(limit.denominator * x, limit.numerator))

    def _select(self, near: Coefficient, far: Coefficient) -> Coefficient:
        return self.m.where(self.is_near, near, far)

    # --- below the limit ----------------------------------------------------------------------------------------

    # x below the limit; 0 beyond
    _x = scalar(lambda at: at.m.where(at.is_near, at.x, at.x - at.x), "xn")

    def _a(self, count: int) -> Coefficient:
        return self.chart.near.polynomials[count].at(self._x, self.m, f"a{count}")  # the derivative of this order

    _aa = scalar(lambda at: at._a(0) * at._a(0), "aa")

    _zeta = scalar(lambda at: at.m.div(at._x * at._aa, 4), "zeta")
    _stumpff = cached_property(lambda at: exponential.Stumpff(at._zeta, at.m))
    _c3 = scalar(lambda at: at._stumpff.c3, "c3")
    _bend = scalar(lambda at: at._stumpff.slope, "c3x")
    _rate_near = scalar(lambda at: at._a(0) + 2 * (at._x * at._a(1)), "rhon")
    _ratey_near = scalar(lambda at: 6 * at._a(1) + 4 * (at._x * at._a(2)), "rhony")
    _growth = scalar(lambda at: at._a(0) * at._rate_near, "xix")  # dξ/dx
    _cube = scalar(lambda at: at._aa * at._a(0), "aaa")

    _hy_near = property(
        lambda at: 6 * (at._aa * at._a(1)) * at._c3 + 4 * at._a(2) + at._cube * at._growth * at._bend
    )

    @property
    def _hyy_near(self) -> Coefficient:
        a, a1, a2, a3 = map(self._a, range(4))
        twist = self._stumpff.bend
        of_growth = self.m.div(2 * (a1 * self._rate_near) + a * self._ratey_near, 2)
        direct = (12 * (a * a1 * a1) + 6 * (self._aa * a2)) * self._c3 + 4 * a3
        first = 6 * (self._aa * a1) * self._growth * self._bend
        last = self._cube * (self.m.div(twist * self._growth * self._growth, 2) + of_growth * self._bend)
        return 2 * (direct + first + last)

    # --- beyond the limit ---------------------------------------------------------------------------------------

    @cached_property
    def _square(self) -> Coefficient:
        """Value of x beyond the limit; elsewhere the limit, an unused number."""
        limit = self.chart.near.limit
        beside = self.m.div(self.x - self.x + limit.numerator, limit.denominator)
        return self.m.name("xx", self.m.where(self.is_near, beside, self.x))

    _length = scalar(lambda at: at.m.sqrt(at._square), "length_x")

    @cached_property
    def far_angle(self) -> Coefficient:
        """Angle α beyond the limit; elsewhere, an unused angle."""
        return self.chart.far_angle(self._square, self._length, self.m)

    def angle_of(self, r: Coefficient) -> Coefficient:
        """Return α for a length r, where ``r² = x``."""
        return self.m.name("alpha", self._select(self._a(0) * r, self.far_angle))

    _circular = cached_property(lambda at: half_angle(at.far_angle, at._length, at.m))
    _slopes = cached_property(lambda at: at.chart.lengths(at.far_angle, at.far_angle * at.far_angle, at.m, "f"))

    def _derivative(self, count: int) -> Coefficient:
        return self._slopes.derivative(self.chart.phi, count)

    _rate_far = scalar(lambda at: at.m.div(1, at._derivative(1)), "rhof")

    @property
    def _ratey_far(self) -> Coefficient:
        cube = self.m.name("rho3", self._rate_far * self._rate_far * self._rate_far)
        return -self._derivative(2) * cube / self._length

    @property
    def _rateyy_far(self) -> Coefficient:
        first, second, third = map(self._derivative, (1, 2, 3))
        change = 3 * (second * second) * self._rate_far - third + second * first / self._length
        return change / (self._square * (first * first * (first * first)))

    # --- in both ranges -----------------------------------------------------------------------------------------

    s = scalar(lambda at: at._select(at._stumpff.C0, at._circular[0]))
    w = scalar(lambda at: at._select(at.m.div(at._a(0) * at._stumpff.C1, 2), at._circular[1]))
    rate = scalar(lambda at: at._select(at._rate_near, at._rate_far), "rho")
    ratey = scalar(lambda at: at._select(at._ratey_near, at._ratey_far), "rhoy")
    rateyy = scalar(lambda at: at._select(20 * at._a(2) + 8 * (at._x * at._a(3)), at._rateyy_far), "rhoyy")
    h = scalar(lambda at: at._select(at._cube * at._c3 + 2 * at._a(1), (at.rate - at.f) / at._square))
    hy = scalar(lambda at: at._select(at._hy_near, (at.ratey - 3 * at.h + at.rate * at.g) / at._square))
    hyy = scalar(lambda at: at._select(at._hyy_near, at._hyy_change / at._square))

    _hyy_change = property(lambda at: at.rateyy - 5 * at.hy + at.ratey * at.g + at.rate * at.gy)


class GeneralAtAngle(GeneralScalars):
    """Scalars for known f_i and α."""

    def __init__(self, chart: General, x: Coefficient, fi: Coefficient, angle: Coefficient, m: Arithmetic) -> None:
        super().__init__(chart, x, m)
        self.fi = fi
        # below the limit, an unused angle at which all functions are regular
        beside = plus(angle - angle, chart.far.edge / 2, m, "beside")
        self.far_angle = m.name("distant", m.where(self.is_near, beside, m.abs(angle)))


@dataclass(frozen=True)
class General(AngleChart):
    """Chart v = φ(α) u up to the first zero of φ′ or pole of φ, at most up to 4π."""

    name: str
    expression: sympy.Expr
    selection: tuple[str, str]
    title: str = "Parameterization by an angle"

    @property
    def phi(self) -> sympy.Expr:
        return self.expression

    @cached_property
    def _edge(self) -> Edge:
        return edge_of(self.expression)

    @property
    def edge(self) -> sympy.Expr:
        return self._edge.angle

    @property
    def angle(self) -> sympy.Expr:
        return Angle.at_square(self.phi, self.edge)

    @cached_property
    def near(self) -> Ratio:
        """Polynomials of a(x) and its derivatives, below a limit."""
        return ratio(self.expression, self._edge)

    @property
    def _first(self) -> Any:
        return self.inverse(mpmath.sqrt(float(self.near.limit)))

    @cached_property
    def beside_zero(self) -> Ratio | None:
        """Polynomials of φ/α in α², and its derivatives; None if φ is no quotient at 0.

        They hold up to half a turn, or else up to the angle at the limit of x.
        """
        if not self.expression.has(Quotient):
            return None
        try:
            return length_ratio(self.expression, mpmath.pi)
        except PhiError:
            return length_ratio(self.expression, self._first)

    @cached_property
    def far(self) -> Guess:
        """First guess of Newton's method beyond the limit."""
        return guess(self.expression, self._edge, self.near.limit)

    @property
    def steep(self) -> tuple[Any, ...]:
        return self._edge.flat

    @property
    def remainder(self) -> float:
        return max(of.remainder for of in (self.near, self.beside_zero) if of) + exponential.REMAINDER

    def overflow(self, largest: float) -> tuple[str, float]:
        if self._edge.kind == "pole":
            return "x overflows", float(largest**0.5)
        with mpmath.workdps(PHI_DIGITS):
            size = float(self.phi.subs(alpha, self.edge).evalf(PHI_DIGITS))
        return f"v ends, at Re|v| = {size:.6g}", size

    @property
    def range(self) -> sympy.Expr:
        return sympy.oo if self._edge.kind == "pole" else super().range

    @property
    def folds(self) -> bool:
        return self._edge.kind == "fold"

    def require_kernels(self) -> None:
        """Raise `PhiError` if kernels cannot compute the chart to full precision."""
        try:
            if float(self.edge) < math.pi:
                end = self.edge if self.edge.has(sympy.pi) else self.edge.evalf(8)
                reason = f"ends at alpha = {end}, and poses that turn further, up to pi, have no v"
                raise PhiError(f"phi = {self.phi} {reason}")
            require_digits(elementary(self.expression), self._edge, self._first)
            _ = self.far, self.beside_zero
        except PhiError as error:
            raise PhiError(f"{error}: {SYMBOLIC_ONLY}") from None

    def scalars(self, x: Coefficient, m: Arithmetic) -> GeneralScalars:
        return GeneralScalars(self, x, m)

    def at_known(self, x: Coefficient, fi: Coefficient, known: Coefficient, m: Arithmetic) -> DependentScalars:
        if self._edge.kind == "fold":
            return GeneralAtAngle(self, x, fi, known, m)
        return super().at_known(x, fi, known, m)

    def own_angle(self, at: GeneralScalars, r: Coefficient) -> Coefficient:
        return at.angle_of(r)

    def far_angle(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        """Return α by Newton's method from the first guess; NaN beyond the end of the chart."""
        if self._edge.kind != "pole":
            left = from_end(x, self.far.size, m)
            r = m.name("length_in", r + (left - left))
        return self.far.solved(x, r, m)

    def phi_derivatives(self, angle: Coefficient, m: Arithmetic, mark: str = "") -> Derivatives:
        """Return φ, φ′, φ″; NaN beyond the edge, by 0/0. At a fold, an angle beyond it by rounding is the edge."""
        with mpmath.workdps(PHI_DIGITS):
            limit = -(mpmath.mpf(self.edge.evalf(PHI_DIGITS)) ** 2)
        own = m.name(f"square{mark}", angle * angle)
        over = m.name(f"over{mark}", plus(own, limit, m, f"within{mark}"))
        none = m.name(f"none{mark}", own - own)
        if self.folds:
            left = m.where(m.less(own, m.beside(own, m.div(over, NOISE))), none, 1 + none)
        else:
            left = m.where(m.less(over, 0), 1 + none, none)
        left = m.name(f"left{mark}", left)
        one = m.name(f"inside{mark}", m.div(left, left))
        at = self.lengths(angle, own, m, mark)
        r, slope, bend = (at.derivative(self.phi, count) for count in range(3))
        return r * one, slope * one, bend * one

    def lengths(self, angle: Coefficient, square: Coefficient, m: Arithmetic, mark: str) -> PhiValues | Lengths:
        """Return φ and its derivatives at an angle, given its square."""
        near = self.beside_zero
        return Lengths(near, self.far.edge, angle, square, m, mark) if near else PhiValues(angle, m)
