"""What is known of mutants from before: fates that nothing has touched since, and what to ask first of the others.

A fate stands as long as what decided it is the same: a kill by a test, if the file of that test and all that is no test
are; a kill by anything else, if the latter is. What survived is tried again by the files of tests that have changed.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from .mutant import KILLED, SURVIVED, Fate
from .tree import Deciding


@dataclass(frozen=True, slots=True)
class Past:
    """Fates, what decided them, and the tests that could not take part, by reason."""

    deciding: Deciding
    left_out: Mapping[str, Sequence[str]]
    fates: Mapping[str, Fate]


@dataclass(frozen=True, slots=True)
class Known:
    """What the past says of a tree.

    ``settled`` are fates that stand, ``alive`` mutants that survived all tests but those of the files ``changed``;
    ``former`` is what killed a mutant at any time, to be asked first. ``left_out`` is of the other files.
    """

    settled: Mapping[str, Fate]
    alive: frozenset[str]
    changed: tuple[str, ...]
    former: Mapping[str, Fate]
    left_out: Mapping[str, list[str]]


def known(pasts: Sequence[Past], now: Deciding) -> Known:
    """What these say, the latest last; only where nothing but tests has changed is there more than killers."""
    former = {key: fate for past in pasts for key, fate in past.fates.items() if fate.kind == KILLED}
    of_use = [past for past in pasts if past.deciding.base == now.base]
    settled: dict[str, Fate] = {}
    alive: dict[str, tuple[str, ...]] = {}
    for past in of_use:
        for key, fate in past.fates.items():
            if fate.kind == SURVIVED:
                alive[key] = now.changed(past.deciding)
            elif _stands(fate, past.deciding, now):
                settled[key] = fate
    settled |= {key: Fate(SURVIVED) for key, files in alive.items() if not files and key not in settled}
    alive = {key: files for key, files in alive.items() if key not in settled}
    changed = {file for files in alive.values() for file in files}
    left_out = _without(of_use[-1].left_out, changed) if of_use else {}
    return Known(settled, frozenset(alive), tuple(sorted(changed)), former, left_out)


def _stands(fate: Fate, before: Deciding, now: Deciding) -> bool:
    file = re.split("::| ", fate.by)[0]
    return fate.kind != KILLED or file not in before.tests or before.tests[file] == now.tests.get(file)


def _without(left_out: Mapping[str, Sequence[str]], files: set[str]) -> dict[str, list[str]]:
    """Tests of these files may take part another time."""
    return {why: [name for name in names if name.partition("::")[0] not in files] for why, names in left_out.items()}


def write_head(path: Path, deciding: Deciding, left_out: Mapping[str, Sequence[str]]) -> None:
    """Begin a file of fates."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps({**asdict(deciding), "left_out": left_out}) + "\n", encoding="utf-8")


def line(key: str, fate: Fate, seconds: float) -> str:
    """Of such a file."""
    return json.dumps({"key": key, "seconds": seconds, **asdict(fate)}) + "\n"


def read(path: Path) -> Past | None:
    """A file of fates; None where there is none."""
    if not path.exists():
        return None
    head, *lines = map(json.loads, path.read_text(encoding="utf-8").splitlines())
    fates = {entry["key"]: _fate(entry) for entry in lines}
    return Past(Deciding(head["base"], head["tests"]), head["left_out"], fates)


def _fate(entry: Mapping[str, Any]) -> Fate:
    return Fate(entry["kind"], entry["stage"], entry["by"])
