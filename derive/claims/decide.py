"""Decision of an entry: one procedure for those of transcripts and for claims of files.

Each reading is decided as a claim, and a correction alike. Of a claim of a file, changes in one step that make it true
are sought, or terms that do not matter and constraints that it needs.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from .deciding.changes import mended, needed, vacuous
from .deciding.claim import ORDERS, Claim
from .deciding.conditions import is_sharp
from .deciding.counterexample import outside_words, shown_at
from .deciding.finding import Finding, Outcome, decided
from .deciding.identity import with_vectors_for_lengths
from .deciding.places import places
from .deciding.proof import proved
from .equation import Entry, Reading, UndecidedError, require_complete
from .language.operator_table import both, implies
from .language.printed import Term
from .result import Counterexample, Result, Status, Verdict, undecided


def decide(
    paper: str, entry: Entry, lost: str = "", orders: Sequence[int] = ORDERS,
    early: Callable[[Result], None] = lambda result: None,
) -> Result:  # fmt: skip
    """Return the result of an entry of the paper with this slug, with statements about n evaluated at some orders.

    The extraction of the paper's text lost some characters. `early` receives the result before the search for changes,
    terms and constraints, which may take long. Raise UndecidedError if an entry of a transcript is incomplete, or the
    computation contradicts its condition, correction or domain.
    """
    if entry.undecided:
        return undecided(paper, entry, entry.undecided)
    require_complete(entry, lost + entry.lost)
    if entry.because is not None:
        _support(entry, entry.because, orders)
    claims = [_premised(Claim(entry, reading.statement, orders)) for reading in entry.readings]

    def result(*findings: Finding) -> Result:
        return _result(paper, entry, claims, findings)

    findings = [_settled(claim, lambda finding: early(result(finding))) for claim in claims]
    found = result(*findings)
    early(found)
    if not entry.of_file or found.status in (Status.UNDECIDED, Status.ERRATUM, Status.AMBIGUOUS):
        return found
    ((claim, finding),) = zip(claims, findings, strict=True)
    if finding.holds:
        return replace(found, vacuous=tuple(dict.fromkeys(vacuous(claim, finding.true))), needs=tuple(needed(claim)))
    for change in mended(claim, finding.failing, lambda other: decided(other).holds):
        early(found := replace(found, changes=(*found.changes, change)))
    return found


def _result(paper: str, entry: Entry, claims: Sequence[Claim], findings: Sequence[Finding]) -> Result:
    rows = sorted(zip(claims, findings, entry.readings, strict=True), key=lambda row: not row[1].holds)
    (claim, finding, _), verdicts = rows[0], tuple(_verdict(*row) for row in rows)
    status, method = finding.status, finding.method
    if _is_ambiguous(entry, verdicts):
        status, method = Status.AMBIGUOUS, "; ".join(verdict.method for verdict in verdicts)
    elif status is Status.FALSE and (entry.corrected is not None or not entry.of_file):
        status, method = _corrected(claim, finding)
    decisive = claim.statement if entry.corrected is None else entry.corrected
    return Result(
        paper, entry, status, method, verdicts, entry.condition is not None and is_sharp(entry.condition, decisive),
        finding.certainty, finding.points, finding.found, _outside(claim, finding), cuts=finding.cuts,
    )  # fmt: skip


def _settled(claim: Claim, early: Callable[[Finding], None]) -> Finding:
    """Return the decision of a claim; an entry of a transcript that cannot be decided is a mistake of ours."""
    finding = decided(claim, early)
    if finding.status is Status.UNDECIDED and not claim.entry.of_file:
        raise UndecidedError(f"({claim.entry.number}): {finding.method}")
    return finding


def _verdict(claim: Claim, finding: Finding, reading: Reading) -> Verdict:
    example = None if finding.failing is None else shown_at(claim, finding.failing)
    return Verdict(reading.statement, reading.note, finding.holds, finding.method, example)


def _outside(claim: Claim, finding: Finding) -> Counterexample | None:
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
    """Return the claim with the premise of an implication as part of the stated domain, of a file.

    A magnitude that is 0 there is written as its vector.
    """
    while claim.entry.of_file and claim.statement.operator is implies:
        premise, statement = claim.statement.arguments
        claimed = premise if claim.entry.claimed is None else both(claim.entry.claimed, premise)
        claim = replace(claim, entry=replace(claim.entry, claimed=claimed), statement=statement)
    if claim.entry.of_file and claim.entry.claimed is not None:
        claimed = with_vectors_for_lengths(claim.entry.claimed)
        return replace(claim, entry=replace(claim.entry, claimed=claimed))
    return claim


def _support(entry: Entry, identity: Term, orders: Sequence[int]) -> None:
    """Raise unless the supporting identity is proved; points where it is undefined are ignored."""
    claim = Claim(replace(entry, condition=None, claimed=None), identity, orders)
    at = Outcome().tried(claim, places(claim), lambda outcome: bool(outcome.false))
    if at.false or proved(claim) is None:
        reason = f"false at {at.false[0].label}" if at.false else "not exact"
        raise UndecidedError(f"({entry.number}): the supporting identity is not proved: {reason}")
