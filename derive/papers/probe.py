"""Points at which a claim may fail: wide values, special values, equal letters, and zero sets of its singular parts.

A singular part is a divisor, a matrix to invert, a radicand, the argument of a logarithm or of an inverse function, or
the difference of both sides of an inequality. Its zeros are found along each letter, and tried on and beside.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from itertools import combinations, islice, pairwise
from math import pi
from typing import Any

from ..algebra import Quaternion, Structure, Tensor, Vector, matrix
from .claim import Claim, Place, kind, operators
from .constrained import onto, touching
from .language.operator_table import cos, norm, sin
from .language.printed import Number, Symbol, Term, symbols, walk
from .language.written import written
from .numbers.balls import Ball, BlurredError, arb, flint, precision
from .numbers.fields import innermost
from .numbers.kinds import Numbers, special
from .numbers.quantities import ORDER, SIGN

SHORT = tuple(map(Fraction, (1, 2, -1, 3, -2)))
"""Numbers of the first points, so that counterexamples are short."""
REGIMES = ((5, 0.1, 1.0), (5, 0.5, 2.0), (5, 2.0, 12.0), (2, 1e-6, 1e-3), (2, 30.0, 1e3))
"""Number of wide points with coordinates of each size; further points mix the sizes."""
ORDERS = (1, 1, 2, 2, 3, 4, 5, 9, 25)
"""Orders at which claims are evaluated, small ones more often."""
FAR = tuple(map(Fraction, (30, 100, 1000, 10**4, 10**6, 10**12, 10**24)))
"""Values beyond the grid on which zeros are searched."""
ORDERED = frozenset(("less", "at most", "greater", "at least", "unlike"))
BOUND = 1000
"""Size of integers and orders at which inequalities are tried."""
INTEGERS_MAX = 64
"""Size of the integers and orders at which zeros are sought."""
PAIRS_MAX = 24
"""Number of points with two special letters."""
ROOTS_MAX = 4
"""Number of zeros of one singular part along one line that are tried."""
PROJECTIONS_MAX = 40
"""Number of points that are moved onto the equations of the stated domain."""
FEW = 24
"""Number of points in the stated domain below which more are drawn near them."""
NEAR = Fraction(1, 1000)
"""Distance of a point beside a zero, relative to the zero."""
FINE, WIDTH = 512, 160
"""Bits of the search for zeros, and bits of a zero's position."""


@dataclass(frozen=True)
class Singular:
    """Part of a formula that is singular where a number vanishes; `size` gives the number from the part's value."""

    part: Term
    size: Callable[[Any], Any]

    def number(self, claim: Claim, place: Place) -> Any:
        """Return the number at a point as Arb's ball."""
        return arb(self.size(claim.env(place).value(self.part)))


def size(value: Any) -> Any:
    """Return the number that vanishes where a value has no inverse."""
    if isinstance(value, Quaternion):
        return innermost(value.norm2())
    if isinstance(value, Vector):
        return innermost(value.dot(value))
    if isinstance(value, Tensor):
        return innermost(value.det())
    if isinstance(value, Structure):
        rows, columns = matrix.shape(value)
        return innermost(matrix.det(value) if rows == columns else sum(c * c for c in value))
    return innermost(value)


def singular(*statements: Term) -> Iterator[Singular]:
    """Yield the singular parts of statements that contain letters."""
    found: dict[Term, Singular] = {}
    for node in (node for statement in statements for node in walk(statement)):
        name, arguments = node.operator.name, node.arguments
        if name in ("over", "power"):
            exponent = arguments[1]
            if name == "over" or not (isinstance(exponent, Number) and exponent.value >= 0):
                part = _bare(arguments[1 if name == "over" else 0])
                found[part] = Singular(part, size)
        elif name in ("inverse", "root", "log", "norm", "atan2 of two", "K10 length"):
            found[arguments[0]] = Singular(arguments[0], _half_turn if name == "log" else size)
        elif name in ("acos", "asin"):
            found[node] = Singular(arguments[0], lambda a: 1 - innermost(a) * innermost(a))
        elif name in ("tan", "cot"):
            part = (cos if name == "tan" else sin)(*arguments)
            found[part] = Singular(part, size)
        elif name in ORDERED or (name == "equal" and node not in statements):
            part = _bare(arguments[0] if arguments[1] == Number(0) else arguments[0] - arguments[1])
            found[part] = Singular(part, size)
    bound = "index"
    for one in found.values():
        letters = symbols(one.part)
        if letters and not any(a.quantity.name == bound for a in letters):
            yield one


