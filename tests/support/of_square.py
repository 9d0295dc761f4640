"""Oracle of a φ given by ``φ/α`` as a function of α²; it is analytic at 0, so no root loses nilpotent parts."""

from __future__ import annotations

from collections.abc import Callable
from math import factorial
from typing import Any

import mpmath

from tests.support.families import DIGITS, angle_by_tangent, real
from tests.support.first_principles import remembered
from tests.support.nilpotent import Field, Nil, dot
from tests.support.oracle import Oracle

Share = Callable[[Field, Any], Any]


class OfSquare(Oracle):
    """Oracle of v = α share(α²) u; α² comes from root finding, its nilpotent parts from steps with the real slope."""

    def __init__(self, share: Share) -> None:
        super().__init__(1, DIGITS)
        self.share = share

    @remembered
    def root(self, real: Any) -> tuple[Any, Any]:
        """Return α² and its slope at a real x, which many arguments have in common."""
        with mpmath.workdps(DIGITS):
            found = mpmath.findroot(lambda u: self._x(u) / real - 1, self._bounds(real)) if real else real
        one = self.field.number(1)
        return found, self._x(Nil(one * found, one)).du

    def square(self, x: Any) -> Any:
        """Return α² at x = v·v; each step with the real slope adds one level of nilpotent parts."""
        found, slope = self.root(real(x))
        u = x * 0 + found
        for _ in range(_levels(x)):
            u = u - (self._x(u) - x) / slope
        return u

    def _x(self, u: Any) -> Any:
        share = self.share(self.field, u)
        return u * share * share

    def _bounds(self, x: Any) -> tuple[Any, Any]:
        """Return bounds of α², by doubling and halving, since x grows with α²."""
        u = x / self._x(x * 0 + 1e-30) * 1e-30
        while self._x(u) > x:
            u = u / 2
        while self._x(2 * u) < x:
            u = u * 2
        return u, 2 * u

    def base(self, v: Any) -> Any:
        u = self.square(dot(v, v))
        return angle_by_tangent(self.field, u) * self.share(self.field, u)

    def size(self, theta: Any) -> Any:
        alpha = 2 * theta
        return alpha * self.share(self.field, alpha * alpha)


def _levels(number: Any) -> int:
    return 1 + _levels(number.re) if isinstance(number, Nil) else 0


def series(u: Any, first: int, slope: int = 0) -> Any:
    """Return the derivative of order ``slope`` of ``Σ u^k/(2k + first)!``: cosh √u for 0, sinh √u/√u for 1."""
    if isinstance(u, Nil):
        return Nil(series(u.re, first, slope), u.du * series(u.re, first, slope + 1))
    term = total = u * 0 + 1
    k = 0
    while abs(term) * 10 ** (DIGITS + 10) > abs(total):
        k += 1
        j = 2 * (k + slope) + first
        term = term * u * (k + slope) / (k * j * (j - 1))
        total = total + term
    return total * factorial(slope) / factorial(2 * slope + first)
