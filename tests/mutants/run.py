"""Draw the sample of a room, try each mutant in a process of its own, keep what became of it."""

from __future__ import annotations

import pickle
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from functools import partial
from itertools import islice
from pathlib import Path
from typing import Any

from . import past, road
from .checks import Checks
from .child import Child, Outcome, outcomes, shared
from .knowledge import NotControlled
from .mutant import KILLED, SURVIVED, TIMEOUT, Fate, Mutant, keyed, sample
from .past import Known, known
from .record import Record, Trial, read
from .rooms import Files, Room
from .tree import Copy, Deciding, deciding, enter

Say = Callable[[str], None]
CONTROL = "unchanged"


@dataclass(frozen=True)
class Part:
    """Mutants of a room that are tried in the same way."""

    room: Room
    mutants: Mapping[str, Mutant]

    @property
    def trials(self) -> dict[str, Mutant | None]:
        """The unchanged tree, and the mutants."""
        return {f"{CONTROL} by {len(tests)} files" if (tests := self._tests) else CONTROL: None, **self.mutants}

    @property
    def _tests(self) -> tuple[str, ...]:
        checks = self.room.checks
        return checks.tests if checks and checks.later else ()


@dataclass(frozen=True)
class Work:
    """What there is to do in a room: mutants, how many there are, what is known of them, and what has to be tried."""

    room: Room
    total: int
    sample: Mapping[str, Mutant]
    deciding: Deciding
    known: Known

    @property
    def parts(self) -> list[Part]:
        """What nothing is known of, by all checks; what survived before, by the tests that have changed."""
        before = self.known
        left = {key: m for key, m in self.sample.items() if key not in before.settled and key not in before.alive}
        again = {key: m for key, m in self.sample.items() if key in before.alive}
        parts = [Part(self.room, left)] if left else []
        if again and isinstance(self.room, Files):
            parts.append(Part(self.room.again(self.known.changed), again))
        return parts


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

    def deciding(self, checks: Checks | None) -> Deciding:
        """What decides the fates of mutants that these have to kill."""
        return checks.deciding(self.root) if checks else deciding(self.root, ())

    def folder(self, found: Deciding) -> Path:
        """Where results are kept for what decides."""
        folder = self.cache / found.name
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
            works = [self._work(room, *drawn) for room, drawn in zip(rooms, self._drawn(rooms, copies))]
            checks = {part.room.checks for work in works for part in work.parts} - {None}
            knowledge = self._prepared(sorted(checks, key=str), copies)
            for work in works:
                yield self._tried(work, knowledge, copies)

    # --- what trials need -----------------------------------------------------------------------------------------

    def _drawn(self, rooms: list[Room], copies: list[Copy]) -> list[Any]:
        name = f"sample-{self.seed}-{self.count}"
        jobs = {
            self.folder(self.deciding(room.checks)) / f"{name}-{room.name}.pickle": partial(
                draw, room, self.seed, self.count
            )
            for room in rooms
        }
        return self._values(jobs, copies)

    def _work(self, room: Room, total: int, chosen: Mapping[str, Mutant]) -> Work:
        now = self.deciding(room.checks)
        here = sorted(self.cache.glob(f"*/{room.name}.jsonl"), key=lambda path: path.stat().st_mtime)
        record = read(self.root, room.name)
        pasts = [*([record.past] if record else []), *(found for path in here if (found := past.read(path)))]
        return Work(room, total, chosen, now, known(pasts, now))

    def _prepared(self, checks: Sequence[Checks], copies: list[Copy]) -> dict[Checks, Any]:
        wanted = [(of, look) for of in checks for look in of.looks]
        jobs = {
            self.folder(self.deciding(of)) / f"checks-{of.name}-{look}.pickle": partial(prepare, of, look)
            for of, look in wanted
        }
        found: dict[Checks, dict[str, Any]] = {}
        for (of, look), value in zip(wanted, self._values(jobs, copies), strict=True):
            found.setdefault(of, {})[look] = value
        return {of: of.knowledge(looks) for of, looks in found.items()}

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

    def _tried(self, work: Work, knowledge: Mapping[Checks, Any], copies: list[Copy]) -> Record:
        name, fates, left_out = work.room.name, dict(work.known.settled), dict(work.known.left_out)
        parts = [(part, knowledge[part.room.checks] if part.room.checks else None) for part in work.parts]
        for _, needed in parts:
            for why, names in needed.left_out.items() if needed else ():
                left_out[why] = sorted({*left_out.get(why, ()), *names})
        path = self.folder(work.deciding) / f"{name}.jsonl"
        if not path.exists():
            past.write_head(path, work.deciding, left_out)
        shown = time.monotonic()
        with path.open("a", encoding="utf-8") as file:
            for part, needed in parts:
                for key, fate, seconds in self._fates(part, needed, work.known, copies):
                    fates[key] = fate
                    file.write(past.line(key, fate, seconds))
                    file.flush()
                    if time.monotonic() - shown > 10:
                        shown = time.monotonic()
                        self.say(_progress(work, fates))
        self.say(_progress(work, fates))
        trials = {key: _trial(mutant, fates[key]) for key, mutant in work.sample.items()}
        told = {why: list(names) for why, names in left_out.items() if names}
        return Record(name, self.state, self.seed, work.total, work.deciding, told, trials)

    def _fates(self, part: Part, needed: Any, before: Known, copies: list[Copy]) -> Iterator[tuple[str, Fate, float]]:
        """Of a part, as they are found; what was tried before the run was stopped is not tried again."""
        trials = {key: mutant for key, mutant in part.trials.items() if key not in before.settled}
        former = {} if part.room.checks and part.room.checks.later else before.former
        jobs = [partial(_start, part.room, mutant, needed, former.get(key)) for key, mutant in trials.items()]
        for number, outcome in shared(copies, partial(warm, part.room), jobs):
            key, fate = list(trials)[number], _fate(outcome)
            if trials[key] is None and fate.kind != SURVIVED:
                raise NotControlled(f"{part.room.name}: the unchanged tree fails {fate.stage}: {fate.by}")
            yield key, fate, outcome.seconds


def _start(room: Room, mutant: Mutant | None, needed: Any, former: Fate | None, copy: Copy) -> tuple[ExitStack, Child]:
    stack = ExitStack()
    stack.enter_context(copy.changed(room.edit(mutant) if mutant else None))
    return stack, Child(partial(room.trial, mutant, needed, former), room.limit(mutant, needed))


def _progress(work: Work, fates: Mapping[str, Fate]) -> str:
    done = Counter(fates[key].kind for key in work.sample if key in fates)
    counts = ", ".join(f"{count} {kind}" for kind, count in sorted(done.items()))
    return f"{work.room.name}: {sum(done.values())} of {len(work.sample)}: {counts}"


def prepare(checks: Checks, look: str, folder: Path) -> Any:
    """Look at the unchanged tree, inside a copy."""
    enter(folder)
    return checks.looks[look](folder)


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


def _trial(mutant: Mutant, fate: Fate) -> Trial:
    shown = (mutant.where, mutant.change) if fate.kind == SURVIVED else ()
    return Trial(mutant.operator, fate, *shown)


def _fate(outcome: Outcome) -> Fate:
    if outcome.how == "done":
        return outcome.value  # type: ignore[no-any-return]
    if outcome.how == "timeout":
        return Fate(TIMEOUT, "time limit")
    return Fate(KILLED, "crash", str(outcome.value)[-200:])
