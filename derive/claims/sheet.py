"""Papers as TOML files: letters, definitions and claims in plain text, read to entries. Nothing in a file is evaluated.

A file that is no such file raises `SheetError`. An equation that cannot be read is a `Problem`, one without a claim is
unread; all others are entries. Documents with comments beside their equations are read in the same way.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import filterfalse
from pathlib import Path
from typing import Any

from ..output.shown import one_line
from .documents import READERS, content
from .documents.comments import Written
from .documents.files import SheetError as SheetError
from .documents.files import text_of
from .equation import Entry, Home, Paper, Reading
from .language.claims import statement
from .language.expressions import tree
from .language.letters import LITERALS
from .language.letters import letters as declared
from .language.names import Abbreviation, ClaimError, Scope, expanded
from .language.operations import CONSTANTS, OPERATIONS
from .language.printed import Symbol, Term
from .lines import Lines
from .transcript import READING_KEYS, Transcript

FILES = (".toml", *READERS)
"""Endings of files with claims."""
BYTES_MAX = 2_000_000
"""Largest size of a file."""
EQUATIONS_MAX = 2000
MESSAGE_MAX = 5000
"""Largest number of characters in a message, which may quote a claim."""
TABLES = ("paper", "letters", "definitions", "latex", "claims", "reasons", "equation", "field")
PAPER_KEYS = ("slug", "short", "title", "source", "doi", "conditions", "lost", "sections")
KEYS = ("number", "title", "at", "latex", "claim", "domain", "corrected", "remark", "proposed")
STATED_KEYS = (*KEYS, "line", "reading", "condition", "because", "stated", "said", "fixed_by", "lost", "extract",
               "undecided")
"""Keys of an equation, and those of a transcript, which states conditions."""
KIND_OF = {"line": int, "proposed": bool}
WORDS = {int: "an integer", bool: "true or false", str: "a text in quotes"}
"""Kinds of the values of keys other than texts, and words for them."""
HEAD = re.compile(r"([A-Za-z]\w*)\s*(?:\(\s*([A-Za-z]\w*(?:\s*,\s*[A-Za-z]\w*)*)\s*\))?", re.ASCII)


@dataclass(frozen=True)
class Problem:
    """Part of a file that cannot be read, with its place and what was expected."""

    file: str
    equation: str  # number of the equation, or words for a letter or definition; empty for the file
    column: int | None
    message: str
    line: int | None = None

    def __str__(self) -> str:
        file = f"{self.file}:{self.line}" if self.line else self.file
        where = ", ".join(filter(None, (self.equation, f"column {self.column}" if self.column else "")))
        return one_line(": ".join(filter(None, (file, where, self.message))))

    def as_json(self) -> dict[str, Any]:
        """Return the fields printed by ``--format json``."""
        return {name: getattr(self, name) for name in ("file", "line", "equation", "column", "message")}


Content = tuple[tuple["Entry", ...], tuple[Problem, ...]]


@dataclass(frozen=True)
class Sheet(Paper):
    """Paper read from a file; its equations are read on first use, and those of some numbers alone."""

    stated: bool = False  # whether it is a transcript, whose conditions are stated
    read: Callable[[Collection[str] | None], Content] = field(default=lambda n: ((), ()), repr=False, compare=False)
    numbers: tuple[str, ...] = field(default=(), repr=False)  # of all its equations, in order
    unread: tuple[Mapping[str, str], ...] = field(default=(), repr=False)  # number, place, LaTeX of those without claim
    request: tuple[Any, ...] = field(default=(), repr=False)  # arguments that make the sheet again in another process
    lines: Lines | None = field(default=None, repr=False, compare=False)

    @staticmethod
    def made(request: tuple[Any, ...]) -> Sheet:
        return sheet(*request) if len(request) == 2 else claim_alone(*request)

    @cached_property
    def _content(self) -> Content:
        return self.read(None)

    def line(self, number: str) -> int:
        return self.lines.of_equation(self.numbers.index(number)) if self.lines and number in self.numbers else 0

    @property
    def problems(self) -> tuple[Problem, ...]:
        return self._content[1]

    def entries(self, numbers: Collection[str] | None = None) -> tuple[Entry, ...]:
        return self._content[0] if numbers is None else self.read(numbers)[0]


def load(path: str | Path) -> Sheet:
    """Return the sheet of a file; raise SheetError or OSError."""
    if (suffix := Path(path).suffix.lower()) in READERS:
        tables, wrong = content(path)
        return sheet(tables, str(path), wrong=wrong)
    try:
        return sheet(text_of(path, BYTES_MAX), str(path))
    except SheetError as error:
        if suffix in FILES:
            raise
        raise SheetError(f"{error}; files with claims end in {', '.join(FILES)}") from None


def unreadable(name: str, error: SheetError) -> Problem:
    """Return the problem of a file that cannot be read at all."""
    said = rf"(?:{re.escape(name)}(?::(\d+))?: )?(.*?(?:\(at line (\d+), column \d+\))?)"
    found = re.fullmatch(said, str(error), re.DOTALL)
    assert found is not None
    line = found[1] or found[3]
    return Problem(name, "", None, found[2], int(line) if line else None)


def tables_of(text: str, name: str) -> dict[str, Any]:
    """Return the tables of a TOML text with the file's name."""
    try:
        return tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError, ValueError) as error:
        raise SheetError(f"{name}: not TOML: {str(error) or 'too many brackets in each other'}") from None


