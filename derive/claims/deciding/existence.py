"""Proof that both sides of a claim have a value, by the signs of exact numbers.

A partial operation asks something of a number: a divisor is not 0, a radicand is not negative. This is proved where the
factors of the number have one sign on the stated domain, or are asked to by a condition that was found.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from functools import partial

from ...algebra import Quaternion, Structure, Tensor
from ...algebra.matrix import Matrix
from ..language.printed import Term, symbols
from ..language.substitution import written_out
from ..numbers.fields import innermost
from ..numbers.generators import Generators
from .claim import Claim
from .frames import with_frames_at_rest, with_free_product
from .identity import ABSENT, every_sign, setting
from .partial import OPEN, is_invertible, is_named, partial_operations
from .signs import Signs, signs_in
from .solved import with_solved_equations
from .terms import is_dual


def signs_of(claim: Claim, condition: Sequence[Term], parts: Sequence[Term]) -> list[Signs]:
    """Return the signs for each choice of orders and of signs of the roots in parts, with what the domain says."""
    found: list[Signs] = []
    for fixed in claim.general:
        for env in every_sign(partial(setting, claim, Generators, fixed)):
            signs = signs_in(claim, env, condition)
            for part in parts:
                with suppress(*ABSENT):
                    env.value(part)
            found.append(signs)
    return found


def undecided_parts(claim: Claim, condition: Sequence[Term] = ()) -> list[Term]:
    """Return the partial operations of a claim that are not proved to have a value."""
    claim, condition = with_solved_equations(claim, *condition)
    claim, condition = with_free_product(claim, *condition)
    claim, condition = with_frames_at_rest(claim, *condition)
    given = [part.arguments[0] for part in condition if part.operator.name == "equal"]  # those have a value
    asking = list(partial_operations(written_out(claim.statement), partial(_has_slope, claim), given))
    parts = list(dict.fromkeys(part for part, _ in asking))
    try:
        every = signs_of(claim, condition, parts)
    except ABSENT:
        return parts
    open_parts = [part for part, asked in asking if not all(_has_value(signs, part, asked) for signs in every)]
    return list(dict.fromkeys(open_parts))


def _has_slope(claim: Claim, part: Term) -> bool:
    """Return whether rates or the dual part of a part matter."""
    return bool(claim.depth and not claim.at_rest.issuperset(symbols(part))) or is_dual(part)


def _has_value(signs: Signs, part: Term, asked: str) -> bool:
    if asked == OPEN:
        return False
    apart = asked in ("not 0", "magnitude")
    if apart and (is_invertible(part) or is_named(part, signs.named) or signs.is_above(part, True)):
        return True
    try:
        value = signs.env.value(part)
        if asked == "logarithm" and isinstance(value, Tensor | Matrix):
            turned = value.trace() + 1 if isinstance(value, Tensor) else sum(value.rows[i][i] for i in range(4))
            return signs.is_nonzero(signs.field.element(innermost(signs.env.now(turned))))
        if asked == "logarithm" and isinstance(value, Quaternion):  # no negative number
            length = signs.field.sqrt(signs.number(part))
            return signs.is_nonzero(length + signs.number(part, lambda q: innermost(q.scalar)))
        if asked == "logarithm" and isinstance(value, Structure):
            return signs.is_nonzero(signs.number(part))
        if apart:
            number = signs.number(part)
            return signs.is_nonzero(number) or (asked == "magnitude" and not number)  # as fields take magnitudes
        if isinstance(value, Quaternion) and any(value.vector):
            return signs.is_positive(signs.number(part, lambda h: innermost(h.scalar)), strict=True)
        number = signs.number(part, lambda a: innermost(a.scalar if isinstance(a, Quaternion) else a))
        if asked in ("within 1", "inside 1"):
            number = 1 - number * number
        return signs.is_positive(number, strict=asked in ("logarithm", "inside 1"))
    except ABSENT:
        return False
