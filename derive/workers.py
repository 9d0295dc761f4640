"""Worker processes, which end with the main process.

This module loads only the standard library: a worker must be ready to end before it loads other libraries.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import tempfile
import threading
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing.connection import Connection
from typing import TypeVar

PROCESSES_MAX = 61
"""Largest number of processes in a pool on Windows."""

Item = TypeVar("Item")
Result = TypeVar("Result")


def cores() -> int:
    """Return the number of processor cores that this process may use."""
    found = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    return min(found or 1, PROCESSES_MAX)


def each(function: Callable[[Item], Result], items: Iterable[Item], processes: int) -> Iterator[Result]:
    """Yield the results for items in order; other processes begin with each item as soon as it is available.

    With one process, all runs in the main process, item by item. If several calls fail, the first error is raised.
    """
    if processes == 1:
        yield from map(function, items)
        return
    with workers(processes) as pool:
        for begun in [pool.submit(function, item) for item in items]:
            yield begun.result()


@contextmanager
def workers(count: int) -> Iterator[ProcessPoolExecutor]:
    """Provide a pool of processes that end with the block, even if this process fails, is interrupted or is killed.

    Processes are spawned, not forked: a fork may copy a lock held by a thread of JAX or of a progress bar. The death
    of a worker raises ChildProcessError.
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
            held.close()  # otherwise the pool waits for running calls
            pool.shutdown(cancel_futures=True)
            raise


def _begin(watched: Connection, scratch: str) -> None:
    """Prepare a worker to end at any moment; the main process removes its temporary folder."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # a terminal signals all processes; the main process ends the workers
    tempfile.tempdir = scratch
    threading.Thread(target=_end_with, args=(watched,), daemon=True).start()


def _end_with(watched: Connection) -> None:
    watched.poll(None)  # wait until the main process closes its end or dies; it sends nothing
    os._exit(1)
