"""Decision of an entry: one procedure for entries in Python and for claims of files.

1. The claim is evaluated at points: short and wide numbers, special values, zeros of singular parts, related letters.
2. A point where it fails refutes it. If it chooses branches and no domain is stated, a region is sought instead.
3. Points without a value give the condition of a claim of a file; an entry in Python states its condition, and points
   on both sides are tried.
4. Generic values of an exact field prove it; otherwise the points are evidence.
5. A correction is decided alike. Of a claim of a file, changes in one step that make it true are sought, or terms that
   do not matter and constraints that it needs.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace

from ..algebra.element import NotExactError
from ..algebra.mixed import MeaninglessError
from .claim import ORDERS, Claim, Place, RefusedError, operators
from .conditions import exclusions, plain
from .equation import Entry, Reading, UndecidedError, require_complete
from .language.operator_table import both, implies
from .language.printed import Term, Trait, with_trait
from .near import mended, needed, vacuous
from .numbers.balls import BlurredError
from .places import Probe, places
from .proof import ContradictionError, proved
from .regions import REGION_MIN, Region, branched, region
from .result import Counterexample, Result, Status, Verdict
from .sharp import is_sharp
from .singular import ORDERED
from .witness import outside_words, shown_at

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
        """Number of points that told."""
        return len(self.true) + len(self.false) + len(self.undefined)

    def add(self, truth: bool | None, place: Place) -> None:
        """Add a point."""
        (self.undefined if truth is None else self.true if truth else self.false).append(place)


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


# ---- one claim --------------------------------------------------------------------------------------------------


def decided(claim: Claim) -> Finding:
    """Return the decision of a claim, without what makes it true or vacuous."""
    try:
        return _of_file(claim) if claim.entry.of_file else _in_python(claim)
    except (RefusedError, ContradictionError) as error:
        return Finding(Status.UNDECIDED, str(error))
    except (MeaninglessError, NotExactError, RecursionError, OverflowError) as error:
        return Finding(Status.UNDECIDED, f"it cannot be evaluated: {error}")


def _tried(claim: Claim, found: Iterator[Place], enough: Callable[[Outcome], bool]) -> Outcome:
    """Return the truth of a claim at points, until there are enough."""
    outcome = Outcome()
    for place in found:
        try:
            outcome.add(claim.truth(place), place)
        except BlurredError:
            outcome.blurred += 1
        if enough(outcome):
            break
    return outcome


def _of_file(claim: Claim) -> Finding:
    """Return the decision of a claim whose condition is found."""
    stated = claim.entry.claimed is not None
    choosing = branched(*claim.parts) and ORDERED.isdisjoint(operators(claim.statement))
    probe = Probe(claim)
    at = _tried(claim, probe.all(), lambda outcome: bool(outcome.false) and not choosing)
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
        if choosing and sum(place.generic for place in at.true) >= REGION_MIN:
            within, sharp = region(claim, at.true, at.false)
            cuts += f", all outside {within.words}" if within and sharp else ""
        if within is None or stated:
            cuts += f"; true where {_condition(probe, at, within)[0]}" if within else ""
            method = f"refuted at {at.false[0].label}"
            return Finding(Status.FALSE, method, at.points, "exact", cuts=cuts * choosing, failing=at.false[0])
    condition, outside = _condition(probe, at, within)
    ordered = not ORDERED.isdisjoint(operators(claim.statement))  # generic values tell nothing of an order
    exact = None if at.false or ordered else proved(claim)
    evidence = f"evidence: {at.points} points" + f", {at.blurred} more too close to tell" * bool(at.blurred)
    certainty = "exact" if exact in ("exact", "exact, all n") else "evidence"
    method = f"{exact}; {evidence}" if exact and certainty == "evidence" else exact or evidence
    status = Status.HOLDS_IF if condition else Status.HOLDS
    return Finding(status, method, at.points, certainty, condition, cuts, None, outside, tuple(at.true))


def _condition(probe: Probe, at: Outcome, within: Region | None) -> tuple[str, Place | None]:
    """Return the condition under which a claim is true, in words, and a point outside it."""
    inside = [place for place in at.undefined if within is None or within.test(place)]
    border = within is not None and any(within.test(place) is None for place in at.undefined)
    found = exclusions(probe.claim, inside)
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

    at = _tried(claim, inside(), lambda outcome: bool(outcome.false or outcome.undefined))
    if failing := (*at.false, *at.undefined):
        value = "false" if at.false else "no value"
        return Finding(Status.FALSE, f"refuted at {failing[0].label}: {value}", at.points, failing=failing[0])
    if not at.points or (entry.condition is not None and not beyond.points):
        sides = "both sides" if at.points else "the inside"
        return Finding(Status.UNDECIDED, f"no point on {sides} of its domain")
    if wrong := _contradicted(claim, beyond):
        return Finding(Status.UNDECIDED, wrong)
    method = _method(claim, proved(claim), at.points)
    if beyond.true:
        method += f"; also true at {beyond.true[0].label}"
    status = Status.HOLDS if entry.condition is None else Status.HOLDS_IF
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
    if exact is None and entry.argument:
        return f"proved by the argument in {entry.argument} from identities proved exactly; {tried} besides"
    if exact is None:
        return f"evidence: {points} points{supported}"
    if any(entry.free(part) for part in with_trait(Trait.DELICATE, claim.statement)):
        return f"{exact} where symbols are generic, {tried}{supported}"
    return f"{exact}{supported}"


# ---- an entry ---------------------------------------------------------------------------------------------------


def decide(
    paper: str, entry: Entry, lost: str = "", orders: Sequence[int] = ORDERS,
    early: Callable[[Result], None] = lambda result: None,
) -> Result:  # fmt: skip
    """Return the result of an entry.

    Parameters
    ----------
    paper : str
        Slug of the paper.
    entry : Entry
        Printed equation or claim.
    lost : str, optional
        Characters that the extraction of the paper's text lost.
    orders : sequence of int, optional
        Orders n at which statements about n are evaluated.
    early : callable, optional
        Function that receives the result before the search for changes, terms and constraints, which may take long.

    Raises
    ------
    UndecidedError
        If an entry in Python is incomplete, or the computation contradicts its condition, correction or domain.
    """
    require_complete(entry, lost + entry.lost)
    if entry.because is not None:
        _support(entry, entry.because, orders)
    claims = [_premised(Claim(entry, reading.statement, orders)) for reading in entry.readings]
    found = [(claim, _settled(claim), reading) for claim, reading in zip(claims, entry.readings, strict=True)]
    found.sort(key=lambda row: not row[1].holds)
    (claim, finding, _), verdicts = found[0], tuple(_verdict(*row) for row in found)
    status, method = finding.status, finding.method
    if _is_ambiguous(entry, verdicts):
        status, method = Status.AMBIGUOUS, "; ".join(verdict.method for verdict in verdicts)
    elif status is Status.FALSE and (entry.corrected is not None or not entry.of_file):
        status, method = _corrected(claim, finding)
    decisive = claim.statement if entry.corrected is None else entry.corrected
    result = Result(
        paper, entry, status, method, verdicts, entry.condition is not None and is_sharp(entry.condition, decisive),
        finding.certainty, finding.points, finding.found, _outside(claim, finding), cuts=finding.cuts,
    )  # fmt: skip
    early(result)
    if not entry.of_file:
        return result
    if finding.holds:
        return replace(result, vacuous=tuple(dict.fromkeys(vacuous(claim, finding.true))), needs=tuple(needed(claim)))
    if status is not Status.FALSE:
        return result
    return replace(result, changes=tuple(mended(claim, finding.failing, lambda other: decided(other).holds)))


def _settled(claim: Claim) -> Finding:
    """Return the decision of a claim; an entry in Python that cannot be decided is a mistake of ours."""
    finding = decided(claim)
    if finding.status is Status.UNDECIDED and not claim.entry.of_file:
        raise UndecidedError(f"({claim.entry.number}): {finding.method}")
    return finding


def _verdict(claim: Claim, finding: Finding, reading: Reading) -> Verdict:
    example = None if finding.failing is None else shown_at(claim, finding.failing)
    return Verdict(reading.statement, reading.note, finding.holds, finding.method, example)


def _outside(claim: Claim, finding: Finding) -> Counterexample | None:
    """Return the point outside the condition that was found."""
    place = finding.outside
    return None if place is None or not finding.holds else shown_at(claim, place, outside_words(claim, place))


def _is_ambiguous(entry: Entry, verdicts: Sequence[Verdict]) -> bool:
    """Return whether one reading is true, another false, and the text does not decide between them."""
    true = {verdict.statement for verdict in verdicts if verdict.true}
    supported = any(r.supported_by and r.statement not in true for r in entry.readings)
    return bool(true) and (supported or (not entry.extract and len(true) < len(verdicts)))


def _corrected(claim: Claim, finding: Finding) -> tuple[Status, str]:
    """Return status and method of a false statement by its correction."""
    entry = claim.entry
    if entry.corrected is None:
        raise UndecidedError(f"({entry.number}) is false and has no correction: {finding.method}")
    correction = decided(claim.with_statement(entry.corrected))
    if correction.holds:
        return Status.ERRATUM, f"{finding.method}; correction {correction.method}"
    if not entry.of_file:
        raise UndecidedError(f"({entry.number}): the correction is false: {correction.method}")
    return Status.FALSE, f"{finding.method}; the correction does not hold: {correction.method}"


def _premised(claim: Claim) -> Claim:
    """Return the claim with the premise of an implication as part of the stated domain, of a file."""
    while claim.entry.of_file and claim.statement.operator is implies:
        premise, statement = claim.statement.arguments
        claimed = premise if claim.entry.claimed is None else both(claim.entry.claimed, premise)
        claim = replace(claim, entry=replace(claim.entry, claimed=claimed), statement=statement)
    return claim


def _support(entry: Entry, identity: Term, orders: Sequence[int]) -> None:
    """Raise unless the supporting identity is proved; points where it is undefined are ignored."""
    moving = entry.moving or bool(with_trait(Trait.RATE, identity))
    claim = Claim(replace(entry, condition=None, claimed=None, also=None, moving=moving), identity, orders)
    at = _tried(claim, places(claim), lambda outcome: bool(outcome.false))
    if at.false or proved(claim) is None:
        reason = f"false at {at.false[0].label}" if at.false else "not exact"
        raise UndecidedError(f"({entry.number}): the supporting identity is not proved: {reason}")
