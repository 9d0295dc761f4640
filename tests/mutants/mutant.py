"""What a mutant is, what became of it, and how a sample is drawn."""

from __future__ import annotations

import hashlib
import heapq
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

KILLED, TIMEOUT, SURVIVED, EQUIVALENT, PROSE, MEANINGLESS = (
    "killed", "timeout", "survived", "equivalent", "prose", "meaningless",
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class Mutant:
    """One change.

    Attributes
    ----------
    place : str
        File or program.
    line : int
        In the file; 0 where there is none.
    operator, change : str
        Of the listed operators, and the change in words.
    site : Any
        What the room needs to make it; one of a kind among mutants of the same place, operator and change.
    """

    place: str
    line: int
    operator: str
    change: str
    site: Any

    @property
    def where(self) -> str:
        """The place as it is clicked on."""
        return f"{self.place}:{self.line}" if self.line else self.place


@dataclass(frozen=True, slots=True)
class Fate:
    """What became of a mutant: the stage that killed it and the check that failed, or what showed it equivalent."""

    kind: str
    stage: str = ""
    by: str = ""


def keyed(mutants: Iterable[Mutant]) -> dict[str, Mutant]:
    """Mutants by a name that stays the same when lines move: place, operator, change, and a count among equals."""
    found: dict[str, Mutant] = {}
    seen: dict[str, int] = {}
    for mutant in mutants:
        text = f"{mutant.place}|{mutant.operator}|{mutant.change}"
        seen[text] = seen.get(text, 0) + 1
        found[hashlib.sha256(f"{text}|{seen[text]}".encode()).hexdigest()[:16]] = mutant
    return found


def sample(mutants: dict[str, Mutant], seed: int, count: int) -> dict[str, Mutant]:
    """So many of them, drawn by their names: another mutant more or less leaves the others in the sample."""
    chosen = heapq.nsmallest(count, mutants, key=lambda key: hashlib.sha256(f"{seed}|{key}".encode()).hexdigest())
    return {key: mutants[key] for key in chosen}
