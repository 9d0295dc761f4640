"""What a report says, before it has a format."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from derive.proof import Proof

from ..equation import Result, Status
from ..paper import Paper

MEANING = {
    Status.ERRATUM: "false as printed; the correction is proved",
    Status.AMBIGUOUS: "the text is too lossy: its readings differ",
    Status.HOLDS_IF: "true exactly under the condition shown",
    Status.HOLDS: "true as printed",
}
"""The statuses in the order of the report."""


@dataclass(frozen=True)
class Chapter:
    """The results of one paper."""

    paper: Paper
    results: tuple[Result, ...]

    def of(self, status: Status) -> tuple[Result, ...]:
        """Those with a status."""
        return tuple(result for result in self.results if result.status is status)

    @property
    def counts(self) -> dict[Status, int]:
        """How many there are of each status."""
        return {status: len(self.of(status)) for status in MEANING}


@dataclass(frozen=True)
class Report:
    """Results and proofs.

    Attributes
    ----------
    chapters : tuple of Chapter
        One for each paper that has results.
    proofs : tuple of Proof
    root : str
        Where the project lies, seen from the report: what makes a link of a source. Empty for no links.
    """

    chapters: tuple[Chapter, ...]
    proofs: tuple[Proof, ...]
    root: str = ""

    @classmethod
    def of(cls, papers: Iterable[Paper], results: Sequence[Result], proofs: Iterable[Proof], root: str = "") -> Report:
        """Sort results by paper."""
        chapters = (Chapter(paper, tuple(r for r in results if r.paper == paper.slug)) for paper in papers)
        return cls(tuple(chapter for chapter in chapters if chapter.results), tuple(proofs), root)

    @property
    def results(self) -> tuple[Result, ...]:
        """All results."""
        return tuple(result for chapter in self.chapters for result in chapter.results)

    @property
    def failed(self) -> tuple[Proof, ...]:
        """The proofs that failed."""
        return tuple(proof for proof in self.proofs if not proof.proved)

    def link(self, result: Result) -> str:
        """The module that holds the entry of a result, as a link; it names no line of code, which moves."""
        return f"{self.root}/{result.equation.source}" if self.root else ""


def label(result: Result) -> str:
    """How an equation is cited: ``(111)``, or its slug."""
    number = result.equation.number
    return f"({number})" if number.isdecimal() else number
