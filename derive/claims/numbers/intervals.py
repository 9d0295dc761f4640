"""Intervals of generators by what they stand for: tangents, exponentials, roots and angles."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import comb
from typing import Any

import sympy

from .signed import Bound

ALL = (-sympy.oo, sympy.oo)
Monomial = tuple[tuple[str, int], ...]
"""Generators with their exponents."""


def interval(field: Any, monomial: Monomial) -> tuple[Bound, Bound]:
    """Return the interval of a monomial: that of a name or of a quotient, else all numbers."""
    (name, power), *rest = monomial
    found: tuple[Bound, Bound] = field.ratios.get(monomial, ALL) if rest or power != 1 else field.given.get(name, ALL)
    return found


def _of_tangent(field: Any, name: str, monomial: Monomial) -> None:
    low, high = interval(field, monomial)
    if max(abs(low), abs(high)) < field.steps * sympy.pi:
        ends = [_vanishing_at(end, field.steps) for end in (low, high) if end]
        known = [end for end in ends if end is not None]
        for reached in (field.ring.closed, field.ring.limits, field.ring.endless):
            reached |= {name} if monomial[0][0] in reached else set()
        field.ring.restrict(name, *(sympy.tan(end / (2 * field.steps)) for end in (low, high)), known)


def _of_exponential(field: Any, name: str, monomial: Monomial) -> None:
    """Set the interval of an exponential: it is positive, and at least 1 if its exponent is not negative."""
    lows = {other: interval(field, ((other, 1),))[0] for other, _ in monomial}
    positive = all(power % 2 == 0 or lows[other] >= 0 for other, power in monomial)
    field.ring.restrict(name, sympy.Integer(int(positive)), sympy.oo)
    if positive and any(low < 0 or other in field.closed for other, low in lows.items()):
        field.ring.closed.add(name)


def _of_root(field: Any, name: str, square: Any) -> None:
    field.ring.restrict(name, sympy.Integer(0), sympy.oo)
    _close_unless_apart(field, name, square)


def _of_power(field: Any, name: str, factor: Any) -> None:
    field.ring.restrict(name, sympy.Integer(0), sympy.oo)
    _close_unless_apart(field, name, factor)


def _of_angle(field: Any, name: str, y: Any) -> None:
    """Set the interval of the angle of a point (x, y), which is above the axis if y is positive."""
    if field.is_positive(y):
        field.ring.restrict(name, sympy.Integer(0), sympy.pi)
        _close_unless_apart(field, name, y)


def _close_unless_apart(field: Any, name: str, number: Any) -> None:
    """Note that a generator reaches its end, unless a number that vanishes there is 0 nowhere."""
    if not all(field.ring.definite(factor, strict=True, limits=True) for factor in field.ring.factors(number)):
        field.ring.closed.add(name)


INTERVALS: Mapping[str, Callable[[Any, str, Any], None]] = {
    "tangent": _of_tangent, "exponential": _of_exponential, "root": _of_root, "angle": _of_angle,
    "power": _of_power,
}  # fmt: skip
"""Functions that set the interval of a generator, by what it stands for."""


def _vanishing_at(end: Bound, steps: int) -> Any:
    """Return the polynomial in ``tan(angle/2 steps)`` that vanishes at a multiple of π; None for another angle."""
    if not (end / sympy.pi).is_Rational:
        return None
    power = 2 * steps * (end / sympy.pi).q
    imaginary = {(k,): comb(power, k) * (-1) ** (k // 2) for k in range(1, power + 1, 2)}  # of (1 + i x)**power
    return sympy.Poly(imaginary, sympy.Symbol("x"))
