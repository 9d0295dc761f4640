"""Equations of a file that follows the text of a paper: lines, readings, stated conditions and printed forms.

A file with ``conditions = "stated"`` in its table [paper] is such a transcript. Its statements stand as printed, with
names in place of what they mean. Each condition is tested on both sides, and none is searched for.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from .equation import Entry, Reading
from .extracted import Latex
from .language.claims import statement
from .language.matrices import unlike
from .language.names import ClaimError, Scope
from .language.operator_table import equal, nonzero, words
from .language.printed import Apply, Number, Symbol, Term, Trait, shown_as, walk
from .numbers.kinds import ORDER

READING_KEYS = ("claim", "note", "supported_by")
WORDS = ("title", "stated", "lost", "undecided", "fixed_by", "said", "remark")
"""Keys that stand in the entry unchanged."""


@dataclass(frozen=True)
class Transcript:
    """Scope, names as printed and sections, which all entries of a transcript share."""

    source: str
    scope: Scope
    printed: Mapping[str, str]  # LaTeX of operators by name, if not as usual
    sections: tuple[int, ...] = ()  # first line of each section

    def entry(self, row: Mapping[str, Any]) -> Entry:
        """Return the entry of an equation whose keys were checked; raise ClaimError."""
        rows = row.get("reading") or ([{"claim": row["claim"]}] if "claim" in row else [])
        readings = tuple(
            Reading(self._read(r, "claim"), r.get("note", ""), r.get("supported_by", "")) for r in rows
        )  # fmt: skip
        if "undecided" in row:
            title = row.get("title", row["number"])
            readings = (Reading(words(rf"\text{{{title}}}", title)),)
        domain, condition, corrected, because = (
            self._read(row, key) if key in row else None for key in ("domain", "condition", "corrected", "because")
        )
        line = row.get("line", 0)
        return Entry(
            row["number"], readings, line=line, extract=row.get("extract") or Latex(row.get("latex", "")),
            claimed=domain, condition=_sharp(condition), corrected=corrected, because=because, orders=_orders(domain),
            source=self.source, at=self._section(line), abbreviations=self.scope.abbreviations,
            **{key: row[key] for key in WORDS if key in row},
        )  # fmt: skip

    def _read(self, row: Mapping[str, str], key: str) -> Term:
        try:
            return shown_as(statement(row[key], self.scope), self.printed)
        except ClaimError as error:
            raise error if key == "claim" else ClaimError(f"{key}: {error.message}", error.column) from None

    def _section(self, line: int) -> str:
        return f"section {sum(first <= line for first in self.sections)}" if self.sections else ""


def _orders(domain: Term | None) -> tuple[int, ...] | None:
    """Return the orders that a domain such as ``n == 2`` names, which are tried whichever are asked for."""
    equations = [] if domain is None else [node.arguments for node in walk(domain) if node.operator is equal]
    found = [b.value for a, b in equations if isinstance(a, Symbol) and a.quantity is ORDER and isinstance(b, Number)]
    return tuple(found) or None


def _sharp(condition: Term | None) -> Term | None:
    """Return a condition in which ``a != 0`` is the operator whose sharpness is tested."""
    if not isinstance(condition, Apply):
        return condition
    if condition.operator is unlike and condition.arguments[1] == Number(0):
        return nonzero(condition.arguments[0])
    if Trait.JOINS in condition.operator.traits:
        return Apply(condition.operator.name, *map(_sharp, condition.arguments))
    return condition
