"""Decision of one claim: what its points and generic values tell.

1. The claim is evaluated at points: short and wide numbers, special values, zeros of singular parts, related letters.
2. A point where it fails refutes it. If it chooses branches and no domain is stated, a region is sought instead.
3. Points without a value give its condition. One that states its condition must hold there without a further one, and
   points outside are tried.
4. Generic values of an exact field prove it; otherwise the points are evidence.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import chain, islice

from ...algebra.element import NotExactError
from ...algebra.structures import MeaninglessError
from ..language.operations import written
from ..language.operator_table import RELATIONS, difference, equal, negated
from ..language.printed import Term
from ..numbers.balls import PRECISIONS, BlurredError, precision
from ..result import Status
from .claim import Claim, RefusedError
from .conditions import exclusions, is_sharp, plain
from .existence import undecided_parts
from .identity import MODULO, jumps, proved, proved_at_orders
from .ordering import ordered
from .place import Place
from .places import Probe
from .regions import Outcome, Region, branched, region
from .singular import ORDERED
from .split import split
from .terms import operators

JUMPS = frozenset(("atan2 of two", "arctan", "acos", "asin", "log"))
"""Operators that choose a branch, so that an identity at generic values may be false at special ones."""
DIGITS_TRIED = 4
"""Number of points at which an equality without a proof is tried with more digits."""
CONFIRMING = 4
"""Number of points without a value that confirm a condition by divisors."""
SHOWN = 3
"""Largest number of parts without a proof that are named."""
WORDS: dict[type[Exception], str] = {
    RecursionError: "its parts stand too deep in each other", OverflowError: "its numbers are too large",
    **dict.fromkeys((TypeError, AttributeError, LookupError, ValueError),
                    "an operation has no meaning for the values of its arguments"),
}  # fmt: skip
"""Reasons why a claim has no value at all."""
OPEN_RELATIONS = RELATIONS - {"equal"}
"""Relations that are true in regions."""
POINTS_MIN = 6
"""Least number of points at which a claim is called true."""


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
    """Return the decision of a claim; a decision without proof is `early` told before the proof."""
    try:
        return _stated(claim, early) if claim.entry.is_transcribed else _found(claim, early)
    except RefusedError as error:
        return Finding(Status.UNDECIDED, str(error))
    except (MeaninglessError, NotExactError) as error:
        return Finding(Status.UNDECIDED, f"it cannot be evaluated: {error}")
    except tuple(WORDS) as error:
        words = next(words for kind, words in WORDS.items() if isinstance(error, kind))
        return Finding(Status.UNDECIDED, f"it cannot be evaluated: {words}")


def _found(claim: Claim, early: Callable[[Finding], None]) -> Finding:
    """Return the decision of a claim, with the condition under which it has a value and is true.

    A claim without branches that is proved, with both sides, needs one point, and none at zeros of its singular parts.
    """
    choosing = branched(*claim.parts) and ORDERED.isdisjoint(operators(claim.statement))

    def enough(at: Outcome) -> bool:
        return bool(at.false) and not choosing

    probe = Probe(claim)
    at = Outcome().tried(claim, probe.first(), enough)
    settled = bool(at.true) and not (at.false or at.undefined)
    tried = settled and JUMPS.isdisjoint(operators(*claim.parts))
    first = Finding(Status.HOLDS, f"true at {at.points} points", at.points, true=tuple(at.true))
    if tried and at.points >= POINTS_MIN:
        early(_unproved(first, ""))
    how = _proof(claim) if tried else None
    if how is not None and not _is_for_some_orders(how) and not _without_value(claim):
        return _proved(first, how)
    at.false += _equal_sides(claim, at.blurred)
    if not enough(at):
        at.tried(claim, probe.zeros(), enough)
    finding = _at_points(probe, at, choosing)
    if not finding.holds:
        return finding
    early(_unproved(finding, ""))
    given = [*([] if finding.within is None else finding.within.terms),
             *(part for part in finding.needed if part.operator is not equal)]  # equations say that a term has a value
    within = claim.within(*given) if given else claim
    return _with_proof(within, finding, how if tried and within is claim else _proof(within))


def _equal_sides(claim: Claim, places: Sequence[Place]) -> list[Place]:
    """Return the first of these points if the claim says that two sides differ, and they are proved to be equal."""
    if not places or claim.statement.operator.name not in ("unlike", "nonzero", "less", "greater"):
        return []
    gap = difference(claim.statement)
    equality = replace(claim, entry=replace(claim.entry, claimed=None), statement=equal(gap, 0))
    found = (place for place in places if claim.evaluated(place, gap) is not None)
    return list(islice(found, 1)) if proved(equality) else []


def _proof(claim: Claim) -> str | None:
    """Return how a claim is proved where both sides have a value, by the weakest of its parts; or None."""
    hows = [_proof_of_part(part) for part in split(claim)]  # none if no point lies in the domain
    known = [how for how in hows if how is not None]
    if not hows or known != hows:
        return None
    return max(known, key=lambda how: (_is_for_some_orders(how), how.startswith(MODULO)))


def _proof_of_part(claim: Claim) -> str | None:
    if jumps(claim.statement):
        return None  # true at generic values, it may be false at special ones
    if not ORDERED.isdisjoint(operators(claim.statement)):
        return "exact" if ordered(claim) else None
    return proved(claim) or proved_at_orders(claim)


def _is_for_some_orders(how: str) -> bool:
    return ", n = " in how


def _with_proof(claim: Claim, finding: Finding, how: str | None) -> Finding:
    """Return a decision at points with its proof: of the statement, then of the values of both sides."""
    if how is None and (place := _failing_at_more_digits(claim, finding.true)) is not None:
        method = f"refuted at {place.label}, with {PRECISIONS[-1]} bits"
        return Finding(Status.FALSE, method, finding.points, "exact", failing=place)
    if how is None or _is_for_some_orders(how):
        return _unproved(finding, how or "")
    if without := _without_value(claim, finding.needed):
        shown = ", ".join(dict.fromkeys(written(claim.entry.contracted(part)) for part in without[:SHOWN]))
        return _unproved(finding, f"{how} where both sides have a value, which is open for {shown}")
    return _proved(finding, how)


def _without_value(claim: Claim, condition: Sequence[Term] = ()) -> list[Term]:
    """Return the parts of a claim that are not proved to have a value."""
    return [part for one in split(claim) for part in undecided_parts(one, condition)]


def _proved(finding: Finding, how: str) -> Finding:
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


def _at_points(probe: Probe, at: Outcome, choosing: bool) -> Finding:
    """Return the decision of a claim whose condition is found, by its points."""
    claim, stated = probe.claim, probe.claim.entry.claimed is not None
    if not at.open and (choosing or not at.false):
        at.tried(claim, probe.near(at.true), lambda outcome: False)
    if at.blurred and not at.points:
        return Finding(Status.UNDECIDED, f"numbers at {len(at.blurred)} points are too large or too uncertain to tell")
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
    method = f"true at {at.points} points" + f", {len(at.blurred)} more too close to tell" * bool(at.blurred)
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


def _stated(claim: Claim, early: Callable[[Finding], None]) -> Finding:
    """Return the decision of a claim that states its condition: it must hold there, and not at points outside."""
    condition = claim.entry.condition
    finding = _found(claim.within(*([] if condition is None else [condition])), early)
    if finding.holds and finding.outside is not None:
        value = "no value" if claim.truth(finding.outside) is None else "false"
        return Finding(Status.FALSE, f"refuted at {finding.outside.label}: {value}", finding.points, "exact",
                       failing=finding.outside)  # fmt: skip
    if condition is None or not finding.holds:
        return finding
    other = claim.within(negated(condition))
    alone = [negated(claim.statement)] if operators(condition).isdisjoint(OPEN_RELATIONS) else []
    # a further solution shows that a condition by equations is too narrow
    probe = Probe(other, condition, *alone, at_instants=True)
    few = is_sharp(condition, claim.statement)  # outside it has no value by its form, which a few points confirm
    outside = chain(probe.first(), probe.zeros())
    beyond = Outcome().tried(other, outside, lambda found: few and len(found.undefined) >= CONFIRMING)
    if not (beyond.points or beyond.blurred):
        return Finding(Status.UNDECIDED, "no point outside its condition")
    if wrong := contradicted(claim, beyond):
        return Finding(Status.UNDECIDED, wrong)
    known = "" if beyond.points else "no point outside its condition tells"
    known = f"also true at {beyond.true[0].label}" if beyond.true else known
    method = "; ".join(filter(None, (finding.method, known)))
    status = Status.HOLDS_IF if finding.status is Status.HOLDS else finding.status
    return replace(finding, status=status, method=method)


def contradicted(claim: Claim, beyond: Outcome) -> str:
    """Return how the points outside a stated condition contradict it, if they do.

    The claim may be true outside if two letters are special. It has no value there if its divisors say so.
    """
    is_open = any(place.generic for place in (*beyond.true, *beyond.false, *beyond.undefined))
    single = next((p for p in beyond.true if p.generic or p.on or not (p.pair or is_open)), None)
    if single is not None:
        return f"true outside its condition, at {single.label}"
    valued = (*beyond.true, *beyond.false)
    if valued and claim.entry.condition is not None and is_sharp(claim.entry.condition, claim.statement):
        return f"its form says no value, but there is one, at {valued[0].label}"
    return ""
