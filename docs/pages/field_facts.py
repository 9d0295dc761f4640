"""Facts about formulas in use: the documents of the library with their results, places, scores, and JSON of all."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from derive.claims.language.operations import written
from derive.claims.result import Result, Status
from derive.claims.run import SECONDS, check_sheets
from derive.claims.sheet import Sheet, load
from derive.output.pages import json_rows
from derive.output.shown import no_op

LIBRARY = Path(__file__).parents[2] / "derive" / "papers" / "field"
OPEN = (Status.UNDECIDED, Status.UNREFUTED)
TRUE, WRONG = (Status.HOLDS, Status.HOLDS_IF), (Status.FALSE, Status.ERRATUM)
COLLECTIONS = ("code-alone", "preintegration", "reports")
"""Files that are no document: formulas of code, and formulas that readers reported."""

SCHEMA = 1
COMMIT = re.compile(r"([\w.-]+/[\w.-]+), commit ([0-9a-f]{7,40})\b")
LINES = re.compile(r"([^\s,]+):(\d+(?:-\d+)?)")


@dataclass(frozen=True)
class Place:
    """Repository, commit, file and lines of a formula; None for what a document does not say."""

    repository: str | None
    commit: str | None
    path: str | None  # from the root of the repository
    line: str | None  # such as "71" or "71-73"

    @staticmethod
    def of(at: str, source: str) -> Place:
        """Return the place named in words, in a source that names the repository and lists its files."""
        found, lines = COMMIT.search(at) or COMMIT.search(source), LINES.search(at)
        file = lines[1] if lines else ""
        listed = (part for part in re.split(r",\s*", source) if part.rpartition("/")[2] == file)
        path = file if "/" in file else next(listed, None)
        return Place(found and found[1], found and found[2], path, lines and lines[2])

    @property
    def link(self) -> str:
        """Address of the lines on the host of the repository, or an empty text."""
        if None in (self.repository, self.commit, self.path, self.line):
            return ""
        first, _, last = (self.line or "").partition("-")
        lines = f"#L{first}" + (f"-L{last}" if last else "")
        return f"https://github.com/{self.repository}/blob/{self.commit}/{self.path}?plain=1{lines}"


@dataclass(frozen=True)
class Document:
    """File of the library with its results, and facts about the document and about equations by their number."""

    sheet: Sheet
    about: Mapping[str, Any]  # table [field]
    results: Sequence[Result]

    @property
    def slug(self) -> str:
        """Short name of the document."""
        return self.sheet.slug

    @property
    def title(self) -> str:
        """Title of the document."""
        return self.sheet.citation.partition(". ")[0]

    @property
    def short(self) -> str:
        """Title up to its first colon."""
        return self.title.partition(":")[0]

    def on(self, result: Result) -> Mapping[str, Any]:
        """Return the facts about an equation: kind of error, code, report, alarm, switch."""
        found: Mapping[str, Any] = self.about.get(result.equation.number, {})
        return found

    def count(self, *statuses: Status) -> int:
        """Return the number of equations with one of these statuses."""
        return sum(result.status in statuses for result in self.results)

    def place(self, result: Result) -> Place:
        """Return the place of an equation."""
        return Place.of(result.equation.at, self.sheet.citation)

    def score(self, result: Result) -> str:
        """Return "found", "missed" or "false alarm" for a formula that a reader reported, else an empty text."""
        facts = self.on(result)
        if "report" not in facts:
            return ""
        if facts.get("alarm"):
            return "false alarm" if result.status in TRUE else "missed"
        return "found" if result.status in WRONG else "missed"


def sheets() -> list[Sheet]:
    """Return the files of the library, read."""
    return [load(path) for path in sorted(LIBRARY.glob("*.toml"))]


def document(sheet: Sheet, results: Sequence[Result]) -> Document:
    """Return a file of the library with results."""
    return Document(sheet, tomllib.loads(sheet.request[0])["field"], results)


def decided(
    library: Sequence[Sheet], seconds: float = SECONDS, step: Callable[[str], None] = no_op
) -> tuple[Document, ...]:
    """Return the documents of the library, decided; a slow equation is undecided."""
    results = iter(check_sheets(library, None, seconds, step))
    return tuple(document(sheet, [next(results) for _ in sheet.entries()]) for sheet in library)


def anchor(result: Result) -> str:
    """Return the anchor of an equation on the page: letters, digits and hyphens, as Sphinx makes them."""
    return re.sub(r"[^a-z0-9]+", "-", result.anchor.lower()).strip("-")


def correction(result: Result) -> str:
    """Return the correction of a wrong formula as a claim, or an empty text."""
    mended = result.equation.mended
    return written(mended) if mended is not None and result.status is Status.ERRATUM else ""


def facts(of: Document, result: Result) -> dict[str, Any]:
    """Return the facts about one equation, for JSON."""
    entry, place = result.equation, of.place(result)
    further = {
        "repository": place.repository, "at": entry.at, "printed": entry.printed, "certainty": result.certainty,
        "domain": result.domain, "undecided": result.method if result.status in OPEN else "",
        "remark": entry.remark, "score": of.score(result),
        **{key: of.on(result).get(key) for key in ("error", "report", "code", "switch")},
    }  # fmt: skip
    return {
        "id": anchor(result), "document": of.slug, "commit": place.commit, "line": place.line, "claim": result.claim,
        "status": str(result.status), "condition": result.found or None, "corrected": correction(result) or None,
        **{key: value for key, value in further.items() if value},
    }  # fmt: skip


def as_json(library: Sequence[Document]) -> str:
    """Return the facts about all equations as JSON."""
    rows = [facts(of, result) for of in library for result in of.results]
    return json_rows(schema=SCHEMA, formulas=rows)
