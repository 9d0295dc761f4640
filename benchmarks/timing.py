"""Processor time of calls that take turns in one process, on one core except for JAX.

Other processes hardly affect processor time. Times depend on the machine. Ratios on different machines agree within
some 15 %; ratios of two forms of one program (`paired_ratio`) agree within a few hundredths.
"""

from __future__ import annotations

import os
import statistics
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, nullcontext
from time import process_time

Call = Callable[[], object]

ROUNDS = 9
SECONDS = 0.02
"""Seconds that a call is repeated in each round."""


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
    lines = [f"## {title}", "", "| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join([*lines, *("| " + " | ".join(row) + " |" for row in rows), ""])
