"""Processes that work beside this one, and end with it.

Only the standard library is loaded here: a process must be ready to end before it loads the libraries of its work.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import tempfile
import threading
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing.connection import Connection
from typing import Any, TypeVar

PROCESSES_MAX = 61
"""Processes that a pool can have on Windows."""

Result = TypeVar("Result")


def cores() -> int:
    """Return the number of processor cores that this process may use."""
    if sys.version_info >= (3, 13):
        found = os.process_cpu_count()
    else:
        found = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    return min(found or 1, PROCESSES_MAX)


def each(
    function: Callable[..., Result], calls: Iterable[tuple[Any, ...]], processes: int
) -> Iterator[Result]:
    """Yield the results of calls in their order, computed in other processes as soon as arguments are there.

    With one process they are computed here, one by one. Of several calls that fail the first is told.
    """
    if processes == 1:
        for arguments in calls:
            yield function(*arguments)
        return
    with workers(processes) as pool:
        for begun in [pool.submit(function, *arguments) for arguments in calls]:
            yield begun.result()


@contextmanager
def workers(count: int) -> Iterator[ProcessPoolExecutor]:
    """Provide a pool of processes, none of which is left however the block ends: done, failed, interrupted or killed.

    They are spawned, not forked: a fork may copy a lock that a thread holds, such as JAX's or a progress bar's.

    Raises
    ------
    ChildProcessError
        If one of them dies.
    """
    context = multiprocessing.get_context("spawn")
    watched, held = context.Pipe(duplex=False)
    with (
        tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as scratch,
        watched,
        held,
        ProcessPoolExecutor(count, context, _begin, (watched, scratch)) as pool,
    ):
        try:
            yield pool
        except BrokenProcessPool as error:
            raise ChildProcessError("a worker process died, perhaps for want of memory; nothing is written") from error
        except BaseException:
            held.close()  # a pool would wait for calls that have begun
            pool.shutdown(cancel_futures=True)
            raise


def _begin(watched: Connection, scratch: str) -> None:
    """Prepare a process to end at any moment; the first process removes its temporary folder."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # a terminal sends it to all; the first process ends the others
    tempfile.tempdir = scratch
    threading.Thread(target=_end_with, args=(watched,), daemon=True).start()


def _end_with(watched: Connection) -> None:
    watched.poll(None)  # nothing is sent: the other end closes, by its process or with it
    os._exit(1)
