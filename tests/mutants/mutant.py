"""Mutants and their verdicts: drawing of samples, and trial of each mutant in a separate process."""

from __future__ import annotations

import hashlib
import multiprocessing
import os
import resource
import signal
import traceback
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess

from derive.workers import stopped

KILLED, SURVIVED = "killed", "survived"

TRIAL_SECONDS = 900  # of processor time for each process of a trial; a mutant that exceeds it counts as killed


@dataclass(frozen=True, slots=True)
class Verdict:
    """Result of a trial: killed or survived; ``by`` begins with the stage that killed the mutant."""

    kind: str
    by: str = ""


@dataclass(frozen=True, slots=True)
class Mutant:
    """Change at one place: its operator, and the function that tries it."""

    place: str
    operator: str
    change: str
    trial: Callable[[], Verdict]

    def __str__(self) -> str:
        return f"{self.place}: {self.operator}: {self.change}"


Room = Callable[[], Iterable[Mutant]]
"""Function that yields the unchanged tree first, which must survive, then every mutant."""


def sampled(mutants: Iterable[Mutant], count: int, seed: int) -> list[Mutant]:
    """Draw mutants by a hash of their text, so that adding a mutant hardly changes the sample."""

    def rank(mutant: Mutant) -> bytes:
        return hashlib.sha256(f"{seed}|{mutant}".encode()).digest()

    return sorted(mutants, key=rank)[:count]


def tried(mutants: Sequence[Mutant], jobs: int, limit: int = TRIAL_SECONDS) -> Iterator[Verdict]:
    """Yield the verdicts in the order of mutants; each trial runs in a forked process."""
    waiting, verdicts = deque(enumerate(mutants)), dict[int, Verdict]()
    running: dict[Connection, tuple[int, BaseProcess]] = {}
    for place in range(len(mutants)):
        while place not in verdicts:
            while waiting and len(running) < jobs:
                index, mutant = waiting.popleft()
                receiver, process = _started(mutant, limit)
                running[receiver] = index, process
            ready = wait(list(running))
            for receiver in [each for each in running if each in ready]:
                index, process = running.pop(receiver)
                verdicts[index] = _ended(receiver, process)
        yield verdicts[place]


def _started(mutant: Mutant, limit: int) -> tuple[Connection, BaseProcess]:
    context = multiprocessing.get_context("fork")
    receiver, sender = context.Pipe(duplex=False)
    process = context.Process(target=_run, args=(mutant, sender, limit))
    process.start()
    sender.close()
    return receiver, process


def _run(mutant: Mutant, sender: Connection, limit: int) -> None:
    os.setpgid(0, 0)
    resource.setrlimit(resource.RLIMIT_CPU, (limit, resource.getrlimit(resource.RLIMIT_CPU)[1]))
    try:
        verdict = mutant.trial()
    except BaseException:
        verdict = Verdict(KILLED, f"exception {traceback.format_exc().splitlines()[-1]}")
    sender.send(verdict)


def _ended(receiver: Connection, process: BaseProcess) -> Verdict:
    """Return the verdict of a trial's process, and kill its process group."""
    verdict = None
    with suppress(EOFError):
        verdict = receiver.recv()
    with suppress(ProcessLookupError, PermissionError):
        os.killpg(process.pid or 0, signal.SIGKILL)
    process.join()
    return verdict or Verdict(KILLED, "time limit" if stopped(process.exitcode) else "crash")
