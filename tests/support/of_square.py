"""Oracle of a φ given by ``φ/α`` as a function of α²; it is analytic at 0, so no root loses nilpotent parts."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath

from tests.support.families import DIGITS, angle_by_tangent
from tests.support.nilpotent import Field, Nil, dot
from tests.support.oracle import Oracle

Share = Callable[[Field, Any], Any]

TERMS = 90
"""Number of terms of series in α² up to (4π)², for 60 digits: 158^90/180! is 1e-131."""
NESTED = 4
"""Number of Newton steps for nilpotent parts, enough for nested dual numbers and derivatives."""


class OfSquare(Oracle):
    """Oracle of v = α share(α²) u; α² comes from root finding, its nilpotent parts from steps with the real slope."""

    def __init__(self, share: Share) -> None:
        super().__init__(1, DIGITS)
        self.share = share

    def square(self, x: Any) -> Any:
        """Return α² at x = v·v."""
        real, one = _real(x), self.field.number(1)
        with mpmath.workdps(DIGITS):
            found = mpmath.findroot(lambda u: self._x(u) / real - 1, self._bounds(real)) if real else real
        slope = self._x(Nil(one * found, one)).du
        u = x * 0 + found
        for _ in range(NESTED):
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


def _real(number: Any) -> Any:
    return _real(number.re) if isinstance(number, Nil) else number


def series(u: Any, first: int) -> Any:
    """Return ``Σ u^k/(2k + first)!``: cosh √u for ``first`` = 0, sinh √u/√u for 1."""
    total = u * 0
    for k in range(TERMS, 0, -1):
        total = (total + 1) * u / ((2 * k + first) * (2 * k + first - 1))
    return total + 1
