"""Derivatives of a φ that is 0/0 or a root of 0 at α = 0, for kernels: by a polynomial where φ loses digits."""

from __future__ import annotations

from typing import Any

import sympy

from ...algebra import Coefficient
from ...algebra.arithmetic import Arithmetic
from ..real_constants import plus
from .near_zero import Ratio
from .phi_values import PhiValues


class Lengths:
    """Derivatives of a φ that is a quotient at 0: below a limit those of ``α b(α²)``, with a polynomial b."""

    def __init__(
        self, near: Ratio, end: Any, angle: Coefficient, square: Coefficient, m: Arithmetic, mark: str
    ) -> None:
        self.m, self.angle, self.mark, self.near = m, angle, mark, near
        limit = near.limit
        self._known: dict[int, Coefficient] = {}
        self.is_near = m.name(f"small{mark}", m.less(limit.denominator * square, limit.numerator))
        self.square = m.name(f"squaren{mark}", m.where(self.is_near, square, square - square))
        self.side = m.name(f"sideof{mark}", m.where(m.less(angle, 0), -1, 1))
        beside = plus(angle - angle, end / 2, m, f"between{mark}")  # an unused angle
        self.far = PhiValues(m.name(f"large{mark}", m.where(self.is_near, beside, self.side * angle)), m)

    def derivative(self, phi: sympy.Expr, count: int) -> Coefficient:
        """Return a derivative up to the third, or φ itself for count 0."""
        far, xi, angle = self.far.derivative(phi, count), self.square, self.angle
        near = (
            lambda: angle * self._b(0),
            lambda: self._b(0) + 2 * (xi * self._b(1)),
            lambda: angle * (6 * self._b(1) + 4 * (xi * self._b(2))),
            lambda: 6 * self._b(1) + 24 * (xi * self._b(2)) + 8 * (xi * xi * self._b(3)),
        )[count]()
        value = self.m.where(self.is_near, near, far if count % 2 else self.side * far)
        return self.m.name(f"phi{count}{self.mark}", value)

    def _b(self, count: int) -> Coefficient:
        if count not in self._known:
            self._known[count] = self.near.polynomials[count].at(self.square, self.m, f"b{count}{self.mark}")
        return self._known[count]
