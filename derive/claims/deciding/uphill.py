"""Points of a bounded domain at which an order relation is most likely to fail: corners, and the way uphill from one.

Each stated bound gives ends of a number, or vectors of the largest length along the axes. From the best point, steps
along the gradient are brought back into the bounds.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from fractions import Fraction
from itertools import islice, product
from typing import Any

from ..language.operator_table import difference
from ..language.printed import Symbol, Term
from ..numbers.balls import BlurredError, arb
from ..numbers.fields import innermost
from ..numbers.kinds import Numbers
from .claim import Claim, kind
from .place import Place
from .polar import bounds
from .terms import STRICT

CORNERS_MAX = 512
"""Largest number of corners."""
STEPS, WIDTH = 24, 1e-4
"""Number of steps uphill, and the width of differences."""
INSIDE = Fraction(10**9 - 1, 10**9)
"""Factor that brings rounded numbers within their bound."""
AXES = ((1, 0, 0), (0, 1, 0), (0, 0, 1), (Fraction(2, 3), Fraction(1, 3), Fraction(2, 3)))


class Uphill:
    """Source of points at the bounds of a domain, for a claim that is an order relation."""

    def __init__(self, claim: Claim) -> None:
        domain = claim.domain
        found = bounds(domain)
        self.claim = claim
        bounded = [a for a in claim.coordinates if a.name in found and kind(a).spread != "integer"]
        self.ends = {a: _ends(found[a.name]) for a in bounded}

    def places(self, at: dict[Symbol, Any]) -> Iterator[Place]:
        """Yield the corners, then the points on the way uphill; other letters stay as they are."""
        relation = self.claim.statement
        if not self.ends or relation.operator.name not in STRICT:
            return
        gap = difference(relation) if relation.operator.name in ("less", "at most") else -difference(relation)
        best: tuple[float, Place] | None = None
        choices = [_corners(kind(a).size, ends) for a, ends in self.ends.items()]
        for i, corner in enumerate(islice(product(*choices), CORNERS_MAX)):
            place = Place(f"corner {i + 1}", at | dict(zip(self.ends, corner, strict=True)))
            yield place
            height = self._height(gap, place)
            if height is not None and (best is None or height > best[0]):
                best = height, place
        if best is not None:
            yield from self._climbed(gap, best[1])

    def _height(self, gap: Term, place: Place) -> float | None:
        """Return by how much the relation fails at a point."""
        with suppress(BlurredError, ArithmeticError, TypeError, AttributeError):
            value = self.claim.evaluated(place, gap, lambda a: float(arb(innermost(a)).mid()))
            return None if value is None else float(value)
        return None

    def _climbed(self, gap: Term, place: Place) -> Iterator[Place]:
        step = 0.5
        for i in range(STEPS):
            here = self._height(gap, place)
            slopes = {a: self._slopes(gap, place, a, here) for a in self.ends}
            length = max((abs(s) for row in slopes.values() for s in row), default=0)
            if here is None or not length:
                return
            moved = {a: self._within(a, [float(c) + step * self._size(a) * s / length
                                         for c, s in zip(place.at[a], row, strict=True)])
                     for a, row in slopes.items()}  # fmt: skip
            other = Place(f"uphill {i + 1}", {**place.at, **moved})
            height = self._height(gap, other)
            if height is not None and height > here:
                place = other
                yield place
            else:
                step /= 3

    def _slopes(self, gap: Term, place: Place, letter: Symbol, here: float | None) -> list[float]:
        found = []
        for i, c in enumerate(place.at[letter]):
            row = [*place.at[letter]]
            row[i] = Fraction(c) + Fraction(WIDTH)
            height = self._height(gap, Place("", {**place.at, letter: row}))
            found.append(0.0 if height is None or here is None else (height - here) / WIDTH)
        return found

    def _size(self, letter: Symbol) -> float:
        low, high = self.ends[letter]
        return float(high) if kind(letter).size > 1 else float(high - low)

    def _within(self, letter: Symbol, numbers: Sequence[float]) -> Numbers:
        low, high = self.ends[letter]
        if kind(letter).size == 1:
            return [min(max(Fraction(f"{numbers[0]:.6g}"), low), high)]
        size = sum(c * c for c in numbers) ** 0.5
        scale = min(1.0, float(high) / size) if size else 1.0
        return [Fraction(f"{c * scale:.9g}") * (INSIDE if scale < 1 else 1) for c in numbers]


def _ends(interval: tuple[Any, Any]) -> tuple[Fraction, Fraction]:
    """Return rational ends of an interval, a large number in place of infinity."""
    found = []
    for end, sign in zip(interval, (-1, 1), strict=True):
        number = Fraction(str(end.evalf(30))) if end.is_finite else Fraction(100 * sign)
        found.append(number if end.is_Rational else number * (1 - Fraction(sign * (1 if number > 0 else -1), 10**20)))
    return found[0], found[1]


def _corners(size: int, ends: tuple[Fraction, Fraction]) -> list[Numbers]:
    """Return the ends and the middle of a number, or vectors of the largest length along axes."""
    low, high = ends
    if size == 1:
        return [[high], [low], [(low + high) / 2]]
    return [[sign * high * c for c in (*axis, *[0] * (size - 3))] for axis in AXES for sign in (1, -1)]
