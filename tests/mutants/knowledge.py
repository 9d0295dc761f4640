"""What is known of the unchanged tree before anything in it is changed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from . import road, suite
from .python import Edit
from .reach import Table


class NotControlled(Exception):
    """The unchanged tree does not survive its own checks, or none of them can be used: killing would say nothing."""


@dataclass(frozen=True)
class Watched:
    """What checks took and reached while they were watched; see `Knowledge`. ``first`` are those that are no tests."""

    first: Mapping[str, Mapping[str, float]]
    tests: suite.Times
    table: Table
    printing: frozenset[tuple[str, int]]
    controlling: frozenset[tuple[str, int]]
    controls: Sequence[str]
    starters: frozenset[str]


@dataclass(frozen=True)
class Knowledge:
    """Of the unchanged tree: seconds of the checks of every stage, what they reach, and what is emitted.

    ``setups`` are seconds too, of all fixtures, ``left_out`` the tests that cannot take part, by reason, and
    ``printing`` the lines that only make texts. ``controlling`` are those that only make controls of proofs, and
    ``controls`` what these are of.
    """

    seconds: Mapping[str, Mapping[str, float]]
    setups: float
    table: Table
    printing: frozenset[tuple[str, int]]
    controlling: frozenset[tuple[str, int]]
    controls: Sequence[str]
    left_out: Mapping[str, Sequence[str]]
    prints: Mapping[str, road.Prints]

    def plan(self, edit: Edit | None) -> dict[str, list[str]]:
        """The checks that reach an edit, by stage, in their order."""
        reached = None if edit is None else self.table.checks(edit.path, edit.lines)
        return {
            stage: [name for name in seconds if reached is None or name in reached or stage == "kernels"]
            for stage, seconds in self.seconds.items()
        }

    def processor(self, edit: Edit | None) -> float:
        """Seconds of processor time that those take, watched."""
        planned = ((stage, name) for stage, names in self.plan(edit).items() for name in names)
        return self.setups + sum(self.seconds[stage][name] for stage, name in planned)

    def prints_only(self, edit: Edit) -> bool:
        """Whether an edit is in what makes texts, and in nothing that validates them."""
        places = self._places(edit)
        return bool(places) and places <= self.printing

    def controls_only(self, edit: Edit) -> bool:
        """Whether an edit is in what makes theorems wrong on purpose, and in nothing that decides them."""
        places = self._places(edit)
        return bool(places) and places <= self.controlling

    def _places(self, edit: Edit) -> set[tuple[str, int]]:
        return {(edit.path, line) for line in range(edit.lines[0], edit.lines[1] + 1)} & self.table.lines.keys()
