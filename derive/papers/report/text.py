"""The report as tables: counts, then what is wrong with printed and corrected side by side, then the rest."""

from __future__ import annotations

import io

from rich.console import Console
from rich.table import Table

from ..equation import Result, Status
from .content import MEANING, Chapter, Report, example, label, readings
from .plain import plain

WIDTH = 120


def as_text(report: Report) -> str:
    """Plain text, `WIDTH` columns wide, the same on a terminal and in a file."""
    screen = Console(file=io.StringIO(), width=WIDTH, highlight=False, color_system=None, markup=False, emoji=False)
    screen.print(counts(report))
    for chapter in report.chapters:
        for status, table in TABLES.items():
            if chapter.of(status):
                screen.print()
                screen.print(table(chapter))
    if report.proofs:
        screen.print()
        screen.print(proofs(report))
    output = screen.file
    assert isinstance(output, io.StringIO)
    return "\n".join(line.rstrip() for line in output.getvalue().splitlines()) + "\n"


def counts(report: Report) -> Table:
    """How many equations of each paper have each status."""
    table = Table(title="equations decided", title_justify="left")
    table.add_column("paper")
    for status in MEANING:
        table.add_column(str(status), justify="right")
    table.add_column("all", justify="right")
    for chapter in report.chapters:
        numbers = chapter.counts.values()
        table.add_row(chapter.paper.short, *map(str, numbers), str(sum(numbers)))
    return table


def errata(chapter: Chapter) -> Table:
    """Printed and corrected, side by side."""
    table = _table(chapter, Status.ERRATUM, "equation", "printed", "corrected")
    for result in chapter.of(Status.ERRATUM):
        table.add_row(_name(result), plain(result.printed), plain(result.corrected or ""), end_section=True)
        if result.counterexample is not None:
            table.add_row("where they differ", "\n".join(example(result.counterexample)), readings(result))
    return table


def ambiguous(chapter: Chapter) -> Table:
    """Each reading with its verdict."""
    table = _table(chapter, Status.AMBIGUOUS, "equation", "reading", "verdict")
    for result in chapter.of(Status.AMBIGUOUS):
        for i, verdict in enumerate(result.verdicts):
            note = f"\n{verdict.note}" if verdict.note else ""
            table.add_row("" if i else _name(result), plain(verdict.latex) + note, str(verdict.true).lower())
    return table


def conditional(chapter: Chapter) -> Table:
    """Printed, with its condition."""
    table = _table(chapter, Status.HOLDS_IF, "equation", "printed", "condition")
    for result in chapter.of(Status.HOLDS_IF):
        table.add_row(_name(result), plain(result.printed), plain(result.condition or ""))
    return table


def true(chapter: Chapter) -> Table:
    """Printed, with how it is known."""
    table = _table(chapter, Status.HOLDS, "equation", "printed", "method")
    for result in chapter.of(Status.HOLDS):
        table.add_row(_name(result), plain(result.printed), result.method)
    return table


TABLES = {
    Status.ERRATUM: errata,
    Status.AMBIGUOUS: ambiguous,
    Status.HOLDS_IF: conditional,
    Status.HOLDS: true,
}


def proofs(report: Report) -> Table:
    """The theorems behind the formulas of this project."""
    table = Table(title="proofs", title_justify="left", show_lines=False)
    for heading in ("scope", "status", "statement"):
        table.add_column(heading)
    for proof in report.proofs:
        table.add_row(proof.scope, proof.status, proof.statement)
    return table


def _table(chapter: Chapter, status: Status, first: str, second: str, third: str) -> Table:
    title = f"{chapter.paper.short}, {status}: {MEANING[status]}"
    table = Table(title=title, title_justify="left", show_lines=True)
    table.add_column(first, width=24)
    table.add_column(second, ratio=3)
    table.add_column(third, ratio=3 if status is Status.ERRATUM else 2)
    return table


def _name(result: Result) -> str:
    return f"{label(result)}\n{result.equation.title}"
