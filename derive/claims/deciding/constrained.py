"""Points moved onto the equations of a stated domain, such as R Rᵀ = I, or to where a number of one sign vanishes.

Both use Newton's method with least steps.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from functools import reduce
from itertools import pairwise
from typing import Any

import flint

from ..language.environment import Env
from ..language.operator_table import RELATIONS, both, difference, negated
from ..language.printed import Term, Trait, rate_depth, symbols, walk
from ..language.values import add, coefficients
from ..numbers.balls import Ball, BlurredError, arb, precision
from ..numbers.kinds import Numbers
from .claim import Claim, kind
from .place import Place
from .terms import STRICT, is_dual

BITS, STEPS_MAX = 512, 40
"""Bits of Newton's method, and its largest number of steps."""
STEP, DAMPING = 200, 100
"""Exponents of 2 of the step of differences, and of the term that makes dependent equations solvable."""
KEPT = 20
"""Exponent of 2 of the differences below which the slopes are kept."""
REACHED, WIDTH = 300, 190
"""Exponents of 2 of the largest difference of both sides in the end, and of the width of the coordinates."""
APPROACH_MAX = 48
"""Largest number of steps towards a zero of a number of one sign."""
Moved = Callable[[Sequence[Any]], Place]
"""Function that returns the point at some coordinates."""


def onto(claim: Claim, place: Place) -> Place | None:
    """Return a nearby point at which the equations of the stated domain hold, or None."""
    real = claim.of_number(reduce(both, claim.constraints))
    sides = (side for part in claim.constraints for side in part.arguments)
    further = not real.flat or bool(claim.depth) or any(map(is_dual, sides))
    evaluated = claim if further else real
    start, moved = _coordinates(claim, place, claim.constraints, further)
    if not start():
        return None  # orders alone, which do not move

    def left(x: Sequence[Any]) -> list[Any]:
        return [arb(c).mid() for c in gaps(evaluated.env(moved(x)), claim.constraints)]

    with precision(BITS):
        try:
            x = _solved(left, start())
        except (ArithmeticError, BlurredError):
            return None
        if x is None:
            return None
        found = moved(_wide(x))
        shown = found.exact or _has_slopes(left, x)
        return found if shown and (not claim.depth or _is_smooth(claim, found)) else None


def is_on(claim: Claim, place: Place) -> bool:
    """Return whether a point and its rates are on a path along which the equations of the stated domain hold."""
    found = all(arb(c).contains(0) for c in gaps(claim.env(place), claim.constraints))
    with precision(BITS):
        return found and _is_smooth(claim, place)


def is_at_edge(claim: Claim, place: Place) -> bool:
    """Return whether sides of an order relation of the domain, or of a negated relation, are equal."""
    env = claim.env(place)
    names = ((part, RELATIONS if part.operator is negated else STRICT.keys()) for part in claim.domain)
    gaps = (difference(node) for part, some in names for node in walk(part) if node.operator.name in some)
    with suppress(ArithmeticError, TypeError):
        return any(all(arb(c).contains(0) for c in coefficients(env.now(env.value(gap)))) for gap in gaps)
    return False


def _has_slopes(left: Any, x: list[Any]) -> bool:
    """Return whether each difference has a slope at a point, so that small differences show a zero beside it."""
    rows = _slopes(left, x, left([Ball(c) for c in x]))
    return all(any(abs(slope) > flint.arb(2) ** -KEPT for slope in column) for column in zip(*rows, strict=True))


def _is_smooth(claim: Claim, place: Place) -> bool:
    """Return whether as many differences of equations without rates change independently at a point as beside it.

    Then each rate that the equations allow is that of a path. At the only solution of ``x**2 == 0`` none changes.
    """
    still = [part for part in claim.constraints if not rate_depth(part)]
    if not still:
        return True
    start, moved = _coordinates(claim, place, still, further=False)
    x, real = start(), claim.of_number(reduce(both, still))

    def left(x: Sequence[Any]) -> list[Any]:
        return [arb(c).mid() for c in gaps(real.env(moved(x)), still)]

    beside = [c + flint.arb(i + 2).sqrt().mid() / 64 for i, c in enumerate(x)]
    here, there = (_rank(_slopes(left, at, left([Ball(c) for c in at]))) for at in (x, beside))
    return here >= there


def _rank(rows: list[list[Any]]) -> int:
    """Return the rank of a matrix, by elimination with the largest entries."""
    rank, rows = 0, [list(row) for row in rows]
    while rows:
        size, i, k = max((abs(c), i, k) for i, row in enumerate(rows) for k, c in enumerate(row))
        if not size > flint.arb(2) ** -KEPT:
            break
        pivot, rank = rows.pop(i), rank + 1
        rows = [[(c - row[k] / pivot[k] * p).mid() for c, p in zip(row, pivot, strict=True)] for row in rows]
    return rank


