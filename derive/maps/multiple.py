r"""Multiples ``v = K w`` of a base chart with vector w.

The chart ``scaledn`` is 2n times ``cayleyn``, with φ′(0) = 1. Every scalar of v is the scalar of w at ``x/K²``,
divided by a power of K (`POWERS`). Inverse maps and branches come from the base chart:

.. math:: s(x) = s_w(x/K^2) \qquad f = \frac{f_w}{K} \quad g = \frac{g_w}{K^2} \quad h = \frac{h_w}{K^3} \qquad
    f_i = K f_{i,w} \quad h_i = \frac{h_{i,w}}{K}
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from operator import attrgetter
from types import SimpleNamespace
from typing import Any

import sympy

from ..algebra import Coefficient, Quaternion
from ..algebra.arithmetic import Arithmetic, Pair
from .chart import Chart, Followed
from .chart_formulas import Scalars
from .order_charts import Derivatives
from .polynomials import Triple, x
from .real_constants import SMALL

POWERS = {
    "s": 0, "w": 1, "f": 1, "g": 2, "h": 3, "fi": -1, "hi": 1, "ai": -1,
    "rate": 1, "ratey": 3, "sy": 2, "wy": 3, "fy": 3, "gy": 4, "hy": 5, "fiy": 1, "hiy": 3,
    "fyy": 5, "gyy": 6, "hyy": 7, "fiyy": 3, "hiyy": 5,
}  # fmt: skip
"""Powers of K that divide the scalars of the base chart; each slope adds two."""

FURTHER_POWERS = {
    "x": -2, "y": -2, "v11": -2, "v22": -2, "v33": -2, "r": -1, "fe": -1, "b": 1, "gain": -1, "rk": -1,
    "place": -2, "along": -1, "of_e": -1,
}  # fmt: skip
"""Powers of K that divide other numbers of the base chart; angles, turns and quaternions have none."""


def divided(value: Coefficient, factor: Fraction, m: Arithmetic, power: int = 1) -> Coefficient:
    """Return ``value/factor^power``, by integers that every number type holds exactly."""
    if power < 0:
        factor, power = 1 / factor, -power
    largest = max(factor.numerator, factor.denominator)
    while power > 0:
        step = next((k for k in range(power, 1, -1) if largest**k <= SMALL), 1)
        by, power = factor**step, power - step
        above = value if by.denominator == 1 else by.denominator * value
        value = above if by.numerator == 1 else m.div(above, by.numerator)
    return value


class MultipleScalars:
    """Scalars of ``v = K w``, from the scalars of the base chart at ``x/K²``."""

    def __init__(self, base: Scalars, factor: Fraction, m: Arithmetic) -> None:
        self.base = base
        self.factor = factor
        self.m = m

    def __getattr__(self, name: str) -> Coefficient:
        if name not in POWERS:
            raise AttributeError(name)
        return self.m.name(f"{name}_v", divided(getattr(self.base, name), self.factor, self.m, POWERS[name]))

    @property
    def ray(self) -> Triple:
        a, b, size = self.base.ray
        return a, divided(b, self.factor, self.m), size


@dataclass(frozen=True)
class Multiple(Chart):
    """Chart ``v = K w``, K > 0, with the branches, edge and singular angles of the base chart of w."""

    name: str
    base: Chart = field()  # without the default of Chart
    factor: Fraction = field()
    selection: tuple[str, str] = ("", "")
    title: str = ""

    order = property(attrgetter("base.order"), doc="Order of the base chart.")
    edge = property(attrgetter("base.edge"), doc="Edge of the base chart.")
    branches = property(attrgetter("base.branches"), doc="Period of the branches of the base chart.")
    singular_angles = property(attrgetter("base.singular_angles"), doc="Singular angles of the base chart.")
    remainder = property(attrgetter("base.remainder"), doc="Approximation error of the base chart.")

    @property
    def phi(self) -> sympy.Expr:
        return sympy.Rational(self.factor) * self.base.phi

    @property
    def algebraic(self) -> bool:
        return (self.factor**2).denominator == 1 and all(c.free_symbols <= {x} for c in self.base.tangent.coefficients)

    def overflow(self, largest: float) -> tuple[str, float]:
        reason, most = self.base.overflow(largest)
        if self.range.is_finite:
            return f"v ends, at Re|v| = {self.range}", most * float(self.factor)
        return reason.replace("x", f"x/{self.factor**2}", 1), most * float(self.factor)

    @cached_property
    def _values(self) -> Any:
        """Scalars from the formulas of the base chart, already in lowest terms."""
        if not self.algebraic:
            return super()._values
        factor = sympy.Rational(self.factor)
        (s, w), (f, g, h) = self.base.quaternion.coefficients, self.base.tangent.coefficients
        fi, _, hi = (2 * c for c in self.base.tangent_inv.coefficients)
        found = {"s": s, "w": w, "f": f, "g": g, "h": h, "fi": fi, "hi": hi}
        return SimpleNamespace(
            x=x, **{k: v.xreplace({x: x / factor**2}) / factor ** POWERS[k] for k, v in found.items()}
        )

    @property
    def angle(self) -> sympy.Expr:
        return self.base.angle.xreplace({x: x / sympy.Rational(self.factor) ** 2})

    # --- scalars and inverse maps ---------------------------------------------------------------------------------

    def scalars(self, x: Coefficient, m: Arithmetic) -> MultipleScalars:
        return MultipleScalars(self.base.scalars(self._square(x, m), m), self.factor, m)

    def coefficient(self, angle: Coefficient, m: Arithmetic) -> Pair:
        return self._multiplied(self.base.coefficient(angle, m), m)

    def coefficient_of(self, angle: Coefficient, sine: Coefficient, cosine: Coefficient, m: Arithmetic) -> Pair:
        return self._multiplied(self.base.coefficient_of(angle, sine, cosine, m), m)

    def _multiplied(self, pair: Pair, m: Arithmetic) -> Pair:
        r, slope = pair
        return self._times(r, m, "r_v"), self._times(slope, m, "slope_v")

    def gain(self, q: Quaternion, size: Coefficient, m: Arithmetic) -> Coefficient:
        return self._times(self.base.gain(q, size, m), m, "gain_v")

    def back(self, x: Coefficient, fi: Coefficient, m: Arithmetic) -> Pair:
        f, h = self.base.back(self._square(x, m), m.name("fi_w", divided(fi, self.factor, m)), m)
        return self._times(f, m, "fi_v"), m.name("hi_v", divided(h, self.factor, m))

    def known(self, angle: Coefficient, m: Arithmetic) -> Coefficient:
        return self.base.known(angle, m)

    def at_known(self, x: Coefficient, fi: Coefficient, known: Coefficient, m: Arithmetic) -> MultipleScalars:
        fi = m.name("fi_w", divided(fi, self.factor, m))
        return MultipleScalars(self.base.at_known(self._square(x, m), fi, known, m), self.factor, m)

    def followed(
        self, x: Coefficient, along: Coefficient, e: Quaternion, size: Coefficient, turn: Coefficient, m: Arithmetic
    ) -> Followed:
        along = m.name("along_w", divided(along, self.factor, m))
        found = self.base.followed(self._square(x, m), along, e, size, turn, m)
        return found._replace(of_e=self._times(found.of_e, m, "ofe_v"), fe=self._times(found.fe, m, "fe_v"))

    def natural(self, x: Coefficient, y: Coefficient, r: Coefficient, m: Arithmetic) -> Triple:
        angle, slope, sign = self.base.natural(self._square(x, m), y, self._length(r, m), m)
        return angle, divided(slope, self.factor, m), sign

    def unfolded(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        return self.base.unfolded(self._square(x, m), self._length(r, m), m)

    def turned(self, r: Coefficient, turn: Sequence[Coefficient], m: Arithmetic) -> Derivatives:
        rk, slope, bend = self.base.turned(self._length(r, m), turn, m)
        return self._times(rk, m, "rk_v"), slope, m.name("bend_v", divided(bend, self.factor, m))

    def beyond(self, x: Coefficient, table: Sequence[Coefficient], m: Arithmetic) -> tuple[Any, Coefficient, Pair]:
        selected, place, turn = self.base.beyond(self._square(x, m), table, m)
        return selected, m.name("place_v", divided(place, self.factor, m, -2)), turn

    def turn(self, branch: int) -> tuple[Any, Any]:
        return self.base.turn(branch)

    def returns(self) -> Sequence[tuple[Any, Any, Any]]:
        """Return the table of the base chart, whose limits apply to ``x/K²``."""
        return self.base.returns()

    def _square(self, x: Coefficient, m: Arithmetic) -> Coefficient:
        return m.name("x_w", divided(x, self.factor, m, 2))

    def _length(self, r: Coefficient, m: Arithmetic) -> Coefficient:
        return m.name("r_w", divided(r, self.factor, m))

    def _times(self, value: Coefficient, m: Arithmetic, name: str) -> Coefficient:
        return m.name(name, divided(value, self.factor, m, -1))
