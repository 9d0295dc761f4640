"""Claims near a claim: changes in one step that mend it, terms that do not matter, and constraints that it needs."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import islice

from ..language.printed import Symbol
from ..language.written import written
from ..numbers.balls import BlurredError
from .changes import CANDIDATES_MAX, changes, signs_and_coefficients
from .claim import Claim, Place, kind
from .places import Probe

CHANGES_MAX, SAMPLE = 3, 6
"""Changes shown, and points at which a changed claim is tried first."""


def true_at(claim: Claim, found: Sequence[Place], least: int = 1) -> bool:
    """Return whether a claim is false at no point, and true at so many."""
    true = 0
    for place in found:
        try:
            truth = claim.truth(place)
        except BlurredError:
            continue
        except (TypeError, AttributeError, ValueError, IndexError, ArithmeticError):
            return False
        if truth is False:
            return False
        true += truth is True
    return true >= least


def mended(claim: Claim, failing: Place | None, holds: Callable[[Claim], bool]) -> Iterator[str]:
    """Yield the changes in one step that make a false claim true."""
    sample = list(islice(Probe(claim).quick(), SAMPLE))
    first = [failing] if failing else []
    shown: set[str] = set()  # one change of each sort, since changes of one sort are often equivalent
    for _, sort, words, changed in changes(claim.entry.written or claim.statement)[:CANDIDATES_MAX]:
        other = claim.with_statement(claim.entry.expanded(changed))
        wanted = sort not in shown and len(shown) < CHANGES_MAX
        if wanted and true_at(other, [*first, *sample]) and holds(other):
            shown.add(sort)
            yield f"{words}: {written(changed)}"


def vacuous(claim: Claim, true: Sequence[Place]) -> Iterator[str]:
    """Yield the terms of a true claim whose sign or coefficient does not matter."""
    for words, changed in signs_and_coefficients(claim.entry.written or claim.statement):
        if true_at(claim.with_statement(claim.entry.expanded(changed)), true, (len(true) + 1) // 2):
            yield words


def needed(claim: Claim) -> Iterator[str]:
    """Yield the constraints of letters and of the domain without which a true claim is false."""
    for letter in claim.coordinates:
        row = kind(letter)
        if row.free and row.needs:
            name = f"constant {row.free}" if row.constant else row.free
            free = {letter: Symbol(letter.name, name, *map(str, letter.args[2:]))}
            claimed = None if claim.entry.claimed is None else claim.entry.claimed.xreplace(free)
            entry = replace(claim.entry, claimed=claimed)
            other = replace(claim, entry=entry, statement=claim.statement.xreplace(free))
            if not true_at(other, list(Probe(other).quick())):
                yield row.needs.format(letter.name)
    for constraint in claim.constraints:
        other = replace(claim, entry=replace(claim.entry, claimed=None))
        if not true_at(other, list(Probe(other).quick())):
            yield written(constraint)
