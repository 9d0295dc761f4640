"""Decision of an entry: refutation at points, proof at generic values, test of both sides of a condition."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial
from itertools import product
from typing import Any

from ..algebra.element import NotExactError
from .claim import Claim, rate_depth
from .conditions import branched
from .equation import Entry, Reading, UndecidedError, faithful
from .explore import Trial, counterexample, explore
from .judge import ORDERS, Pairs, first_failure, steps_of
from .language.environment import Env
from .language.printed import Term, Trait, takes_apart, with_trait
from .numbers.generic import Generic
from .numbers.quantities import BRANCH, ORDER, SIGN
from .probe import singular
from .result import Counterexample, Result, Status, Verdict
from .sharp import is_sharp

SHORT_DECIMALS = 1
"""Decimals of the numbers in a counterexample, if the statement also fails at numbers this short."""


def decide(paper: str, entry: Entry, lost: str, orders: Sequence[int] = ORDERS) -> Result:
    """Return the result of an entry; ``paper`` is the paper's slug, ``lost`` the characters that its extraction lost.

    Raises
    ------
    UndecidedError
        If the entry is incomplete, or the computation contradicts its condition, correction or claimed domain.
    """
    _check(entry, lost + entry.lost)
    if entry.because is not None:
        _support(entry, entry.because)
    orders = tuple(n for n in orders if entry.orders is None or n in entry.orders) or (entry.orders or orders)
    listed = tuple(judge(entry, reading, orders) for reading in entry.readings)
    verdicts = tuple(sorted(listed, key=lambda verdict: not verdict.true))
    first, truths = verdicts[0], {verdict.true for verdict in listed}
    supported = any(r.supported_by and not v.true for r, v in zip(entry.readings, listed, strict=True))
    decided = entry.corrected if entry.corrected is not None else first.statement
    sharp = entry.condition is not None and is_sharp(entry.condition, decided)
    result = partial(Result, paper, entry, verdicts=verdicts, exact=sharp)
    if first.true and (supported or (not entry.extract and len(truths) > 1)):  # the text does not decide
        return result(Status.AMBIGUOUS, "; ".join(verdict.method for verdict in verdicts))
    if first.true:
        return result(Status.HOLDS if entry.condition is None else Status.HOLDS_IF, first.method)
    if entry.corrected is None:
        raise UndecidedError(f"({entry.number}) is false and has no correction: {first.method}")
    correction = judge(entry, Reading(entry.corrected), orders)
    if not correction.true:
        raise UndecidedError(f"({entry.number}): the correction is false: {correction.method}")
    return result(Status.ERRATUM, f"{first.method}; correction {correction.method}")


def _check(entry: Entry, lost: str) -> None:
    """Raise if an entry lacks a part that another part needs, or does not agree with the extracted text."""
    unfaithful = not all(faithful(reading.statement, entry.extract, lost) for reading in entry.readings)
    mistakes = {
        "an argument leads on from an identity that is proved": entry.argument and entry.because is None,
        "rates are nested, which claims of files may do": any(rate_depth(r.statement) > 1 for r in entry.readings),
        "a claimed domain and the words that state it come together": (entry.claimed is None) != (entry.stated is None),
        f"a reading does not have the characters of line {entry.line}": entry.extract and unfaithful,
        "an erratum shows the words of the paper": entry.corrected is not None and not (entry.extract or entry.said),
        f"the correction is a reading of line {entry.line}":
            entry.corrected is not None and entry.extract and faithful(entry.corrected, entry.extract, lost),
    }
    for mistake, made in mistakes.items():
        if made:
            raise UndecidedError(f"({entry.number}): {mistake}")


def _support(entry: Entry, identity: Term) -> None:
    """Raise unless the supporting identity is proved; points where it is undefined are ignored."""
    moving = entry.moving or bool(with_trait(Trait.RATE, identity))
    entry = replace(entry, condition=None, claimed=None, also=None, moving=moving)
    refuted = next((o for o in explore(entry, identity, ORDERS) if o.truth is False), None)
    if refuted is not None or prove(entry, identity, ORDERS) is None:
        reason = "not exact" if refuted is None else f"false at {refuted.place}"
        raise UndecidedError(f"({entry.number}): the supporting identity is not proved: {reason}")


def judge(entry: Entry, reading: Reading, orders: Sequence[int]) -> Verdict:
    """Return the verdict on one reading: evaluate it at points to refute it, then prove it exactly."""
    verdict = partial(Verdict, reading.statement, reading.note)
    trials = list(explore(entry, reading.statement, orders))
    inside = [trial for trial in trials if trial.inside]
    failed = next((trial for trial in inside if trial.truth is not True), None)
    if failed is not None:
        short = explore(entry, reading.statement, orders, SHORT_DECIMALS)
        shown = next((trial for trial in short if trial.inside and trial.truth is False), failed)
        return verdict(False, f"refuted at {failed.place}", counterexample(shown, entry, reading.statement))
    if (refuted := _refuted(entry, reading.statement)) is not None:
        return verdict(False, f"refuted at {refuted.point}", refuted)
    outside = [trial for trial in trials if not trial.inside]
    if not inside or (entry.condition is not None and not outside):
        raise UndecidedError(f"({entry.number}): no point on {'both sides' if inside else 'the inside'} of its domain")
    beyond = _beyond(entry, reading.statement, outside)
    method = _method(entry, reading.statement, prove(entry, reading.statement, orders), len(inside))
    return verdict(True, f"{method}; also true at {beyond.point}" if beyond else method)


def _refuted(entry: Entry, statement: Term) -> Counterexample | None:
    """Return a point at which a statement without definitions, domain or condition fails, as for claims of files."""
    if entry.where or entry.also or entry.claimed is not None or entry.condition is not None:
        return None
    if not branched(statement) and next(singular(statement), None) is None:
        return None  # a polynomial identity has no special place
    return first_failure(Claim(entry, statement, lenient=True))


def _beyond(entry: Entry, statement: Term, outside: Sequence[Trial]) -> Trial | None:
    """Return the first trial outside the condition at which the statement is true, if any.

    Raise if the condition is too strict: the statement is true outside it with fewer than two special symbols. Also
    raise if the statement has a value outside a condition that its denominators show to be sharp.
    """
    for trial in outside:
        if trial.truth is True and not trial.pair:
            raise UndecidedError(f"({entry.number}): true outside its condition, at {trial.place}")
        if trial.truth is not None and entry.condition is not None and is_sharp(entry.condition, statement):
            raise UndecidedError(f"({entry.number}): its form says no value, but there is one, at {trial.place}")
    return next((trial for trial in outside if trial.truth is True), None)


def _method(entry: Entry, statement: Term, exact: str | None, points: int) -> str:
    """Return the method in words. A delicate statement proved at generic values may fail at special ones."""
    evidence = f"60-digit evaluation at {points} seeded points"
    supported = ", with a supporting identity proved exactly" if entry.because not in (None, statement) else ""
    if exact is None and entry.argument:
        return f"proved by the argument in {entry.argument} from identities proved exactly; {evidence} besides"
    if exact is None:
        return f"evidence: {evidence}{supported}"
    if any(entry.free(part) for part in with_trait(Trait.DELICATE, statement)):
        return f"{exact} where symbols are generic, {evidence}{supported}"
    return f"{exact}{supported}"


def prove(entry: Entry, statement: Term, orders: Sequence[int], found: list[Pairs] | None = None) -> str | None:
    """Prove a statement exactly; return the method, or None if no exact field suits its operations and domain.

    If `found` is a list, fractions are not reduced, and it receives the pairs of equal numbers for each choice of
    order, branch and sign.
    Raise if the statement is false at generic values although it is true at all seeded points.
    """
    free = entry.free(statement)
    order, branch, sign = (next((s for s in free if s.quantity is q), None) for q in (ORDER, BRANCH, SIGN))
    # sort vectors whose magnitude occurs to the front: only the first vector has a rational magnitude
    lengths = {symbol for part in with_trait(Trait.LENGTH, statement) for symbol in entry.free(part)}
    generic = sorted((a for a in free if a not in (order, branch, sign)), key=lambda a: a not in lengths)
    if order is not None and branch is None:
        with suppress(NotExactError):
            if _checked(entry, statement, Generic(generic, False, entry.moving, order=order), found):
                return "exact, all n"
    dual, checked = takes_apart(statement, *entry.definitions), False
    try:
        for n in orders if order is not None else (0,):
            for k, plus_minus in product(range((entry.branches or n) if branch else 1), (1, -1) if sign else (1,)):
                steps = 4 * n or steps_of(statement)
                point = Generic(generic, dual, entry.moving, steps, framed=not entry.components)
                if branch is not None:
                    point.fix_branch(branch, k)
                point.values |= {a: value for a, value in ((order, n), (sign, plus_minus)) if a is not None}
                checked |= _checked(entry, statement, point, found)
    except NotExactError:
        return None
    if not checked:
        return None
    return "exact" if order is None else f"exact, n = {', '.join(map(str, orders))}"


def _checked(entry: Entry, statement: Term, point: Generic, found: list[Pairs] | None = None) -> bool:
    """Return whether the generic values lie in the domain; if they do, raise unless the statement is true there."""
    point.field.functions.lowest_terms = found is None
    pairs: Pairs | None = None if found is None else []

    def value(part: Term, pairs: Pairs | None = None) -> Any:
        return Env(point.field, dict(point.values), entry.definitions, point.dual, point.moving, pairs).value(part)

    try:
        inside = all(value(part) for part in (entry.claimed, entry.condition) if part is not None)
    except NotExactError:
        inside = True
    except ArithmeticError:
        inside = False
    if inside and not value(statement, pairs):
        raise UndecidedError(f"({entry.number}): true at all points but false exactly")
    if found is not None and inside:
        found.append(pairs or [])
    return inside
