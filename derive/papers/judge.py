"""Decision of a claim whose condition is found: refuted at points, proved at generic values, or true on a region."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import islice, product
from math import lcm
from typing import Any

from ..algebra.element import Element, NotExactError
from ..algebra.mixed import MeaninglessError
from .changes import changes, signs_and_coefficients
from .claim import Claim, Place, RefusedError, kind, operators
from .conditions import REGION_MIN, Region, branched, exclusions, plain, region
from .constrained import gaps
from .equation import Entry
from .explore import sides
from .language.environment import Env
from .language.operator_table import both, implies, over
from .language.printed import Number, Symbol, Term, Trait, walk, with_trait
from .language.values import coefficients
from .language.written import written
from .numbers.balls import Ball, BlurredError, precision
from .numbers.fields import Exact
from .numbers.generic import STEPS, Generic
from .numbers.ideal import Ideal
from .numbers.quantities import ORDER, SIGN
from .probe import ORDERED, Probe
from .result import Counterexample, Result, Status, Verdict

WAYS: tuple[Mapping[str, bool], ...] = ({}, {"turning": True}, {"framed": False})
"""Generic values: a vector's magnitude as the tangent of an angle, as an angle, and free components."""
COMPONENTWISE = frozenset(("matrix", "block", "entry", "kron", "vec", "zeros", "K10"))
"""First words of operators that depend on the frame."""
CHANGES_MAX, CANDIDATES_MAX, SAMPLE = 3, 400, 6
"""Changes shown, changes tried, and points at which a changed claim is tried first."""


ORDERS = (1, 2, 3, 4, 5)
Pairs = list[tuple[Any, Any]]
"""Pairs of equal numbers in one exact field."""
POINTS_MIN = 6
"""Least number of points at which a claim is called true."""


@dataclass(frozen=True)
class Outcome:
    """Points at which a claim is true, is false, or has no value, and the number of those that did not tell."""

    true: list[Place]
    false: list[Place]
    undefined: list[Place]
    blurred: int


@dataclass(frozen=True)
class Finding:
    """Decision of one claim."""

    status: Status
    method: str
    points: int = 0
    certainty: str = ""
    found: str = ""
    cuts: str = ""
    failing: Place | None = None  # where the claim is false
    outside: Place | None = None  # where it has no value, or is on another branch
    true: tuple[Place, ...] = ()

    @property
    def holds(self) -> bool:
        return self.status in (Status.HOLDS, Status.HOLDS_IF)


def judge_claim(paper: str, entry: Entry, early: Callable[[Result], None] = lambda result: None) -> Result:
    """Return the result of an entry with one reading and no stated condition; ``paper`` is the paper's slug.

    `early` receives the result before the search for changes, terms and constraints, which may take long.
    """
    statement = entry.readings[0].statement
    claim = _premised(Claim(entry, statement))
    finding = decided(claim)
    status, method = finding.status, finding.method
    if status is Status.FALSE and entry.corrected is not None:
        correction = decided(claim.with_statement(entry.corrected))
        if correction.holds:
            status, method = Status.ERRATUM, f"{method}; correction {correction.method}"
        else:
            method += f"; the correction does not hold: {correction.method}"
    example = witness(claim, finding)
    verdict = Verdict(statement, "", finding.holds, finding.method, None if finding.holds else example)
    result = Result(
        paper, entry, status, method, (verdict,), certainty=finding.certainty, points=finding.points,
        found=finding.found, outside=example if finding.holds else None, cuts=finding.cuts,
    )  # fmt: skip
    early(result)
    if finding.holds:
        return replace(result, vacuous=tuple(dict.fromkeys(_vacuous(claim, finding))), needs=tuple(_needed(claim)))
    return replace(result, changes=tuple(_mended(claim, finding))) if status is Status.FALSE else result


def _premised(claim: Claim) -> Claim:
    """Return the claim with the premise of an implication as part of the stated domain."""
    while claim.statement.operator is implies:
        premise, statement = claim.statement.arguments
        claimed = premise if claim.entry.claimed is None else both(claim.entry.claimed, premise)
        claim = Claim(replace(claim.entry, claimed=claimed), statement)
    return claim


def decided(claim: Claim) -> Finding:
    """Return the decision of a claim, without what makes it true or vacuous."""
    try:
        return _decided(claim)
    except RefusedError as error:
        return Finding(Status.UNDECIDED, str(error))
    except (MeaninglessError, NotExactError, RecursionError, OverflowError) as error:
        return Finding(Status.UNDECIDED, f"it cannot be evaluated: {error}")


