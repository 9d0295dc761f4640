"""Decision of one claim: what its points and generic values tell.

1. The claim is evaluated at points: short and wide numbers, special values, zeros of singular parts, related letters.
2. A point where it fails refutes it. If it chooses branches and no domain is stated, a region is sought instead.
3. Points without a value give the condition of a claim of a file. An entry of a transcript states its condition, and
   points on both sides are tried.
4. Generic values of an exact field prove it; otherwise the points are evidence.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, field, replace
from itertools import islice

from ...algebra.element import NotExactError
from ...algebra.structures import MeaninglessError
from ..language.operations import written
from ..language.printed import Term, Trait, with_trait
from ..numbers.balls import PRECISIONS, BlurredError, precision
from ..result import Status
from .claim import Claim, Place, RefusedError, operators
from .conditions import exclusions, is_sharp, plain
from .existence import undecided_parts
from .identity import MODULO, identical, jumps
from .ordering import ordered
from .places import Probe, places
from .proof import ContradictionError, proved
from .regions import REGION_MIN, Region, branched, region
from .singular import ORDERED

DIGITS_TRIED = 4
"""Number of points at which an equality without a proof is tried with more digits."""
SHOWN = 3
"""Largest number of parts without a proof that are named."""
POINTS_MIN = 6
"""Least number of points at which a claim is called true."""


@dataclass
class Outcome:
    """Points at which a claim is true, is false, or has no value, and the number of those that did not tell."""

    true: list[Place] = field(default_factory=list)
    false: list[Place] = field(default_factory=list)
    undefined: list[Place] = field(default_factory=list)
    blurred: int = 0

    @property
    def points(self) -> int:
        return len(self.true) + len(self.false) + len(self.undefined)

    @property
    def open(self) -> bool:
        """Whether the claim is true at points drawn at random, so in a region and not in special places only."""
        return sum(place.generic for place in self.true) >= REGION_MIN

    def add(self, truth: bool | None, place: Place) -> None:
        (self.undefined if truth is None else self.true if truth else self.false).append(place)

    def tried(self, claim: Claim, found: Iterable[Place], enough: Callable[[Outcome], bool]) -> Outcome:
        for place in found:
            try:
                self.add(claim.truth(place), place)
            except BlurredError:
                self.blurred += 1
            if enough(self):
                break
        return self


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
    needed: tuple[Term, ...] = ()  # requirements of the condition, as statements
    within: Region | None = None  # region of the condition

    @property
    def holds(self) -> bool:
        return self.status in (Status.HOLDS, Status.HOLDS_IF, Status.UNREFUTED)


def decided(claim: Claim, early: Callable[[Finding], None] = lambda finding: None) -> Finding:
    """Return the decision of a claim of a file or transcript; that of a file is told to `early` before its proof."""
    try:
        if not claim.entry.of_file:
            return _in_python(claim)
        finding = _at_points(claim)
        if not finding.holds:
            return finding
        early(_unproved(finding, ""))
        return _with_proof(claim, finding)
    except (RefusedError, ContradictionError) as error:
        return Finding(Status.UNDECIDED, str(error))
    except (MeaninglessError, NotExactError, RecursionError, OverflowError) as error:
        return Finding(Status.UNDECIDED, f"it cannot be evaluated: {error}")


def _with_proof(claim: Claim, finding: Finding) -> Finding:
    """Return a decision at points with its proof: of the statement, then of the values of both sides."""
    within = claim if finding.within is None else finding.within.inside(claim)
    if jumps(claim.statement):
        how = None  # true at generic values, it may be false at special ones
    elif not ORDERED.isdisjoint(operators(claim.statement)):
        how = "exact" if not finding.cuts and ordered(claim) else None
    else:
        how = (proved(within) if within is claim else None) or identical(within)
    if how is None and (place := _failing_at_more_digits(claim, finding.true)) is not None:
        method = f"refuted at {place.label}, with {PRECISIONS[-1]} bits"
        return Finding(Status.FALSE, method, finding.points, "exact", failing=place)
    if how is None or ", n = " in how:
        return _unproved(finding, how or "")
    if without := undecided_parts(within, finding.needed):
        shown = ", ".join(dict.fromkeys(written(claim.entry.contracted(part)) for part in without[:SHOWN]))
        return _unproved(finding, f"{how} where both sides have a value, which is open for {shown}")
    return replace(finding, method=how, certainty=MODULO if how.startswith(MODULO) else "exact")


def _failing_at_more_digits(claim: Claim, places: Iterable[Place]) -> Place | None:
    """Return the first of a few points at which more digits show that the sides differ."""
    with precision(PRECISIONS[-1]):
        for place in islice((place for place in places if place.exact), DIGITS_TRIED):
            with suppress(ArithmeticError, BlurredError):
                if not claim.env(place).value(claim.statement):
                    return place
    return None


def _unproved(finding: Finding, known: str) -> Finding:
    """Return the decision of a claim that is true at all points and not proved."""
    method = "; ".join(filter(None, (known, finding.method)))
    return replace(finding, status=Status.UNREFUTED, method=method, certainty="evidence")


def _at_points(claim: Claim) -> Finding:
    """Return the decision of a claim whose condition is found, by its points."""
    stated = claim.entry.claimed is not None
    choosing = branched(*claim.parts) and ORDERED.isdisjoint(operators(claim.statement))
    probe = Probe(claim)
    at = Outcome().tried(claim, probe.all(), lambda outcome: bool(outcome.false) and not choosing)
    if not at.open and (choosing or not at.false):
        at.tried(claim, probe.near(at.true), lambda outcome: False)
    if at.blurred and not at.points:
        return Finding(Status.UNDECIDED, f"numbers at {at.blurred} points are too large or too uncertain to tell")
    if at.points < POINTS_MIN and not at.false:
        few = f"only {at.points} of the points tried" if at.points else "no point tried"
        return Finding(Status.UNDECIDED, f"{few} {'in' if stated else 'outside'} the stated domain", at.points)
    known = any(place.generic for place in (*at.true, *at.false)) or not any(p.generic for p in at.undefined)
    if not known and not at.false:
        return Finding(Status.UNDECIDED, f"it has no value at generic points, of {at.points} points in all", at.points)
    within = None
    cuts = f"{len(at.false)} of {len(at.true) + len(at.false)} points fail" if at.false else ""
    if at.false:
        if choosing and at.open:
            within, sharp = region(claim, at.true, at.false)
            cuts += f", all outside {within.words}" if within and sharp else ""
        if within is None or stated:
            cuts += f"; true where {_condition(probe, at, within)[0]}" if within else ""
            method = f"refuted at {at.false[0].label}"
            return Finding(Status.FALSE, method, at.points, "exact", cuts=cuts * choosing, failing=at.false[0])
    condition, outside = _condition(probe, at, within)
    method = f"true at {at.points} points" + f", {at.blurred} more too close to tell" * bool(at.blurred)
    status = Status.HOLDS_IF if condition else Status.HOLDS
    asked = tuple(term for one in exclusions(claim, _inside(at, within)) if (term := one.term) is not None)
    if within is not None and within.strict in condition:
        asked, within = (*asked, *within.interior), replace(within, terms=within.interior)
    return Finding(
        status, method, at.points, "evidence", condition, cuts, None, outside, tuple(at.true), asked, within
    )  # fmt: skip


def _inside(at: Outcome, within: Region | None) -> list[Place]:
    return [place for place in at.undefined if within is None or within.test(place)]


def _condition(probe: Probe, at: Outcome, within: Region | None) -> tuple[str, Place | None]:
    """Return the condition under which a claim is true, in words, and a point outside it."""
    border = within is not None and any(within.test(place) is None for place in (*at.undefined, *at.false))
    found = exclusions(probe.claim, _inside(at, within))
    parts = [within.strict if border else within.words] if within else []
    words = " and ".join(dict.fromkeys([*parts, *(plain(probe, requirement) for requirement in found)]))
    return words, next(iter((*found.values(), *at.undefined, *at.false)), None)


def _in_python(claim: Claim) -> Finding:
    """Return the decision of a claim whose condition is stated; it must be true inside and not outside."""
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
    if wrong := _contradicted(claim, beyond):
        return Finding(Status.UNDECIDED, wrong)
    exact = proved(claim)
    method = _method(claim, exact, at.points)
    if beyond.true:
        method += f"; also true at {beyond.true[0].label}"
    status = Status.HOLDS if entry.condition is None else Status.HOLDS_IF
    if exact is None:
        status = Status.UNREFUTED
    return Finding(status, method, at.points, true=tuple(at.true))


def _truth(claim: Claim, statement: Term, place: Place) -> bool | None:
    try:
        return claim.truth(place, statement)
    except BlurredError:
        return None


def _contradicted(claim: Claim, beyond: Outcome) -> str:
    """Return how the points outside a stated condition contradict it, if they do.

    The claim may be true outside if two letters are special. It has no value there if its divisors say so.
    """
    single = next((place for place in beyond.true if not place.pair), None)
    if single is not None:
        return f"true outside its condition, at {single.label}"
    valued = (*beyond.true, *beyond.false)
    if valued and claim.entry.condition is not None and is_sharp(claim.entry.condition, claim.statement):
        return f"its form says no value, but there is one, at {valued[0].label}"
    return ""


def _method(claim: Claim, exact: str | None, points: int) -> str:
    """Return the method in words. A delicate statement proved at generic values may fail at special ones."""
    entry, tried = claim.entry, f"true at {points} points"
    supported = ", with a supporting identity proved exactly" if entry.because not in (None, claim.statement) else ""
    if exact is None:
        return f"evidence: {points} points{supported}"
    if any(entry.free(part) for part in with_trait(Trait.DELICATE, claim.statement)):
        return f"{exact} where symbols are generic, {tried}{supported}"
    return f"{exact}{supported}"
