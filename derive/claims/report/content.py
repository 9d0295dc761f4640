"""Content of a report, independent of format."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import zip_longest
from shlex import quote
from typing import Protocol

from ... import about
from ..equation import Entry, Paper
from ..language.printed import latex, rate_depth
from ..language.values import coefficients
from ..numbers.kinds import KINDS
from ..result import Counterexample, Result, Status
from ..sheet import Problem
from .plain import plain

MEANING = {
    Status.FALSE: "false, with a point where it fails, and changes in one step that make it true",
    Status.ERRATUM: "false as printed in every listed reading; its correction is decided like any other statement",
    Status.UNDECIDED: "neither proved nor refuted, for the reason shown",
    Status.UNREFUTED: "true at all points that were tried, and not proved",
    Status.AMBIGUOUS: "a true and a false reading that the text cannot tell apart",
    Status.HOLDS_IF: "proved under the condition shown",
    Status.HOLDS: "proved as printed",
}
"""Meaning of each status, in the order of the report."""
ERRORS = "not understood"
"""Word for what cannot be read in a file: claims, letters, comments."""


class StatementProof(Protocol):
    """Proof of a statement about charts, as a report lists it."""

    @property
    def statement(self) -> str: ...
    @property
    def scope(self) -> str: ...
    @property
    def status(self) -> str: ...
    @property
    def method(self) -> str: ...
    @property
    def seconds(self) -> float: ...
    @property
    def proved(self) -> bool: ...


@dataclass(frozen=True)
class Chapter:
    """Results of one paper."""

    paper: Paper
    results: tuple[Result, ...]

    def of(self, status: Status) -> tuple[Result, ...]:
        return tuple(result for result in self.results if result.status is status)

    @property
    def counts(self) -> dict[Status, int]:
        return {status: len(self.of(status)) for status in MEANING}

    @property
    def of_file(self) -> bool:
        return any(result.equation.written is not None for result in self.results)


@dataclass(frozen=True)
class Report:
    """Results and proofs of a report, with one chapter for each paper that has results.

    `root` is the relative path from the report to the project, for links to sources; empty for no links.
    """

    chapters: tuple[Chapter, ...]
    proofs: tuple[StatementProof, ...]
    root: str = ""
    problems: tuple[Problem, ...] = ()
    unread: tuple[Mapping[str, str], ...] = ()  # number, place and LaTeX of equations without a claim

    @classmethod
    def of(
        cls, papers: Iterable[Paper], results: Sequence[Result], proofs: Iterable[StatementProof], root: str = "",
        problems: Iterable[Problem] = (), unread: Iterable[Mapping[str, str]] = (),
    ) -> Report:  # fmt: skip
        """Return a report with results grouped by paper, what could not be read in files, and what has no claim."""
        chapters = (Chapter(paper, tuple(r for r in results if r.paper == paper.slug)) for paper in papers)
        found = tuple(chapter for chapter in chapters if chapter.results)
        return cls(found, tuple(proofs), root, tuple(problems), tuple(unread))

    @property
    def counts(self) -> dict[str, int]:
        """Numbers of equations that are decided and unread, of errors, of each status, proofs and proposed claims."""
        found = Counter(result.status for result in self.results)
        decided = len(self.results) - found[Status.UNDECIDED] - found[Status.UNREFUTED]
        counts = {"decided": decided, "unread": len(self.unread)}
        rest = {ERRORS: len(self.problems), **{str(s): found[s] for s in MEANING}, "proofs": len(self.proofs)}
        rest["proposed"] = sum(result.equation.proposed for result in self.results)
        return counts | {what: n for what, n in rest.items() if n}

    @property
    def summary(self) -> str:
        """Counts in one line, such as "41 decided, 3 unread: 2 false, 39 holds"."""
        parts, first = [f"{count} {what}" for what, count in self.counts.items()], 2 + bool(self.problems)
        return ": ".join(filter(None, (", ".join(parts[:first]), ", ".join(parts[first:]))))

    @property
    def statuses(self) -> dict[Status, str]:
        """Statuses of the results with their meanings."""
        found = {result.status for result in self.results}
        return {status: meaning for status, meaning in MEANING.items() if status in found}

    @property
    def of_files(self) -> bool:
        return all(chapter.of_file for chapter in self.chapters)

    @property
    def results(self) -> tuple[Result, ...]:
        return tuple(result for chapter in self.chapters for result in chapter.results)

    @property
    def errata(self) -> tuple[tuple[Chapter, Result], ...]:
        """Errata with their chapters, those of numbered equations first."""
        found = ((chapter, result) for chapter in self.chapters for result in chapter.of(Status.ERRATUM))
        return tuple(sorted(found, key=lambda pair: not pair[1].equation.number.isdecimal()))

    @property
    def failed(self) -> tuple[StatementProof, ...]:
        return tuple(proof for proof in self.proofs if not proof.proved)

    def link(self, result: Result) -> str:
        return f"{self.root}/{result.equation.source}" if self.root else ""


def label(result: Result) -> str:
    """Return the label for citing an equation: ``(111)``, its slug, or "claim" for one alone."""
    number = result.equation.number
    return f"({number})" if number.isdecimal() else number or "claim"


def place(result: Result) -> str:
    """Return the section and the equation number of an entry in words; of a claim in a file where it is printed."""
    number = result.equation.number
    if result.equation.written is not None:
        return ", ".join(filter(None, (f"equation {number}" if number else "", result.equation.at)))
    return f"section {result.section}" + (f", equation ({number})" if number.isdecimal() else "")


def readings(result: Result) -> str:
    """Return the numbers of listed and of true readings in words; empty for a single reading."""
    count, true = len(result.verdicts), sum(verdict.true for verdict in result.verdicts)
    return f"{count} readings, {true or 'none'} true" if count > 1 else ""


def extent(result: Result) -> str:
    """Return "if" for a sharp condition, "at least where" for a sufficient one, "where" for other statuses."""
    if result.status is not Status.HOLDS_IF:
        return "where"
    return "if" if result.exact or result.found else "at least where"


def domain(result: Result) -> tuple[str, ...]:
    """Return one line for the condition found and one for the domain stated by the paper."""
    condition = result.found or plain(result.condition or "")
    found = f"{extent(result)} {condition}" if condition else ""
    stated = f"for {result.domain or plain(result.claimed)}, as stated" if result.claimed else ""
    return tuple(line for line in (found, stated) if line)


def details(result: Result) -> tuple[str, ...]:
    """Return further lines about a claim of a file: a point outside its condition, what mends it, what it needs."""
    return (
        *([result.caution] if result.caution else []),
        *([result.outside.point] if result.outside else []),
        *([result.cuts] if result.cuts else []),
        *(f"true with: {change}" for change in result.changes),
        *(f"since, as declared, {need}" for need in result.needs),
        *(f"true as well with another sign or factor: {term}" for term in result.vacuous),
    )


def shown(result: Result) -> str:
    """Return a result's formula in one line: a claim as written, a printed formula in Unicode."""
    return result.claim or plain(result.printed)


