"""Chart v = sin(α/6) u that the toolkit does not know: a subclass of `OrderChart` with scalars in closed form."""

from __future__ import annotations

from dataclasses import dataclass

import sympy

from derive.algebra import Coefficient
from derive.algebra.arithmetic import Arithmetic, Pair
from derive.maps.elementary import alpha
from derive.maps.order_charts import Derivatives, OrderChart
from derive.maps.scalars import DependentScalars, scalar


class SineScalars(DependentScalars):
    """Scalars at x = sin² θ, with θ = α/6 and q̂ = cos 3θ + u sin 3θ."""

    cc = scalar(lambda at: 1 - at.x)
    c = scalar(lambda at: at.m.sqrt(at.cc))  # cos θ
    s = scalar(lambda at: (1 - 4 * at.x) * at.c)
    w = scalar(lambda at: 3 - 4 * at.x)
    rate = scalar(lambda at: 6 / at.c, "rho")
    ratey = scalar(lambda at: at.rate / at.cc, "rhoy")
    rateyy = scalar(lambda at: 3 * (at.ratey / at.cc), "rhoyy")
    h = scalar(lambda at: (38 + (32 * at.x - 64) * at.x) / at.c)
    hy = scalar(lambda at: at._hcc - 128 * at.c)
    hyy = scalar(lambda at: (at.hy + 2 * at._hcc) / at.cc + 128 / at.c)
    _hcc = scalar(lambda at: at.h / at.cc, "hcc")


@dataclass(frozen=True)
class Sine(OrderChart):
    """Chart v = sin(α/6) u, up to |Re α| = 3π."""

    name: str = "sine6"
    order: int = 3
    selection: tuple[str, str] = ("--phi", "sin(alpha/6)")
    title: str = "Sine of a sixth of the angle"

    @property
    def phi(self) -> sympy.Expr:
        return sympy.sin(alpha / 6)

    def overflow(self, largest: float) -> tuple[str, float]:
        return "v is no sine", 1.0

    def scalars(self, x: Coefficient, m: Arithmetic) -> SineScalars:
        return SineScalars(x, m)

    def phi_derivatives(self, sine: Coefficient, cosine: Coefficient, m: Arithmetic, mark: str = "") -> Derivatives:
        return sine, cosine, -sine

    def cosine(self, x: Coefficient, m: Arithmetic) -> Pair:
        return m.name("c", m.sqrt(1 - x)), 1

    def over_sine(self, cosine: Coefficient, m: Arithmetic) -> Pair:
        return 1, 1
