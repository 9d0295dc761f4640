"""Draw the sample of a room, try each mutant in a process of its own, keep what became of it."""

from __future__ import annotations

import json
import pickle
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager
from dataclasses import asdict, dataclass
from functools import partial
from itertools import islice
from pathlib import Path
from typing import Any

from . import road
from .checks import Checks
from .child import Child, Outcome, outcomes, shared
from .mutant import KILLED, SURVIVED, TIMEOUT, Fate, Mutant, keyed, sample
from .record import Record, Trial, read
from .rooms import Room
from .tree import Copy, digest, enter

Say = Callable[[str], None]
CONTROL = "unchanged"


@dataclass(frozen=True, slots=True)
class Drawn:
    """A room ready to be tried: how many mutants there are, the sample, and what trials need to know.

    ``former`` are fates in other trees: what killed a mutant there is the first to be asked again.
    """

    room: Room
    total: int
    sample: Mapping[str, Mutant]
    knowledge: Any
    former: Mapping[str, Fate]


class NotControlled(Exception):
    """The unchanged tree does not survive its own checks, so that killing says nothing."""


class Run:
    """Rooms of one tree.

    Parameters
    ----------
    root : Path
        The working tree.
    cache : Path
        Where results are kept, in folders named by the digest of what decides.
    state : str
        The commit, and whether the tree differs from it.
    seed, count, jobs : int
        Of the sample, its size in each room, and how many processes at once.
    """

    def __init__(self, root: Path, cache: Path, state: str, seed: int, count: int, jobs: int, say: Say) -> None:
        self.root, self.cache, self.state, self.say = root, cache, state, say
        self.seed, self.count, self.jobs = seed, count, jobs

    def kept(self, checks: Checks | None) -> Path:
        """Where results are kept for what decides these checks."""
        folder = self.cache / digest(self.root, checks.deciding if checks else ())
        folder.mkdir(parents=True, exist_ok=True)
        return folder

    @contextmanager
    def copies(self) -> Iterator[list[Copy]]:
        """A copy of the tree for every process."""
        with tempfile.TemporaryDirectory(prefix="mutants-") as folder:
            yield [Copy(self.root, Path(folder) / str(slot)) for slot in range(self.jobs)]

    def rooms(self, rooms: list[Room]) -> Iterator[Record]:
        """Prepare all rooms, then try them one after the other."""
        with self.copies() as copies:
            knowledge = self._prepared({checks.name: checks for room in rooms if (checks := room.checks)}, copies)
            drawn = self._drawn(rooms, copies)
            for room in rooms:
                total, chosen = drawn[room.name]
                known = knowledge[room.checks.name] if room.checks else None
                yield self._tried(Drawn(room, total, chosen, known, self._former(room)), copies)

    # --- what trials need -----------------------------------------------------------------------------------------

    def _prepared(self, checks: Mapping[str, Checks], copies: list[Copy]) -> dict[str, Any]:
        jobs = {self.kept(of) / f"checks-{name}.pickle": partial(prepare, of) for name, of in checks.items()}
        return dict(zip(checks, self._values(jobs, copies)))

    def _drawn(self, rooms: list[Room], copies: list[Copy]) -> dict[str, Any]:
        jobs = {
            self.kept(room.checks) / f"sample-{self.seed}-{self.count}-{room.name}.pickle": partial(
                draw, room, self.seed, self.count
            )
            for room in rooms
        }
        return dict(zip((room.name for room in rooms), self._values(jobs, copies)))

    def _values(self, jobs: Mapping[Path, Callable[[Path], Any]], copies: list[Copy]) -> list[Any]:
        """Values of jobs, each kept in a file of its own."""
        missing = [path for path in jobs if not path.exists()]

        def start(path: Path, copy: Copy) -> tuple[ExitStack, Child]:
            return ExitStack(), Child(partial(jobs[path], copy.folder))

        for number, outcome in outcomes([partial(start, path) for path in missing], copies):
            path = missing[number]
            if outcome.how != "done":
                raise NotControlled(f"{path.stem}: {outcome.how}\n{outcome.value}")
            path.write_bytes(pickle.dumps(outcome.value))
            self.say(f"{path.stem}: {outcome.seconds:.0f} s")
        return [pickle.loads(path.read_bytes()) for path in jobs]

    # --- trials ---------------------------------------------------------------------------------------------------

    def _former(self, room: Room) -> dict[str, Fate]:
        """Of mutants that were killed in other trees, by what; the last time here counts more than the record."""
        record, now = read(self.root, room.name), self.kept(room.checks)
        others = sorted(self.cache.glob(f"*/{room.name}.jsonl"), key=lambda path: path.stat().st_mtime)
        entries = (entry for path in others if path.parent != now for entry in _read(path).values())
        here = {entry["key"]: _kept_fate(entry) for entry in entries if entry["kind"] == KILLED}
        return {**(record.killers if record else {}), **here}

    def _tried(self, drawn: Drawn, copies: list[Copy]) -> Record:
        path = self.kept(drawn.room.checks) / f"{drawn.room.name}.jsonl"
        kept = _read(path)
        trials: dict[str, Mutant | None] = {CONTROL: None, **drawn.sample}
        wanted = [key for key in trials if key not in kept]
        shown = time.monotonic()
        with path.open("a", encoding="utf-8") as file:
            jobs = [partial(self._start, drawn, trials[key], drawn.former.get(key)) for key in wanted]
            for number, outcome in shared(copies, partial(warm, drawn.room), jobs) if jobs else ():
                fate = _fate(outcome)
                key = wanted[number]
                if key == CONTROL and fate.kind != SURVIVED:
                    raise NotControlled(f"{drawn.room.name}: the unchanged tree fails {fate.stage}: {fate.by}")
                kept[key] = {"key": key, "seconds": outcome.seconds, **asdict(fate)}
                file.write(json.dumps(kept[key]) + "\n")
                file.flush()
                if time.monotonic() - shown > 10:
                    shown = time.monotonic()
                    self.say(self._progress(drawn, kept))
        self.say(self._progress(drawn, kept))
        return self._record(drawn, {key: _kept_fate(kept[key]) for key in drawn.sample})

    def _record(self, drawn: Drawn, fates: Mapping[str, Fate]) -> Record:
        left_out = {why: list(names) for why, names in getattr(drawn.knowledge, "left_out", {}).items() if names}
        trials = {key: _trial(mutant, fates[key]) for key, mutant in drawn.sample.items()}
        return Record(drawn.room.name, self.state, self.seed, drawn.total, left_out, trials)

    @staticmethod
    def _progress(drawn: Drawn, kept: Mapping[str, Mapping[str, Any]]) -> str:
        done = Counter(str(kept[key]["kind"]) for key in drawn.sample if key in kept)
        counts = ", ".join(f"{count} {kind}" for kind, count in sorted(done.items()))
        return f"{drawn.room.name}: {sum(done.values())} of {len(drawn.sample)}: {counts}"

    @staticmethod
    def _start(drawn: Drawn, mutant: Mutant | None, former: Fate | None, copy: Copy) -> tuple[ExitStack, Child]:
        room, stack = drawn.room, ExitStack()
        stack.enter_context(copy.changed(room.edit(mutant) if mutant else None))
        limit = room.limit(mutant, drawn.knowledge)
        return stack, Child(partial(room.trial, mutant, drawn.knowledge, former), limit)


