"""Region on which a claim of one branch is true, found from the points where it is true and where it fails."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import partial
from itertools import combinations, product
from typing import Any

from ..language.matrices import at_least, at_most, entry, greater, less, stacked
from ..language.operations import written
from ..language.operator_table import conjugate, norm, pi, trace
from ..language.printed import Number, Symbol, Term, Trait, symbols, walk
from ..numbers.balls import Ball, Balls, BlurredError, arb
from ..numbers.fields import innermost
from .claim import Claim, kind
from .place import Place
from .places import Probe

BRANCHED = frozenset((
    "root", "acos", "asin", "arctan", "atan2 of two", "log", "norm",
))  # fmt: skip
"""Operators that choose a branch or a sign."""
REGION_MIN = 3
"""A claim is true in a region if it is at one in this many of the generic points."""
Read = Callable[[Term, Place], Any]
"""Function that returns the number of a part at a point, or None."""
Test = Callable[[Place], bool | None]
"""Function that tells whether a condition holds at a point; None on its border or where it has no value."""


@dataclass
class Outcome:
    """Points at which a claim is true, is false, has no value, or that did not tell."""

    true: list[Place] = field(default_factory=list)
    false: list[Place] = field(default_factory=list)
    undefined: list[Place] = field(default_factory=list)
    blurred: list[Place] = field(default_factory=list)

    @property
    def points(self) -> int:
        return len(self.true) + len(self.false) + len(self.undefined)

    @property
    def open(self) -> bool:
        """Whether the claim is true at points drawn at random, so in a region and not in special places only."""
        return sum(place.generic for place in self.true) >= REGION_MIN

    def add(self, truth: bool | None, place: Place) -> None:
        (self.undefined if truth is None else self.true if truth else self.false).append(place)

    def tried(self, claim: Claim, found: Iterable[Place], enough: Callable[[Outcome], bool]) -> Outcome:
        for place in found:
            try:
                self.add(claim.truth(place), place)
            except BlurredError:
                self.blurred.append(place)
            if enough(self):
                break
        return self


@dataclass(frozen=True)
class Region:
    """Condition on a region, in words and as a test."""

    words: str
    test: Test
    terms: tuple[Term, ...]

    @property
    def interior(self) -> tuple[Term, ...]:
        """Relations without the border."""
        return tuple((less if term.operator is at_most else greater)(*term.arguments) for term in self.terms)

    @property
    def strict(self) -> str:
        """Words without the border."""
        return self.words.replace("<=", "<").replace(">=", ">")


def region(claim: Claim, true: Sequence[Place], false: Sequence[Place]) -> tuple[Region | None, bool]:
    """Return the simplest condition that separates the points of truth from the others, and whether it is sharp.

    Without a sharp one, return a condition that is sufficient at all points, or None.
    """
    known: dict[tuple[Term, int], Any] = {}

    def number(part: Term, place: Place) -> Any:
        key = part, id(place)
        if key not in known:
            try:
                known[key] = claim.evaluated(place, part, lambda a: arb(innermost(getattr(a, "scalar", a))))
            except BlurredError:
                known[key] = None
        return known[key]

    found = []
    for candidate in _candidates(claim, number):
        if not any(candidate.test(place) for place in false):
            at_true = [candidate.test(place) for place in true]
            found.append((candidate, False not in at_true, at_true.count(True)))
            if found[-1][1] and found[-1][2] * 2 > len(true):  # not a number that is 0 at all points, such as eps
                return candidate, True
    many = [(inside, -len(candidate.words), candidate) for candidate, _, inside in found if inside * 2 > len(true)]
    return (max(many, key=lambda row: row[:2])[2], False) if many else (None, False)


def _candidates(claim: Claim, number: Read) -> Iterator[Region]:
    """Yield conditions, simple ones first: bounds of letters, signs of numbers in the claim, and pairs of signs."""
    parts = [part for part in dict.fromkeys(walk(claim.statement)) if _is_number(claim, part)]
    sizes = [size for letter in claim.coordinates for size in _sizes(letter)]
    tests = [turn for letter in claim.coordinates for turn in _turns(letter)]
    inner = [p.arguments[0] for p in parts if Trait.TRANSCENDENTAL in p.operator.traits]
    signed, bounded = dict.fromkeys([*sizes, *tests, *parts]), dict.fromkeys([*sizes, *inner])
    signs = [_sign(part, relation, number) for part in signed for relation in (">= 0", "<= 0")]
    bounds = [_between(part, *bound, number) for part in bounded if _is_number(claim, part) for bound in _BOUNDS]
    yield from sorted([*signs, *bounds], key=lambda candidate: len(candidate.words))
    own = [_between(part, *bound, number) for part in sizes if _is_number(claim, part) for bound in _BOUNDS]
    pairs = [*combinations(signs[:16], 2), *product(signs[:16], own), *combinations(own, 2)]
    for one, two in pairs:
        yield Region(f"{one.words} and {two.words}", partial(_both, one.test, two.test), (*one.terms, *two.terms))


def _sizes(letter: Symbol) -> list[Term]:
    """Return the magnitude of a letter: of a twist, that of its first part."""
    if kind(letter).size == 6:
        return [norm(stacked(*(entry(letter, Number(i)) for i in (1, 2, 3))))]
    return {1: [letter], 3: [norm(letter)]}.get(kind(letter).size, [])


def _turns(letter: Symbol) -> list[Term]:
    """Return a number of a letter whose sign tells a small turn from a large one."""
    name = letter.quantity.name
    if "quaternion" in name:
        return [letter + conjugate(letter)]
    turns = {"rotation": trace(letter) - 1, "orthogonal": trace(letter) - 1, "pose": trace(letter) - 2}
    return [turn for word, turn in turns.items() if word in name]


_BOUNDS: tuple[tuple[float | None, float, str], ...] = (
    (-0.5, 0.5, "norm({0}) <= pi/2"), (-1, 1, "norm({0}) <= pi"), (-2, 2, "norm({0}) <= 2*pi"),
    (0, 0.5, "0 <= {0} and {0} <= pi/2"), (0, 1, "0 <= {0} and {0} <= pi"), (0, 2, "0 <= {0} and {0} <= 2*pi"),
    (None, 0.5, "{0} <= pi/2"), (None, 1, "{0} <= pi"), (None, 2, "{0} <= 2*pi"), (-0.25, 0.25, "norm({0}) <= pi/4"),
    (1, 2, "pi <= {0} and {0} <= 2*pi"), (0.5, 1.5, "pi/2 <= {0} and {0} <= 3*pi/2"),
    (-1, 0, "-pi <= {0} and {0} <= 0"),
)  # fmt: skip


def _is_number(claim: Claim, part: Term) -> bool:
    if isinstance(part, Number) or any(a.quantity.name == "index" for a in symbols(part)) or not symbols(part):
        return False
    for place in Probe(claim).quick():
        try:
            value = claim.evaluated(place, part)
        except (TypeError, AttributeError, BlurredError):
            return False
        if value is not None:
            return isinstance(innermost(value), Ball | int) and not isinstance(value, bool)
    return False


def _sign(part: Term, relation: str, number: Read) -> Region:
    def test(place: Place) -> bool | None:
        value = number(part, place)
        if value is None or value.contains(0):
            return None
        return bool(value > 0) == (relation == ">= 0")

    term = (at_least if relation == ">= 0" else at_most)(part, Number(0))
    return Region(f"{written(part)} {relation}", test, (term,))


def _between(part: Term, low: float | None, high: float, words: str, number: Read) -> Region:
    def test(place: Place) -> bool | None:
        value = number(part, place)
        if value is None:
            return None
        turns = value / arb(Balls().pi)
        for bound in (low, high):
            if bound is not None and abs(turns - bound) < 1e-15:
                return None
        return bool((low is None or turns > low) and turns < high)

    shown = written(part)
    if part.operator is norm:
        words = words.replace("norm({0})", "{0}").replace("0 <= {0} and ", "")
    ends = [at_most(part, _turns_of_pi(high)), *([] if low is None else [at_least(part, _turns_of_pi(low))])]
    return Region(words.format(shown), test, tuple(ends))


def _turns_of_pi(count: float) -> Term:
    number = Fraction(count)
    return Number(number.numerator) * pi / Number(number.denominator)


def _both(first: Test, second: Test, place: Place) -> bool | None:
    a, b = first(place), second(place)
    if a is False or b is False:
        return False
    return None if a is None or b is None else True


def branched(*statements: Term) -> bool:
    """Return whether statements choose a branch or a sign."""
    return any(_chooses(node) for statement in statements for node in walk(statement))


def _chooses(node: Term) -> bool:
    """Return whether an operator chooses a branch; a power does so if its exponent is a quotient."""
    name = node.operator.name
    return name in BRANCHED or (name == "power" and "over" in (part.operator.name for part in walk(node.arguments[1])))