def _decided(claim: Claim) -> Finding:
    choosing = branched(*claim.parts) and ORDERED.isdisjoint(operators(claim.statement))
    outcome: dict[bool | None, list[Place]] = {True: [], False: [], None: []}
    blurred = 0
    probe = Probe(claim)
    for place in probe.all():
        try:
            outcome[claim.truth(place)].append(place)
        except BlurredError:
            blurred += 1
        if not choosing and outcome[False]:
            break
    true, false, undefined = outcome[True], outcome[False], outcome[None]
    points = len(true) + len(false) + len(undefined)
    if blurred and not points:
        return Finding(Status.UNDECIDED, f"numbers at {blurred} points are too large or too uncertain to tell")
    if points < POINTS_MIN and not false:
        stated = claim.entry.claimed is not None
        few = f"only {points} of the points tried" if points else "no point tried"
        return Finding(Status.UNDECIDED, f"{few} {'in' if stated else 'outside'} the stated domain", points)
    known = any(place.generic for place in (*true, *false)) or not any(place.generic for place in undefined)
    if not known and not false:
        return Finding(Status.UNDECIDED, f"it has no value at generic points, of {points} points in all", points)
    within, cuts = None, ""
    if false:
        cuts = f"{len(false)} of {len(true) + len(false)} points fail"
        if choosing and sum(place.generic for place in true) >= REGION_MIN:
            within, sharp = region(claim, true, false)
            cuts += f", all outside {within.words}" if within and sharp else ""
        if within is None:
            method, cuts = f"refuted at {false[0].label}", cuts * choosing
            return Finding(Status.FALSE, method, points, "exact", cuts=cuts, failing=false[0])
    return _true(probe, Outcome(true, false, undefined, blurred), within, cuts)


def _true(probe: Probe, at: Outcome, within: Region | None, cuts: str) -> Finding:
    """Return the finding for a claim that is true on a region, or wherever it has a value."""
    claim = probe.claim
    inside = [place for place in at.undefined if within is None or within.test(place)]
    border = within is not None and any(within.test(place) is None for place in at.undefined)
    found = exclusions(claim, inside)
    parts = [within.strict if border else within.words] if within else []
    condition = " and ".join(dict.fromkeys([*parts, *(plain(probe, requirement) for requirement in found)]))
    ordered = not ORDERED.isdisjoint(operators(claim.statement))  # generic values tell nothing of an order
    exact = not (at.false or ordered) and proved(claim)
    points = len(at.true) + len(at.false) + len(at.undefined)
    evidence = f"evidence: {points} points" + f", {at.blurred} more too close to tell" * bool(at.blurred)
    outside = next(iter((*found.values(), *at.undefined, *at.false)), None)
    status = Status.HOLDS_IF if condition else Status.HOLDS
    method, certainty = ("exact", "exact") if exact else (evidence, "evidence")
    return Finding(status, method, points, certainty, condition, cuts, None, outside, tuple(at.true))


# ---- proof ------------------------------------------------------------------------------------------------------


def proved(claim: Claim, found: list[Pairs] | None = None) -> bool:
    """Return whether a claim is true at generic values of an exact field, whose roots are positive everywhere.

    If `found` is a list, fractions are not reduced, and it receives the pairs of equal numbers for each choice.
    """
    order = next((a for a in claim.letters if a.quantity is ORDER), None)
    sign = next((a for a in claim.letters if a.quantity is SIGN), None)
    framed = COMPONENTWISE.isdisjoint(name.split()[0] for name in operators(*claim.parts) if name)
    for way in WAYS if framed and not claim.constraints else WAYS[2:]:
        for every in (True, False) if order is not None else (False,):
            choices = product((None,) if every or order is None else ORDERS, (1, -1) if sign else (1,))
            discrete = [{a: b for a, b in ((order, n), (sign, s)) if a and b} for n, s in choices]
            if found is not None:
                found.clear()
            try:
                if all(_exact(claim, way, values, order if every else None, found) for values in discrete):
                    return True
            except NotExactError:
                continue
    return False


def _exact(
    claim: Claim, way: Mapping[str, bool], discrete: dict[Symbol, int], order: Symbol | None, found: list[Pairs] | None
) -> bool:
    lengths = {a for part in with_trait(Trait.LENGTH, *claim.parts) for a in claim.entry.free(part)}
    letters = sorted(claim.coordinates, key=lambda a: a not in lengths)
    steps = max(STEPS, steps_of(claim.statement), *(4 * n for a, n in discrete.items() if a.quantity is ORDER), 0)
    generic = Generic(letters, claim.dual, claim.depth, steps, order=order, **way)
    generic.field.functions.lowest_terms = found is None
    pairs: Pairs | None = None if found is None else []
    env = Env(generic.field, generic.values | discrete, claim.entry.definitions, claim.dual, claim.depth)
    if claim.constraints:
        equations = [generic.field.functions.element(c) for c in gaps(env, claim.constraints)]
        generic.field.ideal = Ideal([equation for equation in equations if equation])
    try:
        if claim.entry.claimed is not None and not env.value(claim.entry.claimed):
            return False
    except NotExactError:
        pass
    try:
        if not replace(env, found=pairs).value(claim.statement):
            raise NotExactError("other roots")
    except (ArithmeticError, TypeError) as error:
        raise NotExactError("no generic value") from error
    if found is not None:
        found.append(pairs or [])
    return not generic.field.branched


