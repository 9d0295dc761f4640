"""An identity and its decision: every residue must be the zero of an exact ring or field."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Any, Literal

ALL_ORDERS = "all n"
Check = tuple[str, Any]  # what is checked, and left side minus right side


@dataclass(frozen=True)
class Residue:
    """One checked difference.

    Attributes
    ----------
    label : str
        What the difference belongs to: "base n = 1", "step n -> n + 1", "entry (1, 2)" ...
    value : polynomial, field or ring element
        Left side minus right side. It is zero exactly when the checked equation holds.
    """

    label: str
    value: Any

    @property
    def vanishes(self) -> bool:
        """Whether the two sides are equal."""
        return bool(self.value == 0)


@dataclass(frozen=True)
class Proof:
    """The outcome of deciding one statement.

    Attributes
    ----------
    statement, latex : str
        The statement in plain text and in LaTeX.
    scope : str
        "all n", or the one order it was decided for, as in "n = 7".
    status : {"proved", "failed"}
    method : str
        How it was decided.
    seconds : float
        Time the decision took.
    equations : tuple of int
        Numbers of the equations of CP23 that it proves.
    residues : tuple of Residue
        Everything that was checked.
    """

    statement: str
    latex: str
    scope: str
    status: Literal["proved", "failed"]
    method: str
    seconds: float = field(compare=False)
    equations: tuple[int, ...]
    residues: tuple[Residue, ...] = field(compare=False, repr=False)

    @property
    def proved(self) -> bool:
        """Whether the statement holds."""
        return self.status == "proved"

    @property
    def failures(self) -> tuple[Residue, ...]:
        """The residues that do not vanish."""
        return tuple(residue for residue in self.residues if not residue.vanishes)

    def __str__(self) -> str:
        return f"{self.status} [{self.scope}] {self.statement} ({self.method})"


@dataclass(frozen=True)
class Claim:
    """A statement before its decision: the words of a :class:`Proof` without the outcome."""

    statement: str
    latex: str
    method: str
    equations: tuple[int, ...] = ()


def decide(claim: Claim, checks: Callable[[], Iterable[Check]], scope: str = ALL_ORDERS) -> Proof:
    """Decide a statement: it is proved when there are residues and all of them are exactly zero.

    Parameters
    ----------
    claim : Claim
    checks : callable
        Yields (label, left side minus right side), elements of an exact ring or field.
    scope : str
        "all n" or "n = 7".
    """
    start = time.perf_counter()
    residues = tuple(Residue(label, value) for label, value in checks())
    holds = bool(residues) and all(residue.vanishes for residue in residues)
    seconds = time.perf_counter() - start
    status: Literal["proved", "failed"] = "proved" if holds else "failed"
    return Proof(claim.statement, claim.latex, scope, status, claim.method, seconds, claim.equations, residues)
