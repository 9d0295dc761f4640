"""Decision of entries with definitions in Python: their singular parts are unknown, and their condition is stated.

Here an overlap of balls is an equality, and generic values in a frame prove. No other module needs this one.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import chain, islice
from math import lcm
from typing import Any

from ...algebra.element import NotExactError
from ..language.environment import Env
from ..language.printed import Symbol, Term, Trait, symbols, takes_apart, with_trait
from ..numbers.balls import PRECISIONS, Ball, Balls, BlurredError, arb, precision
from ..numbers.fields import Constants, Field
from ..numbers.generic import Generic
from ..numbers.kinds import BRANCH, ORDER, Numbers
from ..result import Status
from .claim import Claim, Place, RefusedError, kind
from .finding import Finding, Outcome, contradicted
from .identity import steps_of
from .places import Probe
from .singular import singular

WAYS: tuple[Mapping[str, bool], ...] = ({}, {"turning": True}, {"framed": False})
"""Generic values: a vector's magnitude as the tangent of an angle, as an angle, and free components."""


class Loose(Balls):
    """Balls whose overlap is an equality, and where a dual vector always has a magnitude."""

    @property
    def certain(self) -> Loose:
        return self

    def compared(self, test: Any, a: Any, b: Any) -> bool:
        a = Ball(arb(a))
        return test.__name__ in ("le", "ge") if a.overlaps(b) else super().compared(test, a, b)

    def magnitude(self, v: Any) -> Any:
        return Field.magnitude(self, v)


@dataclass(frozen=True)
class OfPython(Claim):
    """Claim of an entry in Python."""

    @property
    def constraints(self) -> tuple[Term, ...]:
        return ()

    def env(self, place: Place, field: Field | None = None) -> Env:
        return super().env(place, field or Loose())

    def value(self, letter: Symbol, place: Place, field: Field | None = None) -> Any:
        return super().value(letter, place, None if isinstance(field, Loose) else field)

    def with_statement(self, statement: Term) -> OfPython:
        return replace(self, statement=statement)

    def truth(self, place: Place, statement: Term | None = None) -> bool | None:
        part = self.statement if statement is None else statement
        try:
            found: bool | None = self.evaluated(place, part, bool)
        except BlurredError:
            if not place.exact:
                raise
            try:
                with precision(PRECISIONS[0]):
                    return bool(self.env(place, Constants()).value(part))
            except (ArithmeticError, TypeError, AttributeError) as error:
                raise BlurredError from error
        return found


class Few(Probe):
    """Source of few points of a claim at fixed orders, branches and signs."""

    def __init__(self, claim: Claim, fixed: dict[Symbol, int], label: str) -> None:
        super().__init__(claim)
        self.fixed, self.label = fixed, label

    def _drawn(self, letter: Symbol, low: float, high: float) -> Numbers:
        found = super()._drawn(letter, low, high)
        return [abs(c) for c in found] if kind(letter).forward else found

    def _discrete(self) -> dict[Symbol, Any]:
        return dict(self.fixed)

    def all(self) -> Iterator[Place]:
        stages = chain(
            islice(self._short(), 1), islice(self._generic(), 2), self._special(), self._given(), self._related(),
            self._zeros(), islice(self._wide(), 4, 5), islice(self._pairs(), 8),
        )  # fmt: skip
        return self._moved(replace(place, label=f"{self.label}{place.label}") for place in stages)

    def _zeros(self) -> Iterator[Place]:
        entry = self.claim.entry
        stated = [] if entry.condition is None else list(singular(entry.condition))
        for part in singular(*self.claim.parts):
            used = symbols(part.part)
            if part in stated or entry.definitions.keys().isdisjoint(used):
                for letter in (a for a in self.claim.letters if a in used and a in self.claim.coordinates):
                    for line in islice(self._lines(letter, part.part), 1):
                        yield from (place for place in line.places(part)[1] if "between" not in place.label)


def places(claim: Claim) -> Iterator[Place]:
    """Yield the points of a claim, for each order, branch and sign in turn."""
    for fixed in claim.choices:
        order = next((f"n = {n}, " for a, n in fixed.items() if a.quantity is ORDER), "")
        yield from Few(claim, fixed, order).all()


