"""Mutants of the papers' statements, by the operators of ``derive.papers.mutation``."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import Any

from .mutant import EQUIVALENT, KILLED, MEANINGLESS, SURVIVED, Fate, Mutant
from .python import Edit


@dataclass(frozen=True)
class Statements:
    """Every statement of the papers that was found true; one mark of it or of its domain changed, it must not be."""

    name: str = "statements"
    what: str = "statements of the papers that were found true: by executing them"
    checks: None = None
    unchanged: tuple[str, ...] = ("derive.papers",)

    def edit(self, mutant: Mutant) -> Edit | None:
        return None

    def mutants(self, folder: Path) -> Iterator[Mutant]:
        mutation = importlib.import_module("derive.papers.mutation")
        for paper in importlib.import_module("derive.papers").PAPERS:
            for entry in paper.entries():
                for k, statement in enumerate(mutation.true_statements(_decided(paper, entry))):
                    for index, (change, _) in enumerate(mutation.trials(entry, statement)):
                        operator = change.partition(" made ")[0] if " made " in change else change
                        place = f"{paper.short} ({entry.number})"
                        yield Mutant(place, 0, operator, change, (paper.slug, entry.number, k, index))

    def is_one(self, mutant: Mutant) -> bool:
        return True

    def limit(self, mutant: Mutant | None, knowledge: Any) -> float:
        return 120

    def trial(self, mutant: Mutant | None, knowledge: Any, former: Fate | None = None) -> Fate:
        if mutant is None:
            return Fate(SURVIVED)
        mutation = importlib.import_module("derive.papers.mutation")
        slug, number, k, index = mutant.site
        (paper,) = (paper for paper in importlib.import_module("derive.papers").PAPERS if paper.slug == slug)
        (entry,) = (entry for entry in paper.entries() if entry.number == number)
        statement = mutation.true_statements(_decided(paper, entry))[k]
        _, trial = next(islice(mutation.trials(entry, statement), index, None))
        score = trial()
        if score.survivors:
            return Fate(SURVIVED, by=score.survivors[0].statement)
        if score.equivalent:
            return Fate(EQUIVALENT, by="decided exactly: it says the same")
        return Fate(MEANINGLESS) if score.meaningless else Fate(KILLED, "execution")


def _decided(paper: Any, entry: Any) -> Any:
    return importlib.import_module("derive.papers.decide").decide(paper.slug, entry, paper.lost)
