"""Answers for the page on which a reader tries claims and charts: JSON for JSON. The browser runs this file."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from typing import Any

from derive.claims.language.claims import statement
from derive.claims.language.letters import letters
from derive.claims.language.names import ClaimError, Scope
from derive.claims.language.printed import latex
from derive.claims.report.content import MEANING, example
from derive.claims.result import Result
from derive.claims.run import found_here
from derive.claims.sheet import Sheet, sheet
from derive.codegen import catalogue
from derive.codegen.build import print_package
from derive.codegen.targets import TARGETS
from derive.maps.chart import Chart
from derive.pages import formulas

ORDER_MAX = 16
"""Largest order on the page; proofs of higher ones take long in a browser."""

Form = dict[str, str]


def answered(name: str, form: str, early: Callable[[str], None] = lambda answer: None) -> str:
    """Return the answer of a function below, or why there is none; `early` receives verdicts before the last one."""
    try:
        answer = {"decided": decided, "shown": shown, "printed": printed}[name]
        return json.dumps(answer(json.loads(form), lambda found: early(json.dumps(found))))
    except (ValueError, TypeError) as error:
        return json.dumps({"errors": str(error).splitlines()})


def decided(form: Form, early: Callable[[Any], None]) -> dict[str, Any]:
    """Return the verdict on a claim; raise ValueError for what cannot be read in a form, a problem a line."""
    asked, scope = read(form)

    def verdict(result: Result) -> dict[str, Any]:
        meaning = MEANING[result.status].removeprefix("false, ")
        rows = [row for row in _rows(result, scope) if row[1]]
        return {"status": result.status, "meaning": meaning, "claim": result.printed, "rows": rows}

    return verdict(found_here(asked, 0, lambda result: early(verdict(result))))


def read(form: Form) -> tuple[Sheet, Scope]:
    """Return a claim as a sheet, and the names that it may use."""
    declared = _pairs(form.get("letters", "").split(";"))
    tables = {"letters": declared, "definitions": _pairs(form.get("definitions", "").splitlines())}
    claim = {name: form[name] for name in ("claim", "domain") if form.get(name, "").strip()}
    lines = [line for name, table in tables.items() for line in (f"[{name}]", *_toml(table))]
    asked = sheet("\n".join([*lines, "[[equation]]", "number = 1", *_toml(claim)]), "form")
    if asked.problems:
        found = (str(replace(problem, file="", line=None)) for problem in asked.problems)
        raise ValueError("\n".join(text.replace("equation 1", "claim", 1) for text in found))
    known = {a: symbol for name, kind in declared.items() for a, symbol in letters(name, kind).items()}
    return asked, Scope(known, asked.entries()[0].abbreviations)


def _pairs(rows: Iterable[str]) -> dict[str, str]:
    """Return names and texts of rows such as ``v = vector``."""
    found: dict[str, str] = {}
    for row in filter(str.strip, rows):
        name, sign, text = (part.strip() for part in row.partition("="))
        if name in found or not sign:
            raise ValueError(f"{name} is given twice" if sign else f"expected a name, = and a text, got {name!r}")
        found[name] = text
    return found


def _toml(table: dict[str, str]) -> Iterator[str]:
    return (" = ".join(json.dumps(text, ensure_ascii=False) for text in row) for row in table.items())


def _rows(result: Result, scope: Scope) -> Iterator[tuple[str, list[Form]]]:
    """Yield headings with texts about a result. The claim at the end of a text stands as LaTeX."""

    def piece(text: str) -> Form:
        words, colon, claim = text.rpartition(": ")
        try:
            return {"text": words + colon, "latex": latex(statement(claim, scope))}
        except ClaimError:
            return {"text": text}

    entry, outside, failing = result.equation, result.outside, result.counterexample
    yield "for", [{"text": "", "latex": result.claimed}] if result.claimed else []
    yield "holds where", [piece(result.found)] if result.found else []
    at = () if outside is None else (outside.point, *(example(outside, entry) if outside.sides else ()))
    for heading, lines in (
        ("outside", at), ("fails at", example(failing, entry) if failing else ()), ("true with", result.changes),
        ("since, as declared,", result.needs), ("true as well with another sign or factor", result.vacuous),
        ("points", filter(None, [result.cuts])), ("how it is known", [result.method]),
    ):  # fmt: skip
        yield heading, list(map(piece, lines))


def shown(form: Form, early: object) -> dict[str, Any]:
    """Return the formulas of a chart as ``dualcay show`` prints them, as text and as LaTeX."""
    chart = _chart(form)
    return {"text": "\n".join(formulas.lines(chart, "text")), "latex": list(formulas.lines(chart, "latex"))}


def printed(form: Form, early: object) -> dict[str, Any]:
    """Return the kernels of a chart in a language, as files by name: proved and printed, not run."""
    chart = _chart(form)
    chart.require_kernels()
    return {"files": dict(print_package([chart], TARGETS[form["target"]], tested=False).texts)}


def _chart(form: Form) -> Chart:
    asked = form["chart"].strip()
    if not asked.isdecimal():
        return catalogue.charts(phi=asked, name="phi")[0]
    if int(asked) > ORDER_MAX:
        raise ValueError(f"the page takes orders up to {ORDER_MAX}; the command dualcay takes more")
    return catalogue.charts([int(asked)])[0]
