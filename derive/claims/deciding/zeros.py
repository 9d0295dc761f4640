"""Zeros of singular parts, sought along lines of points, on segments between points, and among integers."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property, partial
from itertools import combinations, islice, pairwise
from math import pi
from random import Random
from typing import Any

import flint

from ..language.environment import Env
from ..language.operations import written
from ..language.operator_table import Re, norm
from ..language.printed import Symbol
from ..numbers.balls import Ball, BlurredError, arb, precision
from ..numbers.kinds import ORDER, Numbers
from .claim import Claim, kind
from .place import Place
from .singular import ABSENT, Singular, plain_in

FAR = tuple(map(Fraction, (30, 100, 1000, 10**4, 10**6, 10**12, 10**24)))
"""Values beyond the grid on which zeros are searched."""
ROOTS_MAX = 4
"""Number of zeros of one singular part along one line that are tried."""
NEAR = Fraction(1, 1000)
"""Distance of a point beside a zero, relative to the zero."""
ASIDE = Fraction(1, 2**30)
"""Distance from a zero on the grid at which the search for others goes on, relative to the zero."""
BESIDE, SMALL = 2.0**-6, 2.0**-30
"""Distance at which a number is compared with its value at a zero, and the largest ratio of both.

A zero as a float is off by 2^-52, and so the ratio is near 2^-46.
"""
INTEGERS_MAX = 64
"""Size of the integers and orders at which zeros are sought."""
FINE, WIDTH = 512, 160
"""Bits of the search for zeros, and bits of a zero's position."""
Find = Callable[[], list[Any]]


@dataclass(frozen=True)
class Line:
    """Line of points ``start + t direction`` of one letter; a `radial` one has t = magnitude."""

    claim: Claim
    at: dict[Symbol, Any]
    letter: Symbol
    start: Numbers
    direction: Numbers
    radial: bool = False

    @property
    def one_sided(self) -> bool:
        return self.radial or kind(self.letter).spread == "positive"

    @property
    def shown(self) -> str:
        """Name of the line's parameter t in labels: the letter itself, or its magnitude, or t along the letter."""
        part = Re(self.letter) if kind(self.letter).dual else self.letter
        if self.radial or kind(self.letter).size == 1:
            return written(norm(part) if self.radial else part)
        return f"t along {self.letter.name}"

    def point(self, t: Any) -> dict[Symbol, Any]:
        scale: Any = t
        if self.radial:
            scale = t / Ball(arb(sum(d * d for d in self.direction)).sqrt())
        return {**self.at, self.letter: [s + scale * d for s, d in zip(self.start, self.direction, strict=True)]}

    @cached_property
    def _env(self) -> Env:
        return self.claim.env(Place("", self.at))

    def value(self, part: Singular, t: Any) -> Any:
        """Return the middle of the number that vanishes on the singular set, or None."""
        try:
            with suppress(BlurredError, ArithmeticError):
                self._env.value(part.part)  # parts without the letter are known then
            env = self._env.bound(self.letter, self.claim.value(self.letter, Place("", self.point(t))))
            return arb(part.size(env.value(part.part))).mid()
        except ABSENT:
            return None

    def roots(self, part: Singular) -> list[float]:
        """Return the zeros of a singular part along the line, those near 0 first."""
        with precision(FINE):
            return [float(t) for t in self._roots(part)]

    def vanishes_at(self, part: Singular, t: float) -> bool:
        """Return whether a singular part is near 0 at a number, and not beside it."""
        with precision(FINE):
            at, beside = (self.value(part, Ball(flint.arb(s))) for s in (t, t + BESIDE))
        return at is not None and beside is not None and bool(abs(at) < abs(beside) * SMALL)

    def _roots(self, part: Singular, brief: bool = False) -> list[Any]:
        grid = [*(Fraction(k, 2) for k in range(1, 20 if brief else 40)), *(() if brief else FAR)]
        grid = [1 / FAR[-1] if kind(self.letter).spread == "positive" else Fraction(0), *grid]
        if not self.one_sided:
            grid = [*(-t for t in reversed(grid[1:])), *grid]
        value = partial(self.value, part)
        zeros: list[Any] = []
        for _, refined in sorted(_brackets(value, grid, brief), key=lambda row: abs(row[0])):
            for t in refined() if len(zeros) < ROOTS_MAX else ():
                f = None if t is None else value(Ball(t))
                small = f is not None and abs(f) < flint.arb(2) ** -WIDTH
                if small and not any(abs(t - z) < arb(ASIDE) for z in zeros):
                    zeros.append(t)
        return sorted(zeros, key=lambda t: (abs(float(t)), float(t)))

    def places(self, part: Singular, brief: bool = False) -> tuple[list[float], list[Place]]:
        """Return the zeros of a singular part, and the points on them, beside them and between them."""
        with precision(FINE):
            roots, found = self._roots(part, brief), []
            for t in roots:
                place, near = f"{self.shown} = {named(float(t))}", NEAR * (1 + abs(Ball(t)))
                exact = (t * 4).is_integer()
                on = Ball(t if exact else flint.arb(t, flint.arb(2) ** -WIDTH))
                found.append(enclosing(part, self.claim, Place(place, self.point(on), on=place), t, self.point))
                narrow = [near, near * NEAR] if self.claim.entry.claimed is not None else [near]
                beside = [b for d in narrow for b in (Ball(t) - d, Ball(t) + d) if not (self.one_sided and b < 0)]
                found += [Place(f"beside {place}", self.point(b)) for b in beside]
            for t, u in pairwise(sorted(roots, key=float)):
                found.append(Place(f"{self.shown} between zeros", self.point(Ball(((t + u) / 2).mid()))))
        return list(map(float, roots)), found


