r"""Multiples of Cayley charts, ``v = K tan(α/2n) u``: those of K = 2n have φ′(0) = 1, and n = 2 is Wiener–Milenković.

Every scalar is that of order n at ``x/K²``, by a power of K.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from types import SimpleNamespace
from typing import Any

import sympy

from ..algebra import Coefficient, Quaternion
from ..algebra.arithmetic import Arithmetic
from . import branches, gains
from .cayley import Cayley
from .cayley_scalars import CayleyScalars
from .chart import Scalars
from .dependent import divided
from .families import alpha
from .parameterized import Parameterized
from .polynomials import x

POWERS = {
    "s": 0, "w": 1, "f": 1, "g": 2, "h": 3, "fi": -1, "hi": 1,
    "rate": 1, "ratey": 3, "sy": 2, "wy": 3, "fy": 3, "gy": 4, "hy": 5, "fiy": 1, "hiy": 3,
    "fyy": 5, "gyy": 6, "hyy": 7, "fiyy": 3, "hiyy": 5,
}  # fmt: skip
"""The power of K by which each scalar is divided."""


class ScaledScalars:
    """The scalars at x = K² tan² θ."""

    def __init__(self, order: int, scale: Fraction, x: Coefficient, m: Arithmetic) -> None:
        self.scale = scale
        self.m = m
        self.inner = CayleyScalars(order, m.name("z", divided(x, scale**2, m)), m)
        self._known: dict[str, Coefficient] = {}

    def __getattr__(self, name: str) -> Coefficient:
        if name not in POWERS:
            raise AttributeError(name)
        if name not in self._known:
            value = divided(getattr(self.inner, name), self.scale ** POWERS[name], self.m)
            self._known[name] = self.m.name(f"{name}_v", value)
        return self._known[name]

    @property
    def ray(self) -> tuple[Coefficient, Coefficient, Coefficient]:
        a, b, size = self.inner.ray
        return a, divided(b, self.scale, self.m), size


@dataclass(frozen=True)
class Scaled(branches.BranchesOfOrder, Parameterized):
    """v = K tan(α/2n) u, up to |Re α| = nπ."""

    name: str
    order: int = 1
    scale: Fraction = Fraction(1)
    selection: tuple[str, str] = ("", "")
    title: str = ""

    @property
    def phi(self) -> sympy.Expr:
        return sympy.Rational(self.scale) * sympy.tan(alpha / (2 * self.order))

    @property
    def algebraic(self) -> bool:
        return (self.scale**2).denominator == 1

    def overflow(self, largest: float) -> tuple[str, float]:
        reason, most = Cayley(self.order).overflow(largest)
        return reason.replace("x", f"x/{self.scale**2}"), most * float(self.scale)

    @cached_property
    def _values(self) -> Any:
        """From the formulas of the Cayley map, which are in lowest terms."""
        if not self.algebraic:
            return super()._values
        at, scale = Cayley(self.order), sympy.Rational(self.scale)
        (s, w), (f, g, h) = at.quaternion.coefficients, at.tangent.coefficients
        fi, _, hi = (2 * c for c in at.tangent_inv.coefficients)
        found = {"s": s, "w": w, "f": f, "g": g, "h": h, "fi": fi, "hi": hi}
        return SimpleNamespace(x=x, **{k: v.xreplace({x: x / scale**2}) / scale ** POWERS[k] for k, v in found.items()})

    def scalars(self, x: Coefficient, m: Arithmetic) -> Scalars:
        return ScaledScalars(self.order, self.scale, x, m)

    def coefficient(self, angle: Coefficient, m: Arithmetic) -> tuple[Coefficient, Coefficient]:
        t, slope = Cayley(self.order).coefficient(angle, m)
        return self._times(t, m, "v"), self._times(slope, m, "v_slope")

    def coefficient_of(
        self, angle: Coefficient, sine: Coefficient, cosine: Coefficient, m: Arithmetic
    ) -> tuple[Coefficient, Coefficient]:
        t, slope = Cayley(self.order).coefficient_of(angle, sine, cosine, m)
        return self._times(t, m, "v"), self._times(slope, m, "v_slope")

    def gain(self, q: Quaternion, size: Coefficient, m: Arithmetic, positive: bool = False) -> Coefficient:
        return self._times(gains.gain(self.order, q, size, m, positive), m, "gain")

    def back(self, x: Coefficient, fi: Coefficient, m: Arithmetic) -> tuple[Coefficient, Coefficient]:
        at = self.scalars(x, m)
        return at.fi, at.hi

    def at_angle(self, x: Coefficient, fi: Coefficient, angle: Coefficient, m: Arithmetic) -> Scalars:
        return self.scalars(x, m)

    def direction(self, x: Coefficient, y: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        tangent = divided(r, self.scale, m)
        return branches.direction(self.order, self._inner(x, m), y, tangent, m)

    def natural(
        self, x: Coefficient, y: Coefficient, r: Coefficient, m: Arithmetic
    ) -> tuple[Coefficient, Coefficient, Coefficient]:
        tangent = divided(r, self.scale, m)
        angle, slope, sign = branches.natural(self.order, self._inner(x, m), y, tangent, m)
        return angle, divided(slope, self.scale, m), sign

    def unfolded(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        return 2 * self.order * m.atan2(divided(r, self.scale, m), 1)

    def turned(self, r: Coefficient, turn: Sequence[Coefficient], m: Arithmetic) -> tuple[Coefficient, Coefficient]:
        rk, slope = branches.turned(m.name("rt", divided(r, self.scale, m)), turn, m)
        return self._times(rk, m, "rv"), slope

    def returns(self) -> tuple[tuple[Any, Any, Any], ...]:
        square = self.scale**2
        rows = branches.returns(self.order)
        return tuple((limit * square.numerator / square.denominator, *turn) for limit, *turn in rows)

    def _inner(self, x: Coefficient, m: Arithmetic) -> CayleyScalars:
        return CayleyScalars(self.order, m.name("z", divided(x, self.scale**2, m)), m)

    def _times(self, value: Coefficient, m: Arithmetic, name: str) -> Coefficient:
        return m.name(name, divided(value, 1 / self.scale, m))
