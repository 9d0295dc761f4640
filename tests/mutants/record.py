"""What became of the sample of a room, kept with the sources: figures of the page, and what is asked first next time.

A record is a file of JSON lines in ``fates``: the circumstances, then a line for each mutant.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path

from .mutant import SURVIVED, Fate
from .past import Past
from .tree import Deciding

FOLDER = "tests/mutants/fates"


@dataclass(frozen=True, slots=True)
class Trial:
    """A mutant and what became of it; the place and the change are kept of those alone that are shown."""

    operator: str
    fate: Fate
    where: str = ""
    change: str = ""


@dataclass(frozen=True, slots=True)
class Record:
    """A room as it was measured.

    Attributes
    ----------
    state : str
        The commit, and whether the tree differed from it.
    seed, total : int
        Of the sample; how many mutants there are.
    deciding : Deciding
        What decided.
    left_out : mapping
        Tests that could not take part, by reason.
    trials : mapping
        By the names of the mutants.
    """

    room: str
    state: str
    seed: int
    total: int
    deciding: Deciding
    left_out: Mapping[str, list[str]]
    trials: Mapping[str, Trial]

    @property
    def past(self) -> Past:
        """What it says of another tree."""
        return Past(self.deciding, self.left_out, {key: trial.fate for key, trial in self.trials.items()})

    @property
    def survivors(self) -> list[Trial]:
        """Mutants that no check kills and no command shows to be equivalent, by their place."""
        alive = (trial for trial in self.trials.values() if trial.fate.kind == SURVIVED)
        return sorted(alive, key=lambda trial: (trial.where, trial.operator, trial.change))

    def write(self, root: Path) -> None:
        """Into the file of the room."""
        head = {"room": self.room, "state": self.state, "seed": self.seed, "total": self.total,
                "deciding": asdict(self.deciding), "left_out": self.left_out}  # fmt: skip
        lines = [head, *({"key": key, **_line(self.trials[key])} for key in sorted(self.trials))]
        path = _path(root, self.room)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("".join(json.dumps(line, ensure_ascii=False) + "\n" for line in lines), encoding="utf-8")


def read(root: Path, room: str) -> Record | None:
    """The record of a room; None where it was never measured."""
    path = _path(root, room)
    if not path.exists():
        return None
    head, *lines = map(json.loads, path.read_text(encoding="utf-8").splitlines())
    head["deciding"] = Deciding(**head["deciding"])
    return Record(**head, trials={line.pop("key"): Trial(fate=Fate(**line.pop("fate")), **line) for line in lines})


def _path(root: Path, room: str) -> Path:
    return root / FOLDER / f"{room}.jsonl"


def _line(trial: Trial) -> dict[str, object]:
    """What is kept: nothing that is empty."""
    kept = {name: value for name, value in asdict(trial).items() if value}
    return {**kept, "fate": {name: value for name, value in asdict(trial.fate).items() if value}}
