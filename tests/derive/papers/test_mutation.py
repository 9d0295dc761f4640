"""Every mutant of what was found true must stop being true, or say why it is as true as before."""

from __future__ import annotations

import multiprocessing
import pickle
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import pytest

from derive.papers import PAPERS, Status
from derive.papers.decide import decide
from derive.papers.equation import Equation
from derive.papers.mutation import Score, try_mutants

pytestmark = pytest.mark.thorough

ENOUGH = 0.98
PROCESSES = 2
CHUNKS = 24

POINTS = "another point of the same line, or another vector with the same image"
ALSO = "the changed statement is true as well"
EMPTY = "the premise is never fulfilled, or no point lies where the change shows"
ZERO = "both sides are zero, or the part dropped is"
SAME = "the changed domain is the same one, for what is positive or between −1 and 1"
BEYOND = "it is true beyond the domain that the paper claims"

REASONS = {
    "CP23": {
        "6": POINTS, "polar-unique": ALSO, "line": POINTS, "line-free": POINTS, "orthogonal-group": ALSO,
        "18-moment": ZERO, "non-commutative": ALSO, "22-expanded": ZERO, "exponential-unit": ALSO,
        "cayley-well-defined": ALSO, "rodrigues-domain": ALSO, "cayley-quaternion-well-defined": ALSO,
        "38-domain": ALSO, "44-domain": ALSO, "theorem-11-onto": ALSO, "shadow-avoids-singularity": EMPTY, "71": ZERO,
        "120": POINTS, **dict.fromkeys(("sine-P", "sine-Q", "119"), SAME),
        **dict.fromkeys(("theorem-16-factor", "theorem-16-step", "18-axis"), EMPTY),
        **dict.fromkeys(("9", "general-screw", "pure-translation", "pure-rotation", "38", "shadow-vectors"), BEYOND),
        **{f"corollary-{i}-{kind}": ALSO for i in (1, 2, 3) for kind in ("translation", "general")},
        "corollary-4-translation": ALSO, "corollary-4-otherwise": ALSO, "84": BEYOND,
    },
    "K10": {
        "no-field": ALSO, "extension": ZERO, "degenerate": ZERO, "quadratic-form": ZERO, "not-singular": ALSO,
        **dict.fromkeys(("half-angle", "14", "15", "16", "zero-components"), EMPTY),
        **{f"step-{i}": BEYOND for i in (19, 20, 21, 22)},
    },
}  # fmt: skip
"""Why mutants of these entries survive."""


SAMPLE = 6
"""One in so many of the mutants of an entry that should have no survivors; `make mutants` draws from all."""


def step(paper: str, number: str) -> int:
    """One in how many mutants of an entry is tried."""
    return 1 if number in REASONS[paper] else SAMPLE


def statement(entry: Equation) -> Equation:
    """The entry itself, or with its correction in place of what is printed."""
    return entry if entry.corrected is None else entry.reading(entry.corrected)


def _scores(chunk: int) -> dict[tuple[str, str], Score]:
    entries = [(paper, entry) for paper in PAPERS for entry in paper.entries()]
    return {
        (paper.short, entry.number): try_mutants(
            decide(paper.slug, statement(entry), paper.lost, count=False), step(paper.short, entry.number)
        )
        for paper, entry in entries[chunk::CHUNKS]
    }


@pytest.fixture(scope="module")
def scores(shared: Callable[[str, Callable[[Path], object]], Path]) -> dict[tuple[str, str], Score]:
    def fill(folder: Path) -> None:
        context = multiprocessing.get_context("spawn")
        with ProcessPoolExecutor(PROCESSES, mp_context=context) as pool:
            found = {key: score for part in pool.map(_scores, range(CHUNKS)) for key, score in part.items()}
        (folder / "scores").write_bytes(pickle.dumps(found))

    return pickle.loads((shared("mutants_of_papers", fill) / "scores").read_bytes())


def test_mutants_are_killed(scores, record_testsuite_property, capsys) -> None:
    total = sum(scores.values(), start=Score())
    report = f"{total.killed} of {total.killed + len(total.survivors)} mutants killed ({total.share:.1%})"
    report += f", {len(total.equivalent)} more say the same"
    record_testsuite_property("mutation score", report)
    nonsense = total.meaningless - len(total.equivalent)
    with capsys.disabled():
        print(f"\n{report}; {nonsense} combine what cannot be combined")
        for (paper, number), score in scores.items():
            if score.survivors:
                reason = REASONS[paper].get(number, "no reason is known")
                print(f"  {paper} ({number}): {len(score.survivors)} survive: {reason}")
    assert total.killed > 1000
    killed = sum(score.killed * step(*key) for key, score in scores.items())  # of all, as far as a sample tells
    assert killed >= ENOUGH * (killed + len(total.survivors))


def test_survivors_have_a_reason(scores) -> None:
    alive = {key for key, score in scores.items() if score.survivors}
    known = {(paper, number) for paper, reasons in REASONS.items() for number in reasons}
    assert alive == known


def test_every_entry_has_something_true(scores) -> None:
    assert set(scores) == {(paper.short, entry.number) for paper in PAPERS for entry in paper.entries()}


@pytest.mark.parametrize("paper", PAPERS, ids=lambda paper: paper.short)
def test_corrections_hold_in_place_of_what_is_printed(paper) -> None:
    corrected = [entry for entry in paper.entries() if entry.corrected is not None]
    assert corrected
    for entry in corrected:
        status = decide(paper.slug, statement(entry), paper.lost, count=False).status
        assert status is (Status.HOLDS if entry.condition is None else Status.HOLDS_IF), entry.number
