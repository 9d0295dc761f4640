"""Control of proofs: a formula in use, or of a paper, that is changed in one step is proved only if it stays true."""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from contextlib import suppress
from itertools import islice

import pytest

from derive.claims.decide import _premised
from derive.claims.deciding.changes import changes
from derive.claims.deciding.claim import Claim
from derive.claims.deciding.finding import _proof
from derive.claims.deciding.places import Probe
from derive.claims.equation import Entry
from derive.claims.numbers.balls import BlurredError
from derive.papers import PAPERS
from docs.pages.field_facts import sheets

READ = [entry for sheet in (*sheets(), *PAPERS) for entry in sheet.entries()]
ROWS = [entry.meant for entry in READ if entry.corrected is None and not entry.undecided]
POINTS = 12
SORTS = ("sign", "factor", "swapped")


def mutants(entries: Sequence[Entry], count: int) -> Iterator[Claim]:
    """Yield claims with one sign, factor or order of operands changed, so many of each entry."""
    source = random.Random(7)
    for entry in entries:
        steps = [changed for _, sort, _, changed in changes(entry.readings[0].statement) if sort in SORTS]
        for changed in source.sample(steps, min(count, len(steps))):
            with suppress(ValueError):  # a mutant may be no claim at all
                yield _premised(Claim(entry, changed)).within(*([] if entry.condition is None else [entry.condition]))


def is_false(claim: Claim) -> bool:
    """Return whether a claim is certainly false at one of a few points of its domain."""
    for place in islice(Probe(claim).quick(), POINTS):
        with suppress(BlurredError, ArithmeticError, TypeError, AttributeError, ValueError, LookupError):
            if claim.truth(place) is False:
                return True
    return False


def wrongly_proved(entries: Sequence[Entry], count: int) -> tuple[int, list[str]]:
    """Return the number of mutants that are false, and those of them that are proved."""
    false = [claim for claim in mutants(entries, count) if is_false(claim)]
    wrong = [claim for claim in false if _proof(claim) is not None]
    return len(false), [f"{claim.entry.number}: {claim.statement}" for claim in wrong]


def test_no_false_mutant_of_a_sample_is_proved() -> None:
    count, wrong = wrongly_proved(ROWS[5::51], 1)
    assert count >= 5
    assert wrong == []


@pytest.mark.thorough
def test_no_false_mutant_is_proved() -> None:
    count, wrong = wrongly_proved(ROWS, 2)
    assert count >= 168
    assert wrong == []
