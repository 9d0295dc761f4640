"""Mutants of true statements of the papers, made and executed by ``derive.papers.mutation``."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

from derive.papers import PAPERS
from derive.papers.decide import decide
from derive.papers.mutation import Score, trials, true_statements

from .mutant import EQUIVALENT, KILLED, SURVIVED, Mutant, Verdict


def mutants() -> Iterator[Mutant]:
    """Yield every true statement with one change, in the statement or in its domain."""
    yield Mutant("papers", "none", "unchanged", partial(Verdict, SURVIVED))
    for paper in PAPERS:
        for entry in paper.entries():
            for statement in true_statements(decide(paper.slug, entry, paper.lost)):
                for change, trial in trials(entry, statement):
                    operator = change.partition(" made ")[0]
                    yield Mutant(f"{paper.short} ({entry.number})", operator, change, partial(_trial, trial))


def _trial(execute: Callable[[], Score]) -> Verdict:
    score = execute()
    if score.survivors:
        return Verdict(SURVIVED)
    return Verdict(KILLED, "execution") if score.killed else Verdict(EQUIVALENT)
