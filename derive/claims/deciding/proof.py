"""Proof of a claim at generic values of an exact field, which decides it for all values at once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from math import lcm, prod
from typing import Any

from ...algebra.element import NotExactError
from ..language.environment import Env
from ..language.operator_table import over
from ..language.printed import Number, Symbol, Term, Trait, takes_apart, with_trait
from ..numbers.generic import Generic, Ideal
from ..numbers.kinds import BRANCH, ORDER
from .claim import Claim, operators
from .constrained import gaps

WAYS: tuple[Mapping[str, bool], ...] = ({}, {"turning": True}, {"framed": False})
"""Generic values: a vector's magnitude as the tangent of an angle, as an angle, and free components."""
COMPONENTWISE = frozenset(("vector", "matrix", "block", "entry", "kron", "vec", "zeros"))
"""First words of operators that depend on the frame."""


class ContradictionError(Exception):
    """Error for a claim that is true at all points and false exactly."""


def proved(claim: Claim) -> str | None:
    """Return for which orders a claim is proved, as "exact …", or None."""
    order = next((a for a in claim.letters if a.quantity is ORDER), None)
    branch = next((a for a in claim.letters if a.quantity is BRANCH), None)
    for way in WAYS if _frame_is_free(claim) else WAYS[2:]:
        for every in (True, False) if order is not None and branch is None else (False,):
            choices = _without(order, claim.choices) if every else claim.choices
            try:
                inside = [_proved_at(claim, way, fixed, order if every else None) for fixed in choices]
            except NotExactError:
                continue
            if any(inside):
                orders = "all n" if every else f"n = {', '.join(map(str, dict.fromkeys(c[order] for c in choices)))}" \
                    if order is not None else ""  # fmt: skip
                return ", ".join(filter(None, ("exact", orders)))
    return None


def _without(order: Symbol | None, choices: tuple[dict[Symbol, int], ...]) -> list[dict[Symbol, int]]:
    found: list[dict[Symbol, int]] = []
    for fixed in choices:
        rest = {a: value for a, value in fixed.items() if a != order}
        if rest not in found:
            found.append(rest)
    return found


def _frame_is_free(claim: Claim) -> bool:
    """Return whether a frame may be chosen along the vectors."""
    if claim.entry.components or claim.constraints:
        return False
    return not claim.entry.of_file or COMPONENTWISE.isdisjoint(
        name.split()[0] for name in operators(*claim.parts) if name)  # fmt: skip


def _proved_at(
    claim: Claim, way: Mapping[str, bool], fixed: Mapping[Symbol, int], order: Symbol | None
) -> bool:
    """Return whether the generic values lie in the domain; if they do, raise unless the claim is true there."""
    lengths = {a for part in with_trait(Trait.LENGTH, *claim.parts) for a in claim.entry.free(part)}
    letters = sorted(claim.coordinates, key=lambda a: a not in lengths)  # only the first has a rational magnitude
    steps = lcm(steps_of(claim.statement), *(4 * n for a, n in fixed.items() if a.quantity is ORDER))
    dual = claim.dual and takes_apart(claim.statement, *claim.constraints, *claim.entry.definitions)
    generic = Generic(letters, dual, claim.depth, steps, order=order, **way)
    for branch, k in fixed.items():
        if branch.quantity is BRANCH:
            generic.fix_branch(branch, k)
    env = Env(generic.field, generic.values | dict(fixed), claim.entry.definitions, generic.dual, claim.depth)
    if claim.constraints:
        equations = [generic.field.functions.element(c) for c in gaps(env, claim.constraints)]
        generic.field.ideal = Ideal([equation for equation in equations if equation])
    if not _inside(claim, env):
        return False
    _require(claim, env)
    return True


def _inside(claim: Claim, env: Env) -> bool:
    try:
        return all(env.value(part) for part in claim.parts[1:])
    except NotExactError:
        return True
    except ArithmeticError:
        return False


def _require(claim: Claim, env: Env) -> None:
    """Raise unless the statement is true at generic values, by roots and angles that are those at all points."""
    field: Any = env.field
    try:
        true = replace(env, values=dict(env.values)).value(claim.statement)
    except NotExactError:
        raise
    except (ArithmeticError, TypeError) as error:
        raise NotExactError("no generic value") from error
    if not true and not (field.branched or claim.constraints):
        raise ContradictionError("true at all points but false exactly")
    if not true or (field.branched and claim.entry.of_file):
        raise NotExactError("other roots")


def steps_of(statement: Term) -> int:
    """Return an integer M such that the statement contains only multiples of α/M, for each free angle α."""
    return 2 * lcm(2, divisor(statement))


def divisor(statement: Term) -> int:
    """Return a multiple of all divisors in a statement, and of their products within an argument, as 4 of ``x/2/2``."""

    def of(node: Term) -> int:
        below = [of(a) for a in node.arguments]
        if Trait.TRANSCENDENTAL in node.operator.traits:
            found.extend(below)
            return 1
        if node.operator is over and isinstance(number := node.arguments[1], Number) and number.value:
            found.append(abs(number.value))
            return below[0] * abs(number.value)
        return prod(below) if node.operator.name == "times" else lcm(1, *below)

    found: list[int] = [1]
    of(statement)
    return lcm(*found)