def prepare(checks: Checks, folder: Path) -> Any:
    """Look at the unchanged tree, inside a copy."""
    enter(folder)
    return checks.prepare(folder)


def draw(room: Room, seed: int, count: int, folder: Path) -> tuple[int, dict[str, Mutant]]:
    """How many mutants a room has, and a sample, inside a copy."""
    enter(folder)
    population = keyed(room.mutants(folder))
    drawn = sample(population, seed, len(population)).items()
    return len(population), dict(islice(((key, mutant) for key, mutant in drawn if room.is_one(mutant)), count))


def warm(room: Room, copy: Copy) -> None:
    """Make ready for trials inside a copy: import what no mutant of the room changes."""
    enter(copy.folder)
    road.warm(room.unchanged)


def _read(path: Path) -> dict[str, Mapping[str, Any]]:
    """What became of mutants, by their names."""
    lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    return {entry["key"]: entry for entry in map(json.loads, lines)}


def _trial(mutant: Mutant, fate: Fate) -> Trial:
    shown = (mutant.where, mutant.change) if fate.kind == SURVIVED else ()
    return Trial(mutant.operator, fate, *shown)


def _kept_fate(entry: Mapping[str, Any]) -> Fate:
    return Fate(entry["kind"], entry["stage"], entry["by"])


def _fate(outcome: Outcome) -> Fate:
    if outcome.how == "done":
        return outcome.value  # type: ignore[no-any-return]
    if outcome.how == "timeout":
        return Fate(TIMEOUT, "time limit")
    return Fate(KILLED, "crash", str(outcome.value)[-200:])
