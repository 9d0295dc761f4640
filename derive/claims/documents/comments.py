"""Comments of a document with their places, and the equations to which they belong."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections import Counter
from typing import NamedTuple

from ..language.names import ClaimError
from .files import SheetError

PARTS_MAX = 10_000
"""Largest number of displayed equations, comments and problems of a document."""
OF_AN_EQUATION = ("claim", "domain", "corrected", "remark")
KNOWN = ("letters", "definition", *OF_AN_EQUATION)
HEAD = re.compile(r"\s*([A-Za-z]+)(?:\s*\[([^\]]*)\])?")
LABEL = re.compile(r"\\label\s*\{([^{}]*)\}")
LAYOUT = re.compile(rf"{LABEL.pattern}|\\tag\*?\s*\{{[^{{}}]*\}}|\\no(?:number|tag)\b")


class Place(NamedTuple):
    """Place of a character in a document, counted from 1; in a text, `offset` is that of the character."""

    file: str
    line: int
    column: int
    offset: int = 0


class Written(str):
    """Text of a document, whose characters have places."""

    starts: tuple[Place, ...] = ()  # places where its lines begin
    shift: int = 0  # offset of this part

    @classmethod
    def of(cls, lines: list[tuple[Place, str]]) -> Written:
        text, starts, offset = cls("\n".join(line for _, line in lines)), [], 0
        for place, line in lines:
            starts.append(place._replace(offset=offset))
            offset += len(line) + 1
        text.starts = tuple(starts)
        return text

    def place(self, offset: int = 0) -> Place:
        """Return the place of a character, counted from 0."""
        at = offset + self.shift
        start = self.starts[bisect_right(self.starts, at, key=lambda start: start.offset) - 1]
        return start._replace(column=start.column + at - start.offset)

    def part(self, first: int, last: int | None = None) -> Written:
        """Return a part of the text without spaces around it."""
        whole = self[first:last]
        text = Written(whole.strip())
        text.starts, text.shift = self.starts, self.shift + first + len(whole) - len(whole.lstrip())
        return text

    def error(self, message: str, column: int = 0) -> ClaimError:
        """Return an error at a column of the text, counted from 1, with its place in the document."""
        place = self.place(max(column - 1, 0))
        return ClaimError(message, place.column, place[:2])


class Collector:
    """Collector of a document's letters, definitions, equations with their comments, and problems.

    A comment belongs to the equation before it, or to the one whose label stands in brackets.
    """

    def __init__(self) -> None:
        self.letters: dict[str, Written] = {}
        self.definitions: dict[str, Written] = {}
        self.equations: list[dict[str, str]] = []
        self.labelled: dict[str, dict[str, str]] = {}
        self.problems: list[tuple[str, ClaimError]] = []
        self.numbers: Counter[str] = Counter()
        self.parts = 0

    def _count(self, place: Place) -> None:
        self.parts += 1
        if self.parts > PARTS_MAX:
            where = f"{place.file}:{place.line}"
            raise SheetError(f"{where}: a document has at most {PARTS_MAX} displayed equations and comments")

    def problem(self, about: str, place: Place, message: str) -> None:
        self._count(place)
        self.problems.append((about, ClaimError(message, at=place[:2])))

    def equation(self, latex: str, place: Place, number: str, labels: list[str]) -> None:
        """Add a displayed equation, which has the number if it has no label."""
        self._count(place)
        named = labels[0] if labels else number
        self.numbers[named] += 1
        if self.numbers[named] > 1:
            named += f" ({self.numbers[named]})"
        latex = " ".join(LAYOUT.sub(" ", latex).split())
        self.equations.append({"number": named, "at": f"{place.file}:{place.line}", "latex": latex})
        self.labelled |= dict.fromkeys(labels, self.equations[-1])

    def comment(self, text: Written) -> None:
        self._count(text.place())
        try:
            self._comment(text)
        except ClaimError as error:
            self.problems.append(("comment", error))

    def _comment(self, text: Written) -> None:
        head = HEAD.match(text)
        if head is not None and head[1] == "dualcay":
            raise text.error("expected a colon after dualcay")
        if head is None or head[1] not in KNOWN:
            raise text.error(f"expected {', '.join(KNOWN)}, got {(head[1] if head else text[:20].strip())!r}")
        rest = text.part(head.end())
        if not rest:
            raise text.error(f"expected a text after {head[1]}")
        if head[1] in OF_AN_EQUATION:
            self._of_equation(head[1], head[2], rest)
        elif head[1] == "definition":
            _pair(rest, self.definitions)
        else:
            for found in re.finditer(r"[^;]+", rest):
                if found[0].strip():
                    _pair(rest.part(*found.span()), self.letters)

    def _of_equation(self, word: str, label: str | None, text: Written) -> None:
        if not self.equations:
            raise text.error(f"no displayed equation stands before this {word}")
        row = self.equations[-1] if label is None else self.labelled.get(label.strip())
        if row is None:
            raise text.error(f"no equation with the label {label} stands before this {word}")
        if word in row:
            raise text.error(f"equation {row['number']} has a {word} already: join relations by \"and\", or choose "
                             f"another equation by its label, as in {word} [label]")
        row[word] = text


def _pair(text: Written, known: dict[str, Written]) -> None:
    """Add a name with its meaning, which stands after the first sign =; both may be said twice."""
    name, sign, _ = text.partition("=")
    head, meaning = " ".join(name.split()), text.part(len(name) + 1)
    if not (sign and head and meaning):
        raise text.error("expected a name, the sign = and its meaning")
    if known.setdefault(head, meaning) != meaning:
        raise text.error(f"{head} has another meaning in line {known[head].place().line}")
