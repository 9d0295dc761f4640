"""Papers as TOML files: letters, definitions and claims in plain text, read to entries. Nothing in a file is evaluated.

A file that is no such file raises `SheetError`. An equation that cannot be read is a `Problem`; all others are entries.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from .equation import Entry, Paper, Reading
from .language.claims import LITERALS, Abbreviation, ClaimError, Scope, expanded, statement, tree
from .language.kinds import letter
from .language.operations import CONSTANTS, OPERATIONS
from .language.printed import Term, Trait, with_trait

BYTES_MAX = 2_000_000
"""Largest size of a file."""
EQUATIONS_MAX = 2000
TABLES = ("paper", "letters", "definitions", "equation", "field")
PAPER_KEYS = ("slug", "title", "source")
KEYS = ("number", "title", "at", "latex", "claim", "domain", "corrected", "remark")
HEAD = re.compile(r"([A-Za-z]\w*)\s*(?:\(\s*([A-Za-z]\w*(?:\s*,\s*[A-Za-z]\w*)*)\s*\))?", re.ASCII)


class SheetError(ValueError):
    """Error for a file that cannot be read as a paper: one line with the file and what was expected."""


@dataclass(frozen=True)
class Problem:
    """Part of a file that cannot be read, with its place and what was expected."""

    file: str
    equation: str  # number of the equation, or words for a letter or definition
    column: int | None
    message: str

    def __str__(self) -> str:
        where = f", column {self.column}" if self.column else ""
        return f"{self.file}: {self.equation}{where}: {self.message}"

    def as_json(self) -> dict[str, Any]:
        """Return the fields printed by ``--format json``."""
        return {"file": self.file, "equation": self.equation, "column": self.column, "message": self.message}


@dataclass(frozen=True)
class Sheet(Paper):
    """Paper read from a file, with what could not be read."""

    read: tuple[Entry, ...] = ()
    problems: tuple[Problem, ...] = ()
    request: tuple[Any, ...] = field(default=(), repr=False)  # arguments that make the sheet again in another process

    @staticmethod
    def made(request: tuple[Any, ...]) -> Sheet:
        """Return the sheet made from a request."""
        return sheet(*request) if len(request) == 2 else claim_alone(*request)

    def entries(self) -> tuple[Entry, ...]:
        return self.read


def load(path: str | Path) -> Sheet:
    """Return the sheet of a file; raise SheetError or OSError."""
    name = str(path)
    with open(path, "rb") as file:
        content = file.read(BYTES_MAX + 1)
    if len(content) > BYTES_MAX:
        raise SheetError(f"{name}: a file has at most {BYTES_MAX} bytes")
    try:
        text = content.decode("utf-8")
    except UnicodeDecodeError as error:
        wrong = f"the byte {content[error.start]:#x} at {error.start}"
        raise SheetError(f"{name}: expected UTF-8 text, got {wrong}") from None
    return sheet(text, name)


def sheet(text: str, name: str) -> Sheet:
    """Return the sheet of a text with the file's name."""
    try:
        data = tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError, ValueError) as error:
        raise SheetError(f"{name}: not TOML: {str(error) or 'too many brackets in each other'}") from None
    for key in data:
        if key not in TABLES:
            raise SheetError(f"{name}: unknown table {key!r}: expected {', '.join(TABLES)}")
    about = _strings(data, "paper", name)
    if unknown := ", ".join(key for key in about if key not in PAPER_KEYS):
        raise SheetError(f"{name}: unknown key {unknown} in [paper]: expected {', '.join(PAPER_KEYS)}")
    equations = data.get("equation", [])
    if not (isinstance(equations, list) and equations and all(isinstance(e, dict) for e in equations)):
        raise SheetError(f"{name}: expected one or more tables [[equation]] with number and claim")
    if len(equations) > EQUATIONS_MAX:
        raise SheetError(f"{name}: a file has at most {EQUATIONS_MAX} equations, got {len(equations)}")
    slug = about.get("slug") or Path(name).stem
    reader = _Reader(name)
    scope = reader.scope(_strings(data, "letters", name), _strings(data, "definitions", name))
    entries = tuple(e for number, row in enumerate(equations, 1) if (e := reader.entry(number, row, scope)) is not None)
    citation = ". ".join(part for part in (about.get("title", ""), about.get("source", "")) if part)
    return Sheet(slug=slug, short=slug, citation=citation, lost="", package="", sections=(), claims={}, reasons={},
                 read=entries, problems=tuple(reader.problems), request=(text, name))  # fmt: skip


