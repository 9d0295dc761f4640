r"""Breusing's chart, the geometric mean of tangent and sine: ``v = sin θ/√(cos θ) u``, θ = α/4.

From ``x = (1 − c²)/c``, ``c = cos θ``, so that the quaternion is ``c − x + 2 √c v`` over ``1/c = c + x``:

.. math::
    c = \frac{2}{x + \sqrt{x^2 + 4}} \qquad s = \frac{c - x}{c + x} \quad w = \frac{2 \sqrt c}{c + x} \quad
    \rho = \frac{8 c^{3/2}}{1 + c^2} \quad h_i = \frac{3}{4 \sqrt c} \quad h = \frac{4 c^{5/2} (3 + 2 c^2)}{1 + c^2}

    \frac{dc}{dx} = -\frac{c^2}{1 + c^2}

Over c + x, not times c: so it is a unit quaternion whatever rounding makes of c.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import sympy

from ..algebra import Coefficient
from ..algebra.arithmetic import Arithmetic
from . import branches, near_pole
from .dependent import DependentScalars
from .families import alpha
from .order_charts import OrderChart, double_angle


def twice_secant(x: Coefficient, m: Arithmetic) -> Coefficient:
    """``2/cos θ`` at x; where x² overflows infinite."""
    return m.name("below", x + m.sqrt(x * x + 4))


def cosine(x: Coefficient, m: Arithmetic) -> Coefficient:
    """cos θ at x; where x² overflows NaN, not 0."""
    below = twice_secant(x, m)
    return m.name("c", (below - below + 2) / below)


class BreusingScalars(DependentScalars):
    """The scalars at ``x = sin² θ/cos θ``."""

    @cached_property
    def c(self) -> Coefficient:
        return cosine(self.x, self.m)

    @cached_property
    def cc(self) -> Coefficient:
        return self.m.name("cc", self.c * self.c)

    @cached_property
    def _over(self) -> Coefficient:
        """``1/(1 + c²)``."""
        return self.m.name("over", self.m.div(1, 1 + self.cc))

    @cached_property
    def _weight(self) -> Coefficient:
        return self.m.name("weight", 3 + 2 * self.cc)

    @cached_property
    def _above(self) -> Coefficient:
        """``c − x``."""
        return self.m.name("above", self.c - self.x)

    @cached_property
    def _size(self) -> Coefficient:
        """``c + x = 1/c``."""
        return self.m.name("size", self.c + self.x)

    @cached_property
    def s(self) -> Coefficient:
        return self.m.name("s", self._above / self._size)

    @cached_property
    def w(self) -> Coefficient:
        return self.m.name("w", 2 * self._root / self._size)

    @property
    def _twice(self) -> Coefficient:
        """2 w."""
        return 2 * self.w

    @property
    def ray(self) -> tuple[Coefficient, Coefficient, Coefficient]:
        return self._above, self.m.name("b", 2 * self._root), self._size

    @cached_property
    def _root(self) -> Coefficient:
        return self.m.name("rootc", self.m.sqrt(self.c))

    @cached_property
    def rate(self) -> Coefficient:
        return self.m.name("rho", 4 * (self.w * self._over))

    @cached_property
    def h(self) -> Coefficient:
        """``2 c w (3 + 2 c²)/(1 + c²)``, of fewer operations."""
        return self.m.name("h", self.c * self._twice * (2 + self._over))

    @cached_property
    def _decline(self) -> Coefficient:
        """``−2 c′/c``."""
        return self.m.name("decline", 2 * (self.c * self._over))

    @cached_property
    def _share(self) -> Coefficient:
        """``4 c²/(1 + c²)``."""
        return self.m.name("share", 4 * (self.cc * self._over))

    @cached_property
    def _declining(self) -> Coefficient:
        """The slope of that."""
        half = self.m.div(self._share, 2)
        return self.m.name("decliney", self._decline * self._decline * (half - 1))

    @cached_property
    def _sharing(self) -> Coefficient:
        return self.m.name("sharey", -2 * (self._share * self._over * self._decline))

    @cached_property
    def f(self) -> Coefficient:
        return self.m.name("f", self.s * self._twice)

    @cached_property
    def g(self) -> Coefficient:
        """``2 w² = 8 c/(c + x)²``, of fewer roundings."""
        return self.m.name("g", 8 * (self.c / (self._size * self._size)))

    @cached_property
    def fi(self) -> Coefficient:
        """``s/w = (c − x)/(2 √c)``."""
        return self.m.name("fi", self._above / (2 * self._root))

    @cached_property
    def hi(self) -> Coefficient:
        """``3/(4 √c)``."""
        return self.m.name("hi", self.m.div(3, 4 * self._root))

    @cached_property
    def hiy(self) -> Coefficient:
        return self.m.name("hiy", self.m.div(self.hi * self._decline, 2))

    @cached_property
    def hiyy(self) -> Coefficient:
        return self.m.name("hiyy", self.m.div(self.hiy * self._decline + self.hi * self._declining, 2))

    def _bend(self, slope: Coefficient, value: Coefficient, growth: Coefficient, change: Coefficient) -> Coefficient:
        """The slope of ``value · decline · growth/2``."""
        of_decline = self._declining * growth + self._decline * change
        return self.m.div(slope * self._decline * growth + value * of_decline, 2)

    @cached_property
    def _rate_growth(self) -> Coefficient:
        return self.m.name("rhogrowth", self._share - 3)

    @cached_property
    def ratey(self) -> Coefficient:
        return self.m.name("rhoy", self.m.div(self.rate * self._decline * self._rate_growth, 2))

    @cached_property
    def rateyy(self) -> Coefficient:
        return self.m.name("rhoyy", self._bend(self.ratey, self.rate, self._rate_growth, self._sharing))

    @cached_property
    def _h_growth(self) -> Coefficient:
        return self.m.name("hgrowth", self._share - 5 - 8 * (self.cc / self._weight))

    @cached_property
    def hy(self) -> Coefficient:
        return self.m.name("hy", self.m.div(self.h * self._decline * self._h_growth, 2))

    @cached_property
    def hyy(self) -> Coefficient:
        change = self._sharing + 48 * (self.cc * self._decline / (self._weight * self._weight))
        return self.m.name("hyy", self._bend(self.hy, self.h, self._h_growth, change))


@dataclass(frozen=True)
class Breusing(OrderChart):
    """v = sin(α/4)/√cos(α/4) u, up to |Re α| = 2π."""

    name: str = "breusing"
    order: int = 2
    selection: tuple[str, str] = ("--family", "breusing")
    title: str = "Breusing's chart"

    @property
    def phi(self) -> sympy.Expr:
        return sympy.sin(alpha / 4) / sympy.sqrt(sympy.cos(alpha / 4))

    @property
    def algebraic(self) -> bool:
        return False

    def overflow(self, largest: float) -> tuple[str, float]:
        return "x^2 overflows", float(largest**0.25)

    def scalars(self, x: Coefficient, m: Arithmetic) -> BreusingScalars:
        return BreusingScalars(x, m)

    def sized(self, sine: Coefficient, cosine: Coefficient, m: Arithmetic, mark: str = "") -> branches.Derivatives:
        square = m.name(f"square{mark}", cosine * cosine)
        inverse = m.name(f"iroot{mark}", m.div(1, m.sqrt(cosine)))
        slope = m.div((1 + square) / cosine * inverse, 2)
        return sine * inverse, slope, m.div((3 - square) * sine / square * inverse, 4)

    def coefficient_of(
        self, angle: Coefficient, sine: Coefficient, cosine: Coefficient, m: Arithmetic
    ) -> tuple[Coefficient, Coefficient]:
        next_to, rest, side = near_pole.sides(self.order, angle, sine, cosine, m)
        of_rest = double_angle(m.name("t", m.tan(m.div(rest, 4 * self.order))), m)
        first, second = (m.name(f"{letter}rest", value) for letter, value in zip("sc", of_rest, strict=True))
        return self._folded(side * m.where(next_to, second, first), m.where(next_to, first, second), m)

    def back(self, x: Coefficient, fi: Coefficient, m: Arithmetic) -> tuple[Coefficient, Coefficient]:
        """``h_i = ¾ √(1/c)``, of fewer operations; what a quaternion leads to never overflows."""
        return fi, m.name("hi", m.sqrt(m.div(9 * twice_secant(x, m), 32)))

    def cosine(self, x: Coefficient, m: Arithmetic) -> tuple[Coefficient, Coefficient]:
        c = cosine(x, m)
        return c, m.name("sigma", m.sqrt(c))

    def over_sine(self, cosine: Coefficient, m: Arithmetic) -> tuple[Coefficient, Coefficient]:
        return 1, m.sqrt(cosine)