def touching(claim: Claim, place: Place, part: Term, size: Callable[[Any], Any]) -> Place | None:
    """Return a nearby point where a number that does not change its sign vanishes, as the square of a length does.

    Such zeros lie on no line through another point. Steps of twice the tangent's length approach them; then Newton's
    method finds the zero of the gradient. Where the number changes its sign on the way, return the point beyond.
    """
    start, moved = _coordinates(claim, place, (part, *claim.constraints), further=False)

    def value(x: Sequence[Any]) -> Any:
        env = claim.env(moved(x))
        squares = [arb(c) ** 2 for c in gaps(env, claim.constraints)]
        return sum(squares, arb(size(env.value(part)))).mid()

    def gradient(x: Sequence[Any]) -> list[Any]:
        step = Ball(flint.arb(2) ** -STEP)
        beside = [[[*x[:i], c + h, *x[i + 1 :]] for h in (step, -step)] for i, c in enumerate(x)]
        return [((value(after) - value(before)) / (2 * step.arb)).mid() for after, before in beside]

    with precision(BITS):
        try:
            x, beyond = _approached(value, gradient, start())
            if x is not None and beyond:
                return moved(_wide(x))
            x = None if x is None else _solved(gradient, x, KEPT)
            if x is None or not abs(value([Ball(c) for c in x])) < flint.arb(2) ** -REACHED:
                return None
        except (ArithmeticError, BlurredError, TypeError, AttributeError):
            return None
        return moved(_wide(x))


def _approached(value: Any, gradient: Any, x: list[Any]) -> tuple[list[Any] | None, bool]:
    """Return a point near a zero of a number of one sign, or beyond its zeros; None where it stays away from 0."""
    first = last = value([Ball(c) for c in x])
    for i in range(APPROACH_MAX):
        slopes = gradient([Ball(c) for c in x])
        square = sum(c * c for c in slopes)
        if not square > 0:
            return None, False
        x = [(c - 2 * last * g / square).mid() for c, g in zip(x, slopes, strict=True)]
        last = value([Ball(c) for c in x])
        if first * last < 0:
            return x, True
        if not first * last > 0 or (i % 8 == 7 and not abs(last) < abs(first) / 2 ** (i // 8 + 1)):
            return (x if abs(last) < flint.arb(2) ** -KEPT else None), False
        if abs(last) < flint.arb(2) ** (-2 * KEPT):
            break
    return x, False


def _coordinates(
    claim: Claim, place: Place, parts: Sequence[Term], further: bool = True
) -> tuple[Callable[[], list[Any]], Moved]:
    """Return the coordinates of the letters in some parts, and the function that moves the point to other ones."""
    used = {a for part in parts for a in symbols(part)}
    letters = [a for a in claim.coordinates if a in used and (further or kind(a).spread != "integer")]
    start = [[*place.at[a], *(claim.further(a, place) if further else ())] for a in letters]
    sizes = [len(place.at[a]) for a in letters]

    def moved(x: Sequence[Any]) -> Place:
        at, parts, numbers = dict(place.at), {}, iter(x)
        for letter, size, row in zip(letters, sizes, start, strict=True):
            values: Numbers = [next(numbers) for _ in row]
            at[letter] = values[:size]
            if further:
                parts[letter] = values[size:]
        return replace(place, at=at, parts=parts, on="", zero=None, known={})

    return lambda: [arb(c).mid() for row in start for c in row], moved


def _wide(x: Sequence[Any]) -> list[Any]:
    """Return coordinates as balls, those near a quarter of an integer as this number."""
    width, found = flint.arb(2) ** -WIDTH, []
    for c in x:
        near = Fraction(round(float(c) * 4), 4)
        found.append(near if abs(c - arb(near)) < width else Ball(flint.arb(c, width)))
    return found


def gaps(env: Env, constraints: Sequence[Term]) -> list[Any]:
    """Return the differences of both sides of equations, with their dual parts and rates; magnitudes are squared."""
    pairs = [pair for part in constraints for pair in pairwise(part.arguments)]
    squared = [any(Trait.LENGTH in side.operator.traits for side in pair) for pair in pairs]
    sides = [[env.value(a**2 if square else a) for a in pair] for pair, square in zip(pairs, squared, strict=True)]
    found = [a if isinstance(b, int) and not b else add(a, -b) for a, b in sides]
    return [c for gap in found for c in coefficients(gap)]


def _solved(left: Any, x: list[Any], damping: int = DAMPING) -> list[Any] | None:
    """Return a zero of the differences near x, by steps of least length.

    The larger term of `damping` keeps a gradient's steps from directions in which the number is nearly constant.
    """
    matrix, two = flint.arb_mat, flint.arb(2)
    transposed = inverse = None
    for _ in range(STEPS_MAX):
        now = left([Ball(c) for c in x])
        if all(abs(g) < two**-REACHED for g in now):
            return x
        if inverse is None or any(abs(g) > two**-KEPT for g in now):  # nearer, the slopes serve further steps
            transposed = matrix(_slopes(left, x, now))
            damped = matrix([[two**-damping if i == k else 0 for k in range(len(now))] for i in range(len(now))])
            inverse = (transposed.transpose() * transposed + damped).inv()
        change = transposed * (inverse * matrix([[g] for g in now]))
        x = [(c - change[i, 0]).mid() for i, c in enumerate(x)]
    return None


def _slopes(left: Any, x: list[Any], now: list[Any]) -> list[list[Any]]:
    step, rows = flint.arb(2) ** -STEP, []
    for i in range(len(x)):
        beside = left([Ball(c + step if i == k else c) for k, c in enumerate(x)])
        rows.append([((b - a) / step).mid() for a, b in zip(now, beside, strict=True)])
    return rows
