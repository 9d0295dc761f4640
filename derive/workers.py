"""Temporary folders, worker processes that end with the main process, and limits of processor time.

This module loads only the standard library: a worker must be ready to end before it loads other libraries.
"""

from __future__ import annotations

import multiprocessing
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager, suppress
from functools import partial
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any, TypeVar

NEW, PREFIX = ".dualcay-new-", ".dualcay-scratch-"
"""Beginnings of the names of folders, before and after their process has locked them."""


@contextmanager
def scratch() -> Iterator[Path]:
    """Provide an empty temporary folder; first remove those of processes that were killed.

    Its process locks the folder. The system drops the lock when the process ends, however it ends. Windows has no such
    lock: there the folder of a killed process stays.
    """
    if sys.platform == "win32":
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as name:
            yield Path(name)
        return
    import fcntl

    _sweep()
    new = Path(tempfile.mkdtemp(prefix=NEW))
    handle = os.open(new, os.O_RDONLY)
    with suppress(OSError):  # a file system without locks: nothing there is swept
        fcntl.flock(handle, fcntl.LOCK_EX)
    folder = new.rename(new.with_name(new.name.replace(NEW, PREFIX)))
    try:
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)
        os.close(handle)


def _sweep() -> None:
    if sys.platform != "win32":
        import fcntl

        for folder in Path(tempfile.gettempdir()).glob(f"{PREFIX}*"):
            with suppress(OSError):  # its process lives, or it is another user's
                handle = os.open(folder, os.O_RDONLY | os.O_NOFOLLOW)
                try:
                    fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
                    shutil.rmtree(folder)
                finally:
                    os.close(handle)


ALONE = sys.platform == "emscripten"
"""Whether the system starts neither threads nor processes, as in a browser."""

PROCESSES_MAX = 61
"""Largest number of processes in a pool on Windows."""

Item = TypeVar("Item")
Result = TypeVar("Result")


def cores() -> int:
    """Return the number of processor cores that this process may use; one if it is `ALONE`."""
    if ALONE:
        return 1
    found = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    return min(found or 1, PROCESSES_MAX)


@contextmanager
def mapping(
    function: Callable[[Item], Result], processes: int
) -> Iterator[Callable[[Iterable[Item]], Iterator[Result]]]:
    """Provide a map of a function over items, in order, whose calls run in this and in further processes.

    The other processes load the function at once, and begin with each item as soon as it is available. When all are,
    this process takes part, from the last item backwards. With one process, all runs here, item by item. If several
    calls fail, the first error is raised.
    """
    if processes == 1:
        yield partial(map, function)
        return
    with ThreadPoolExecutor(processes - 1) as threads, workers(processes - 1) as pool:
        for _ in range(processes - 1):
            pool.submit(callable, function)
        yield partial(_shared, function, pool, threads)


def _shared(
    function: Callable[[Item], Result], pool: Executor, threads: Executor, items: Iterable[Item]
) -> Iterator[Result]:
    """Yield the results for items in order; each thread waits for one worker, as a pool reserves calls in advance."""
    waiting, found = deque[tuple[Future[Result], Item]](), deque[Future[Result]]()

    def run(take: Callable[[], tuple[Future[Result], Item]], call: Callable[[Item], Result]) -> None:
        with suppress(IndexError):  # no item is left
            future, item = take()
            try:
                future.set_result(call(item))
            except Exception as error:
                future.set_exception(error)

    for item in items:
        found.append(Future())
        waiting.append((found[-1], item))
        threads.submit(run, waiting.popleft, lambda item: pool.submit(function, item).result())
    while found:
        run(waiting.pop, function)
        while found and (found[0].done() or not waiting):
            yield found.popleft().result()


@contextmanager
def workers(count: int) -> Iterator[ProcessPoolExecutor]:
    """Provide a pool of processes that end with the block, even if this process fails, is interrupted or is killed.

    Processes are spawned, not forked: a fork may copy a lock held by a thread of JAX or of a progress bar. The death
    of a worker raises ChildProcessError.
    """
    context = multiprocessing.get_context("spawn")
    watched, held = context.Pipe(duplex=False)
    with (
        scratch() as folder,
        watched,
        held,
        ProcessPoolExecutor(count, context, _begin, (watched, folder)) as pool,
    ):
        try:
            yield pool
        except BrokenProcessPool as error:
            raise ChildProcessError("a worker process died, perhaps for want of memory; nothing is written") from error
        except BaseException:
            held.close()  # otherwise the pool waits for running calls
            pool.shutdown(cancel_futures=True)
            raise


def _begin(watched: Connection, folder: Path) -> None:
    """Prepare a worker to end at any moment; the main process removes its temporary folder."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # a terminal signals all processes; the main process ends the workers
    tempfile.tempdir = str(folder)
    threading.Thread(target=_end_with, args=(watched,), daemon=True).start()


def _end_with(watched: Connection) -> None:
    watched.poll(None)  # wait until the main process closes its end or dies; it sends nothing
    os._exit(1)


# --- limits of processor time -----------------------------------------------------------------------------------------

SECONDS_MAX = 1e9
"""Longest limit that timers of operating systems take."""


class SlowError(Exception):
    """Error of a program that was stopped at its limit of processor time."""


def limit(seconds: float) -> None:
    """End this process after further seconds of its processor time, even inside a library; 0 lifts the limit.

    Time in which it sleeps, or in which other processes run, does not count. Windows has no such limit.
    """
    if sys.platform != "win32":
        signal.setitimer(signal.ITIMER_PROF, min(seconds, SECONDS_MAX))


def stopped(returncode: int | None) -> bool:
    """Tell whether a process ended at its limit of processor time."""
    return sys.platform != "win32" and returncode in (-signal.SIGPROF, -signal.SIGXCPU)


def run(command: Sequence[str], seconds: int, **options: Any) -> subprocess.CompletedProcess[str]:
    """Run a program and return what it prints; raise SlowError if it takes more seconds of processor time.

    Each process that the program begins has the same limit. Windows has no such limit.
    """
    started = list(command)
    if sys.platform != "win32":
        started = ["sh", "-c", f'ulimit -c 0; ulimit -S -t {seconds}; exec "$@"', "sh", *command]
    done = subprocess.run(started, capture_output=True, text=True, check=False, **options)
    if stopped(done.returncode):
        raise SlowError(f"{Path(command[0]).name} was stopped after {seconds} s of processor time")
    return done
