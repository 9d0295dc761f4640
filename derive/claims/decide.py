"""Decision of an entry: one procedure for claims of files, and for transcripts, which state their conditions.

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
from .deciding.finding import Finding, decided
from .deciding.solved import with_vectors_for_lengths
from .deciding.split import is_for_an_instant
from .equation import Entry, Reading, UndecidedError, require_complete
from .language.operator_table import both, implies
from .language.printed import Term
from .result import Counterexample, Result, Status, Verdict, undecided


def decide(
    paper: str, entry: Entry, lost: str = "", orders: Sequence[int] = ORDERS,
    early: Callable[[Result], None] = lambda result: None,
) -> Result:  # fmt: skip
    """Return the result of an entry of the paper with this slug, with statements about n evaluated at some orders.

    The extraction of the paper's text lost some characters. `early` receives the result before its correction, and the
    search for changes, terms and constraints, which may take long. Raise UndecidedError if the entry of a transcript is
    incomplete, or the computation contradicts its condition, correction or domain.
    """
    if entry.undecided:
        return undecided(paper, entry, entry.undecided)
    require_complete(entry, lost + entry.lost)
    meant = entry.meant
    if meant.because is not None:
        _support(meant, meant.because, orders)
    claims = [_premised(Claim(meant, reading.statement, orders)) for reading in meant.readings]

    def result(*findings: Finding) -> Result:
        return _result(paper, entry, claims, findings)

    def tell(finding: Finding) -> None:
        if len(claims) == 1:
            early(result(finding))

    findings = [_settled(claim, tell) for claim in claims]
    found = result(*findings)
    early(found)
    claim, finding = max(zip(claims, findings), key=lambda row: row[1].holds)
    if found.status is Status.FALSE and (entry.corrected is not None or entry.is_transcribed):
        found = _corrected(found, claim, finding)
    if entry.is_transcribed or found.status in (Status.UNDECIDED, Status.ERRATUM, Status.AMBIGUOUS):
        return found
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
    meant = claim.entry
    if meant.because is not None:
        method += "; its supporting identity is proved"
    decisive = claim.statement if meant.corrected is None else meant.corrected
    return Result(
        paper, entry, status, method, verdicts, meant.condition is not None and is_sharp(meant.condition, decisive),
        finding.certainty, finding.points, finding.found, _outside(claim, finding), cuts=finding.cuts,
    )  # fmt: skip


def _settled(claim: Claim, early: Callable[[Finding], None]) -> Finding:
    """Return the decision of a claim; a transcript that cannot be decided is a mistake of ours."""
    finding = decided(claim, early)
    if finding.status is Status.UNDECIDED and claim.entry.is_transcribed:
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


def _corrected(found: Result, claim: Claim, finding: Finding) -> Result:
    """Return the result of a false statement: its correction, and the condition under which that is true."""
    entry = claim.entry
    if entry.corrected is None:
        raise UndecidedError(f"({entry.number}) is false and has no correction: {finding.method}")
    claim = _premised(claim.with_statement(entry.corrected))
    correction = decided(claim)
    if correction.holds:
        method = f"{found.method}; correction {correction.method}"
        return replace(found, status=Status.ERRATUM, method=method, found=correction.found)
    if entry.is_transcribed:
        raise UndecidedError(f"({entry.number}): the correction is false: {correction.method}")
    return replace(found, method=f"{finding.method}; the correction does not hold: {correction.method}")


def _premised(claim: Claim) -> Claim:
    """Return the claim with the premise of an implication as part of the stated domain.

    One that is asked at an instant stays. A magnitude that is 0 in the domain is written as its vector.
    """
    while claim.statement.operator is implies and not is_for_an_instant(claim.statement):
        premise, statement = claim.statement.arguments
        claimed = premise if claim.entry.claimed is None else both(claim.entry.claimed, premise)
        claim = replace(claim, entry=replace(claim.entry, claimed=claimed), statement=statement)
    if claim.entry.claimed is not None:
        claimed = with_vectors_for_lengths(claim.entry.claimed)
        return replace(claim, entry=replace(claim.entry, claimed=claimed))
    return claim


def _support(entry: Entry, identity: Term, orders: Sequence[int]) -> None:
    """Raise unless the supporting identity is proved; points where it is undefined are ignored."""
    claim = Claim(replace(entry, condition=None, claimed=None, written=identity), identity, orders)
    finding = decided(claim)  # its condition is found
    if finding.status not in (Status.HOLDS, Status.HOLDS_IF):
        raise UndecidedError(f"({entry.number}): the supporting identity is not proved: {finding.method}")