def steps_of(statement: Term) -> int:
    """Return an integer M such that the statement contains only multiples of α/M, for each free angle α."""
    divisors = [node.arguments[1] for node in walk(statement) if node.operator is over]
    return 2 * lcm(2, *(d.value for d in divisors if isinstance(d, Number)))


# ---- what makes a claim true, or vacuous ------------------------------------------------------------------------


def _expanded(claim: Claim, statement: Term) -> Claim:
    """Return the claim of a statement in which abbreviations of the file occur by name."""
    return claim.with_statement(claim.entry.expanded(statement))


def _true_at(claim: Claim, places: Sequence[Place]) -> bool:
    """Return whether a claim is true at all points where it has a value, and has one somewhere."""
    somewhere = False
    for place in places:
        try:
            truth = claim.truth(place)
        except (TypeError, AttributeError, ValueError, IndexError, ArithmeticError, BlurredError):
            return False
        if truth is False:
            return False
        somewhere |= truth is True
    return somewhere


def _mended(claim: Claim, finding: Finding) -> Iterator[str]:
    """Yield the changes in one step that make a false claim true."""
    sample = list(islice(Probe(claim).quick(), SAMPLE))
    first = [finding.failing] if finding.failing else []
    shown: set[str] = set()  # one change of each sort, since changes of one sort are often equivalent
    for _, sort, words, changed in changes(claim.entry.written or claim.statement, written)[:CANDIDATES_MAX]:
        other = _expanded(claim, changed)
        wanted = sort not in shown and len(shown) < CHANGES_MAX
        if wanted and _true_at(other, [*first, *sample]) and decided(other).holds:
            shown.add(sort)
            yield f"{words}: {written(changed)}"


def _vacuous(claim: Claim, finding: Finding) -> Iterator[str]:
    """Yield the terms of a true claim whose sign or coefficient does not matter."""
    for words, changed in signs_and_coefficients(claim.entry.written or claim.statement, written):
        if _true_at(_expanded(claim, changed), finding.true):
            yield words


def _needed(claim: Claim) -> Iterator[str]:
    """Yield the constraints of letters without which a true claim is false."""
    for letter in claim.coordinates:
        row = kind(letter)
        if row.free and row.needs:
            name = f"constant {row.free}" if row.constant else row.free
            free = Symbol(letter.name, name, *map(str, letter.args[2:]))
            other = Claim(_relaxed(claim.entry, {letter: free}), claim.statement.xreplace({letter: free}))
            if not _true_at(other, list(Probe(other).quick())):
                yield row.needs.format(letter.name)


    for constraint in claim.constraints:
        other = Claim(replace(claim.entry, claimed=None), claim.statement)
        if not _true_at(other, list(Probe(other).quick())):
            yield written(constraint)


def _relaxed(entry: Entry, free: Mapping[Symbol, Symbol]) -> Entry:
    return replace(entry, claimed=None if entry.claimed is None else entry.claimed.xreplace(free))


# ---- counterexamples --------------------------------------------------------------------------------------------


def witness(claim: Claim, finding: Finding) -> Counterexample | None:
    """Return the point where a claim is false, or a point outside its condition."""
    if finding.failing is not None:
        return _counterexample(claim, finding.failing)
    outside = finding.outside
    return None if outside is None else _counterexample(claim, outside, _outside(claim, outside))


def first_failure(claim: Claim) -> Counterexample | None:
    """Return the first point at which a claim is false or has no value, if it can be evaluated at points."""
    with suppress(RefusedError, MeaninglessError, NotExactError, BlurredError):
        for place in Probe(claim).all():
            if not claim.truth(place):
                return _counterexample(claim, place, _outside(claim, place).partition(" at ")[2])
    return None


def _outside(claim: Claim, place: Place) -> str:
    where = place.on or place.label
    admits = ", which the stated domain admits" if claim.entry.claimed is not None else ""
    undefined = claim.truth(place) is None
    return f"{'undefined' if undefined else 'false'} at {where}{admits}"


def _counterexample(claim: Claim, place: Place, words: str = "") -> Counterexample:
    """Return the letters and both sides at a point, by exact rationals if the sides are rational."""
    with precision(256):
        env, exact = claim.env(place), claim.env(place, Exact())
        letters = {a.name: _numbers(exact.value(a)) or _numbers(env.value(a)) for a in claim.letters}
        for proof, field in (("exact rationals", exact), ("disjoint intervals", env)):
            with suppress(ArithmeticError, TypeError, AttributeError):
                if found := sides(field, claim.statement, _numbers):
                    return Counterexample(words or place.label, letters, found, proof)
    return Counterexample(words or place.label, letters, ())


def _numbers(value: Any) -> list[str]:
    """Return the numbers of a value; none if it contains other things, or balls beside fractions."""
    found = [a.ring.value(a.numerator) / a.ring.value(a.denominator) if isinstance(a, Element) else a
             for a in coefficients(value)]  # fmt: skip
    return [str(a) for a in found] if all(isinstance(a, int | Fraction | Ball) for a in found) else []

