"""Processes that work beside this one, and end when what they were started for does.

It loads the standard library only: a process has to be ready for its end before it loads what its work needs.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import tempfile
import threading
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing.connection import Connection

MOST = 61
"""Processes that a pool can have on Windows; more would not be busy elsewhere either."""


def cores() -> int:
    """How many processor cores this process may use."""
    if sys.version_info >= (3, 13):
        found = os.process_cpu_count()
    else:
        found = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    return min(found or 1, MOST)


@contextmanager
def workers(count: int) -> Iterator[ProcessPoolExecutor]:
    """A pool of processes, none of which is left however the block ends: done, failed, interrupted or killed.

    They are spawned, not forked: what a fork copies may just be locked by a thread, such as JAX's or a progress bar's.

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
    """Be ready to end at any moment: what is left in temporary folders, the first process removes."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # a terminal sends it to all of them: the first one sees to the others
    tempfile.tempdir = scratch
    threading.Thread(target=_end_with, args=(watched,), daemon=True).start()


def _end_with(watched: Connection) -> None:
    watched.poll(None)  # nothing is ever sent: the other end is closed, by its process or with it
    os._exit(1)
