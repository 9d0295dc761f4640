"""Numbers of a point at which a claim fails: its letters and both sides, exact or with bounds on their errors."""

from __future__ import annotations

from contextlib import suppress
from fractions import Fraction
from itertools import pairwise
from typing import Any

from ...algebra.element import Element
from ..language import operator_table
from ..language.environment import Env
from ..language.printed import Term, Trait, latex
from ..language.values import coefficients, equal
from ..numbers.balls import PRECISIONS, Ball, BlurredError, precision
from ..numbers.fields import Exact
from ..result import Counterexample
from .claim import Claim
from .place import Place


def shown_at(claim: Claim, place: Place, words: str = "") -> Counterexample:
    """Return the letters and both sides at a point, by exact rationals if the sides are rational."""
    letters: dict[str, list[str]] = {}
    for bits in PRECISIONS:
        with precision(bits):
            env, exact = claim.env(place), claim.env(place, Exact())
            named = {latex(a) if claim.entry.is_transcribed else a.name: a for a in claim.letters}
            numbers = {name: _rational(exact, a) or _numbers(env.value(a)) for name, a in named.items()}
            letters = letters or {name: parts for name, parts in numbers.items() if parts}
            for proof, field in (("exact rationals", exact), ("disjoint intervals", env)):
                with suppress(ArithmeticError, BlurredError, TypeError, AttributeError):
                    if found := sides(field, claim.statement.xreplace(dict(place.known))):
                        return Counterexample(words or place.label, letters, found, proof)
    return Counterexample(words or place.label, letters, ())


def outside_words(claim: Claim, place: Place) -> str:
    """Return how a claim fails at a point, and whether its stated domain admits this point."""
    where = place.on or place.label
    admits = ", which the stated domain admits" if claim.entry.claimed is not None else ""
    return f"{'undefined' if claim.truth(place) is None else 'false'} at {where}{admits}"


def sides(env: Env, statement: Term) -> tuple[list[str], ...]:
    """Return the numbers of the first two neighbouring sides of an equation that are unequal."""
    if Trait.JOINS in statement.operator.traits:
        return next((found for part in statement.arguments if (found := sides(env, part))), ())
    if statement.operator is operator_table.equal:
        for pair in pairwise(statement.arguments):
            a, b = (env.now(env.value(side)) for side in pair)
            if not equal(env.field, a, b):
                return _numbers(a), _numbers(b)
    return ()


def _rational(env: Env, letter: Any) -> list[str]:
    with suppress(ArithmeticError, TypeError, AttributeError):
        return _numbers(env.value(letter))
    return []


def _numbers(value: Any) -> list[str]:
    """Return the numbers of a value; none if it contains other things, or balls beside fractions."""
    if isinstance(value, bool):
        return []
    found = [a.ring.value(a.numerator) / a.ring.value(a.denominator) if isinstance(a, Element) else a
             for a in coefficients(value)]  # fmt: skip
    return [str(a) for a in found] if all(isinstance(a, int | Fraction | Ball) for a in found) else []
