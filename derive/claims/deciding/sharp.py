"""Sharpness of a condition: outside a sharp condition, a denominator of the formula has real part 0."""

from __future__ import annotations

from collections.abc import Iterator

from ..language.operator_table import Re, cos, det, nonzero, over, remark, sin
from ..language.printed import Number, Term, Trait


def is_sharp(condition: Term, statement: Term) -> bool:
    """Return whether the denominators of a statement show that it is undefined outside a condition.

    Each part of the condition must require a nonzero real part of a term, and the statement must always divide by that
    term. The test is sufficient only: False means that the denominators do not show sharpness.
    """
    needed = set(_needed(statement))
    return all(_subject(part) in needed for part in _parts(condition))


def _parts(condition: Term) -> Iterator[Term]:
    if condition.operator is remark:
        yield from _parts(condition.arguments[0])
    elif Trait.JOINS in condition.operator.traits and not condition.operator.lazy:
        for part in condition.arguments:
            yield from _parts(part)
    else:
        yield condition


def _subject(part: Term) -> Term | None:
    """Return a if the condition is ``a ≠ 0`` or ``Re a ≠ 0``, else None."""
    if part.operator is not nonzero:
        return None
    (subject,) = part.arguments
    return subject.arguments[0] if subject.operator is Re else subject


def _needed(node: Term) -> Iterator[Term]:
    """Yield the terms whose real part must be nonzero for a statement to have a value."""
    if node.operator.lazy and node.operator.name != "power":
        return
    if node.operator is over:
        yield from _factors(node.arguments[1])
    elif node.operator.name == "power" and _is_negative(node.arguments[1]):
        yield det(node.arguments[0])
        yield from _factors(node.arguments[0])
    elif Trait.OVER_COSINE in node.operator.traits:
        yield cos(node.arguments[0])
    elif Trait.OVER_SINE in node.operator.traits:
        yield sin(node.arguments[0])
    for argument in node.arguments:
        yield from _needed(argument)


def _factors(below: Term) -> Iterator[Term]:
    """Yield a denominator and its factors, including factors inside powers and magnitudes."""
    yield below
    is_power = below.operator.name == "power" and not _is_negative(below.arguments[1])
    if is_power or below.operator.name in ("times", "root") or Trait.LENGTH in below.operator.traits:
        for factor in below.arguments[: 1 if is_power else None]:
            yield from _factors(factor)


def _is_negative(exponent: Term) -> bool:
    return isinstance(exponent, Number) and exponent.value < 0