def decided(claim: Claim) -> Finding:
    """Return the decision of a claim whose condition is stated; it must be true inside and not outside."""
    claim = OfPython(claim.entry, claim.statement, claim.orders)
    entry, beyond = claim.entry, Outcome()

    def inside() -> Iterator[Place]:
        for place in places(claim):
            if entry.condition is None or _truth(claim, entry.condition, place):
                yield place
            else:
                beyond.add(_truth(claim, claim.statement, place), place)

    at = Outcome().tried(claim, inside(), lambda outcome: bool(outcome.false or outcome.undefined))
    if failing := (*at.false, *at.undefined):
        value = "false" if at.false else "no value"
        return Finding(Status.FALSE, f"refuted at {failing[0].label}: {value}", at.points, failing=failing[0])
    if not at.points or (entry.condition is not None and not beyond.points):
        sides = "both sides" if at.points else "the inside"
        return Finding(Status.UNDECIDED, f"no point on {sides} of its domain")
    if wrong := contradicted(claim, beyond):
        return Finding(Status.UNDECIDED, wrong)
    exact = proved(claim)
    method = _method(claim, exact, at.points)
    if beyond.true:
        method += f"; also true at {beyond.true[0].label}"
    status = Status.HOLDS if entry.condition is None else Status.HOLDS_IF
    if exact is None and not entry.argument:
        status = Status.UNREFUTED
    return Finding(status, method, at.points, true=tuple(at.true))


def supported(claim: Claim) -> str:
    """Return why a supporting identity is not proved; points where it is undefined are ignored."""
    claim = OfPython(claim.entry, claim.statement, claim.orders)
    at = Outcome().tried(claim, places(claim), lambda outcome: bool(outcome.false))
    return f"false at {at.false[0].label}" if at.false else "" if proved(claim) else "not exact"


def _truth(claim: Claim, statement: Term, place: Place) -> bool | None:
    with suppress(BlurredError):
        return claim.truth(place, statement)
    return None


def _method(claim: Claim, exact: str | None, points: int) -> str:
    """Return the method in words. A delicate statement proved at generic values may fail at special ones."""
    entry, tried = claim.entry, f"true at {points} points"
    supported = ", with a supporting identity proved exactly" if entry.because not in (None, claim.statement) else ""
    if exact is None and entry.argument:
        return f"proved by the argument in {entry.argument} from identities proved exactly; {tried} besides"
    if exact is None:
        return f"evidence: {points} points{supported}"
    if any(entry.free(part) for part in with_trait(Trait.DELICATE, claim.statement)):
        return f"{exact} where symbols are generic, {tried}{supported}"
    return f"{exact}{supported}"


def proved(claim: Claim) -> str | None:
    """Return for which orders a claim is proved, as "exact …", or None."""
    order = next((a for a in claim.letters if a.quantity is ORDER), None)
    branch = next((a for a in claim.letters if a.quantity is BRANCH), None)
    for way in WAYS if not claim.entry.components else WAYS[2:]:
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


def _proved_at(
    claim: Claim, way: Mapping[str, bool], fixed: Mapping[Symbol, int], order: Symbol | None
) -> bool:
    """Return whether the generic values lie in the domain; if they do, raise unless the claim is true there."""
    lengths = {a for part in with_trait(Trait.LENGTH, *claim.parts) for a in claim.entry.free(part)}
    letters = sorted(claim.coordinates, key=lambda a: a not in lengths)  # only the first has a rational magnitude
    steps = lcm(steps_of(claim.statement), *(4 * n for a, n in fixed.items() if a.quantity is ORDER))
    dual = claim.dual and takes_apart(claim.statement, *claim.entry.definitions)
    generic = Generic(letters, dual, claim.depth, steps, order=order, **way)
    for branch, k in fixed.items():
        if branch.quantity is BRANCH:
            generic.fix_branch(branch, k)
    env = Env(generic.field, generic.values | dict(fixed), claim.entry.definitions, generic.dual, claim.depth)
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
    if not true and not field.branched:
        raise RefusedError("true at all points but false exactly")
    if not true:
        raise NotExactError("other roots")