def lines(claim: Claim, letter: Symbol, at: dict[Symbol, Any], source: Random) -> Iterator[Line]:
    """Yield lines of points of a letter: multiples of a vector, and a line through another point."""
    row = kind(letter)
    if row.spread == "integer":
        return
    start = [Fraction(source.choice((-1, 1)) * source.randint(2, 9), 5) for _ in range(row.size)]
    head, tail = ([0] * row.size, start) if row.size == 1 else (start, [*start[1:], start[0]])
    if row.size in (3, 6) and not row.projective:
        yield Line(claim, at, letter, [Fraction(0)] * row.size, start, row.size == 3)
    yield Line(claim, at, letter, head, [Fraction(1)] if row.size == 1 else tail)


def parallel(claim: Claim, letters: Sequence[Symbol], drawn: Callable[[], dict[Symbol, Any]]) -> Iterator[Line]:
    """Yield the line of multiples of one vector for another: there turns about one axis add up."""
    vectors = [a for a in letters if kind(a).size == 3 and not kind(a).projective]
    for a, b in islice(combinations(vectors, 2), 1):
        at = drawn()
        yield Line(claim, at, b, [Fraction(0)] * 3, at[a])


def _brackets(value: Callable[[Any], Any], grid: Sequence[Any], brief: bool) -> Iterator[tuple[Any, Find]]:
    """Yield the places near which a number vanishes, each with the function that finds the zeros there."""
    seen = []
    for t in grid:
        f = value(t)
        if f is not None and f.contains(0):
            yield t, partial(list, [arb(t)])
            seen += [(u, value(u)) for u in (t - ASIDE * (1 + abs(t)), t + ASIDE * (1 + abs(t)))]
        else:
            seen.append((t, f))
    for (t, f), (u, g) in pairwise(seen):
        if f is not None and g is not None and f * g < 0:
            yield t, partial(lambda *ends: [zero(value, *ends)], arb(t), arb(u), f, g)
    if brief:
        return
    for (t, f), (_, g), (u, h) in zip(seen, seen[1:], seen[2:], strict=False):
        if None not in (f, g, h) and f * h > 0 and f * g > 0 and not abs(g) > abs(f) and not abs(g) > abs(h):
            yield t, partial(_about_least, value, arb(t), arb(u), f, h)


def _about_least(value: Callable[[Any], Any], a: Any, b: Any, fa: Any, fb: Any) -> list[Any]:
    """Return where a number is nearest to 0 between two places, and its zeros on both sides if it crosses 0."""
    least = _least(value, a, b)
    f = None if least is None else value(Ball(least))
    if f is None or not f * fa < 0:
        return [least]
    return [zero(value, a, least, fa, f), zero(value, least, b, f, fb)]


