"""Where others are faster than our kernels, and gates that are missed, with the reason of each."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from benchmarks import kernels
from benchmarks.maps import FORMS, NUMPY, PART, SMALL
from benchmarks.peers import LIBRARIES, looped
from benchmarks.times import Data, Timed
from benchmarks.timing import LARGE

MARGIN = 1.15
"""Least ratio for which another counts as faster; ratios on other machines vary by some 15 %."""

KEPT, ONE, BATCH, WRITTEN, COMPILED_BY_JAX, ARITHMETIC, MEMORY = (
    "products of kept transforms", "one pose at a time", "batches in NumPy", "rows, beside SymPy",
    "derivatives, beside JAX", "large batches", "memory and cores",
)  # fmt: skip
REASONS = {
    KEPT: "a kept transform is multiplied without a logarithm; multiply matrices of `pose` to do the same",
    ONE: "the other is C++ or compiled code without shapes and options; our kernels run on Python floats",
    BATCH: "a batch takes some hundred NumPy calls of 0.4 µs each, which compiled functions save",
    WRITTEN: "SymPy's function returns zeros and equal components as references; ours writes every row of one array",
    COMPILED_BY_JAX: "a compiled call costs 5 µs, as ours do",
    ARITHMETIC: "the other has fewer operations, or more of them at once in a register",
    MEMORY: "both wait for memory, or share the cores with others",
}


@dataclass(frozen=True, slots=True)
class Faster:
    """Call of another that takes less time than ours for some numbers of poses, with the ratios of times."""

    ours: Timed
    peer: Timed
    ratios: dict[int, float]
    why: str

    def line(self) -> str:
        """Return a sentence with the numbers of poses."""
        where = ", ".join(f"N = {size:,} ({ratio:.2g} x)" for size, ratio in self.ratios.items())
        return f"- {self.peer.by}, `{self.peer.call}`, is faster than {self.ours.by}, `{self.ours.call}`, at {where}."


def why(ours: Timed, peer: Timed, size: int) -> str:
    """Return the kind of reason for which the other may be faster, or a gate be missed."""
    if peer.part == kernels.ON_ROWS:
        return MEMORY if size >= LARGE and ours.ns[size] < peer.ns[size] else WRITTEN
    if peer.part not in (PART, SMALL):
        return COMPILED_BY_JAX if peer.part == kernels.DERIVATIVES else MEMORY
    if peer.call in LIBRARIES[peer.by].texts[peer.function][1:]:
        return KEPT
    if size == 1 or LIBRARIES[peer.by].manner is looped:
        return ONE
    return BATCH if ours.by == NUMPY and size <= 1_000 else ARITHMETIC


def every(data: Data) -> list[Faster]:
    """Return all calls of others that are faster than ours, by reason."""
    found = [faster for ours, peer in _pairs(data) for faster in _compared(ours, peer)]
    return sorted(found, key=lambda faster: list(REASONS).index(faster.why))


def _pairs(data: Data) -> Iterator[tuple[Timed, Timed]]:
    """Yield each of our calls with each call of another for the same function."""
    for ours in data.times:
        others = data.find(ours.part, "", ours.function)
        if ours.part in (PART, SMALL) and ours.by in FORMS:
            yield from ((ours, peer) for peer in others if peer.by in LIBRARIES)
        elif ours.part in (kernels.ON_ROWS, kernels.DERIVATIVES) and ours.by == NUMPY:
            rivals = (kernels.LAMBDIFY, kernels.JITTED)
            yield from ((ours, peer) for peer in others if peer.by in rivals and peer.chart == ours.chart)


def _compared(ours: Timed, peer: Timed) -> Iterator[Faster]:
    found: dict[str, dict[int, float]] = {}
    for size in ours.ns.keys() & peer.ns.keys():
        ratio = ours.ns[size] / peer.ns[size]
        if ratio > MARGIN:
            found.setdefault(why(ours, peer, size), {})[size] = ratio
    yield from (Faster(ours, peer, dict(sorted(ratios.items())), kind) for kind, ratios in found.items())


def summary(data: Data) -> list[str]:
    """Return a line for each reason: where others are faster, by at most how much, and why."""
    found, lines = every(data), []
    for kind, reason in REASONS.items():
        largest: dict[str, float] = {}
        sizes = set[int]()
        for faster in (faster for faster in found if faster.why == kind):
            largest[faster.peer.by] = max(largest.get(faster.peer.by, 0), *faster.ratios.values(), 0)
            sizes |= faster.ratios.keys()
        if largest:
            worst = sorted(largest.items(), key=lambda item: -item[1])
            names = ", ".join(f"{by} {ratio:.2g} x" for by, ratio in worst)
            span = " … ".join(f"{size:,}" for size in sorted({min(sizes), max(sizes)}))
            lines.append(f"- {kind}, N = {span} (up to {names}): {reason}.")
    return lines