def claim_alone(claim: str, letters: Mapping[str, str], domain: str = "") -> Sheet:
    """Return a single claim as a sheet; raise ClaimError."""
    scope = Scope({name: letter(name, kind) for name, kind in letters.items()})
    entry = _entry({"number": "", "claim": claim, **({"domain": domain} if domain else {})}, scope, "")
    return Sheet(slug="", short="claim", citation="", lost="", package="", sections=(), claims={}, reasons={},
                 read=(entry,), request=(claim, dict(letters), domain))  # fmt: skip


def _strings(data: Mapping[str, Any], table: str, name: str) -> dict[str, str]:
    found = data.get(table, {})
    if not isinstance(found, dict):
        raise SheetError(f"{name}: expected a table [{table}]")
    for key, value in found.items():
        if not isinstance(value, str):
            raise SheetError(f"{name}: {key!r} in [{table}] is a text in quotes, got {type(value).__name__}")
    return found


class _Reader:
    """Reader of a file's letters, definitions and equations, which collects problems."""

    def __init__(self, file: str) -> None:
        self.file = file
        self.problems: list[Problem] = []
        self.numbers: set[str] = set()

    def problem(self, place: str, error: ClaimError | str) -> None:
        column = (error.column or None) if isinstance(error, ClaimError) else None
        message = error.message if isinstance(error, ClaimError) else error
        self.problems.append(Problem(self.file, place, column, " ".join(message.split())))

    def scope(self, letters: Mapping[str, str], definitions: Mapping[str, str]) -> Scope:
        """Return the scope of the file's letters and definitions."""
        known = {}
        for name, kind in letters.items():
            try:
                known[name] = letter(name, kind)
            except ClaimError as error:
                self.problem(f"letter {name}", error.message)
        found: dict[str, Abbreviation] = {}
        for head, text in definitions.items():
            try:
                abbreviation = _abbreviation(head, text, {**known, **found})
                found[abbreviation.name] = abbreviation
                tree(text)
            except ClaimError as error:
                self.problem(f"definition {head}", error)
        return Scope(known, found)

    def entry(self, place: int, row: Mapping[str, Any], scope: Scope) -> Entry | None:
        """Return the entry of an equation, or None for one that cannot be read."""
        number = row.get("number")
        label = str(number) if isinstance(number, str | int) and str(number).strip() else ""
        where = f"equation {label}" if label else f"equation at place {place}"
        try:
            if not label:
                raise ClaimError("an equation has a number, such as number = \"17\"")
            if label in self.numbers:
                raise ClaimError("this number is given twice")
            self.numbers.add(label)
            if unknown := ", ".join(key for key in row if key not in KEYS):
                raise ClaimError(f"unknown key {unknown}: expected {', '.join(KEYS)}")
            if wrong := next((key for key in KEYS[1:] if key in row and not isinstance(row[key], str)), None):
                raise ClaimError(f"{wrong} is a text in quotes, got {type(row[wrong]).__name__}")
            if "claim" not in row:
                raise ClaimError("an equation has a claim, such as claim = \"a == b\"")
            return _entry({**row, "number": label}, scope, self.file)
        except ClaimError as error:
            self.problem(where, error)
            return None


def _abbreviation(head: str, text: str, taken: Mapping[str, Any]) -> Abbreviation:
    match = HEAD.fullmatch(head.strip())
    if match is None:
        raise ClaimError(f"a definition is a name such as omega or G(w), got {head!r}")
    name, parameters = match[1], tuple(re.split(r"\s*,\s*", match[2])) if match[2] else ()
    if name in taken and (not parameters or isinstance(taken[name], Abbreviation)):
        raise ClaimError(f"{name} is given twice")
    if name in OPERATIONS or name in LITERALS or name in CONSTANTS:
        raise ClaimError(f"{name} is an operation: take another name")
    if len(set(parameters)) < len(parameters) or set(parameters) & set(CONSTANTS):
        raise ClaimError(f"the parameters of {name} are different letters")
    return Abbreviation(name, parameters, text)


def _entry(row: Mapping[str, str], scope: Scope, source: str) -> Entry:
    """Return the entry of an equation whose keys were checked; raise ClaimError."""

    def read(key: str) -> tuple[Term, Term]:
        try:
            written = statement(row[key], scope)
            return written, expanded(written, scope.abbreviations)
        except ClaimError as error:
            raise error if key == "claim" else ClaimError(f"{key}: {error.message}", error.column) from None

    written, claim = read("claim")
    domain = read("domain")[1] if "domain" in row else None
    mended, correction = read("corrected") if "corrected" in row else (None, None)
    parts = [part for part in (claim, domain, correction) if part is not None]
    return Entry(
        row["number"], row.get("title", ""), 0, "", (Reading(claim),), claimed=domain, corrected=correction,
        moving=bool(with_trait(Trait.RATE, *parts)), remark=row.get("remark", ""), source=source, written=written,
        mended=mended, abbreviations=scope.abbreviations, at=row.get("at", ""), printed=row.get("latex", ""),
    )  # fmt: skip
