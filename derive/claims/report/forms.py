"""Report as text tables and JSON, and as Markdown, HTML and LaTeX by templates."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator

from ...output.pages import holes, json_rows, render
from ...output.shown import WIDTH, Column, Grid
from ..language.operations import written
from ..language.operator_table import define
from ..language.printed import ATOM, LIST, POWER, PRODUCT, RELATION, SUM, Term, latex
from ..result import Result, Status
from .content import (
    ERRORS,
    MEANING,
    Chapter,
    Report,
    command,
    details,
    domain,
    example,
    extent,
    label,
    place,
    readings,
    shown,
    subject,
    why,
)
from .plain import code, escape, in_cell, in_line, plain, prose

MIN_WIDTH = 72
"""Minimum width for two formulas side by side."""

KNOWN, DIFFERENT = "how it is known", "where they differ"
"""Headings of the rows below an erratum."""

Rows = Iterator[tuple[str, ...]]


def as_text(report: Report, width: int = WIDTH) -> str:
    end = [f"{report.summary}\n"] if report.unread else []
    return "\n".join([*(grid.text(width) for grid in _grids(report)), *end])


def _grids(report: Report) -> Iterator[Grid]:
    numbers = [Column(str(status), number=True) for status in report.statuses]
    counts = [
        (c.paper.short, *(str(c.counts[status]) for status in report.statuses), str(len(c.results)))
        for c in report.chapters
    ]
    if counts:
        yield Grid("equations decided", [Column("paper"), *numbers, Column("all", number=True)], counts)
    for chapter in report.chapters:
        if chapter.of_file:
            yield from _claims(chapter)
            continue
        for status in TABLES:
            if chapter.of(status):
                yield table(chapter, status)
    if report.unread:
        places = [(row["number"], row["at"]) for row in report.unread]
        yield Grid("unread: equations without a claim", [Column("equation", width=24), Column("printed at")], places)
    if report.problems:
        unread = [(problem.equation, str(problem)) for problem in report.problems]
        yield Grid(ERRORS, [Column("equation", width=14), Column("reason")], unread, MIN_WIDTH)
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
    if result.equation.printed:
        yield "in print", result.equation.printed
    if result.equation.mended is not None and result.corrected:
        yield "corrected", written(result.equation.mended)
    if result.counterexample is not None:
        yield DIFFERENT, _lines(*example(result.counterexample, result.equation))
    for line in details(result):
        yield "", line
    yield KNOWN, result.method


def table(chapter: Chapter, status: Status) -> Grid:
    second, third, rows_of = TABLES[status]
    title = f"{chapter.paper.short}, {status}: {MEANING[status]}"
    last = Column(third, ratio=3 if status is Status.ERRATUM else 2)
    columns = [Column("equation", width=24), Column(second, ratio=3), last]
    rows = [row for result in chapter.of(status) for row in rows_of(result)]
    return Grid(title, columns, rows, MIN_WIDTH, ruled=True, remarks=(KNOWN, DIFFERENT))


def _erratum(result: Result) -> Rows:
    yield _name(result), _lines(plain(result.printed), *domain(result)), plain(result.corrected or "")
    yield KNOWN, result.method, readings(result)
    if result.counterexample is not None:
        yield DIFFERENT, _lines(*example(result.counterexample)), f"in full: {command(result)} --format json"


def _ambiguous(result: Result) -> Rows:
    for i, verdict in enumerate(result.verdicts):
        yield "" if i else _name(result), _lines(plain(verdict.latex), verdict.note), str(verdict.true).lower()


def _true(result: Result) -> Rows:
    yield _name(result), plain(result.printed), _lines(*domain(result), result.method)


TABLES: dict[Status, tuple[str, str, Callable[[Result], Rows]]] = {
    Status.ERRATUM: ("printed", "corrected", _erratum),
    Status.AMBIGUOUS: ("reading", "verdict", _ambiguous),
    Status.UNDECIDED: ("printed", "reason", _true),
    Status.UNREFUTED: ("printed", "tried", _true),
    Status.HOLDS_IF: ("printed", "condition", _true),
    Status.HOLDS: ("printed", "method", _true),
}
"""Headings of the second and third column, and the rows of a result, by status."""


def _lines(*parts: str) -> str:
    return "\n".join(filter(None, parts))


def _name(result: Result) -> str:
    return f"{label(result)}\n{result.equation.title}"


SCHEMA = 4
LEFT_OUT = ("line", "source", "reading_count", "capped")
"""Fields that say nothing about the equation."""
PROOF_FIELDS = ("statement", "scope", "status", "method")
COLOUR = "#b3261e"
CHANGED = {
    level: define(f"changed {level}", rf"\color{{{{{COLOUR}}}}}{{{{{{0}}}}}}", "{0}", level, (level,), lambda env, a: a)
    for level in (LIST, RELATION, SUM, PRODUCT, POWER, ATOM)
}
"""Operators that colour a term, by binding strength."""


def as_json(report: Report) -> str:
    """Return the report as JSON; `Result.as_json` and `derive.proof.Proof` describe the fields."""
    data = {
        "schema": SCHEMA,
        "equations": [result.as_json() for result in report.results],
        "proofs": [
            {**{name: getattr(proof, name) for name in PROOF_FIELDS}, "seconds": round(proof.seconds, 6)}
            for proof in report.proofs
        ],
        "unread": report.unread,
        "errors": [problem.as_json() for problem in report.problems],
    }
    return json.dumps(data, indent=2, ensure_ascii=False) + "\n"


def data(report: Report) -> str:
    """Return the facts about the equations as JSON for the data beside a page: what is empty is left out."""
    rows = []
    for result in report.results:
        facts = {name: value for name, value in result.as_json().items() if value and name not in LEFT_OUT}
        facts["readings"] = [reading for reading in facts["readings"] if reading["latex"] != result.printed]
        rows.append({name: value for name, value in facts.items() if value})
    return json_rows(schema=SCHEMA, equations=rows)


def page(form: str, report: Report) -> str:
    """Return the report as Markdown ("md"), HTML or LaTeX ("tex"): the template gets the functions that it names."""
    template = f"report/errata.{form}.j2"
    functions = (label, notes, extent, place, readings, why, subject, command, example, mathml, escape,
                 prose, in_line, in_cell, code)
    data = {"report": report, "statuses": report.statuses, "differing": differing_sides}
    data |= {status.name: status for status in Status} | {function.__name__: function for function in functions}
    return render(template, **{name: data[name] for name in holes(template)})


def notes(result: Result) -> tuple[str, ...]:
    """Return the notes on a result: words of the paper, remark, and passage that decides the reading."""
    entry = result.equation
    said = f"In the paper: “{entry.said}”" if entry.said else ""
    fixed = f"The reading follows from {entry.fixed_by}." if entry.fixed_by else ""
    return *(note for note in (said, entry.remark, fixed) if note), *details(result)


def differing_sides(result: Result) -> tuple[str, str]:
    """Return the printed and the corrected formula as LaTeX, with their smallest differing parts in colour."""
    entry = result.equation
    mended = entry.corrected if entry.mended is None else entry.mended
    assert mended is not None
    printed, corrected = _marked(entry.written or result.verdicts[0].statement, mended)
    return latex(printed), latex(corrected)


def _marked(a: Term, b: Term) -> tuple[Term, Term]:
    if a == b:
        return a, b
    if a.arguments and a.operator is b.operator and len(a.arguments) == len(b.arguments):
        firsts, seconds = zip(*map(_marked, a.arguments, b.arguments), strict=True)
        return a.operator(*firsts), b.operator(*seconds)
    return CHANGED[a.operator.level](a), CHANGED[b.operator.level](b)


def mathml(latex: str) -> str:
    from latex2mathml.converter import convert  # slow import, needed by one format only

    return str(convert(re.sub(r"\\text\{([^{}$]*(?:\$[^$]*\$[^{}$]*)+)\}", _apart, latex), display="block"))


def _apart(found: re.Match[str]) -> str:
    r"""Move the formulas out of a ``\text`` command."""
    pieces = found.group(1).split("$")
    return "".join(piece if i % 2 else rf"\text{{{piece}}}" for i, piece in enumerate(pieces) if piece)
