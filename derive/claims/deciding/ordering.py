"""Proof of order relations, by the sign of the difference of both sides as an exact number.

Letters are taken in polar form, with a frame along the first two vectors, or by free components. A relation of numbers
is also proved along one of them: at one end it is true, and the derivative has a sign from there on.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial, reduce

import sympy

from ..language.matrices import at_least, at_most
from ..language.operator_table import both, difference, norm, pi
from ..language.printed import Apply, Number, Symbol, Term, Trait
from ..language.values import coefficients
from ..numbers.derivation import Along
from ..numbers.generators import Generators
from ..numbers.signed import Bound
from .claim import Claim, kind
from .existence import undecided_parts
from .identity import ABSENT, every_sign, not_negative, proved, setting, whole_steps
from .polar import ALL, POSITIVE, Way, bounds
from .signs import MARGIN, Signs, signs_in
from .terms import STRICT, is_frame_free, operators

DERIVATIVES_MAX = 8
"""Largest number of derivatives that are 0 where an order relation begins."""
BEGINNINGS = tuple(map(sympy.Integer, (0, 1, -1)))
"""Numbers at which both sides may be equal."""
Test = Callable[[Signs, Term], bool]


def ordered(claim: Claim) -> bool:
    """Return whether the order relations that a claim states are proved."""
    return _is_true(claim, claim.statement)


def _is_true(claim: Claim, statement: Term) -> bool:
    """Return whether a statement is proved, each of its order relations in any way."""
    if Trait.JOINS in statement.operator.traits or statement.operator is both:
        return all(_is_true(claim, part) for part in statement.arguments)
    known = [difference(part) for part in claim.domain if part.operator.name in ("unlike", "nonzero")]
    if statement.operator.name == "unlike" and difference(statement) in known:
        return True
    if statement.operator.name not in (*STRICT, "unlike"):
        return proved(claim.with_statement(statement)) is not None
    return any(map(_is_proved, map(claim.with_statement, dict.fromkeys((statement, _by_parts(statement))))))


def _is_proved(claim: Claim) -> bool:
    """Return whether an order relation is proved in any form of its letters, or along a number."""
    ways = (_for_all_signs(claim, way, partial(_holds, whole=_is_whole(claim, way))) for way in _ways(claim))
    return any(ways) or _along_numbers(claim)


def _by_parts(relation: Term) -> Term:
    """Return a relation with the magnitudes of the parts in place of that of a sum, on the lesser side."""
    lesser = 0 if relation.operator.name in ("less", "at most") else 1
    sides = list(relation.arguments)
    if relation.operator.name in STRICT:
        sides[lesser] = _parts_of_length(sides[lesser])
    return Apply(relation.operator.name, *sides)


def _parts_of_length(side: Term) -> Term:
    """Return the magnitudes of the parts of a sum of vectors, which are not below its own; rotations do not matter."""
    if side.operator is not norm:
        return side
    (inner,) = side.arguments
    a, b = (*inner.arguments, inner, inner)[:2]
    if inner.operator.name in ("plus", "minus"):
        return _parts_of_length(norm(a)) + _parts_of_length(norm(b))
    turned = inner.operator.name == "times" and isinstance(a, Symbol) and a.quantity.name.endswith("rotation")
    return _parts_of_length(norm(b)) if turned else side


def _ways(claim: Claim) -> Iterator[Way]:
    """Yield the forms of letters in which a claim may be proved."""
    if not claim.depth and is_frame_free(*claim.parts):
        yield Way.FRAMED
    yield Way.POLAR
    if any(kind(a).size > 1 for a in claim.coordinates):
        yield Way.COMPONENTS


def _for_all_signs(claim: Claim, way: Way, test: Test) -> bool:
    """Return whether a test is passed for all orders and for both signs of each root whose sign is unknown."""
    steps = whole_steps(claim.statement)
    ways = (partial(setting, claim, Generators, fixed, way=way, steps=steps) for fixed in claim.general)
    try:
        return all(test(signs_in(claim, env), claim.statement) for of_signs in ways for env in every_sign(of_signs))
    except ABSENT:
        return False


def _holds(signs: Signs, relation: Term, whole: bool) -> bool:
    """Return whether an order relation is proved by the sign of its difference, at all values or at generic ones."""
    if relation.operator.name == "unlike":
        parts = coefficients(signs.env.now(signs.env.value(difference(relation))))
        if any(a and not signs.field.used(a) for a in map(signs.field.element, parts)):
            return True  # a part is a number, as of ε, whose real part is 0
        gap = signs.number(difference(relation))
        return signs.is_nonzero(gap) if whole else any(signs.is_positive(a - MARGIN) for a in (gap, -gap))
    gap, strict = signs.field.element(not_negative(signs.env, relation)), STRICT[relation.operator.name]
    return signs.is_positive(gap, strict) if whole or not strict else signs.is_positive(gap - MARGIN)


def _is_whole(claim: Claim, way: Way) -> bool:
    """Return whether letters reach all their values in a form; a frame may be turned so that two vectors do."""
    kinds = [kind(a) for a in claim.coordinates if kind(a).size > 1]
    if way is Way.FRAMED:
        return len(kinds) < 3 and all(row.size == 3 for row in kinds)
    return not kinds or (way is Way.COMPONENTS and not any(row.projective and row.size > 3 for row in kinds))


# ---- along one number -----------------------------------------------------------------------------------------------


def _along_numbers(claim: Claim) -> bool:
    """Return whether an order relation is proved along one of its numbers, from a place where it is true."""
    if claim.depth or claim.dual or claim.statement.operator.name not in STRICT:
        return False
    if STRICT[claim.statement.operator.name] and not _is_whole(claim, Way.POLAR):
        return False
    if "atan2 of two" in operators(claim.statement) or undecided_parts(claim):
        return False  # there may be a jump or a pole
    if not all(bounds([part]) for part in claim.domain):
        return False  # the way along a number may leave the domain
    return any(_along(claim, a) for a in claim.coordinates if kind(a).size == 1 and kind(a).spread != "integer")


def _along(claim: Claim, letter: Symbol) -> bool:
    low, high = bounds(claim.domain).get(letter.name, POSITIVE if kind(letter).spread == "positive" else ALL)
    for begin in dict.fromkeys((low, high, *BEGINNINGS)):
        if begin.is_finite and low <= begin <= high:
            parts = ((1, high - begin), (-1, begin - low))
            if all(_from(claim, letter, begin, sign, length) for sign, length in parts if length > 0):
                return True
    ends = [_term(end) for end in (low, high) if end.is_finite]
    inside = [_moved(claim, {letter: end}) for end in ends if end is not None]
    return len(inside) == 2 and all(_is_true(one, one.statement) for one in inside) and _for_all_signs(
        claim, Way.POLAR, partial(_bends_down, letter=letter))


def _from(claim: Claim, letter: Symbol, begin: Bound, sign: int, length: Bound) -> bool:
    """Return whether a relation is proved from a value of a letter on, up or down by at most a length."""
    start, most, step = _term(begin), _term(length), Symbol(letter.name, "positive")
    if start is None:
        return False
    moved = {letter: start + step if sign > 0 else start - step}
    within = [at_least(step, Number(0)), *([] if most is None else [at_most(step, most)])]
    return _for_all_signs(_moved(claim, moved, *within), Way.POLAR, partial(_rises, letter=letter))


def _moved(claim: Claim, values: dict[Symbol, Term], *within: Term) -> Claim:
    """Return a claim with terms in place of letters, and with more relations in its domain."""
    domain = [*(part.xreplace(values) for part in claim.domain), *within]
    entry = replace(claim.entry, claimed=reduce(both, domain) if domain else None)
    return Claim(entry, claim.statement.xreplace(values), claim.orders)


def _term(number: Bound) -> Term | None:
    """Return a rational number or a rational multiple of π as a term, else None."""
    for unit, mark in ((sympy.Integer(1), Number(1)), (sympy.pi, pi)):
        part = number / unit
        if part.is_Rational:
            return Number(int(part.p)) / Number(int(part.q)) * mark
    return None


def _rises(signs: Signs, relation: Term, letter: Symbol) -> bool:
    """Return whether a difference is not negative where a letter is 0, nor are its derivatives up to one that rises."""
    along = Along(signs.field, f"{letter.name}.0")
    a, strict = signs.field.element(not_negative(signs.env, relation)), STRICT[relation.operator.name]
    for _ in range(DERIVATIVES_MAX):
        if signs.is_positive(a, strict):
            return True
        if not _is_smooth(signs) or not signs.is_positive(along.start(a), strict):
            return False
        a, strict = along.slope(a), False
    return False


def _bends_down(signs: Signs, relation: Term, letter: Symbol) -> bool:
    """Return whether the second derivative of a difference is nowhere positive, so it is least at an end."""
    along = Along(signs.field, f"{letter.name}.0")
    a = signs.field.element(not_negative(signs.env, relation))
    return _is_smooth(signs) and not signs.field.roots and signs.is_positive(-along.slope(along.slope(a)))


def _is_smooth(signs: Signs) -> bool:
    """Return whether no root reaches 0, so that derivatives have no jump."""
    return all(name not in signs.ring.closed for _, name in signs.field.extensions)
