"""Result of an entry: its status and a verdict for each reading."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields
from enum import StrEnum
from typing import Any

from ..algebra.latex import Typeset
from .equation import Entry
from .language.operations import written
from .language.printed import Term, latex


class Status(StrEnum):
    """Status of a printed equation."""

    HOLDS = "holds"
    HOLDS_IF = "holds-if"
    UNREFUTED = "unrefuted"
    FALSE = "false"
    ERRATUM = "erratum"
    AMBIGUOUS = "ambiguous"
    UNDECIDED = "undecided"


@dataclass(frozen=True)
class Counterexample:
    """Point at which a statement is false, as in the output of ``--format json``."""

    point: str
    letters: Mapping[str, list[str]] = field(hash=False)  # numbers of each free symbol by its LaTeX
    sides: tuple[list[str], ...] = field(hash=False)  # numbers of both sides that differ; empty for a claim in words
    proof: str = field(default="", metadata={"only": "claims"})  # "exact rationals" or "disjoint intervals"


@dataclass(frozen=True)
class Verdict(Typeset):
    """Verdict on one reading: whether its statement is true at every tested point inside its domain.

    A false reading has a counterexample; `method` describes in words how it was decided.
    """

    statement: Term
    note: str
    true: bool
    method: str
    counterexample: Counterexample | None = None

    @property
    def latex(self) -> str:
        """Return the reading as LaTeX."""
        return latex(self.statement)

    def _typeset(self) -> str:
        return rf"\text{{{str(self.true).lower()}:}}\quad {self.latex}"


@dataclass(frozen=True)
class Result(Typeset):
    """Entry with its computed status."""

    paper: str  # slug
    equation: Entry
    status: Status
    method: str  # method of decision in words
    verdicts: tuple[Verdict, ...]  # one for each listed reading, true ones first
    exact: bool = False  # whether the denominators show that the condition is sharp, not only sufficient
    # further fields of claims whose condition is found
    certainty: str = ""  # "exact", "modulo a prime", or "evidence" of points alone
    points: int = 0  # points evaluated inside the domain
    found: str = ""  # condition in the form of claims
    outside: Counterexample | None = None  # point outside the condition
    changes: tuple[str, ...] = ()  # changes in one step that make a false claim true, simplest first
    vacuous: tuple[str, ...] = ()  # terms whose sign or coefficient does not matter
    needs: tuple[str, ...] = ()  # constraints of letters without which the claim is false
    cuts: str = ""  # how many points fail on other branches, and where they lie

    @property
    def own(self) -> dict[str, Any]:
        """Fields that the decision found: all but the paper and the entry."""
        return {field.name: getattr(self, field.name) for field in fields(self)[2:]}

    @property
    def printed(self) -> str:
        """LaTeX of the first reading, or of a claim in a file with the names of its definitions."""
        return self.verdicts[0].latex if self.equation.written is None else latex(self.equation.written)

    @property
    def claim(self) -> str:
        """Claim of a file as plain text."""
        return "" if self.equation.written is None else written(self.equation.written)

    @property
    def domain(self) -> str:
        """Domain that a file states for a claim, as plain text."""
        stated = self.equation.claimed
        return "" if stated is None or self.equation.written is None else written(stated)

    @property
    def corrected(self) -> str | None:
        """LaTeX of the correction of an erratum."""
        return _latex(self.equation.mended or self.equation.corrected) if self.status is Status.ERRATUM else None

    @property
    def condition(self) -> str | None:
        """LaTeX of the condition under which the equation was found to hold."""
        return _latex(self.equation.condition)

    @property
    def claimed(self) -> str | None:
        """LaTeX of the domain stated by the paper."""
        return _latex(self.equation.claimed)

    @property
    def counterexample(self) -> Counterexample | None:
        """Counterexample of an erratum or a false claim."""
        wrong = self.status in (Status.ERRATUM, Status.FALSE)
        return self.verdicts[0].counterexample if wrong else None

    @property
    def caution(self) -> str:
        """Words beside the verdict on a claim that was proposed from LaTeX; empty for others."""
        return "read this before you believe it: the claim was proposed from LaTeX" if self.equation.proposed else ""

    @property
    def section(self) -> str:
        """Section number in the paper, from the entry's place, or from the file name of its module."""
        at, source = self.equation.at, self.equation.source
        found = re.search(r"^section (\d+)", at) or re.search(r"/s0?(\d+)(?:_(\d))?", source)
        return ".".join(part for part in found.groups() if part) if found else ""

    @property
    def anchor(self) -> str:
        """Permanent anchor of the entry in the report pages."""
        return re.sub(r"[^\w.-]+", "-", f"{self.paper}-{self.equation.number}")

    def as_json(self) -> dict[str, Any]:
        """Return the fields printed by ``--format json``."""
        entry = self.equation
        return {
            "paper": self.paper,
            "equation": entry.number,
            "title": entry.title,
            "status": str(self.status),
            "printed": self.printed,
            "corrected": self.corrected,
            "claimed": self.claimed,
            "stated": entry.stated or self.domain or None,
            "condition": self.condition or self.found or None,
            "exact": self.exact if entry.condition is not None else None,
            "readings": [
                {"latex": v.latex, "verdict": "true" if v.true else "false", "note": v.note} for v in self.verdicts
            ],
            "reading_count": len(self.verdicts),
            "capped": False,
            "counterexample": self.counterexample and asdict(self.counterexample),
            "method": self.method,
            "anchor": self.anchor,
            "section": self.section,
            "claim": self.claim or None,
            "domain": self.domain or None,
            "outside": self.outside and asdict(self.outside),
            **{name: getattr(self, name) for name in ("certainty", "points", "changes", "vacuous", "needs", "cuts")},
            **{name: getattr(entry, name) for name in ("at", "line", "source", "said", "remark")},
            "latex": entry.printed or None,
            "proposed": entry.proposed,
        }

    def cells(self) -> dict[str, str]:
        """Return the cells of this result's table row."""
        return {
            "paper": self.paper,
            "equation": self.equation.number,
            "status": str(self.status),
            "printed": f"$\\displaystyle {self.printed}$",
            "corrected": f"$\\displaystyle {self.corrected}$" if self.corrected else "",
            "method": "; ".join(part for part in (self.caution, self.found, self.method) if part),
        }

    def __repr__(self) -> str:
        label = f"{self.paper} ({self.equation.number}): " if self.paper else ""
        return f"<Result {label}{self.status}{': ' if self.found else ''}{self.found}>"

    def _typeset(self) -> str:
        body = rf"\text{{({self.equation.number}) {self.status}:}}\quad {self.printed}"
        if self.corrected is not None:  # on a line of its own
            body = rf"\begin{{gathered}} {body} \\ \longrightarrow\quad {self.corrected} \end{{gathered}}"
        return body


def undecided(paper: str, entry: Entry, reason: str) -> Result:
    """Return the result of an entry without a decision, for a reason in words."""
    verdict = Verdict(entry.readings[0].statement, "", False, reason)
    return Result(paper, entry, Status.UNDECIDED, reason, (verdict,))


def _latex(statement: Term | None) -> str | None:
    return None if statement is None else latex(statement)
