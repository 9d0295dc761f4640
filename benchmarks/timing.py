"""Processor time of calls that take turns in one process, on one core except for JAX.

Other processes hardly affect processor time. Times depend on the machine. Ratios on different machines agree within
some 15 %; ratios of two forms of one program (`paired_ratio`) agree within a few hundredths. Commands that measure
begin with `fix_allocator`, for new pages of large results may cost more than the computation.
"""

from __future__ import annotations

import os
import statistics
import sys
from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from contextlib import contextmanager, nullcontext
from time import process_time
from typing import TypeVar

Call = Callable[[], object]
Key = TypeVar("Key", bound=Hashable)

ROUNDS = 9
SECONDS = 0.01
"""Seconds that a call is repeated in each round."""

LARGE, ROUNDS_OF_LARGE = 1_000_000, 5
"""Number of poses from which fewer rounds are timed, and the number of these rounds."""

ALLOCATOR = {"MALLOC_MMAP_THRESHOLD_": "1073741824", "MALLOC_TRIM_THRESHOLD_": "4294967296"}
"""Thresholds of malloc with which freed memory stays with the process; glibc reads them when a process starts."""


def fix_allocator() -> None:
    """Start this command again with the thresholds of `ALLOCATOR`, unless they are set."""
    if not allocator_is_fixed():
        os.execve(sys.executable, [sys.executable, *sys.orig_argv[1:]], os.environ | ALLOCATOR)


def allocator_is_fixed() -> bool:
    """Return whether this process was started with the thresholds."""
    return ALLOCATOR.items() <= os.environ.items()


def measured(calls: Mapping[Key, Call], size: int, kept: bool = True) -> dict[Key, float]:
    """Return median nanoseconds per pose by name; ``kept`` keeps the process on one core."""
    found = medians([*calls.values()], ROUNDS if size < LARGE else ROUNDS_OF_LARGE, kept)
    return {name: seconds / size * 1e9 for name, seconds in zip(calls, found, strict=True)}


def medians(calls: Sequence[Call], count: int = ROUNDS, kept: bool = True) -> list[float]:
    """Return median seconds of each call; ``kept=False`` allows all cores, for libraries with their own threads."""
    with one_core() if kept else nullcontext():
        return [statistics.median(times) for times in _rounds(calls, count, SECONDS)]


def paired_ratio(former: Call, present: Call, count: int = ROUNDS, seconds: float = SECONDS) -> float:
    """Return the median of present over former time; both times are from the same round, so that drift cancels."""
    before, after = rounds((former, present), count, seconds)
    return statistics.median(now / past for past, now in zip(before, after, strict=True))


def rounds(calls: Sequence[Call], count: int = ROUNDS, seconds: float = SECONDS) -> list[list[float]]:
    """Return seconds of each call in every round; every second round runs the calls in reverse order."""
    with one_core():
        return _rounds(calls, count, seconds)


def _rounds(calls: Sequence[Call], count: int, seconds: float) -> list[list[float]]:
    lines = [(call, _repeats(call, seconds), list[float]()) for call in calls]
    for i in range(count):
        for call, repeats, times in reversed(lines) if i % 2 else lines:
            times.append(_seconds(call, repeats))
    return [times for _, _, times in lines]


@contextmanager
def one_core() -> Iterator[None]:
    """Keep the process on one core, if the system supports it; moving to another core would lose cached data."""
    if not hasattr(os, "sched_setaffinity"):
        yield
        return
    cores = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {max(cores)})
    try:
        yield
    finally:
        os.sched_setaffinity(0, cores)


def _repeats(call: Call, seconds: float) -> int:
    """Return the number of repeats of a call in a round."""
    repeats, spent = 1, 0.0
    while spent < seconds / 4:
        spent = _seconds(call, repeats) * repeats
        reached, repeats = repeats, 2 * repeats
    return max(1, int(reached * seconds / spent))


def _seconds(call: Call, repeats: int) -> float:
    """Return the mean seconds of one call."""
    start = process_time()
    for _ in range(repeats):
        call()
    return (process_time() - start) / repeats


def markdown(title: str, head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Return a section that consists of a table."""
    return f"## {title}\n\n{table(head, rows)}\n"


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Return a table in Markdown."""
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join([*lines, *("| " + " | ".join(row) + " |" for row in rows)])
