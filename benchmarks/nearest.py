"""Search for the φ whose Re T is nearest to a rotation, for ``dualcay compare``.

The measure is the largest of the singular values of Re T and their inverses up to an angle.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from typing import Any, TypeAlias

import numpy as np
from numpy.polynomial.polynomial import polyval
from numpy.typing import NDArray

from derive.pages.comparison import ANGLES, Stretch

POINTS = 400
"""Number of angles in the search for an extremum."""

DECIMAL_UNITS = 10**6

Angles: TypeAlias = NDArray[np.float64]


def searched() -> dict[str, Any]:
    """Return the number of points and the rows of the table: angle, kind, φ and its measure."""
    rows = []
    for name, angle in ANGLES.items():
        rows.append([name, "any (bound)", "", f"{bound(angle):.5f}"])
        rows += [[name, found.kind, f"`{found.phi}`", f"{found.worst:.5f}"] for found in best(angle)]
    return {"points": POINTS, "rows": rows}


def worst(found: Stretch) -> float:
    """Return the largest factor between a singular value and 1."""
    return max(found.along, found.across, 1 / found.along, 1 / found.across)


def bound(angle: float) -> float:
    """Return ``√(A/2 / sin(A/2))``, a lower bound of `worst` up to an angle A for every φ with φ′ > 0.

    ``1/φ′ ≤ M`` gives ``φ(A) ≥ A/M``, and ``φ/(2 sin(A/2)) ≤ M`` gives ``φ(A) ≤ 2 M sin(A/2)``. Hence
    ``M² ≥ A/(2 sin(A/2))``. ``φ = α/M`` attains the bound. No φ with φ′(0) = 1 does: its slope would have to jump.
    """
    return math.sqrt(angle / 2 / math.sin(angle / 2))


@dataclass(frozen=True)
class Best:
    """Best φ of one kind, with the singular values nearest to 1, as text for ``--phi``."""

    kind: str
    phi: str
    worst: float


def best(angle: float, degrees: Sequence[int] = (3, 5)) -> Iterator[Best]:
    """Yield the best φ up to an angle A among tangents, sines, and odd polynomials with φ′(0) = 1.

    Among tangents ``2n tan(α/2n)`` the limit α is best: the worst stretch is at least ``φ(A)/(2 sin(A/2))``, and
    tangents have ``φ(A) > A``. Among sines ``c sin(α/c)`` this quotient falls and ``1/φ′(A)`` grows as c decreases.
    The best c makes both equal: c = 4 for every A. Lambert's chart has singular values ``1/cos(α/4)``, ``cos(α/4)``.
    """
    yield Best("2n tan(α/2n), n without bound", "alpha", _worst(lambda at: (at, np.ones_like(at)), angle))
    c = _rounded(_golden(lambda c: _worst(partial(_sine, c), angle), 2 / math.pi * angle, 2 * angle + 8))
    yield Best("c sin(α/c)", f"{_decimal(c)}*sin(alpha/{_decimal(c)})", _worst(partial(_sine, float(c)), angle))
    for degree in degrees:
        coefficients = [_rounded(c) for c in _polynomial(angle, (degree - 1) // 2)]
        text = "alpha" + "".join(
            f" {'-' if c < 0 else '+'} {_decimal(abs(c))}*alpha**{2 * k + 3}" for k, c in enumerate(coefficients)
        )
        yield Best(f"odd polynomials of degree {degree}", text, _of_polynomial([float(c) for c in coefficients], angle))


def _rounded(value: float) -> Fraction:
    return Fraction(round(value * DECIMAL_UNITS), DECIMAL_UNITS)


def _decimal(value: Fraction) -> str:
    return str(value if value.denominator == 1 else float(value))


def _worst(sized: Callable[[Angles], tuple[Angles, Angles]], angle: float) -> float:
    """Return the largest of both singular values and their inverses up to an angle; `sized` returns φ and φ′."""
    at = np.linspace(0, angle, POINTS + 1)[1:]
    size, slope = sized(at)
    if not (np.all(size > 0) and np.all(slope > 0)):
        return math.inf
    across = 2 * np.sin(at / 2) / size
    return float(max(1.0, *(found.max() for found in (slope, 1 / slope, across, 1 / across))))


def _sine(c: float, at: Angles) -> tuple[Angles, Angles]:
    return c * np.sin(at / c), np.cos(at / c)


def _of_polynomial(coefficients: Sequence[float], angle: float) -> float:
    def sized(at: Angles) -> tuple[Angles, Angles]:
        all_coefficients = np.array([1.0, *coefficients])
        slopes = all_coefficients * np.arange(1, 2 * len(all_coefficients), 2)
        return at * np.asarray(polyval(at * at, all_coefficients)), np.asarray(polyval(at * at, slopes))

    return _worst(sized, angle)


def _polynomial(angle: float, count: int) -> list[float]:
    """Return coefficients of α³, α⁵, … by nested golden sections: the worst stretch is quasiconvex in each."""

    def rest(first: list[float], left: int) -> list[float]:
        if not left:
            return first
        size = 0.5 / angle ** (2 * len(first) + 2)

        def at(c: float) -> float:
            return _of_polynomial(rest([*first, c], left - 1), angle)

        return rest([*first, _golden(at, -size, size)], left - 1)

    return rest([], count)


def _golden(function: Callable[[float], float], low: float, high: float, steps: int = 40) -> float:
    ratio = (math.sqrt(5) - 1) / 2
    left, right = high - ratio * (high - low), low + ratio * (high - low)
    at_left, at_right = function(left), function(right)
    for _ in range(steps):
        if at_left <= at_right:
            high, right, at_right = right, left, at_left
            left = high - ratio * (high - low)
            at_left = function(left)
        else:
            low, left, at_left = left, right, at_right
            right = low + ratio * (high - low)
            at_right = function(right)
    return (low + high) / 2
