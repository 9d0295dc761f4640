"""Report as text tables: counts, then errata with printed and corrected form side by side, then other statuses."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from ...output.shown import WIDTH, Column, Grid
from ..language.written import written
from ..result import Result, Status
from .content import MEANING, Chapter, Report, command, details, domain, example, label, readings, shown
from .plain import plain

MIN_WIDTH = 72
"""Minimum width for two formulas side by side."""

KNOWN, DIFFERENT = "how it is known", "where they differ"
"""Headings of the rows below an erratum."""

Rows = Iterator[tuple[str, ...]]


def as_text(report: Report, width: int = WIDTH) -> str:
    """Return the report as plain text of at most this width."""
    return "\n".join(grid.text(width) for grid in _grids(report))


def _grids(report: Report) -> Iterator[Grid]:
    numbers = [Column(str(status), number=True) for status in report.statuses]
    counts = [
        (c.paper.short, *(str(c.counts[status]) for status in report.statuses), str(len(c.results)))
        for c in report.chapters
    ]
    yield Grid("equations decided", [Column("paper"), *numbers, Column("all", number=True)], counts)
    for chapter in report.chapters:
        if chapter.of_file:
            yield from _claims(chapter)
            continue
        for status in TABLES:
            if chapter.of(status):
                yield table(chapter, status)
    if report.proofs:
        proofs = [(proof.scope, proof.status, proof.statement) for proof in report.proofs]
        yield Grid("proofs", [Column("scope"), Column("status"), Column("statement")], proofs, MIN_WIDTH)


def _claims(chapter: Chapter) -> Iterator[Grid]:
    """Yield the table of a file's claims, then each claim that does not hold, in full."""
    columns = [Column("equation", width=14), Column("status", width=10)]
    columns += [Column("claim", ratio=3), Column("finding", ratio=3)]
    rows = [
        (label(r), str(r.status), shown(r), _lines(*domain(r), *details(r)[:1], r.method)) for r in chapter.results
    ]
    yield Grid(chapter.paper.short, columns, rows, MIN_WIDTH, ruled=True)
    for result in chapter.results:
        if result.status in (Status.FALSE, Status.ERRATUM):
            yield Grid(f"{label(result)}: {result.status}", [Column("", width=14), Column("")], list(_full(result)))


def _full(result: Result) -> Rows:
    yield "claim", shown(result)
    if result.equation.at:
        yield "printed at", result.equation.at
    if result.equation.mended is not None and result.corrected:
        yield "corrected", written(result.equation.mended)
    if result.counterexample is not None:
        yield DIFFERENT, _lines(*example(result.counterexample, result.equation))
    for line in details(result):
        yield "", line
    yield KNOWN, result.method


def table(chapter: Chapter, status: Status) -> Grid:
    """Return the table of a paper's results with one status."""
    second, third, rows_of = TABLES[status]
    title = f"{chapter.paper.short}, {status}: {MEANING[status]}"
    last = Column(third, ratio=3 if status is Status.ERRATUM else 2)
    columns = [Column("equation", width=24), Column(second, ratio=3), last]
    rows = [row for result in chapter.of(status) for row in rows_of(result)]
    return Grid(title, columns, rows, MIN_WIDTH, ruled=True, remarks=(KNOWN, DIFFERENT))


def _erratum(result: Result) -> Rows:
    """Yield the rows of an erratum: both forms, the method, and a numerical counterexample."""
    yield _name(result), _lines(plain(result.printed), *domain(result)), plain(result.corrected or "")
    yield KNOWN, result.method, readings(result)
    if result.counterexample is not None:
        yield DIFFERENT, _lines(*example(result.counterexample)), f"in full: {command(result)} --format json"


def _ambiguous(result: Result) -> Rows:
    for i, verdict in enumerate(result.verdicts):
        yield "" if i else _name(result), _lines(plain(verdict.latex), verdict.note), str(verdict.true).lower()


def _true(result: Result) -> Rows:
    """Yield the row of an equation with its domain and method."""
    yield _name(result), plain(result.printed), _lines(*domain(result), result.method)


TABLES: dict[Status, tuple[str, str, Callable[[Result], Rows]]] = {
    Status.ERRATUM: ("printed", "corrected", _erratum),
    Status.AMBIGUOUS: ("reading", "verdict", _ambiguous),
    Status.UNDECIDED: ("printed", "reason", _true),
    Status.HOLDS_IF: ("printed", "condition", _true),
    Status.HOLDS: ("printed", "method", _true),
}
"""Headings of the second and third column, and the rows of a result, by status."""


def _lines(*parts: str) -> str:
    return "\n".join(filter(None, parts))


def _name(result: Result) -> str:
    return f"{label(result)}\n{result.equation.title}"
