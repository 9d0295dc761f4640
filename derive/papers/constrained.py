"""Points moved onto the equations of a stated domain, such as R Rᵀ = I, by Newton's method with least steps."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

from .claim import Claim, Place
from .language.environment import Env
from .language.printed import Term, Trait, symbols
from .language.values import add, coefficients, negative
from .numbers.balls import Ball, BlurredError, arb, flint, precision
from .numbers.kinds import Numbers

BITS, STEPS_MAX = 512, 40
"""Bits of Newton's method, and its largest number of steps."""
STEP, DAMPING = 200, 100
"""Exponents of 2 of the step of differences, and of the term that makes dependent equations solvable."""
KEPT = 20
"""Exponent of 2 of the differences below which the slopes are kept."""
REACHED, WIDTH = 300, 200
"""Exponents of 2 of the largest difference of both sides in the end, and of the width of the coordinates."""


def onto(claim: Claim, place: Place) -> Place | None:
    """Return a nearby point at which the equations of the stated domain hold, or None."""
    used = {a for part in claim.constraints for a in symbols(part)}
    letters = [a for a in claim.coordinates if a in used]
    start = [[*place.at[a], *claim.further(a, place)] for a in letters]
    sizes = [len(place.at[a]) for a in letters]

    def moved(x: Sequence[Any]) -> Place:
        at, parts, numbers = dict(place.at), {}, iter(x)
        for letter, size, row in zip(letters, sizes, start, strict=True):
            values: Numbers = [next(numbers) for _ in row]
            at[letter], parts[letter] = values[:size], values[size:]
        return replace(place, at=at, parts=parts)

    def left(x: Sequence[Any]) -> list[Any]:
        return [arb(c).mid() for c in gaps(claim.env(moved(x)), claim.constraints)]

    with precision(BITS):
        try:
            x = _solved(left, [arb(c).mid() for row in start for c in row])
        except (ArithmeticError, BlurredError):
            return None
        width = flint().arb(2) ** -WIDTH
        return None if x is None else moved([Ball(flint().arb(c, width)) for c in x])


def gaps(env: Env, constraints: Sequence[Term]) -> list[Any]:
    """Return the differences of both sides of equations, with their dual parts and rates; magnitudes are squared."""
    pairs = [pair for part in constraints for pair in pairwise(part.arguments)]
    squared = [any(Trait.LENGTH in side.operator.traits for side in pair) for pair in pairs]
    sides = [[env.value(a**2 if square else a) for a in pair] for pair, square in zip(pairs, squared, strict=True)]
    found = [a if isinstance(b, int) and not b else add(a, negative(b)) for a, b in sides]
    return [c for gap in found for c in coefficients(gap)]


def _solved(left: Any, x: list[Any]) -> list[Any] | None:
    """Return a zero of the differences near x, by steps of least length."""
    matrix, two = flint().arb_mat, flint().arb(2)
    transposed = inverse = None
    for _ in range(STEPS_MAX):
        now = left([Ball(c) for c in x])
        if all(abs(g) < two**-REACHED for g in now):
            return x
        if inverse is None or any(abs(g) > two**-KEPT for g in now):  # nearer, the slopes serve further steps
            transposed = matrix(_slopes(left, x, now))
            damping = matrix([[two**-DAMPING if i == k else 0 for k in range(len(now))] for i in range(len(now))])
            inverse = (transposed.transpose() * transposed + damping).inv()
        change = transposed * (inverse * matrix([[g] for g in now]))
        x = [(c - change[i, 0]).mid() for i, c in enumerate(x)]
    return None


def _slopes(left: Any, x: list[Any], now: list[Any]) -> list[list[Any]]:
    """Return the derivatives of all differences by each coordinate."""
    step, rows = flint().arb(2) ** -STEP, []
    for i in range(len(x)):
        beside = left([Ball(c + step if i == k else c) for k, c in enumerate(x)])
        rows.append([((b - a) / step).mid() for a, b in zip(now, beside, strict=True)])
    return rows

