"""Report as text tables: counts, then errata with printed and corrected form side by side, then other statuses."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from derive.output.tables import WIDTH, Column, Grid

from ..result import Result, Status
from .content import MEANING, Chapter, Report, command, domain, example, label, readings
from .plain import plain

MIN_WIDTH = 72
"""Minimum width for two formulas side by side."""

KNOWN, DIFFERENT = "how it is known", "where they differ"
"""Headings of the rows below an erratum."""


def as_text(report: Report, width: int = WIDTH) -> str:
    """Return the report as plain text of at most this width."""
    return "\n".join(grid.text(width) for grid in _grids(report))


def _grids(report: Report) -> Iterator[Grid]:
    yield counts(report)
    for chapter in report.chapters:
        for status, table in TABLES.items():
            if chapter.of(status):
                yield table(chapter)
    if report.proofs:
        yield proofs(report)


def counts(report: Report) -> Grid:
    """Return the table of counts by paper and status."""
    numbers = [Column(str(status), number=True) for status in MEANING]
    rows = [(c.paper.short, *map(str, c.counts.values()), str(sum(c.counts.values()))) for c in report.chapters]
    return Grid("equations decided", [Column("paper"), *numbers, Column("all", number=True)], rows)


def errata(chapter: Chapter) -> Grid:
    """Return the table of errata, with printed and corrected form side by side."""
    rows = (row for result in chapter.of(Status.ERRATUM) for row in _erratum(result))
    return _grid(chapter, Status.ERRATUM, ("equation", "printed", "corrected"), rows)


def _erratum(result: Result) -> Iterator[tuple[str, ...]]:
    """Yield the rows of an erratum: both forms, the method, and a numerical counterexample."""
    yield _name(result), _lines(plain(result.printed), *domain(result)), plain(result.corrected or "")
    yield KNOWN, result.method, readings(result)
    if result.counterexample is not None:
        whole = f"in full: {command(result)} --format json"
        yield DIFFERENT, "\n".join(example(result.counterexample)), whole


def ambiguous(chapter: Chapter) -> Grid:
    """Return the table of ambiguous readings with their verdicts."""
    rows = (
        (
            "" if i else _name(result),
            _lines(plain(verdict.latex), verdict.note),
            str(verdict.true).lower(),
        )
        for result in chapter.of(Status.AMBIGUOUS)
        for i, verdict in enumerate(result.verdicts)
    )
    return _grid(chapter, Status.AMBIGUOUS, ("equation", "reading", "verdict"), rows)


def conditional(chapter: Chapter) -> Grid:
    """Return the table of equations that hold under a condition, with condition and method."""
    rows = ((_name(r), plain(r.printed), _lines(*domain(r), r.method)) for r in chapter.of(Status.HOLDS_IF))
    return _grid(chapter, Status.HOLDS_IF, ("equation", "printed", "condition"), rows)


def true(chapter: Chapter) -> Grid:
    """Return the table of equations that hold, with the stated domain and the method."""
    rows = ((_name(r), plain(r.printed), _lines(*domain(r), r.method)) for r in chapter.of(Status.HOLDS))
    return _grid(chapter, Status.HOLDS, ("equation", "printed", "method"), rows)


TABLES = {
    Status.ERRATUM: errata,
    Status.AMBIGUOUS: ambiguous,
    Status.HOLDS_IF: conditional,
    Status.HOLDS: true,
}


def proofs(report: Report) -> Grid:
    """Return the table of proofs."""
    rows = [(proof.scope, proof.status, proof.statement) for proof in report.proofs]
    return Grid("proofs", [Column("scope"), Column("status"), Column("statement")], rows, MIN_WIDTH)


def _grid(chapter: Chapter, status: Status, headings: tuple[str, str, str], rows: Iterable[tuple[str, ...]]) -> Grid:
    title = f"{chapter.paper.short}, {status}: {MEANING[status]}"
    first, second, third = headings
    last = Column(third, ratio=3 if status is Status.ERRATUM else 2)
    columns = [Column(first, width=24), Column(second, ratio=3), last]
    return Grid(title, columns, list(rows), MIN_WIDTH, ruled=True, remarks=(KNOWN, DIFFERENT))


def _lines(*parts: str) -> str:
    return "\n".join(filter(None, parts))


def _name(result: Result) -> str:
    return f"{label(result)}\n{result.equation.title}"