def sheet(
    tables: str | Mapping[str, Any], name: str, home: Home | None = None, wrong: Iterable[tuple[str, ClaimError]] = ()
) -> Sheet:
    """Return the sheet of a TOML text or of its tables, with the file's name.

    `home` finds its entries again when they are pickled; `wrong` is what could not be read before.
    """
    data = tables_of(tables, name) if isinstance(tables, str) else tables
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
    letters, definitions, shown, claims, reasons = (
        _strings(data, table, name) for table in ("letters", "definitions", "latex", "claims", "reasons")
    )
    if about.get("conditions", "found") not in ("found", "stated"):
        raise SheetError(f"{name}: conditions are \"found\" or \"stated\", got {about['conditions']!r}")
    sections = about.get("sections", "").split()
    if other := next((line for line in (*sections, *claims) if not line.isdecimal()), None):
        raise SheetError(f"{name}: expected the number of a line, got {other!r}")
    stated = about.get("conditions") == "stated"
    lines = Lines(tables if isinstance(tables, str) else "")

    def is_unread(row: Mapping[str, Any]) -> bool:
        return not stated and not str(row.get("claim", "")).strip()

    def read(numbers: Collection[str] | None) -> Content:
        reader = Reader(name, lines)
        for where, error in wrong:
            reader.problem(where, error)
        scope = reader.scope(letters, definitions, shown)
        printed = {OPERATIONS[call].operator: text for call, text in shown.items() if call in OPERATIONS}
        transcript = Transcript(name, scope, printed, tuple(map(int, sections))) if stated else None
        rows = [(i, row) for i, row in enumerate(equations, 1) if numbers is None or str(row.get("number")) in numbers]
        found = [reader.entry(i, row, scope, transcript, is_unread(row)) for i, row in rows]
        return tuple(replace(entry, home=home) for entry in found if entry is not None), tuple(reader.problems)

    needed = {**tables, "equation": [*filterfalse(is_unread, equations)]} if isinstance(tables, Mapping) else tables
    citation = ". ".join(part for part in (about.get("title", ""), about.get("source", "")) if part)
    return Sheet(
        slug, about.get("short", slug), citation, about.get("lost", ""),
        {int(line): numbers for line, numbers in claims.items()}, reasons, about.get("doi", ""),
        stated=stated, read=read, numbers=tuple(str(row.get("number", "")) for row in equations),
        unread=tuple(map(_outline, filter(is_unread, equations))), request=(needed, name),
        lines=lines,
    )  # fmt: skip


def _outline(row: Mapping[str, Any]) -> Mapping[str, str]:
    return {name: str(row.get(name, "")) for name in ("number", "at", "latex")}


def claim_alone(claim: str, letters: Mapping[str, str], domain: str = "") -> Sheet:
    """Return a single claim as a sheet; raise ClaimError."""
    scope = Scope({a: symbol for name, kind in letters.items() for a, symbol in declared(name, kind).items()})
    entry = _entry({"number": "", "claim": claim, **({"domain": domain} if domain else {})}, scope, "")
    return Sheet("", "claim", read=lambda numbers: ((entry,), ()), request=(claim, dict(letters), domain))


def _strings(data: Mapping[str, Any], table: str, name: str) -> dict[str, str]:
    found = data.get(table, {})
    if not isinstance(found, dict):
        raise SheetError(f"{name}: expected a table [{table}]")
    for key, value in found.items():
        if not isinstance(value, str):
            raise SheetError(f"{name}: {key!r} in [{table}] is a text in quotes, got {type(value).__name__}")
    return found


