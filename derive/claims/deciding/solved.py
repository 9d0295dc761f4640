"""Equations of a stated domain, solved for letters: a claim about the letters that are left says as much."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import reduce

from ..language.matrices import unlike, zeros
from ..language.operations import written
from ..language.operator_table import Du, Re, both, dot, dyad, epsilon, equal, identity, nonzero, skew, trace, vect
from ..language.printed import Number, Symbol, Term, symbols
from ..numbers.kinds import KINDS
from .claim import Claim, kind
from .terms import conjuncts, whole

PARTS = {
    "dual number": "real", "angle": "real angle", "dual vector": "real vector", "tensor": "tensor 3x3",
    "quaternion": "real quaternion of a letter",
}  # fmt: skip
"""Kinds of the real and dual parts of letters, where both are free."""


def with_solved_equations(claim: Claim, *further: Term) -> tuple[Claim, tuple[Term, ...]]:
    """Return a claim and further terms with expressions for the letters for which its domain is solved.

    A dual letter without real part is ε times a real one; one without dual part is real. One whose parts alone occur is
    two real letters. The trace of a rotation tells the identity and half turns.
    """
    domain = claim.domain
    for part in domain:
        if (values := next(_solutions(claim, part), None)) is not None:
            rest = [one.xreplace(values) for one in domain if one is not part]
            solved = claim.on(reduce(both, rest) if rest else None).with_statement(claim.statement.xreplace(values))
            return with_solved_equations(solved, *(one.xreplace(values) for one in further))
    parts = {part(a): _part(part, a) for a in claim.coordinates if a.quantity.name in PARTS for part in (Re, Du)}
    taken = {a for part in (claim.statement, *domain, *further) for a in symbols(part.xreplace(parts))}
    parts = {part: letter for part, letter in parts.items() if part.arguments[0] not in taken}
    apart = claim.on(reduce(both, [one.xreplace(parts) for one in domain]) if domain else None)
    return apart.with_statement(claim.statement.xreplace(parts)), tuple(one.xreplace(parts) for one in further)


def _solutions(claim: Claim, part: Term) -> Iterator[Mapping[Term, Term]]:
    """Yield what an equation puts in the place of a letter, and of its parts."""
    if part.operator.name != "equal" or len(part.arguments) != 2:
        return
    a, b = part.arguments
    if a.operator.name in ("plus", "minus") and isinstance(a.arguments[1], Number) and b == Number(0):
        a, b = a.arguments[0], -a.arguments[1] if a.operator.name == "plus" else a.arguments[1]
    for side, value in ((a, b), (b, a)):
        is_part = side.operator in (Re, Du) and isinstance(side.arguments[0], Symbol)
        letter = side.arguments[0] if is_part else side
        if (turned := _rotated(side, trace)) in claim.coordinates:
            yield from (values for end, values in _rotations(turned) if value == end)
        if letter not in claim.coordinates or kind(letter).free or kind(letter).spread:
            continue
        name = letter.quantity.name
        if is_part and name in PARTS and value == Number(0):
            left, zero = _part(Du if side.operator is Re else Re, letter), zero_like(letter)
            if side.operator is Re:
                known = {unlike(letter, 0): unlike(left, 0), nonzero(letter): nonzero(left)}
                yield {**known, Re(letter): zero, Du(letter): left, letter: epsilon * left}
            else:
                yield {Re(letter): left, Du(letter): zero, letter: left}
        value = zero_like(letter) if value in (Number(0), Number(0) * letter) else value
        if not is_part and letter not in symbols(value):
            yield {letter: value}


def symmetric(premise: Term) -> list[Term]:
    """Return the equations for the trace of a rotation, one of which is true where its vector is 0."""
    if premise.operator.name != "equal" or premise.arguments[1:] != (Number(0),):
        return []
    side = premise.arguments[0]
    letter = _rotated(side, vect)
    real = letter is not side and (not kind(letter).dual or Re in (side.operator, side.arguments[0].operator))
    return [equal(Re(trace(letter)), end) for end in (3, -Number(1))] if real else []


def _rotated(side: Term, operator: Callable[[Term], Term]) -> Term:
    """Return the letter of a rotation of which, or of whose real part, a side is a function; else the side."""
    inner = whole(side)
    letter = whole(inner.arguments[0]) if inner.operator is operator else side
    return letter if isinstance(letter, Symbol) and letter.quantity.name in ("rotation", "orthogonal tensor") else side


def _rotations(letter: Symbol) -> Iterator[tuple[Term, Mapping[Term, Term]]]:
    """Yield the greatest and the least trace of a rotation, with its value there and that of its vector."""
    axis = Symbol(f"axis of {letter.name}", "real unit vector")
    moment = Symbol(f"moment of {letter.name}", "real vector")
    dual, none = kind(letter).dual, zeros(Number(3), Number(1))
    shift = identity + epsilon * skew(moment) if dual else identity
    for end, turned, slope in (
        (Number(3), shift, moment), (-Number(1), shift * (2 * dyad(axis, axis) - identity), -dot(axis, moment) * axis),
    ):  # fmt: skip
        parts = {Re(vect(letter)): none, Du(vect(letter)): slope, vect(letter): epsilon * slope}
        yield end, {**(parts if dual else {vect(letter): none}), letter: turned}


def _part(operator: Callable[[Term], Term], letter: Symbol) -> Symbol:
    """Return the real letter for the real or dual part of a letter."""
    return Symbol(written(operator(letter)), PARTS[letter.quantity.name])


def zero_like(letter: Symbol) -> Term:
    """Return the zero of a letter's kind; 0 for a kind without a matrix, which 0 equals too."""
    rows = {3: (3, 1), 4: (3, 1), 6: (6, 1), 9: (3, 3)}.get(kind(letter).size)
    zero: Term = Number(0) if rows is None else zeros(*map(Number, rows))
    return Number(0) + zero if kind(letter).size == 4 else zero


def with_vectors_for_lengths(domain: Term) -> Term:
    """Return a domain with ``v == 0`` for ``norm(v) == 0`` and ``dot(v, v) == 0``, which have no derivative there.

    Likewise ``re(a) == 0`` stands for ``re(norm(a)) == 0``.
    """
    sides = (part.arguments for part in conjuncts(domain) if part.operator.name == "equal")
    known = {equal(a, 0): equal(b, 0) for a, *rest in sides if rest == [Number(0)] and (b := _base(a)) is not None}
    plain: Term = domain.xreplace(known)
    return plain


def _base(part: Term) -> Term | None:
    """Return the vector of which a term is the magnitude or its square, if both are 0 together."""
    name, arguments = part.operator.name, part.arguments
    if part.operator is Re:
        inner = arguments[0]
        return Re(inner.arguments[0]) if inner.operator.name == "norm" and _is_letter(inner.arguments[0]) else None
    base = arguments[0] if name == "norm" or (name == "dot" and arguments[0] == arguments[1]) else None
    real = base is not None and (base.operator in (Re, Du) or (_is_letter(base) and not kind(base).dual))
    return base if real else None


def _is_letter(part: Term) -> bool:
    return isinstance(part, Symbol) and part.quantity.name in KINDS
