"""Chart v = sin(α/6) u defined outside the toolkit: it has all members of `Chart` and uses none of its code."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import mpmath
import sympy

from derive.algebra import Coefficient, Quaternion
from derive.algebra.arithmetic import Arithmetic
from derive.maps import IsotropicMap, QuaternionMap, order_charts, x
from derive.maps.chart import DEFINITIONS
from derive.maps.families import alpha

HALF = sympy.Rational(1, 2)
COSINE = sympy.sqrt(1 - x)


def scalar(name: str, formula: Callable[[Any], Coefficient]) -> Any:
    """Return the property that computes a formula once, under its name in programs."""
    return cached_property(lambda at: at.m.name(name, formula(at)))


class SineScalars:
    """Scalars at x = sin² θ, with θ = α/6 and q̂ = cos 3θ + u sin 3θ."""

    def __init__(self, x: Coefficient, m: Arithmetic) -> None:
        self.x, self.m = x, m

    cc = scalar("cc", lambda at: 1 - at.x)
    c = scalar("c", lambda at: at.m.sqrt(at.cc))  # cos θ
    p = scalar("p", lambda at: 1 - 4 * at.x)
    s = scalar("s", lambda at: at.p * at.c)
    w = scalar("w", lambda at: 3 - 4 * at.x)
    ww = scalar("ww", lambda at: at.w * at.w)
    sy = scalar("sy", lambda at: -3 * (at.w / at.c))
    wy = -8
    f = scalar("f", lambda at: 2 * (at.s * at.w))
    g = scalar("g", lambda at: 2 * at.ww)
    h = scalar("h", lambda at: (38 + (32 * at.x - 64) * at.x) / at.c)
    fy = scalar("fy", lambda at: 2 * (at.sy * at.w) - 16 * at.s)
    gy = scalar("gy", lambda at: -32 * at.w)
    hy = scalar("hy", lambda at: at._hcc - 128 * at.c)
    _hcc = scalar("hcc", lambda at: at.h / at.cc)
    rate = scalar("rho", lambda at: 6 / at.c)
    ratey = scalar("rhoy", lambda at: at.rate / at.cc)
    fi = scalar("fi", lambda at: at.s / at.w)
    hi = scalar("hi", lambda at: at.m.div(8 * (at.c / at.w), 3))
    fiy = scalar("fiy", lambda at: -(at.h / at.g))
    hiy = scalar("hiy", lambda at: at.m.div(8 * at._turn, 3 * at.ww))
    _turn = scalar("cw", lambda at: 8 * at.c - at.w / at.c)
    gyy = 256
    fyy = scalar("fyy", lambda at: 2 * ((24 * at.w - 3 * (at.ww / at.cc)) / at.c) - 32 * at.sy)
    hyy = scalar("hyy", lambda at: (at.hy + 2 * at._hcc) / at.cc + 128 / at.c)
    fiyy = scalar("fiyy", lambda at: (at.h * at.gy / at.g - at.hy) / at.g)
    hiyy = scalar("hiyy", lambda at: at.m.div(8 * ((16 * at._turn / at.ww - 1 / (at.c * at.cc)) / at.w), 3))

    @property
    def ray(self) -> tuple[Coefficient, Coefficient, Coefficient]:
        return self.s, self.w, 1


@dataclass(frozen=True)
class Sine:
    """Chart v = sin(α/6) u, up to |Re α| = 3π."""

    name = "sine6"
    selection = ("--phi", "sin(alpha/6)")
    order = 1
    title = "Sine of a sixth of the angle"
    vector = "dual vector"
    algebraic = True
    parameter = "sin(α/6)"
    phi = sympy.sin(alpha / 6)
    edge = 3 * sympy.pi
    branches = 3
    remainder = 0.0
    ends = True
    steep = ()
    range = sympy.Integer(1)
    singular_angles = (2 * sympy.pi, 3 * sympy.pi)
    cayley = None
    base, factor = None, Fraction(1)
    letters = ()
    s, w = (1 - 4 * x) * COSINE, 3 - 4 * x
    scalars = SineScalars

    def overflow(self, largest: float) -> tuple[str, float]:
        return "v is no sine", 1.0

    def _formula(self, kind: Any, name: str, *coefficients: sympy.Expr) -> Any:
        symbol, _, definition = DEFINITIONS[name].partition(" = ")
        texts = {"domain": "every v with |Re v| < 1", "singular": "v ends at Re alpha = 3*pi", "symbol": symbol}
        rest = {"equations": (), "identities": (), "definition": definition}
        return kind(name=name, order=1, coefficients=coefficients, **texts, **rest)

    @cached_property
    def quaternion(self) -> QuaternionMap:
        return self._formula(QuaternionMap, "quaternion", self.s, self.w)

    @cached_property
    def tensor(self) -> IsotropicMap:
        g = 2 * self.w**2
        return self._formula(IsotropicMap, "tensor", sympy.expand(1 - x * g), 2 * self.s * self.w, g)

    @cached_property
    def tangent(self) -> IsotropicMap:
        h = (38 - 64 * x + 32 * x**2) / COSINE
        return self._formula(IsotropicMap, "tangent", 2 * self.s * self.w, 2 * self.w**2, h)

    @cached_property
    def tangent_inv(self) -> IsotropicMap:
        along = 4 * COSINE / (3 * self.w)
        return self._formula(IsotropicMap, "tangent_inv", self.s / (2 * self.w), -HALF, along)

    # --- way back, branches -------------------------------------------------------------------------------------

    def coefficient(self, angle: Coefficient, m: Arithmetic) -> tuple[Coefficient, Coefficient]:
        sine, cosine = _of_twice(m.name("t", m.tan(m.div(angle, 12))), m)
        further = m.name("further", cosine)
        side = m.name("side", m.where(m.less(further, 0), -1, 1))  # beyond the edge, v comes back on the opposite side
        return m.name("r", side * sine), m.name("slope", m.div(side * further, 6))

    def coefficient_of(
        self, angle: Coefficient, sine: Coefficient, cosine: Coefficient, m: Arithmetic
    ) -> tuple[Coefficient, Coefficient]:
        return self.coefficient(angle, m)

    def gain(self, q: Quaternion, size: Coefficient, m: Arithmetic) -> Coefficient:
        negative = m.name("negative", m.less(size + m.div(q.scalar, 16), size))
        cosine = m.name("cos", m.where(negative, -q.scalar, q.scalar))
        square = m.name("ss", q.vector.dot(q.vector))
        still = m.name("still", m.equal(square, 0))
        sine = m.name("sin", m.sqrt(m.where(still, cosine, square)))
        r, _ = _of_twice(m.name("t", m.tan(m.div(m.atan2(sine, cosine), 6))), m)
        gain = m.where(still, 1, r) / m.where(still, 3 * cosine, sine)
        return m.name("gain", m.where(negative, -1, 1) * gain)

    def inside(self, x: Coefficient, m: Arithmetic) -> Coefficient:
        over = m.name("over", x - 1)
        return m.name("shrunk", m.where(m.less(over, 0), 1, m.div(1, 1 + 4 * over)))

    def back(self, x: Coefficient, fi: Coefficient, m: Arithmetic) -> tuple[Coefficient, Coefficient]:
        return fi, self.scalars(x, m).hi

    def at_angle(self, x: Coefficient, fi: Coefficient, angle: Coefficient, m: Arithmetic) -> SineScalars:
        return self.scalars(x, m)

    def direction(self, x: Coefficient, y: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        at = self.scalars(x, m)
        turned = m.where(m.less(at.p, 0), m.name("mw", -at.w), at.w)
        backwards = m.both(m.equal(at.w, 0), m.less(y, 0))
        return m.name("sign", m.where(m.either(m.less(turned, 0), backwards), -1, 1))

    def natural(
        self, x: Coefficient, y: Coefficient, r: Coefficient, m: Arithmetic
    ) -> tuple[Coefficient, Coefficient, Coefficient]:
        at = self.scalars(x, m)
        s, w = (m.where(m.less(value, 0), -value, value) for value in (at.s, at.w))
        return m.name("angle", 2 * m.atan2(r * w, s)), m.name("slope", 6 / at.c), self.direction(x, y, r, m)

    def unfolded(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        return 6 * m.atan2(r, self.scalars(x, m).c)

    def turned(self, r: Coefficient, turn: Sequence[Coefficient], m: Arithmetic) -> order_charts.Derivatives:
        (cosine, sine), rr = turn, m.name("rr", r * r)
        c = m.name("c", m.sqrt(m.where(m.less(1, rr), rr, 1 - rr)))
        further = m.name("further", c * cosine - r * sine)
        sign = m.name("side", m.where(m.less(further, 0), -1, 1))
        rk, slope = m.name("rk", sign * (r * cosine + c * sine)), m.name("slope", sign * further / c)
        return rk, slope, m.name("bend", (slope * r - rk) / (c * c))

    def beyond(self, x: Coefficient, table: Sequence[Coefficient], m: Arithmetic) -> tuple[Any, Sequence[Coefficient]]:
        return order_charts.beyond(x, table, m)

    def turn(self, branch: int) -> tuple[Any, Any]:
        return order_charts.turn(3, branch)

    def returns(self) -> tuple[tuple[Any, Any, Any], ...]:
        return ((mpmath.mpf(1) / 4, *self.turn(-1)),)


def _of_twice(t: Coefficient, m: Arithmetic) -> tuple[Coefficient, Coefficient]:
    """Return sine and cosine of 2 arctan t."""
    tt = m.name("tt", t * t)
    below = m.name("below", 1 + tt)
    return 2 * t / below, (1 - tt) / below