class Reader:
    """Reader of a file's letters, definitions and equations, which collects problems."""

    def __init__(self, file: str, lines: Lines | None = None) -> None:
        self.file, self.lines = file, lines or Lines("")
        self.problems: list[Problem] = []
        self.numbers: set[str] = set()

    def problem(self, place: str, error: ClaimError | str, line: int = 0) -> None:
        known = error if isinstance(error, ClaimError) else ClaimError(error)
        file, at = known.at or (self.file, line or None)
        message = " ".join(known.message[:MESSAGE_MAX].split())
        self.problems.append(Problem(file, place, known.column or None, message, at))

    def scope(self, letters: Mapping[str, str], definitions: Mapping[str, str], shown: Mapping[str, str]) -> Scope:
        """Return the scope of the file's letters and definitions; `shown` has the LaTeX of names as printed."""
        known = {}
        for name, kind in letters.items():
            try:
                for a, (symbol, of) in declared(name, kind).items():
                    known[a] = Symbol(*map(str, (*symbol.args[:2], shown.get(a, symbol.args[2]), a))), of
            except ClaimError as error:
                self.problem(f"letter {name}", _placed(kind, ClaimError(error.message)), self.lines.of("letters", name))
        found: dict[str, Abbreviation] = {}
        for head, text in definitions.items():
            try:
                abbreviation = _abbreviation(head, text, {**known, **found}, shown)
                found[abbreviation.name] = abbreviation
                tree(text)
            except ClaimError as error:
                self.problem(f"definition {head}", _placed(text, error), self.lines.of("definitions", head))
        return Scope(known, found)

    def entry(
        self, place: int, row: Mapping[str, Any], scope: Scope, transcript: Transcript | None, unread: bool
    ) -> Entry | None:
        """Return the entry of an equation, or None for one that has no claim or cannot be read."""
        number = row.get("number")
        label = str(number) if isinstance(number, str | int) and str(number).strip() else ""
        where = f"equation {label}" if label else f"equation at place {place}"
        try:
            if not label:
                raise ClaimError("an equation has a number, such as number = \"17\"")
            if label in self.numbers:
                raise ClaimError("this number is given twice")
            self.numbers.add(label)
            _check(row, STATED_KEYS if transcript else KEYS)
            if unread:
                return None
            if bool("claim" in row or row.get("reading")) is ("undecided" in row):
                raise ClaimError("an equation has a claim, such as claim = \"a == b\"; or it is undecided")
            row = {**row, "number": label}
            return transcript.entry(row) if transcript else _entry(row, scope, self.file)
        except (ClaimError, RecursionError) as error:
            deep = ClaimError("its parts stand too deep in each other")
            said = error if isinstance(error, ClaimError) else _placed(row.get("claim", ""), deep)
            self.problem(where, said, self.lines.of_equation(place - 1))
            return None


def _check(row: Mapping[str, Any], keys: tuple[str, ...]) -> None:
    """Raise ClaimError unless an equation has known keys with values of the right kind."""
    if unknown := ", ".join(key for key in row if key not in keys):
        raise ClaimError(f"unknown key {unknown}: expected {', '.join(keys)}")
    for key, value in row.items():
        if key == "reading":
            if not (isinstance(value, list) and all(isinstance(r, dict) and "claim" in r for r in value)):
                raise ClaimError("reading is a list of tables with a claim, such as [{claim = \"a == b\"}]")
            for reading in value:
                _check(reading, READING_KEYS)
        elif key != "number" and type(value) not in (KIND_OF.get(key, str), Written):
            raise ClaimError(f"{key} is {WORDS[KIND_OF.get(key, str)]}, got {type(value).__name__}")


def _abbreviation(head: str, text: str, taken: Mapping[str, Any], shown: Mapping[str, str]) -> Abbreviation:
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
    return Abbreviation(name, parameters, text, shown.get(name, ""))


def _placed(text: str, error: ClaimError) -> ClaimError:
    """Return an error in a text with the place of the text, if it stands in a document."""
    return text.error(error.message, error.column) if isinstance(text, Written) else error


def _entry(row: Mapping[str, Any], scope: Scope, source: str) -> Entry:
    """Return the entry of an equation whose keys were checked; raise ClaimError."""

    def read(key: str) -> tuple[Term, Term]:
        try:
            written = statement(row[key], scope)
            return written, expanded(written, scope.abbreviations)
        except ClaimError as error:
            known = error if key == "claim" else ClaimError(f"{key}: {error.message}", error.column)
            raise _placed(row[key], known) from None

    written, claim = read("claim")
    domain = read("domain")[1] if "domain" in row else None
    mended, correction = read("corrected") if "corrected" in row else (None, None)
    return Entry(
        row["number"], (Reading(claim),), row.get("title", ""), claimed=domain, corrected=correction,
        remark=row.get("remark", ""), source=source, written=written, mended=mended,
        abbreviations=scope.abbreviations, at=row.get("at", ""), printed=row.get("latex", ""),
        proposed=row.get("proposed", False),
    )  # fmt: skip
