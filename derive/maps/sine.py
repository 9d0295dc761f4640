r"""Sine charts, ``v = sin(α/2n) u``: orthographic at n = 1, Lambert's equal-area projection at n = 2.

Let θ = α/2n, ``x = sin² θ``, ``c = √(1 − x)``, and S, W, H, B be polynomials in x. For even n ``cos nθ = S`` and
``sin nθ/sin θ = c W``; for odd n ``cos nθ = c S`` and ``sin nθ/sin θ = W``. The two forms of
h_i are for even n and for odd n:

.. math::
    h = \frac{H}{c} \quad x H = 2 n - 2 (1 - x) S W \qquad \rho = \frac{2 n}{c} \qquad
    h_i = \frac{B}{n w} \quad x B = (1 - x) W - n S \quad \text{or} \quad
    h_i = \frac{c B}{n w} \quad x B = W - n S

Breusing's chart, the geometric mean of tangent and sine: ``v = sin θ/√(cos θ) u``, θ = α/4.

With ``c = cos θ`` and ``x = (1 − c²)/c`` the quaternion is ``(c − x + 2 √c v)/(c + x)``, where ``c + x = 1/c``:

.. math::
    c = \frac{2}{x + \sqrt{x^2 + 4}} \qquad s = \frac{c - x}{c + x} \quad w = \frac{2 \sqrt c}{c + x} \quad
    \rho = \frac{8 c^{3/2}}{1 + c^2} \quad h_i = \frac{3}{4 \sqrt c} \quad h = \frac{4 c^{5/2} (3 + 2 c^2)}{1 + c^2}

    \frac{dc}{dx} = -\frac{c^2}{1 + c^2}

The code divides by c + x instead of multiplying by c. The norm is then 1 for any rounding error of c.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import sympy

from ..algebra import Coefficient
from ..algebra.arithmetic import Arithmetic, Pair
from .elementary import alpha
from .order_charts import Derivatives, OrderChart, double_angle, near_pole
from .polynomials import RING, RING_X, Triple, horner, ring_pair, x
from .scalars import DependentScalars, scalar


@lru_cache(maxsize=64)
def polynomials_of(n: int) -> tuple[Any, Any, Any, Any]:
    """Return S, W, H and B of order n, as elements of Z[x]."""
    p, q = ring_pair(n)
    S, W = _homogeneous(p, n // 2), _homogeneous(q, (n - 1) // 2)
    sine = W if n % 2 else (1 - RING_X) * W
    return S, W, (2 * n - 2 * (1 - RING_X) * S * W).exquo(RING_X), (sine - n * S).exquo(RING_X)


def _homogeneous(polynomial: Any, degree: int) -> Any:
    """Return ``Σ a_j x^j (1 − x)^(degree − j)``."""
    terms = (c * RING_X**j * (1 - RING_X) ** (degree - j) for (j,), c in polynomial.terms())
    return sum(terms, RING.zero)


class SineScalars(DependentScalars):
    """Scalars at x = sin² θ."""

    def __init__(self, order: int, x: Coefficient, m: Arithmetic) -> None:
        super().__init__(x, m)
        self.order = order
        self.odd = order % 2 == 1
        self.S, self.W, self.H, self.B = polynomials_of(order)

    cc = scalar(lambda at: 1 - at.x)
    c = scalar(lambda at: at.m.sqrt(at.cc))  # cos θ

    def _at(self, name: str, polynomial: Any) -> Coefficient:
        return self.m.name(name, self._value(polynomial))

    def _value(self, polynomial: Any) -> Coefficient:
        return horner(polynomial, self.x)

    def _with_root(self, value: Coefficient, odd: bool) -> Coefficient:
        return self.c * value if odd else value

    s = scalar(lambda at: at._with_root(at._value(at.S), at.odd))
    w = scalar(lambda at: at._with_root(at._value(at.W), not at.odd))
    rate = scalar(lambda at: at.m.div(2 * at.order, at.c), "rho")
    ratey = scalar(lambda at: at.rate / at.cc, "rhoy")
    h = scalar(lambda at: at._value(at.H) / at.c)

    hy = scalar(lambda at: 2 * at._at("dH", at.H.diff(RING_X)) / at.c + at.h / at.cc)  # (2 H′ + H/c²)/c
    rateyy = scalar(lambda at: 3 * (at.ratey / at.cc), "rhoyy")

    @cached_property
    def hyy(self) -> Coefficient:
        """Second slope of h, ``(4 H″ + 4 H′/c² + 3 H/c⁴)/c = (4 H″ − 2 H′/c²)/c + 3 h_y/c²``."""
        slope = self.H.diff(RING_X)
        first, second = self._at("dH", slope), self._at("ddH", slope.diff(RING_X))
        direct = (4 * second - self.m.div(2 * first, self.cc)) / self.c
        return self.m.name("hyy", direct + 3 * self.hy / self.cc)

    _below = scalar(lambda at: at.order * at.w, "below")  # n w
    hi = scalar(lambda at: at.m.div(at._with_root(at._at("B", at.B), at.odd), at._below))

    @cached_property
    def hiy(self) -> Coefficient:
        """Slope of h_i, from ``n (w h_i)_y = 2 B′ c − B/c`` for odd n and ``2 B′`` for even n."""
        B, dB = self._at("B", self.B), 2 * self._at("dB", self.B.diff(RING_X))
        change = self.c * dB - self.m.div(B, self.c) if self.odd else dB
        return self.m.name("hiy", self._quotient(change, self.hi * self.wy))

    @cached_property
    def hiyy(self) -> Coefficient:
        """Second slope of h_i: ``n (w h_i)_yy`` is ``4 B″ c − 4 B′/c − B/c³`` for odd n and ``4 B″`` for even n."""
        slope = self.B.diff(RING_X)
        B, dB, ddB = self._at("B", self.B), self._at("dB", slope), self._at("ddB", slope.diff(RING_X))
        change = 4 * ddB
        if self.odd:
            change = self.c * change - self.m.div(4 * dB + self.m.div(B, self.cc), self.c)
        rest = 2 * (self.hiy * self.wy) + self.hi * self.wyy
        return self.m.name("hiyy", self._quotient(change, rest))

    def _quotient(self, change: Coefficient, rest: Coefficient) -> Coefficient:
        """Return ``(change − n rest)/(n w)``."""
        return self.m.div(change - self.order * rest, self._below)


class SineAtAngle(SineScalars):
    """Scalars for known f_i and cos θ."""

    hi, hiy = DependentScalars.hi, DependentScalars.hiy  # computed from f_i: T⁻¹ along the axis is φ′ for any error

    def __init__(self, chart: Sine, x: Coefficient, fi: Coefficient, cosine: Coefficient, m: Arithmetic) -> None:
        super().__init__(chart.order, x, m)
        self.fi = fi
        self.c = m.name("c", cosine)
        self.cc = m.name("cc", self.c * self.c)

    def _value(self, polynomial: Any) -> Coefficient:
        """Return the value by powers of cos² θ, without loss of digits near the edge."""
        return horner(polynomial.compose(RING_X, 1 - RING_X), self.cc)


@dataclass(frozen=True)
class Sine(OrderChart):
    """Chart v = sin(α/2n) u, up to |Re α| = nπ."""

    name: str
    order: int = 1
    selection: tuple[str, str] = ("", "")
    title: str = ""

    @property
    def phi(self) -> sympy.Expr:
        return sympy.sin(alpha / (2 * self.order))

    @property
    def angle(self) -> sympy.Expr:
        return 2 * self.order * sympy.asin(sympy.sqrt(x))

    def overflow(self, largest: float) -> tuple[str, float]:
        return "v ends, at Re|v| = 1", 1.0

    def scalars(self, x: Coefficient, m: Arithmetic) -> SineScalars:
        return SineScalars(self.order, x, m)

    def known(self, angle: Coefficient, m: Arithmetic) -> Coefficient:
        """Return cos θ, whose sign changes every 2nπ; v is on the side where it is positive."""
        _, cosine = double_angle(m.name("t", m.tan(m.div(angle, 4 * self.order))), m)
        return m.name("known", m.abs(cosine))

    def at_known(self, x: Coefficient, fi: Coefficient, known: Coefficient, m: Arithmetic) -> SineAtAngle:
        return SineAtAngle(self, x, fi, known, m)

    def phi_derivatives(self, sine: Coefficient, cosine: Coefficient, m: Arithmetic, mark: str = "") -> Derivatives:
        return sine, cosine, -sine

    def cosine(self, x: Coefficient, m: Arithmetic) -> Pair:
        return m.name("c", m.sqrt(1 - x)), 1

    def over_sine(self, cosine: Coefficient, m: Arithmetic) -> Pair:
        return 1, 1


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
