"""Points at which a claim may fail: wide values, special values, equal letters, and zero sets of its singular parts."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from functools import cached_property, partial
from itertools import chain, combinations, islice, product
from typing import Any

from ...algebra import Vector
from ..language.operations import written
from ..language.printed import Symbol, Term, symbols
from ..language.substitution import written_out
from ..numbers.balls import BlurredError, arb
from ..numbers.kinds import BRANCH, ORDER, SIGN, Numbers, Quantity, special
from .claim import Claim, kind
from .constrained import is_at_edge, is_on, onto, touching
from .equal_sides import equal_places
from .place import Place
from .singular import ABSENT, ORDERED, Singular, is_integer, singular, size
from .terms import bare, operators
from .uphill import Uphill
from .zeros import Line, at_integers, crossed, lines, parallel

SHORT = tuple(map(Fraction, (1, 2, -1, 3, -2)))
"""Numbers of the first points, so that counterexamples are short."""
REGIMES = ((5, 0.1, 1.0), (5, 0.5, 2.0), (5, 2.0, 12.0), (2, 1e-6, 1e-3), (2, 30.0, 1e3))
"""Number of wide points with coordinates of each size; further points mix the sizes."""
ORDERS = (1, 1, 2, 2, 3, 4, 5, 9, 25)
"""Orders at which claims are evaluated, small ones more often."""
BOUND = 1000
"""Size of integers and orders at which inequalities are tried."""
PAIRS_MAX = 24
"""Number of points with two special letters."""
PROJECTIONS_MAX = 40
"""Number of points that are moved onto the equations of the stated domain."""
ATTEMPTS_MAX = 8
"""Number of attempts for each point that is moved there."""
FEW = 24
"""Number of points in the stated domain below which more are drawn near them."""


class Probe:
    """Source of the points of a claim, determined by the number of its entry.

    Zeros are sought of singular parts of `terms`, by default of all parts. Rates keep to the domain, but `at_instants`.
    """

    def __init__(self, claim: Claim, *terms: Term, at_instants: bool = False) -> None:
        self.claim, self.terms, self.at_instants = claim, terms or claim.parts, at_instants
        self.random = random.Random(f"probe {claim.entry.number}")
        self.roots: dict[tuple[Term, Symbol], list[float]] = {}  # zeros of singular parts along the first line
        self._projections = self._attempts = 0  # points moved, and attempts
        self._found: list[Place] = []

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
        n = self.random.choice(self.claim.entry.orders or ORDERS)
        values: dict[Quantity, Sequence[int]]
        values = {ORDER: [n], SIGN: (-1, 1), BRANCH: range(n)}
        return {a: self.random.choice(values[a.quantity]) for a in self.claim.letters if a.quantity in values}

    def drawn(self, low: float = 0.3, high: float = 2.0) -> dict[Symbol, Any]:
        """Return coordinates of all letters, of a size between two bounds."""
        return {**self._discrete(), **{a: self._drawn(a, low, high) for a in self.claim.coordinates}}

    # ---- points ---------------------------------------------------------------------------------------------------

    def quick(self) -> Iterator[Place]:
        """Yield the first points in the stated domain: short numbers, then generic ones."""
        return self._moved(chain(self._short(), self._generic()))

    def first(self) -> Iterator[Place]:
        """Yield the points in the stated domain that are no zeros of singular parts; quick refutations come first."""
        stages = (self._short(), self._generic(), self._wide(), self._far(), self._special(),
                  self._related(), self._rates(), Uphill(self.claim).places(self.drawn()))  # fmt: skip
        return self._moved(chain.from_iterable(stages))

    def zeros(self) -> Iterator[Place]:
        """Yield the points in the stated domain that are zeros, have equal sides or two special letters."""
        equal = equal_places(self.claim, self.drawn(0.5, 1.5), self.random)
        yield from self._moved(chain(self._zeros(), equal, self._pairs()))
        if self.claim.entry.claimed is not None and len(self._found) < FEW:
            yield from self.near(self._found)

    def _moved(self, places: Iterator[Place]) -> Iterator[Place]:
        """Yield the points that lie in the stated domain, moved onto its equations."""
        for place in self._inside(places):
            self._found.append(place)
            yield place

    def near(self, found: Sequence[Place]) -> Iterator[Place]:
        """Yield points in the stated domain near others, as many as make a region known."""
        return self._inside(map(self._near, list(found)[:FEW] * (FEW // max(len(found), 1))))

    def _near(self, place: Place) -> Place:
        """Return a point whose coordinates differ by up to a half."""
        at = {a: c for a, c in place.at.items() if a not in self.claim.coordinates or kind(a).spread == "integer"}
        for letter in (a for a in self.claim.coordinates if a not in at):
            shown = [Fraction(f"{float(c):.6g}") for c in place.at[letter]]
            at[letter] = [c + Fraction(self.random.randint(-50, 50), 100) * (c or 1) for c in shown]
        return replace(place, label=f"near {place.label}", at=at, generic=True, on="", zero=None)

    def _inside(self, places: Iterable[Place]) -> Iterator[Place]:
        for place in filter(self._has_kinds, places):
            try:
                moving = self.claim.aims if self.claim.depth else ()  # rates, too, fulfil the equations
                if self.claim.depth and not self.at_instants and is_at_edge(self.claim, place):
                    continue
                if self.claim.inside(place) and (not moving or any(is_on(aim, place) for aim in moving)):
                    yield place
                elif self.claim.aims:
                    yield from islice(filter(self.claim.inside, filter(self._has_kinds, self._projected(place))), 1)
            except BlurredError:
                continue

    def _has_kinds(self, place: Place) -> bool:
        """Return whether letters have values of their kinds, and each branch is less than the order."""
        counts: Mapping[Symbol, Any] = place.at
        orders, branches = ([counts[a] for a in self.claim.letters if a.quantity is row] for row in (ORDER, BRANCH))
        rows = [(kind(a), place.at[a]) for a in self.claim.coordinates]
        absent = any(row.invertible and arb(c).contains(0) for row, numbers in rows for c in numbers)
        below = any(row.spread == "positive" and c <= 0 for row, numbers in rows for c in numbers)
        return all(0 <= k < n for n in orders for k in branches) and not absent and not below

    def _projected(self, place: Place) -> Iterator[Place]:
        """Yield the points on the equations of the domain near a point and near the opposite one."""
        opposite = {a: kind(a).antipode(c) if a in self.claim.coordinates else c for a, c in place.at.items()}
        for aim, start in product(self.claim.aims, (place, replace(place, at=opposite))):
            moves = self._projections < PROJECTIONS_MAX and self._attempts < (self._projections + 1) * ATTEMPTS_MAX
            if moves and (moved := onto(aim, start)) is not None:
                self._projections += 1
                yield moved
            self._attempts += moves

    def _short(self) -> Iterator[Place]:
        for i in range(3):
            at: dict[Symbol, Any] = self._discrete()
            for place, letter in enumerate(self.claim.coordinates):
                row = kind(letter)
                free = [SHORT[(i + place) % len(SHORT)], *self.random.choices(SHORT, k=row.size - 1)]
                free = [abs(c) if row.spread == "positive" else c for c in free]
                at[letter] = [Fraction(1), *free[1:]] if row.projective else free
            yield Place(f"point {i + 1} of short numbers", at, generic=True)

    def _generic(self) -> Iterator[Place]:
        sizes = [(low, high) for count, low, high in REGIMES[:3] for _ in range(count)]
        for i, (low, high) in enumerate(sizes, 1):
            yield Place(f"generic point {i}", self.drawn(low, high), generic=True)

    def _wide(self) -> Iterator[Place]:
        sizes = [(low, high) for count, low, high in REGIMES[3:] for _ in range(count)]
        for i, (low, high) in enumerate(sizes, 1):
            yield Place(f"wide point {i}", self.drawn(low, high))
        for i in range(len(sizes) + 1, len(sizes) + 7):
            at = {a: self._drawn(a, *self.random.choice(REGIMES)[1:]) for a in self.claim.coordinates}
            yield Place(f"wide point {i}", {**self._discrete(), **at})

    def _far(self) -> Iterator[Place]:
        """Yield large integers, at which inequalities may fail."""
        if not ORDERED.isdisjoint(operators(self.claim.statement)):
            for n in (BOUND, -BOUND):
                at = self.drawn()
                at |= {a: [Fraction(n)] for a in self.claim.coordinates if kind(a).spread == "integer"}
                at |= {a: abs(n) for a in self.claim.letters if a.quantity is ORDER}
                yield Place(f"integers of size {BOUND}", at)

    @cached_property
    def _specials(self) -> list[tuple[Symbol, str, Place]]:
        """Special coordinates of each letter; of a dual one also with the dual part 0."""
        found = []
        for a in self.claim.coordinates:
            rows: list[tuple[str, Numbers, dict[Symbol, Numbers]]]
            rows = [(label, c, {}) for label, c in special(kind(a)).items()]
            over = kind(a).special(Fraction(1))
            if kind(a).dual:
                still: dict[Symbol, Numbers] = {a: [Fraction(0)] * len(self.claim.further(a, Place("", {})))}
                rows += [(f"{label}, real", c, still) for label, c, _ in rows[:1]]
                rows.append(("real", self._drawn(a, 0.3, 2.0), still))
            turns = {label: {a: (c, over[label])} if "pi" in label else {} for label, c, _ in rows}
            found += [(a, label, Place("", {a: c}, parts=parts, turns=turns[label])) for label, c, parts in rows]
        return found

    def _beside(self) -> dict[Symbol, Any]:
        """Return coordinates of all letters, those of a point in the stated domain if one was found."""
        stated = self.claim.entry.claimed is not None and bool(self._found)
        return dict(self.random.choice(self._found).at) if stated else self.drawn()

    def _special(self) -> Iterator[Place]:
        for letter, label, one in self._specials:
            yield replace(one, label=f"{letter.name}: {label}", at={**self._beside(), **one.at})
        origin = {a: special(kind(a))["0"] for a in self.claim.coordinates if "0" in special(kind(a))}
        if len(origin) > 1:
            yield Place(f"{', '.join(a.name for a in origin)} = 0", {**self._beside(), **origin}, pair=True)

    def _rates(self) -> Iterator[Place]:
        """Yield dual parts and rates of other sizes: all 0, fractions, and large ones."""
        counts = {a: len(self.claim.further(a, Place("", {}))) for a in self.claim.coordinates}
        for label, scale in (("at rest", 0), ("slow", Fraction(1, 7)), ("fast", Fraction(1001, 3))):
            parts = {a: [scale * self.random.choice(SHORT) for _ in range(n)] for a, n in counts.items() if n}
            if parts:
                yield Place(label, self.drawn(), parts=parts)

    def _pairs(self) -> Iterator[Place]:
        pairs = [(one, two) for one, two in combinations(self._specials, 2) if one[0] != two[0]]
        drawn = self.random.sample(pairs, min(PAIRS_MAX, len(pairs)))
        alike = [pair for pair in pairs if pair[0][1] == pair[1][1] and pair not in drawn]
        for (a, label, one), (b, other, two) in (*drawn, *alike):
            at, parts = {**self.drawn(), **one.at, **two.at}, {**one.parts, **two.parts}
            name = f"{a.name}: {label}, {b.name}: {other}"
            yield Place(name, at, parts=parts, pair=True, turns=one.turns | two.turns)

    def _related(self) -> Iterator[Place]:
        """Yield points where two letters of like kinds are equal, opposite or parallel."""
        for a, b in combinations(self.claim.coordinates, 2):
            at = self.drawn()
            if kind(a).build is kind(b).build:
                yield Place(f"{b.name} = {a.name}", {**at, b: at[a]}, pair=True)
                if kind(b).spread != "positive":
                    yield Place(f"{b.name} opposite to {a.name}", {**at, b: kind(b).antipode(at[a])}, pair=True)
            for one, other in ((a, b), (b, a)):
                if kind(one).size == kind(other).size == 3 and not kind(one).projective:
                    along = kind(other).build(at[other])
                    yield Place(f"{one.name} along {other.name}", {**at, one: [2 * c for c in along]}, pair=True)
                    inverse = [c / along.dot(along) for c in along]
                    yield Place(f"{one.name} inverse to {other.name}", {**at, one: inverse}, pair=True)
                    across = along.cross(Vector(*at[one]))
                    yield Place(f"{one.name} across {other.name}", {**at, one: list(across)}, pair=True)

    def _zeros(self) -> Iterator[Place]:
        for part in singular(*map(written_out, self.terms)):
            letters = [a for a in self.claim.letters if a in symbols(part.part)]
            for letter in letters:
                if letter in self.claim.coordinates:
                    for line in self._lines(letter, part.part):
                        roots, places = line.places(part)
                        self.roots.setdefault((part.part, letter), roots)
                        yield from places
                if is_integer(letter):
                    yield from at_integers(self.claim.of_number(part.part), part, letter, self.drawn())
            moving = [a for a in letters if a in self.claim.coordinates and kind(a).spread != "integer"]
            free, met = sum(kind(a).size for a in moving), any(self.roots.get((part.part, a)) for a in letters)
            if free > 1 and not met:
                turns = parallel(self.claim, moving, partial(self.drawn, 0.5, 1.5))
                along = [found for line in turns for found in line.places(part)[1]]
                yield from along or self._meeting(part)

    def _meeting(self, part: Singular) -> Iterator[Place]:
        """Yield a point where a part of several letters vanishes: between unlike signs, or where it touches 0."""
        shown = f"{written(self.claim.entry.contracted(part.part))} = 0"
        claim = self.claim.of_number(part.part)
        drawn = (Place("", self.drawn(low, high)) for _, low, high in REGIMES[:3] * 3)
        ends: dict[bool, Place] = {}
        for place in chain(drawn, islice(self._special(), FEW)):
            with suppress(*ABSENT):
                ends.setdefault(bool(part.number(claim, place) > 0), place)
            if len(ends) == 2:
                break
        found: Place | None = None
        for start in (Place("", self.drawn(low, high)) for low, high in ((0.5, 1.5), (1, 5))):
            if len(ends) < 2 and found is None:
                found = touching(claim, start, part.part, part.size)
                with suppress(*ABSENT):
                    if found is not None and part.number(claim, start) * part.number(claim, found) < 0:
                        yield replace(found, label=f"beyond {shown}")
                        ends, found = {False: start, True: found}, None
        if len(ends) == 2:
            found = crossed(claim, part, ends[False], ends[True])
        if found is not None:
            yield replace(found, label=shown, on=shown)

    def roots_along(self, part: Term, letter: Symbol) -> tuple[str, list[float], Callable[[float], bool]] | None:
        """Return the name of a letter's value, those at which a part vanishes on all lines, and whether one is such."""
        line, part = next(self._lines(letter, part), None), bare(part)
        if line is None or not (line.radial or kind(letter).size == 1):
            return None
        found = line.roots(Singular(part, size))
        known = self.roots.get((part, letter), found)
        alike = len(known) == len(found) and all(abs(a - b) < 1e-9 for a, b in zip(known, found))
        vanishes = partial(line.vanishes_at, Singular(part, size))
        return (line.shown, found, vanishes) if alike and all(map(vanishes, found)) else None

    def _lines(self, letter: Symbol, part: Term) -> Iterator[Line]:
        return lines(self.claim.of_number(part), letter, self.drawn(0.5, 1.5), self.random)
