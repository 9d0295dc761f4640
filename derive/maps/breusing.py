r"""Breusing's chart, the geometric mean of tangent and sine: ``v = sin θ/√(cos θ) u``, θ = α/4.

With ``c = cos θ`` and ``x = (1 − c²)/c`` the quaternion is ``(c − x + 2 √c v)/(c + x)``, where ``c + x = 1/c``:

.. math::
    c = \frac{2}{x + \sqrt{x^2 + 4}} \qquad s = \frac{c - x}{c + x} \quad w = \frac{2 \sqrt c}{c + x} \quad
    \rho = \frac{8 c^{3/2}}{1 + c^2} \quad h_i = \frac{3}{4 \sqrt c} \quad h = \frac{4 c^{5/2} (3 + 2 c^2)}{1 + c^2}

    \frac{dc}{dx} = -\frac{c^2}{1 + c^2}

The code divides by c + x instead of multiplying by c. The norm is then 1 for any rounding error of c.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import sympy

from ..algebra import Coefficient
from ..algebra.arithmetic import Arithmetic
from ..algebra.cayley_pairs import Pair
from .elementary import alpha
from .order_charts import Derivatives, OrderChart, double_angle, near_pole
from .polynomials import Triple
from .scalars import DependentScalars, scalar


def twice_secant(x: Coefficient, m: Arithmetic) -> Coefficient:
    """Return ``2/cos θ`` at x; infinite where x² overflows."""
    return m.name("below", x + m.sqrt(x * x + 4))


def cosine(x: Coefficient, m: Arithmetic) -> Coefficient:
    """Return cos θ at x; NaN instead of 0 where x² overflows."""
    below = twice_secant(x, m)
    return m.name("c", (below - below + 2) / below)


class BreusingScalars(DependentScalars):
    """Scalars at ``x = sin² θ/cos θ``."""

    c = cached_property(lambda at: cosine(at.x, at.m))
    cc = scalar(lambda at: at.c * at.c)
    _over = scalar(lambda at: at.m.div(1, 1 + at.cc), "over")  # 1/(1 + c²)
    _weight = scalar(lambda at: 3 + 2 * at.cc, "weight")
    _above = scalar(lambda at: at.c - at.x, "above")  # c − x
    _size = scalar(lambda at: at.c + at.x, "size")  # c + x = 1/c
    s = scalar(lambda at: at._above / at._size)
    w = scalar(lambda at: 2 * at._root / at._size)

    _twice = property(lambda at: 2 * at.w)

    @property
    def ray(self) -> Triple:
        return self._above, self.m.name("b", 2 * self._root), self._size

    _root = scalar(lambda at: at.m.sqrt(at.c), "rootc")
    rate = scalar(lambda at: 4 * (at.w * at._over), "rho")
    h = scalar(lambda at: at.c * at._twice * at._thickness)  # 2 c w (3 + 2 c²)/(1 + c²), with fewer operations
    _decline = scalar(lambda at: 2 * (at.c * at._over), "decline")  # −2 c′/c
    _share = scalar(lambda at: 4 * (at.cc * at._over), "share")  # 4 c²/(1 + c²)

    @cached_property
    def _declining(self) -> Coefficient:
        """Slope of ``−2 c′/c``."""
        half = self.m.div(self._share, 2)
        return self.m.name("decliney", self._decline * self._decline * (half - 1))

    _sharing = scalar(lambda at: -2 * (at._share * at._over * at._decline), "sharey")
    f = scalar(lambda at: at.s * at._twice)
    g = scalar(lambda at: 8 * (at.c / (at._size * at._size)))  # 2 w² = 8 c/(c + x)², with fewer roundings
    fi = scalar(lambda at: at._above / (2 * at._root))  # s/w = (c − x)/(2 √c)
    hi = scalar(lambda at: at.m.div(3, 4 * at._root))  # 3/(4 √c)
    # −h/g, whose factors underflow sooner, and its slope
    _ratio = scalar(lambda at: at.c / at.w, "ratio")
    _thickness = scalar(lambda at: 2 + at._over, "thickness")
    fiy = scalar(lambda at: -(at._ratio * at._thickness))
    fiyy = scalar(lambda at: -at.m.div(at._ratio * at._decline * (at._thickness + at._over * at._share), 2))
    hiy = scalar(lambda at: at.m.div(at.hi * at._decline, 2))
    hiyy = scalar(lambda at: at.m.div(at.hiy * at._decline + at.hi * at._declining, 2))

    def _bend(self, slope: Coefficient, value: Coefficient, growth: Coefficient, change: Coefficient) -> Coefficient:
        """Return the slope of ``value · decline · growth/2``."""
        of_decline = self._declining * growth + self._decline * change
        return self.m.div(slope * self._decline * growth + value * of_decline, 2)

    _rate_growth = scalar(lambda at: at._share - 3, "rhogrowth")
    ratey = scalar(lambda at: at.m.div(at.rate * at._decline * at._rate_growth, 2), "rhoy")
    rateyy = scalar(lambda at: at._bend(at.ratey, at.rate, at._rate_growth, at._sharing), "rhoyy")
    _h_growth = scalar(lambda at: at._share - 5 - 8 * (at.cc / at._weight), "hgrowth")
    hy = scalar(lambda at: at.m.div(at.h * at._decline * at._h_growth, 2))

    @cached_property
    def hyy(self) -> Coefficient:
        change = self._sharing + 48 * (self.cc * self._decline / (self._weight * self._weight))
        return self.m.name("hyy", self._bend(self.hy, self.h, self._h_growth, change))


@dataclass(frozen=True)
class Breusing(OrderChart):
    """Chart v = sin(α/4)/√cos(α/4) u, up to |Re α| = 2π."""

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

    def phi_derivatives(self, sine: Coefficient, cosine: Coefficient, m: Arithmetic, mark: str = "") -> Derivatives:
        square = m.name(f"square{mark}", cosine * cosine)
        inverse = m.name(f"iroot{mark}", m.div(1, m.sqrt(cosine)))
        slope = m.div((1 + square) / cosine * inverse, 2)
        return sine * inverse, slope, m.div((3 - square) * sine / square * inverse, 4)

    def coefficient_of(self, angle: Coefficient, sine: Coefficient, cosine: Coefficient, m: Arithmetic) -> Pair:
        next_to, rest, side = near_pole(self.order, angle, sine, cosine, m)
        of_rest = double_angle(m.name("t", m.tan(m.div(rest, 4 * self.order))), m)
        first, second = (m.name(f"{letter}rest", value) for letter, value in zip("sc", of_rest, strict=True))
        return self._folded(side * m.where(next_to, second, first), m.where(next_to, first, second), m)

    def back(self, x: Coefficient, fi: Coefficient, m: Arithmetic) -> Pair:
        """Return f_i and ``h_i = ¾ √(1/c)``; x² does not overflow if v was computed from a quaternion."""
        return fi, m.name("hi", m.sqrt(m.div(9 * twice_secant(x, m), 32)))

    def cosine(self, x: Coefficient, m: Arithmetic) -> Pair:
        c = cosine(x, m)
        return c, m.name("sigma", m.sqrt(c))

    def over_sine(self, cosine: Coefficient, m: Arithmetic) -> Pair:
        return 1, m.sqrt(cosine)
