"""Points at which both sides of an order relation are equal, a floor jumps, or an argument in the statement vanishes.

Where a difference only touches 0 it does not change its sign. One of its factors may, as t - 1 does in
``1 - sin(x) = (t - 1)**2/(1 + t**2)`` with t = tan(x/2). So the factor certainly vanishes between two points;
that the difference does is checked there, since a root may have another sign.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from functools import reduce
from itertools import islice
from operator import mul
from random import Random
from typing import Any

from ..language.matrices import exp
from ..language.operator_table import difference, tan
from ..language.printed import Apply, Number, Symbol, Term, Trait, symbols, walk
from ..numbers.balls import BlurredError, arb
from ..numbers.generators import Generators
from .claim import Claim, kind
from .identity import ABSENT, setting, whole_steps
from .place import Place
from .polar import Way
from .singular import Singular, size
from .terms import STRICT, bare
from .zeros import lines

FLOORS = tuple(map(Number, (1, 0, -1)))
"""Integers at which a floor is tried."""
FACTORS_MAX, ARGUMENTS_MAX = 6, 4
"""Largest number of factors, and of arguments, whose zeros are sought."""
FLOOR = "floor of number"


def equal_places(claim: Claim, at: dict[Symbol, Any], source: Random) -> Iterator[Place]:
    """Yield points at which sides are equal or a floor jumps, and those beside zeros of arguments."""
    nodes = [node for node in walk(claim.statement) if node.operator.name in (*STRICT, "unlike", FLOOR)]
    if not nodes or claim.depth or claim.dual:
        return
    for node in nodes:
        for zero, known in _equalities(node):
            found = (place for factor in islice(_factors(claim, zero), FACTORS_MAX)
                     for place in _zeros(claim, factor, at, source, True) if place.zero == factor)  # fmt: skip
            for place in found:
                if _has_sides(claim, node, place) and _is_zero(claim, zero, place):
                    yield replace(place, zero=None, known={node: known})
    for part in islice(_arguments(claim.statement), ARGUMENTS_MAX):
        yield from _zeros(claim, part, at, source)


def _equalities(node: Term) -> Iterator[tuple[Term, Term]]:
    """Yield numbers of a relation or floor, with what it is where they vanish."""
    if node.operator.name != FLOOR:
        yield difference(node), Apply(node.operator.name, 0, 0)
    else:
        yield from ((node.arguments[0] - k, k) for k in FLOORS)


def _is_zero(claim: Claim, zero: Term, place: Place) -> bool:
    """Return whether a difference has a value at a zero of its factor, and no other than 0 for signs of roots there."""
    with suppress(*ABSENT, BlurredError):
        return bool(arb(claim.evaluated(replace(place, zero=None), zero, size)).contains(0))
    return False


def _has_sides(claim: Claim, node: Term, place: Place) -> bool:
    with suppress(BlurredError):
        return all(claim.evaluated(place, side) is not None for side in node.arguments)
    return False


def _zeros(claim: Claim, part: Term, at: dict[Symbol, Any], source: Random, brief: bool = False) -> Iterator[Place]:
    """Yield zeros of a part along lines of its letters, and points beside them."""
    for letter in symbols(part):
        if letter in claim.coordinates:
            for line in lines(claim, letter, at, source):
                yield from line.places(Singular(part, size), brief)[1]


def _arguments(statement: Term) -> Iterator[Term]:
    """Yield sums in exponents, powers and functions: where one vanishes, a number may be largest."""
    found = (bare(node.arguments[0]) for node in walk(statement)
             if node.operator.name == "power" or Trait.TRANSCENDENTAL in node.operator.traits)  # fmt: skip
    yield from dict.fromkeys(part for part in found if part.operator.name in ("plus", "minus") and symbols(part))


def _factors(claim: Claim, zero: Term) -> Iterator[Term]:
    """Yield the factors of a number that contain one generator, as terms."""
    try:
        env = setting(claim.with_statement(zero), Generators, claim.choices[0], (), Way.POLAR, whole_steps(zero))
        field: Any = env.field
        factors = field.ring.factors(field.element(size(env.value(zero))))
    except ABSENT:
        return
    shown = {f"{a.name}.0": a for a in claim.coordinates if kind(a).size == 1}
    for (what, monomial), name in field.meanings.items():
        letters = [shown[other] ** power for other, power in monomial if other in shown]
        if len(letters) == len(monomial):
            product = reduce(mul, letters)
            shown[name] = tan(product / (2 * field.steps)) if what == "tangent" else exp(product)
    for factor in factors:
        terms = {tuple(zip(field.ring.names, powers)): c for powers, c in field.ring.library.terms(factor).items()}
        used = {name for powers in terms for name, power in powers if power}
        if len(used) == 1 and used <= set(shown):
            (name,) = used
            yield _polynomial(shown[name], {dict(powers)[name]: c for powers, c in terms.items()})


def _polynomial(letter: Term, coefficients: Mapping[int, Fraction]) -> Term:
    """Return a polynomial in a term by the rule of Horner."""
    found: Term = Number(0)
    for k in range(max(coefficients), -1, -1):
        c = coefficients.get(k, Fraction(0))
        found = found * letter + Number(c.numerator) / Number(c.denominator)
    return found
