"""Conditions of a claim, found from the points where it fails: parts without a value, and regions of a branch."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import combinations, product
from typing import Any

from ..algebra import Structure, Tensor
from ..algebra.matrix import Matrix
from .claim import Claim, Place, kind
from .language.environment import Env
from .language.matrices import det, entry, stacked, trace
from .language.operator_table import Re, conjugate, cos, norm, sin
from .language.printed import Number, Symbol, Term, Trait, symbols, walk
from .language.written import written
from .numbers.balls import Ball, Balls, BlurredError, arb, precision
from .numbers.fields import innermost
from .probe import Probe, named, size

BRANCHED = frozenset((
    "root", "acos", "asin", "arctan", "atan2 of two", "log", "norm", "floor of number", "K10 length", "K10 power 1/2",
))  # fmt: skip
"""Operators that choose a branch or a sign."""
REGION_MIN = 3
"""A claim is true in a region if it is at one in this many of the generic points."""


@dataclass(frozen=True)
class Exclusion:
    """Requirement ``subject relation`` of a claim for a value, such as ``norm(v) != 0``."""

    subject: Term
    relation: str

    def __str__(self) -> str:
        if self.relation == "has a value":
            return f"{written(self.subject)} has a value"
        return f"{written(self.subject)} {self.relation}"


def fault(env: Env, node: Term) -> Exclusion | None:
    """Return the requirement that a term without a value violates: that of its deepest part without a value."""
    for argument in node.arguments:
        if _undefined(env, argument):
            return fault(env, argument)
    name, arguments = node.operator.name, node.arguments
    if name == "over":
        return Exclusion(_factor(env, arguments[1]), "!= 0")
    if name in ("power", "inverse"):
        return Exclusion(_factor(env, arguments[0]), "!= 0")
    if name == "norm":
        return Exclusion(Re(*arguments) if env.dual else node, "!= 0")
    if name == "root" or name == "K10 power 1/2":
        return Exclusion(arguments[0], ">= 0")
    if name == "log":
        value = env.value(arguments[0])
        if isinstance(value, Tensor | Matrix):
            return Exclusion(trace(*arguments), "!= -1" if isinstance(value, Tensor) else "!= 0")
        if not isinstance(value, Structure):
            return Exclusion(arguments[0], "> 0")
    if name in ("acos", "asin"):
        return Exclusion(norm(arguments[0]), "<= 1")
    if name in ("tan", "cot"):
        return Exclusion((cos if name == "tan" else sin)(*arguments), "!= 0")
    if name == "atan2 of two":
        return Exclusion(norm(arguments[0]) + norm(arguments[1]), "!= 0")
    zero = next((a for a in arguments if symbols(a) and _vanishes(env, a)), None)
    return Exclusion(node, "has a value") if zero is None else Exclusion(zero, "!= 0")


def _vanishes(env: Env, node: Term) -> bool:
    try:
        return bool(size(env.value(node)) == 0)
    except (ArithmeticError, TypeError, AttributeError, KeyError):
        return False


def _undefined(env: Env, node: Term) -> bool:
    try:
        env.value(node)
    except ArithmeticError:
        return True
    except (KeyError, TypeError):  # it has a letter that is bound further out, or is one
        return False
    return False


def _factor(env: Env, below: Term) -> Term:
    """Return the factor of a divisor that vanishes, or its determinant."""
    name, arguments = below.operator.name, below.arguments
    if name in ("negative", "bracket", "root") or (name == "power" and isinstance(arguments[1], Number)):
        return _factor(env, arguments[0])
    if name == "over":
        return _factor(env, arguments[0])
    if name == "times":
        for argument in arguments:
            if innermost(size(env.value(argument))) == 0:
                return _factor(env, argument)
    value = env.value(below)
    return det(below) if isinstance(value, Tensor | Matrix) else below


def exclusions(claim: Claim, places: Sequence[Place]) -> dict[Exclusion, Place]:
    """Return the requirements that the points without a value violate, each with the first such point."""
    found: dict[Exclusion, Place] = {}
    for place in places:
        with precision(256):
            try:
                requirement = fault(claim.env(place), claim.statement)
            except (ArithmeticError, BlurredError):
                continue
        if requirement is not None:
            found.setdefault(requirement, place)
    return found


def plain(probe: Probe, requirement: Exclusion) -> str:
    """Return a requirement in plain form: by values of the letter if it has only one, else as it stands."""
    shown = replace(requirement, subject=probe.claim.entry.contracted(requirement.subject))
    letters = [a for a in symbols(requirement.subject) if a in probe.claim.coordinates]
    simple = requirement.subject in (*letters, *map(norm, letters))
    if requirement.relation == "!= 0" and len(letters) == 1 and not simple:
        name, roots = probe.roots_along(requirement.subject, letters[0]) or ("", [])
        return (roots and values_excluded(name, roots)) or str(shown)
    return str(shown)


def values_excluded(name: str, roots: Sequence[float]) -> str:
    """Return the condition that a number has none of some values; empty if they show no pattern."""
    shown = [named(t) for t in sorted(roots, key=lambda t: (abs(t), -t))]
    if any("." in t for t in shown):
        return ""
    if len(shown) == 1 or (len(shown) == 2 and "pi" not in shown[1]):
        return " and ".join(f"{name} != {t}" for t in shown)
    steps = sorted({abs(t) for t in roots})
    gap = steps[1] - steps[0] if steps[0] else steps[1]
    if all(abs(t / gap - round(t / gap)) < 1e-9 for t in steps):
        first = f"k = {round(steps[0] / gap)}, {round(steps[0] / gap) + 1}, …" if min(roots) >= 0 else "any integer k"
        unit = named(gap).replace("pi", "k*pi") if "pi" in named(gap) else f"{named(gap)}*k"
        return f"{name} != {unit} for {first}"
    return ""


# ---- regions of a branch ----------------------------------------------------------------------------------------


Read = Callable[[Term, Place], Any]
"""Function that returns the number of a part at a point, or None."""
Test = Callable[[Place], bool | None]
"""Function that tells whether a condition holds at a point; None on its border or where it has no value."""


@dataclass(frozen=True)
class Region:
    """Condition on a region, in words and as a test."""

    words: str
    test: Test

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
        yield Region(f"{one.words} and {two.words}", partial(_both, one.test, two.test))


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

    return Region(f"{written(part)} {relation}", test)


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
    return Region(words.format(shown), test)


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
