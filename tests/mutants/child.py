"""Jobs in forked processes: isolated, limited in processor time and wall clock, several at once."""

from __future__ import annotations

import gc
import multiprocessing
import os
import pickle
import resource
import signal
import sys
import tempfile
import time
import traceback
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import ExitStack, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

POLL = 0.005
MEMORY = 8 << 30
WAITING = 20
"""Wall clock allowed for each second of processor time: other processes may be running."""


@dataclass(frozen=True, slots=True)
class Outcome:
    """What a job returned, or the text of its error; ``how`` is done, failed, timeout or crashed.

    ``seconds`` are of processor time, those of its children included.
    """

    how: str
    value: Any
    seconds: float


class Child:
    """A job that runs in a process of its own, in silence.

    Parameters
    ----------
    job : callable
        Whose value can be pickled.
    limit : float, optional
        Seconds of processor time.
    """

    def __init__(self, job: Callable[[], Any], limit: float | None = None) -> None:
        handle, self._answer = tempfile.mkstemp(prefix="mutant-")
        os.close(handle)
        self._deadline = time.monotonic() + WAITING * limit if limit else None
        self._pid = os.fork()
        if not self._pid:
            self._run(job, limit)

    def _run(self, job: Callable[[], Any], limit: float | None) -> None:
        os.setpgid(0, 0)
        gc.freeze()  # what was imported before need not be searched for garbage
        nothing = os.open(os.devnull, os.O_RDWR)
        for stream in (0, 1, 2):
            os.dup2(nothing, stream)
        if limit:
            resource.setrlimit(resource.RLIMIT_CPU, (int(limit) + 1, int(limit) + 5))
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        try:
            answer: tuple[str, Any] = ("done", job())
        except BaseException:
            answer = ("failed", traceback.format_exc())
        with suppress(BaseException):
            Path(self._answer).write_bytes(pickle.dumps(answer))
        os._exit(0)

    def outcome(self) -> Outcome | None:
        """What became of it; None while it runs."""
        late = self._deadline is not None and time.monotonic() > self._deadline
        if late:
            self.stop()
        pid, status, usage = os.wait4(self._pid, 0 if late else os.WNOHANG)
        if not pid:
            return None
        self._sweep()
        answer = Path(self._answer)
        written = answer.read_bytes()
        answer.unlink()
        seconds = usage.ru_utime + usage.ru_stime
        if late or (os.WIFSIGNALED(status) and os.WTERMSIG(status) in (signal.SIGXCPU, signal.SIGKILL)):
            return Outcome("timeout", None, seconds)
        if os.WIFSIGNALED(status) or not written:
            return Outcome("crashed", status, seconds)
        how, value = pickle.loads(written)
        return Outcome(how, value, seconds)

    def wait(self, wanted: Callable[[], bool]) -> Outcome:
        """What became of it; this process ends as soon as nobody wants to know."""
        try:
            while (outcome := self.outcome()) is None:
                if not wanted():
                    sys.exit()
                time.sleep(POLL)
        except SystemExit:
            self.stop()
            raise
        return outcome

    def stop(self) -> None:
        """End it, and whatever it has started."""
        with suppress(ProcessLookupError):
            os.kill(self._pid, signal.SIGKILL)
        self._sweep()

    def _sweep(self) -> None:
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(self._pid, signal.SIGKILL)


def isolated(job: Callable[[], Any]) -> Any:
    """The value of a job that ran in a process of its own."""
    ((_, outcome),) = outcomes([lambda _: (ExitStack(), Child(job))], [None])
    if outcome.how != "done":
        raise RuntimeError(f"{outcome.how}: {outcome.value}")
    return outcome.value


T = TypeVar("T")
Begin = Callable[[T], tuple[ExitStack, Child]]
"""Given a slot: begins a job in it, and says what is to be closed when the job has ended."""


def shared(slots: Sequence[T], warm: Callable[[T], None], jobs: Sequence[Begin[T]]) -> Iterator[tuple[int, Outcome]]:
    """Run jobs, each forked from the process of a slot, which has warmed up; yield number and outcome as they end."""
    fork, parent = multiprocessing.get_context("fork"), os.getpid()
    following, found = fork.Value("i", 0), fork.SimpleQueue()

    def work(slot: T) -> None:
        signal.signal(signal.SIGTERM, lambda *_: sys.exit())
        warm(slot)
        while True:
            with following.get_lock():
                number, following.value = following.value, following.value + 1
            if number >= len(jobs):
                return
            entered, child = jobs[number](slot)
            with entered:
                outcome = child.wait(lambda: os.getppid() == parent)
            found.put((number, outcome))

    workers = [fork.Process(target=work, args=(slot,), daemon=True) for slot in slots]
    for worker in workers:
        worker.start()
    try:
        while any(worker.is_alive() for worker in workers) or not found.empty():
            if found.empty():
                time.sleep(POLL)
            else:
                yield found.get()
        if any(worker.exitcode for worker in workers):
            raise RuntimeError(f"a process that was to run trials ended: {[worker.exitcode for worker in workers]}")
    finally:
        for worker in workers:
            worker.terminate()


Start = Callable[[Any], tuple[ExitStack, Child]]
"""Given a slot: begins a job in it, and says what is to be closed when the job has ended."""


def outcomes(jobs: Iterable[Start], slots: list[Any]) -> Iterator[tuple[int, Outcome]]:
    """Run jobs, one in each slot at a time; yield number and outcome of each as it ends."""
    waiting = enumerate(jobs)
    running: dict[int, tuple[int, ExitStack, Child]] = {}
    try:
        while True:
            for index in range(len(slots)):
                if index not in running and (following := next(waiting, None)) is not None:
                    number, start = following
                    running[index] = (number, *start(slots[index]))
            if not running:
                return
            ended = [(index, found) for index, job in running.items() if (found := job[2].outcome()) is not None]
            for index, found in ended:
                number, entered, _ = running.pop(index)
                entered.close()
                yield number, found
            if not ended:
                time.sleep(POLL)
    finally:
        for _, entered, child in running.values():
            child.stop()
            entered.close()
