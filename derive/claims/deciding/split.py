"""Claims that together say what one claim says: without conjunctions, implications, negations and values by cases."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import reduce

from ..language.matrices import distance, either, unlike
from ..language.operator_table import Re, both, cross, equal, every, implies, negated
from ..language.printed import Apply, Number, Term, Trait, rate_depth, symbols, walk
from ..language.substitution import each
from .claim import Claim
from .identity import contradicts_itself, vanishes_without
from .solved import PARTS, symmetric
from .terms import is_dual, magnitudes

CASES = "cases"
"""First letters of the names of operators whose value depends on conditions."""


def split(claim: Claim) -> Iterator[Claim]:
    """Yield the claims that are true together where a claim is."""
    statement = claim.statement
    if statement.operator in (implies, negated) and is_for_an_instant(statement):
        yield claim
    elif statement.operator is implies:
        premise, conclusion = statement.arguments
        yield from split(claim.within(affirmed(_one_by_one(premise))).with_statement(conclusion))
    elif statement.operator is negated and statement.arguments[0].operator is both:
        first, *rest = statement.arguments[0].arguments
        yield from split(claim.within(affirmed(first)).with_statement(negated(reduce(both, rest))))
    elif Trait.JOINS in statement.operator.traits:
        for part in statement.arguments:
            yield from split(claim.with_statement(part))
    elif (plain := affirmed(statement)) != statement:
        yield from split(claim.with_statement(plain))
    elif (node := next(_by_cases(statement), None)) is not None:
        for value, given in _arms(node):
            yield from split(claim.within(*given).with_statement(statement.xreplace({node: value})))
    elif (kink := next(_kinks(claim), None)) is not None:
        for given in (unlike(kink, 0), equal(kink, 0)):
            yield from split(claim.within(given))
    else:
        domain = claim.domain
        many = next((part for part in domain if _alternatives(part)), None)
        for alternative in [] if many is None else _alternatives(many):
            yield from split(claim.on(reduce(both, [alternative if part is many else part for part in domain])))
        if many is None and not _is_empty(domain) and not contradicts_itself(claim):
            yield claim


def is_for_an_instant(statement: Term) -> bool:
    """Return whether a premise may be true at an instant alone, so that it tells nothing of the rates asked for."""
    premise = statement.arguments[0] if statement.operator is implies else statement
    closed = (node for node in walk(premise) if node.operator.name in ("equal", "at most", "at least"))
    return any(rate_depth(node) < rate_depth(statement) for node in closed)


def _alternatives(premise: Term) -> list[Term]:
    """Return the premises of which one or the other says as much as a premise."""
    if premise.operator is either:
        return list(map(affirmed, premise.arguments))
    if premise.operator is implies:
        first, rest = premise.arguments
    elif premise.operator is negated and premise.arguments[0].operator is both:
        first, *others = premise.arguments[0].arguments
        rest = negated(reduce(both, others))
    else:
        return symmetric(premise)
    return [affirmed(negated(first)), affirmed(both(first, rest))]


def _is_empty(parts: Sequence[Term]) -> bool:
    """Return whether a domain says that one difference is 0, and is not 0."""
    zeros, others = ({_gap(part) for part in parts if part.operator.name in names}
                     for names in (("equal",), ("unlike", "nonzero")))  # fmt: skip
    return not zeros.isdisjoint(others)


def _gap(relation: Term) -> tuple[Term, ...]:
    a, *rest = relation.arguments
    return _base(a), *(b for b in rest if b != Number(0))


def _base(part: Term) -> Term:
    """Return the vector or number that is 0 where a real magnitude is."""
    inner = part.arguments[0] if part.arguments else part
    if part.operator is Re and inner.operator.name == "norm":
        return Re(inner.arguments[0])
    return inner if part.operator.name == "norm" and not is_dual(inner) else part


def affirmed(statement: Term) -> Term:
    """Return a statement with the relations that negations of relations say."""
    if statement.operator is both:
        return reduce(both, map(affirmed, statement.arguments))
    opposite = _opposite(statement.arguments[0]) if statement.operator is negated else None
    return statement if opposite is None else opposite


def _one_by_one(premise: Term) -> Term:
    """Return a premise with its relations for each number in place of those for every one."""
    if premise.operator is both:
        return reduce(both, map(_one_by_one, premise.arguments))
    parts = each(premise) if premise.operator is every else None
    return reduce(both, map(_one_by_one, parts)) if parts else premise


def _opposite(relation: Term) -> Term | None:
    name, arguments = relation.operator.name, relation.arguments
    if name == "equal" and len(arguments) == 2:
        return unlike(*arguments)
    if name in ("unlike", "nonzero"):
        return equal(*arguments) if len(arguments) == 2 else equal(arguments[0], Number(0))
    return relation.arguments[0] if relation.operator is negated else None


def _by_cases(statement: Term) -> Iterator[Term]:
    """Yield the values by cases in a statement, but for those inside of sums and derivatives, outer ones first."""
    if isinstance(statement, Apply) and Trait.RATE not in statement.operator.traits:
        if statement.operator.name.startswith(CASES):
            yield statement
        elif not statement.operator.lazy:
            for part in statement.arguments:
                yield from _by_cases(part)


def _kinks(claim: Claim) -> Iterator[Term]:
    """Yield terms with another formula where they are 0, unless the domain tells whether they are.

    They are the normal of two lines with a distance, and real parts of letters without which a magnitude is 0.
    """
    bent = magnitudes(claim.statement)
    known = {_gap(part) for part in claim.domain if part.operator.name in ("equal", "unlike", "nonzero")}
    for node in walk(claim.statement):
        found = [cross(*map(Re, node.arguments))] if node.operator is distance else []
        if node in bent:
            letters = [a for a in symbols(node.arguments[0]) if a.quantity.name in PARTS]
            found = [Re(a) for a in letters if vanishes_without(node.arguments[0], a)]
        yield from (kink for kink in found if (kink,) not in known)


def _arms(node: Term) -> Iterator[tuple[Term, tuple[Term, ...]]]:
    """Yield the values of a term by cases, each with what is given there."""
    arms = node.arguments
    given: list[Term] = []
    for value, condition in zip(arms[::2], arms[1::2], strict=False):
        yield value, (*given, affirmed(condition))
        given.append(_opposite(condition) or negated(condition))
    if len(arms) % 2:
        yield arms[-1], tuple(given)
