"""Entry for an equation or claim of a paper, and the rules for deciding one of a transcript.

An `Entry` has the printed formula and the definitions of its symbols. `decide` evaluates it and returns a `Result` with
the computed status:

* readings are listed by hand, the most charitable first. Apart from lost characters, each equals the extracted text;
* every reading is evaluated over balls at points, with special values of every symbol. One failure refutes it;
* a reading without failure is then proved at generic values of an exact field, for symbolic n if n occurs. If no exact
  field is suitable, it is ``unrefuted``: the points are only evidence;
* ``holds``: a listed reading is proved. ``holds-if``: a listed reading is true under the entry's condition
  and fails somewhere outside it; both sides are tested. ``erratum``: no listed reading is true, and the correction is.
  ``ambiguous``: one reading is true, another is false, and the text does not decide between them.

An entry of a transcript that fits none of these raises `UndecidedError`. The condition of a claim of a file is found.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, TypeAlias

from ..algebra.latex import Typeset
from .extracted import faithful
from .language.names import Abbreviation, contracted, expanded
from .language.printed import Symbol, Term, as_usual, latex, rate_depth, symbols, walk


class UndecidedError(Exception):
    """Error for an entry without a status: its condition, correction or reading is missing or wrong."""


Home: TypeAlias = Callable[[str, str], "Entry"]


@dataclass(frozen=True)
class Reading:
    """Reading of a display: one way to interpret its characters.

    `note` tells the difference from the other readings. `supported_by` quotes a legible passage, with its line, that
    supports this reading; a supported false reading makes the entry ambiguous.
    """

    statement: Term
    note: str = ""
    supported_by: str = ""


@dataclass(frozen=True)
class Entry(Typeset):
    """Entry for a printed equation or claim; create one with `equation`."""

    number: str  # the paper's number, or a slug
    readings: tuple[Reading, ...]  # listed by hand, the most charitable first
    title: str = ""
    line: int = 0  # line of the extracted text that contains the equation
    extract: str = ""  # characters of the text on that line; empty for a claim in words
    claimed: Term | None = None  # domain stated by the paper; points outside it are not tested
    stated: str = ""  # words that state the claimed domain
    condition: Term | None = None  # condition under which the equation was found to hold
    corrected: Term | None = None  # correction of an erratum
    because: Term | None = None  # identity that supports a statement for which points are only evidence
    orders: tuple[int, ...] | None = None  # orders that the entry is about; all by default
    lost: str = ""  # further characters lost by the extraction in this display
    undecided: str = ""  # why the claim is in words that no formula states; then it is not decided
    fixed_by: str = ""  # legible passage that decides between the readings
    said: str = ""  # words of the paper, for a claim without a display
    remark: str = ""  # one sentence for the report
    source: str = ""  # path of the module or file that defines the entry; filled in by `Paper.entries`
    home: Home | None = field(default=None, compare=False)  # finds the entry by its source and number
    written: Term | None = None  # claim of a file before its definitions are filled in
    mended: Term | None = None  # correction of a file before its definitions are filled in
    abbreviations: Mapping[str, Abbreviation] = field(default_factory=dict, compare=False)  # definitions of its file
    at: str = ""  # place where a claim of a file is printed
    printed: str = ""  # LaTeX of a claim of a file, as printed
    proposed: bool = False  # whether the claim of a file was proposed from its LaTeX, and is not yet confirmed

    @property
    def is_transcribed(self) -> bool:
        """Whether the entry follows a text, with its condition stated; else the condition is found."""
        return self.written is None

    @property
    def meant(self) -> Entry:
        """The entry as it is decided: with its definitions filled in, and operators by their usual names."""
        if not self.abbreviations:
            return self

        def filled(term: Term | None) -> Any:
            return None if term is None else as_usual(self.expanded(term))

        readings = tuple(replace(reading, statement=filled(reading.statement)) for reading in self.readings)
        parts = {name: filled(getattr(self, name)) for name in ("claimed", "condition", "corrected", "because")}
        return replace(self, readings=readings, **parts)

    def free(self, statement: Term) -> tuple[Symbol, ...]:
        """Return the letters of a statement, and of the domain and condition."""
        parts = (statement, *(part for part in (self.claimed, self.condition) if part is not None))
        return tuple(dict.fromkeys(a for part in parts for a in symbols(part) if a.quantity.varies))

    def expanded(self, statement: Term) -> Term:
        return expanded(statement, self.abbreviations)

    def contracted(self, statement: Term) -> Term:
        """Return a part of an expanded statement in the names of its file."""
        named = [self.written] if self.written is not None else []
        known = [body for a in self.abbreviations.values() for kinds, (body, _) in a.known.items() if not kinds]
        parts = [part for whole in (*named, *known) for part in walk(whole) if part.arguments]
        return contracted(statement, {self.expanded(part): part for part in reversed(parts)})

    def __repr__(self) -> str:
        return f"<Equation ({self.number}): {self.title}>"

    def __reduce_ex__(self, protocol: Any) -> Any:
        """Return the place of an entry whose file defines its operators, which another process may not have read."""
        return super().__reduce_ex__(protocol) if self.home is None else (self.home, (self.source, self.number))

    def _typeset(self) -> str:
        return rf"\text{{({self.number})}}\quad {latex(self.readings[0].statement)}"


def equation(number: str, printed: Term | tuple[Reading, ...], **rest: Any) -> Entry:
    """Return an entry; `printed` is a statement or a tuple of readings."""
    return Entry(number, printed if isinstance(printed, tuple) else (Reading(printed),), **rest)


def require_complete(entry: Entry, lost: str) -> None:
    """Raise if an entry of a transcript lacks a part that another needs, or does not agree with the extracted text."""
    if not entry.is_transcribed:
        return
    unfaithful = not all(faithful(reading.statement, entry.extract, lost) for reading in entry.readings)
    mistakes = {
        "rates are nested, which claims of files may do": any(rate_depth(r.statement) > 1 for r in entry.readings),
        "a claimed domain and the words that state it come together": (entry.claimed is None) == bool(entry.stated),
        f"a reading does not have the characters of line {entry.line}": entry.extract and unfaithful,
        "an erratum shows the words of the paper": entry.corrected is not None and not (entry.extract or entry.said),
        f"the correction is a reading of line {entry.line}":
            entry.corrected is not None and entry.extract and faithful(entry.corrected, entry.extract, lost),
    }
    for mistake, made in mistakes.items():
        if made:
            raise UndecidedError(f"({entry.number}): {mistake}")


@dataclass(frozen=True)
class Paper:
    """Paper whose equations are entries."""

    slug: str
    short: str = ""
    citation: str = ""
    lost: str = ""  # characters lost by the extraction of its text
    claims: Mapping[int, str] = field(default_factory=dict)  # further lines of the text, with the entries for them
    reasons: Mapping[str, str] = field(default_factory=dict)  # lines that claim nothing, by reason
    doi: str = ""

    def entries(self, numbers: Collection[str] | None = None) -> tuple[Entry, ...]:
        """Return the entries in the paper's order: all, or those of some numbers."""
        raise NotImplementedError

    def line(self, number: str) -> int:
        """Return the line of the paper's file on which the entry of a number stands; 0 if it is not known."""
        return 0

    def inventory(self) -> dict[int, tuple[str, ...] | str]:
        """Return the inventory: each line with its deciding entries, or with the reason why it claims nothing."""
        lines: dict[int, tuple[str, ...] | str] = {}
        for entry in self.entries():
            lines[entry.line] = (*lines.get(entry.line, ()), entry.number)
        for line, numbers in self.claims.items():
            lines[line] = (*lines.get(line, ()), *numbers.split())
        return lines | {int(line): reason for reason, at in self.reasons.items() for line in at.split()}
