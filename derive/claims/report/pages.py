"""Report as JSON, Markdown, HTML and LaTeX, mostly by templates."""

from __future__ import annotations

import json
import re

from ...output.facts import json_rows
from ...output.templates import holes, render
from ..language.operator_table import define
from ..language.printed import ATOM, LIST, POWER, PRODUCT, RELATION, SUM, Term, latex
from ..result import Result, Status
from .content import Report, command, details, example, extent, label, place, readings, subject, why
from .plain import escape

SCHEMA = 3
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
    functions = (label, notes, extent, place, readings, why, subject, command, example, in_cell, mathml, escape)
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


def in_cell(latex: str) -> str:
    """Return a formula without bars, which would end a cell of a table in Markdown."""
    return latex.replace(r"\|", r"\Vert ").replace("|", r"\vert ")


def mathml(latex: str) -> str:
    """Return the formula as displayed MathML."""
    from latex2mathml.converter import convert  # slow import, needed by one format only

    return str(convert(re.sub(r"\\text\{([^{}$]*(?:\$[^$]*\$[^{}$]*)+)\}", _apart, latex), display="block"))


def _apart(found: re.Match[str]) -> str:
    r"""Move the formulas out of a ``\text`` command."""
    pieces = found.group(1).split("$")
    return "".join(piece if i % 2 else rf"\text{{{piece}}}" for i, piece in enumerate(pieces) if piece)
