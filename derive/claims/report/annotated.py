"""Report beside the lines of files: commands of GitHub's workflows, and SARIF 2.1.0 for editors and code scanning.

Both list what is wrong, what is not proved, and conditions that were found. What holds is in the counts.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple
from urllib.parse import quote

from ... import about
from ..equation import Paper
from ..result import Result, Status
from .content import ERRORS, MEANING, Report, details, domain, example, label, shown

LEVELS = dict.fromkeys(MEANING, "warning") | {Status.FALSE: "error", Status.ERRATUM: "error", Status.HOLDS_IF: "notice"}
RULES = {str(status): (LEVELS[status], meaning) for status, meaning in MEANING.items() if status is not Status.HOLDS}
RULES |= {"unreadable": ("error", f"{ERRORS}, for the reason shown")}
RULES |= {"unproved": ("error", "a theorem without a proof")}
"""Weight in the words of GitHub, and meaning, of each rule."""
SARIF_LEVELS = {"error": "error", "warning": "warning", "notice": "note"}
SCHEMA = "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"


class Remark(NamedTuple):
    """Remark on a line; without a file it has an empty name, and without a line the line 0."""

    rule: str
    file: str
    line: int
    title: str
    text: str


def remarks(report: Report) -> Iterator[Remark]:
    """Yield what is wrong or open, in the report's order, then what was not understood and theorems without a proof."""
    for chapter in report.chapters:
        for result in chapter.results:
            if result.status in RULES:
                title = f"{label(result)}: {result.status}"
                yield Remark(str(result.status), *place(result, chapter.paper), title, explained(result))
    for problem in report.problems:
        title = f"{problem.equation or 'file'}: {ERRORS}"
        text = f"column {problem.column}: {problem.message}" if problem.column else problem.message
        yield Remark("unreadable", problem.file, problem.line or 0, title, text)
    for proof in report.failed:
        yield Remark("unproved", "", 0, f"{proof.scope}: {proof.status}", proof.statement)


def place(result: Result, paper: Paper) -> tuple[str, int]:
    """Return file and line of a claim: where it is printed if that file is there, else where it stands in its file."""
    entry = result.equation
    if found := re.fullmatch(r"(.+):(\d{1,9})", entry.at):
        for name in (os.path.join(os.path.dirname(entry.source), found[1]), found[1]):
            if os.path.isfile(name):
                return name, int(found[2])
    return entry.source, paper.line(entry.number)


def explained(result: Result) -> str:
    """Return the claim, where it holds, where it fails, what mends it, and how it is known, a line for each."""
    failing = example(result.counterexample, result.equation) if result.counterexample else ()
    return "\n".join((shown(result), *domain(result), *failing, *details(result), result.method))


def as_github(report: Report) -> str:
    """Return the commands that annotate lines in a workflow of GitHub, and a line of counts."""
    lines = []
    for rule, file, line, title, text in remarks(report):
        given = {"file": file, "line": str(line or ""), "title": title}
        properties = ",".join(f"{name}={_escaped(value, ':,')}" for name, value in given.items() if value)
        lines.append(f"::{RULES[rule][0]} {properties}::{_escaped(text)}")
    return "\n".join((*lines, report.summary, ""))


def _escaped(text: str, further: str = "") -> str:
    return re.sub(rf"[%\r\n{further}]", lambda found: f"%{ord(found[0]):02X}", text)


def as_sarif(report: Report) -> str:
    """Return the report as SARIF: one run, with the counts among its properties."""
    rules = [
        {"id": rule, **{name: {"text": meaning} for name in ("shortDescription", "fullDescription", "help")},
         "defaultConfiguration": {"level": SARIF_LEVELS[weight]}}
        for rule, (weight, meaning) in RULES.items()
    ]  # fmt: skip
    results = [
        {"ruleId": rule, "ruleIndex": list(RULES).index(rule), "level": SARIF_LEVELS[RULES[rule][0]],
         "message": {"text": f"{title}\n{text}"}, **_location(file, line)}
        for rule, file, line, title, text in remarks(report)
    ]  # fmt: skip
    driver = {"name": "dualcay", "version": about.__version__, "rules": rules}
    run = {"tool": {"driver": driver}, "results": results, "properties": report.counts}
    return json.dumps({"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}, indent=2, ensure_ascii=False) + "\n"


def _location(file: str, line: int) -> dict[str, Any]:
    """Return the place of a result, the first line if none is known; a relative URI begins where the command runs."""
    if not file:
        return {}
    path = Path(file)
    uri = path.as_uri() if path.is_absolute() else quote(os.fsencode(path.as_posix()))
    place = {"artifactLocation": {"uri": uri}, "region": {"startLine": line or 1}}
    return {"locations": [{"physicalLocation": place}]}