def _bare(part: Term) -> Term:
    """Return the part below signs, brackets, powers and magnitudes, which vanishes at the same points."""
    name, arguments = part.operator.name, part.arguments
    power = name == "power" and isinstance(arguments[1], Number) and arguments[1].value > 0
    return _bare(arguments[0]) if power or name in ("negative", "bracket", "norm", "root") else part


def _half_turn(value: Any) -> Any:
    """Return the number that vanishes where the logarithm of a value is singular."""
    if isinstance(value, Tensor):
        return innermost(value.trace()) + 1
    if isinstance(value, matrix.Matrix):
        return innermost(sum(value.rows[i][i] for i in range(4)))
    return size(value)


class Probe:
    """Source of the points of a claim, determined by the number of its entry."""

    def __init__(self, claim: Claim) -> None:
        self.claim, self.random = claim, random.Random(f"probe {claim.entry.number}")
        self.roots: dict[tuple[Term, Symbol], list[float]] = {}  # zeros of singular parts along the first line
        self._projections = 0

    # ---- coordinates ----------------------------------------------------------------------------------------------

    def _number(self, spread: str, low: float, high: float) -> Fraction:
        exponent = self.random.uniform(0, 1)
        value = Fraction(f"{low * (high / low) ** exponent:.3g}")
        if spread == "integer":
            return Fraction(self.random.randint(-9, 9) if high < 30 else self.random.randint(-900, 900))
        return value if spread == "positive" else value * self.random.choice((-1, 1))

    def _drawn(self, letter: Symbol, low: float, high: float) -> Numbers:
        row = kind(letter)
        free = [self._number(row.spread, low, high) for _ in range(row.size)]
        return [Fraction(1), *free[1:]] if row.projective and self.random.random() < 0.8 else free

    def _discrete(self) -> dict[Symbol, Any]:
        return {a: self.random.choice(ORDERS if a.quantity is ORDER else (-1, 1))
                for a in self.claim.letters if a.quantity in (ORDER, SIGN)}  # fmt: skip

    def drawn(self, low: float = 0.3, high: float = 2.0) -> dict[Symbol, Any]:
        """Return coordinates of all letters, of a size between two bounds."""
        return {**self._discrete(), **{a: self._drawn(a, low, high) for a in self.claim.coordinates}}

    # ---- points ---------------------------------------------------------------------------------------------------

    def quick(self) -> Iterator[Place]:
        """Yield the first points in the stated domain: short numbers, then generic ones."""
        return self._moved(self._quick())

    def all(self) -> Iterator[Place]:
        """Yield all points in the stated domain; quick refutations come first."""
        return self._moved(self._all())

    def _moved(self, places: Iterator[Place]) -> Iterator[Place]:
        """Yield the points that lie in the stated domain, moved onto its equations; more near them if they are few."""
        found = []
        for place in self._inside(places):
            found.append(place)
            yield place
        if self.claim.entry.claimed is not None and len(found) < FEW:
            yield from self._inside(map(self._near, found * (FEW // max(len(found), 1))))

    def _near(self, place: Place) -> Place:
        """Return a point whose coordinates differ by up to a half."""
        moved = [a for a in self.claim.coordinates if kind(a).spread != "integer"]
        at = {**place.at, **{a: [c * Fraction(self.random.randint(50, 150), 100) for c in place.at[a]] for a in moved}}
        return replace(place, label=f"near {place.label}", at=at, generic=True, on="")

    def _inside(self, places: Iterable[Place]) -> Iterator[Place]:
        for place in places:
            try:
                if self.claim.inside(place) and not (self.claim.constraints and self.claim.depth):
                    yield place
                elif self.claim.constraints:
                    yield from islice(filter(self.claim.inside, self._projected(place)), 1)
            except BlurredError:
                continue

    def _projected(self, place: Place) -> Iterator[Place]:
        """Yield the points on the equations of the domain near a point and near the opposite one."""
        opposite = {a: kind(a).antipode(c) if a in self.claim.coordinates else c for a, c in place.at.items()}
        for start in (place, replace(place, at=opposite)):
            if self._projections < PROJECTIONS_MAX and (moved := onto(self.claim, start)):
                self._projections += 1
                yield moved

    def _quick(self) -> Iterator[Place]:
        for i in range(3):
            at: dict[Symbol, Any] = self._discrete()
            for place, letter in enumerate(self.claim.coordinates):
                row = kind(letter)
                free = [SHORT[(i + place) % len(SHORT)], *self.random.choices(SHORT, k=row.size - 1)]
                free = [abs(c) if row.spread == "positive" else c for c in free]
                at[letter] = [Fraction(1), *free[1:]] if row.projective else free
            yield Place(f"short numbers {i + 1}", at, generic=True)
        for count, low, high in REGIMES[:3]:
            for i in range(count):
                yield Place(f"generic point {i + 1}, {low} to {high}", self.drawn(low, high), generic=True)

    def _all(self) -> Iterator[Place]:
        yield from self._quick()
        for count, low, high in REGIMES[3:]:
            for i in range(count):
                yield Place(f"wide point {i + 1}, {low} to {high}", self.drawn(low, high))
        for i in range(6):
            at = {a: self._drawn(a, *self.random.choice(REGIMES)[1:]) for a in self.claim.coordinates}
            yield Place(f"wide point {i + 1}, mixed", {**self._discrete(), **at})
        letters = self.claim.coordinates
        if not ORDERED.isdisjoint(operators(self.claim.statement)):
            for n in (BOUND, -BOUND):
                at = self.drawn()
                at |= {a: [Fraction(n)] for a in letters if kind(a).spread == "integer"}
                at |= {a: abs(n) for a in self.claim.letters if a.quantity is ORDER}
                yield Place(f"integers of size {BOUND}", at)
        found = [(a, label, c) for a in letters for label, c in special(kind(a)).items()]
        for letter, label, c in found:
            yield Place(f"{letter.name}: {label}", {**self.drawn(), letter: c})
        origin = {a: special(kind(a))["0"] for a in letters if "0" in special(kind(a))}
        if len(origin) > 1:
            yield Place(f"{', '.join(a.name for a in origin)} = 0", {**self.drawn(), **origin})
        yield from self._related()
        yield from self._zeros()
        pairs = [(one, two) for one, two in combinations(found, 2) if one[0] != two[0]]
        for (a, label, c), (b, other, d) in self.random.sample(pairs, min(PAIRS_MAX, len(pairs))):
            yield Place(f"{a.name}: {label}, {b.name}: {other}", {**self.drawn(), a: c, b: d})

    def _related(self) -> Iterator[Place]:
        """Yield points where two letters of like kinds are equal, opposite or parallel."""
        for a, b in combinations(self.claim.coordinates, 2):
            at = self.drawn()
            if kind(a).build is kind(b).build:
                yield Place(f"{b.name} = {a.name}", {**at, b: at[a]})
                if kind(b).spread != "positive":
                    yield Place(f"{b.name} opposite to {a.name}", {**at, b: kind(b).antipode(at[a])})
            for one, other in ((a, b), (b, a)):
                if kind(one).size == kind(other).size == 3 and not kind(one).projective:
                    along = kind(other).build(at[other])
                    yield Place(f"{one.name} along {other.name}", {**at, one: [2 * c for c in along]})
                    across = along.cross(Vector(*at[one]))
                    yield Place(f"{one.name} across {other.name}", {**at, one: list(across)})

    def _zeros(self) -> Iterator[Place]:
        for part in singular(*self.claim.parts):
            letters = [a for a in self.claim.letters if a in symbols(part.part)]
            for letter in letters:
                if letter in self.claim.coordinates:
                    for line in self.lines(letter):
                        roots, places = line.places(part)
                        self.roots.setdefault((part.part, letter), roots)
                        yield from places
                if letter.quantity is ORDER or (letter in self.claim.coordinates and kind(letter).spread == "integer"):
                    yield from self._at_integers(part, letter)
            free = sum(kind(a).size for a in letters if a in self.claim.coordinates and kind(a).spread != "integer")
            if free > 1 and not any(self.roots.get((part.part, a)) for a in letters):
                yield from self._touching(part)

    def _at_integers(self, part: Singular, letter: Symbol) -> Iterator[Place]:
        """Yield the points at whose integer a singular part vanishes or has another sign than before."""
        order, at, before = letter.quantity is ORDER, self.drawn(), None
        for n in range(1 if order else -INTEGERS_MAX, INTEGERS_MAX + 1):
            label = f"{letter.name} = {n}"
            value: Any = n if order else [Fraction(n)]
            place = Place(label, {**at, letter: value}, on=label)
            try:
                now = part.number(self.claim, place)
            except (ArithmeticError, BlurredError, TypeError, AttributeError, ValueError):
                continue
            if now.contains(0) or (before is not None and now * before < 0):
                yield place
            before = now

    def _touching(self, part: Singular) -> Iterator[Place]:
        """Yield points where a part vanishes without change of sign, such as a length whose vector is 0."""
        claim = Claim(self.claim.entry, part.part)
        for low, high in ((0.5, 1.5), (1, 5)):
            place = touching(claim, Place("", self.drawn(low, high)), part.part, part.size)
            if place is not None:
                zero = f"{written(self.claim.entry.contracted(part.part))} = 0"
                yield replace(place, label=zero, on=zero)
                return

    def roots_along(self, part: Term, letter: Symbol) -> tuple[str, list[float]] | None:
        """Return the name of a letter's value and the values at which a part vanishes, if they are those of a line."""
        line = next(self.lines(letter), None)
        known = self.roots.get((part, letter))
        if line is None or not (line.radial or kind(letter).size == 1):
            return None
        found = line.roots(Singular(part, size))
        if known is not None and (len(known) != len(found) or any(abs(a - b) > 1e-9 for a, b in zip(known, found))):
            return None
        return line.shown, found

    def lines(self, letter: Symbol) -> Iterator[Line]:
        """Yield lines of points: multiples of a vector, and a line through another point."""
        row, at = kind(letter), self.drawn(0.5, 1.5)
        if row.spread == "integer":
            return
        start = [Fraction(self.random.choice((-1, 1)) * self.random.randint(2, 9), 5) for _ in range(row.size)]
        head, tail = ([0] * row.size, start) if row.size == 1 else (start, [*start[1:], start[0]])
        if row.size in (3, 6) and not row.projective:
            yield Line(self.claim, at, letter, [Fraction(0)] * row.size, start, row.size == 3)
        yield Line(self.claim, at, letter, head, [Fraction(1)] if row.size == 1 else tail)


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
        """Whether t is not negative."""
        return self.radial or kind(self.letter).spread == "positive"

    @property
    def shown(self) -> str:
        """Name of t, for labels."""
        if self.radial:
            return written(norm(self.letter))
        return self.letter.name if kind(self.letter).size == 1 else f"t along {self.letter.name}"

    def point(self, t: Any) -> dict[Symbol, Any]:
        """Return the coordinates at t."""
        scale: Any = t
        if self.radial:
            scale = t / Ball(arb(sum(d * d for d in self.direction)).sqrt())
        return {**self.at, self.letter: [s + scale * d for s, d in zip(self.start, self.direction, strict=True)]}

    def roots(self, part: Singular) -> list[float]:
        """Return the zeros of a singular part along the line, those near 0 first."""
        with precision(FINE):
            return [float(t) for t in self._roots(part)]

    def _roots(self, part: Singular) -> list[Any]:
        claim = Claim(replace(self.claim.entry, claimed=None), part.part)  # other letters need no values
        grid = [*(Fraction(k, 2) for k in range(1, 40)), *FAR]
        grid = [1 / FAR[-1] if kind(self.letter).spread == "positive" else Fraction(0), *grid]
        if not self.one_sided:
            grid = [*(-t for t in reversed(grid[1:])), *grid]

        def value(t: Any) -> Any:
            """Return the middle of the number that vanishes on the singular set, or None."""
            try:
                return part.number(claim, Place("", self.point(t))).mid()
            except (ArithmeticError, BlurredError, TypeError, AttributeError):
                return None

        seen = [(t, value(t)) for t in grid]
        found = [(t, partial(arb, t)) for t, f in seen if f is not None and f.contains(0)]
        for (t, f), (u, g) in pairwise(seen):
            if f is not None and g is not None and f * g < 0:
                found.append((t, partial(_zero, value, arb(t), arb(u), f, g)))
        for (t, f), (_, g), (u, h) in zip(seen, seen[1:], seen[2:], strict=False):
            if None not in (f, g, h) and f * h > 0 and f * g > 0 and 2 * abs(g) < abs(f) + abs(h) and g * g <= f * h:
                found.append((t, partial(_least, value, arb(t), arb(u))))
        zeros: list[Any] = []
        for _, refined in sorted(found, key=lambda row: abs(row[0])):
            t = refined()
            f = None if t is None else value(Ball(t))
            if f is not None and abs(f) < flint().arb(2) ** -WIDTH:
                zeros.append(t)
                if len(zeros) == ROOTS_MAX:
                    break
        return sorted(zeros, key=lambda t: (abs(float(t)), float(t)))

    def places(self, part: Singular) -> tuple[list[float], list[Place]]:
        """Return the zeros of a singular part, and the points on them, beside them and between them."""
        with precision(FINE):
            roots, found = self._roots(part), []
            for t in roots:
                place, near = f"{self.shown} = {named(float(t))}", NEAR * (1 + abs(Ball(t)))
                exact = (t * 4).is_integer()
                on = Ball(t if exact else flint().arb(t, flint().arb(2) ** -WIDTH))
                found.append(Place(place, self.point(on), on=place))
                narrow = [near, near * NEAR] if self.claim.entry.claimed is not None else [near]
                beside = [b for d in narrow for b in (Ball(t) - d, Ball(t) + d) if not (self.one_sided and b < 0)]
                found += [Place(f"beside {place}", self.point(b)) for b in beside]
            for t, u in pairwise(sorted(roots, key=float)):
                found.append(Place(f"{self.shown} between zeros", self.point((Ball(t) + Ball(u)) / 2)))
        return list(map(float, roots)), found


def _zero(f: Callable[[Any], Any], a: Any, b: Any, fa: Any, fb: Any) -> Any:
    """Return the zero between two numbers of unlike sign, by false positions of Illinois."""
    for _ in range(80):
        c = ((a * fb - b * fa) / (fb - fa)).mid()
        fc = f(Ball(c))
        if fc is None or fc.contains(0) or abs(b - a) < flint().arb(2) ** -(FINE // 2):
            return None if fc is None else c
        if (fc < 0) != (fb < 0):
            a, fa = b, fb
        else:
            fa = fa / 2
        if abs(c - b) < flint().arb(2) ** -(FINE // 2):
            return c
        b, fb = c, fc
    return b


def _least(f: Callable[[Any], Any], a: Any, b: Any) -> Any:
    """Return the place between two numbers where the slope vanishes, or None."""
    h = Ball(flint().arb(2) ** -120)

    def slope(t: Any) -> Any:
        after, before = f(t + h), f(t - h)
        return None if after is None or before is None else (after - before) * flint().arb(2) ** 119

    first, last = slope(Ball(a) + NEAR), slope(Ball(b) - NEAR)
    if first is None or last is None or not first * last < 0:
        return None
    return _zero(slope, a + arb(NEAR), b - arb(NEAR), first, last)


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