def zero(f: Callable[[Any], Any], a: Any, b: Any, fa: Any, fb: Any) -> Any:
    """Return the zero between two numbers of unlike sign, by false positions of Illinois."""
    for _ in range(80):
        c = ((a * fb - b * fa) / (fb - fa)).mid()
        fc = f(Ball(c))
        if fc is None or fc.contains(0) or abs(b - a) < flint.arb(2) ** -(FINE // 2):
            return None if fc is None else c
        if (fc < 0) != (fb < 0):
            a, fa = b, fb
        else:
            fa = fa / 2
        if abs(c - b) < flint.arb(2) ** -(FINE // 2):
            return c
        b, fb = c, fc
    return b


def _least(f: Callable[[Any], Any], a: Any, b: Any) -> Any:
    """Return the place between two numbers where the slope vanishes, or None."""
    h = Ball(flint.arb(2) ** -120)

    def slope(t: Any) -> Any:
        after, before = f(t + h), f(t - h)
        return None if after is None or before is None else (after - before) * flint.arb(2) ** 119

    first, last = slope(Ball(a) + NEAR), slope(Ball(b) - NEAR)
    if first is None or last is None or not first * last < 0:
        return None
    return zero(slope, a + arb(NEAR), b - arb(NEAR), first, last)


def crossed(claim: Claim, part: Singular, one: Place, other: Place) -> Place | None:
    """Return the place between two places of unlike sign where a number vanishes, on the segment of coordinates."""

    def at(t: Any) -> Place:
        mixed = {a: [(1 - t) * c + t * d for c, d in zip(one.at[a], other.at[a], strict=True)]
                 for a in claim.coordinates if kind(a).spread != "integer"}  # fmt: skip
        return replace(one, at={**one.at, **mixed})

    def value(t: Any) -> Any:
        try:
            return part.number(claim, at(t)).mid()
        except ABSENT:
            return None

    with precision(FINE):
        ends = value(Ball(arb(0))), value(Ball(arb(1)))
        if None in ends or not ends[0] * ends[1] < 0:
            return None
        t = zero(value, arb(0), arb(1), *ends)
        f = None if t is None else value(Ball(t))
        if f is None or not abs(f) < flint.arb(2) ** -WIDTH:
            return None
        return enclosing(part, claim, at(Ball(flint.arb(t, flint.arb(2) ** -WIDTH))), t, lambda t: at(t).at)


def enclosing(part: Singular, claim: Claim, place: Place, t: Any, at: Callable[[Any], Any]) -> Place:
    """Return a place with the part that certainly vanishes there: it has opposite signs at both ends, and no pole."""
    width = flint.arb(2) ** -WIDTH
    try:
        ends = (t - width, flint.arb(t, width), t + width)
        low, on, high = (part.number(claim, replace(place, at=at(Ball(c)))) for c in ends)
    except ABSENT:
        return place
    crosses = (low < 0 and high > 0) or (low > 0 and high < 0)
    return replace(place, zero=part.part) if crosses and on.is_finite() else place


def at_integers(claim: Claim, part: Singular, letter: Symbol, at: dict[Symbol, Any]) -> Iterator[Place]:
    """Yield the points at whose integer a singular part vanishes or has another sign than before, and beside it."""
    order = letter.quantity is ORDER

    def place(n: int) -> Place:
        label, value = f"{letter.name} = {n}", n if order else [Fraction(n)]
        return Place(label, at | {letter: value}, on=label)

    def value(n: int) -> Any:
        try:
            return part.number(claim, place(n))
        except ABSENT:
            return None

    before: tuple[int, Any] | None = None
    far = [s * int(n) for n in FAR for s in (1, -1)] if plain_in(part.part, letter) else []
    for n in sorted({*range(-INTEGERS_MAX, INTEGERS_MAX + 1), *far}):
        now = None if order and n < 1 else value(n)
        if now is None:
            continue
        if now.contains(0):
            yield from (place(m) for m in (n, n - 1, n + 1) if m > 0 or not order)
            continue
        if before is not None and now * before[1] < 0:
            yield from map(place, dict.fromkeys((*_at_zero(value, before[0], n, before[1]), n)))
        before = n, now


def _at_zero(value: Callable[[int], Any], low: int, high: int, at_low: Any) -> tuple[int, ...]:
    """Return the integer between two at which a number vanishes, or the two between which it changes its sign."""
    while high - low > 1:
        middle = (low + high) // 2
        now = value(middle)
        if now is None or now.contains(0):
            return (middle,)
        low, high = (middle, high) if now * at_low > 0 else (low, middle)
    return low, high


def named(t: float) -> str:
    """Return a number in words of claims: a fraction, a multiple of π, or a decimal."""
    for unit, mark in ((1.0, ""), (pi, "pi")):
        part = Fraction(t / unit).limit_denominator(24)
        if abs(float(part) * unit - t) < 1e-13 * (1 + abs(t)):
            above = str(part.numerator)
            if mark and part:
                above = {1: mark, -1: f"-{mark}"}.get(part.numerator, f"{above}*{mark}")
            return above if part.denominator == 1 else f"{above}/{part.denominator}"
    return f"{t:.6g}"