def why(result: Result) -> str:
    """Return a one-sentence explanation of an erratum: its remark or title."""
    entry = result.equation
    return (entry.remark or entry.title).split(". ")[0].rstrip(".") + "."


def subject(result: Result) -> str:
    """Return what an erratum is about: a formula, printed with a sign =, or where something holds or exists."""
    return "formulas" if " = " in result.printed else "domains"


def command(result: Result) -> str:
    """Return the command that prints the entry with its counterexample."""
    if result.paper not in about.PAPERS:
        return f"dualcay verify {quote(result.equation.source)} --eq {quote(result.equation.number)}"
    return f"dualcay verify --paper {result.paper} --eq {result.equation.number}"


SHOWN_DIGITS = 10
TWICE = ", rates "
"""Word for numbers with first and second rates."""


def example(found: Counterexample, entry: Entry | None = None) -> tuple[str, ...]:
    """Return a counterexample as lines: values of the symbols, then the first number that differs between the sides."""
    lines = tuple(f"{plain(name)} = {_numbers(parts, _second(entry, name, parts))}"
                  for name, parts in found.letters.items())  # fmt: skip
    if len(found.sides) != 2 or not all(found.sides):
        return *lines, f"{found.point}: the statement is false"
    left, right = found.sides
    left, right = list(map(short, left)), list(map(short, right))
    rows = list(zip_longest(left, right, fillvalue="0"))  # a side without dual part or rates has zeros there
    i = next((i for i, (a, b) in enumerate(rows) if a[:SHOWN_DIGITS] != b[:SHOWN_DIGITS]), 0)
    which = f"number {i + 1} of {len(rows)}: " if len(rows) > 1 else ""
    return *lines, f"{which}left {rows[i][0]}, right {rows[i][1]}"


def short(number: str) -> str:
    """Return a number with few characters: a long fraction as a decimal, a long decimal cut."""
    above, stroke, below = number.partition("/")
    if stroke and len(number) > SHOWN_DIGITS + 2:
        number = f"{int(above) / int(below):.10g}"
    mantissa, e, exponent = number.partition("e")
    return mantissa[: SHOWN_DIGITS + 2] + e + exponent


def _second(entry: Entry | None, name: str, parts: list[str]) -> str:
    """Return what the second half of a letter's numbers is: the dual part, the rate, or nothing."""
    if entry is None or entry.written is None:
        return " + ε " if len(parts) in (2, 6, 8, 18) else ""
    statement = entry.readings[0].statement
    letter = next(symbol for symbol in entry.free(statement) if name in (symbol.name, latex(symbol)))
    kind, depth = KINDS.get(letter.quantity.name), rate_depth(statement)
    if kind and kind.dual:
        return " + ε "
    if kind and len(parts) == len(list(coefficients(kind.build((Fraction(1),) * kind.size)))):
        return ""
    return ("", ", rate ", TWICE)[depth] if depth < 3 else ""


def _numbers(parts: list[str], second: str) -> str:
    """Return the numbers of a value as one string, its second half or its rates after a word."""
    shown = list(map(short, parts))
    quarter, half = len(shown) // 4, len(shown) // 2
    if second == TWICE and quarter:  # value, rate, rate again, second rate
        pieces = shown[:quarter], shown[quarter:half], shown[half + quarter :]
        value, rate, second_rate = map(_tuple, pieces)
        return f"{value}, rate {rate}, second rate {second_rate}"
    if not second or not half:
        return _tuple(shown)
    first, last = _tuple(shown[:half]), _tuple(shown[half:])
    return f"{first} - ε {last[1:]}" if second == " + ε " and last.startswith("-") else f"{first}{second}{last}"


def _tuple(parts: list[str]) -> str:
    return parts[0] if len(parts) == 1 else f"({', '.join(parts)})"
