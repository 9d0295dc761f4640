"""Gates: the least ratios of others' times to ours, computed from the measured times; the page lists missed ones."""

from __future__ import annotations

import importlib
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from benchmarks import kernels, native, slower
from benchmarks.maps import CAYLEY, COMPILED, FORMS, FUNCTIONS, NUMPY, PART, SMALL, SMALL_SIZES
from benchmarks.times import Data, label
from benchmarks.timing import LARGE

GATED = (1, 10_000)
"""Numbers of poses at which NumPy kernels are tested against SciPy."""

OF_ALGEBRAIC = {
    "pose": (10, 5), "quaternion": (10, 20), "from_pose": (10, 7), "from_quaternion": (10, 20), "compose": (10, 15),
}  # fmt: skip
OF_EXPONENTIAL = {"pose": (6, 3), "from_pose": (6, 3)}
"""Least ratios of SciPy's time to ours, on one pose and on 10^4, by function."""

FORWARD = ("pose", "quaternion")
"""Functions with gates at every order; inverse maps have gates up to n = 2, since beyond they need an arc tangent."""

OF_SMALL_BATCH = (2, 1.3)
"""Least ratios for `pose` of a Cayley map and of the exponential, for the small batches that `maps` measures."""

FEW = 1_000
OF_COMPILED = {"SciPy": (20, 12), "pytransform3d": (10, 6)}
"""Least ratios for compiled functions, for up to `FEW` poses and for more."""

ALONE = 1_200.0
"""Largest time of a compiled call on one pose, in nanoseconds."""


Who = tuple[str, str]
"""Type of who makes a call, with the chart."""


@dataclass(frozen=True, slots=True)
class Gate:
    """Ratio of a peer's time to ours, and its required value `least`; a value below 1 allows us to be slower.

    ``why`` is the kind of reason where it is missed. No program can exceed the ratio `largest`: the peer's time over
    the time of copying the result.
    """

    what: str
    ratio: float
    least: float
    why: str = ""
    largest: float = math.inf

    @property
    def met(self) -> bool:
        return self.ratio >= self.least

    def row(self) -> tuple[str, ...]:
        most = "" if self.largest >= self.least else f"; of a copy {times(self.largest)}"
        return self.what, times(self.ratio), times(self.least), f"{self.why}{most}"


def times(ratio: float) -> str:
    """Return a ratio as text; 1/3 means that ours take three times as long."""
    return f"{ratio:.3g} x" if ratio >= 1 else f"1/{1 / ratio:.3g} x"


def every(data: Data) -> list[Gate]:
    """Return all gates whose times were measured, missed ones first."""
    parts = (of_numpy, of_compiled, of_rows, of_given, of_derivatives)
    return sorted((gate for part in parts for gate in part(data)), key=lambda gate: gate.met)


def _gates(data: Data, part: str, ours: Who, peer: Who, least: Mapping[tuple[str, int], float]) -> Iterator[Gate]:
    """Yield the gates for functions and numbers of poses with both times, each by who makes the call and chart."""
    calls = ours, peer, (kernels.COPY, ours[1])
    for (function, size), required in least.items():
        mine, other, copy = (data.first(part, by, function, chart) for by, chart in calls)
        if size in mine.ns and size in other.ns:
            form = {PART: "" if ours[0] == NUMPY else f"{ours[0]}, "}.get(part, f"{part}, ")
            what = f"{function}, {form}{label(ours[1])}, N = {size}: {peer[0]}"
            found, largest = (other.ns[size] / of.ns.get(size, 1e-300) for of in (mine, copy))
            yield Gate(what, found, required, slower.why(mine, other, size), largest)


def of_numpy(data: Data) -> Iterator[Gate]:
    for chart in FORMS[NUMPY]:
        exponential = chart == "exponential"
        known = OF_EXPONENTIAL if exponential else OF_ALGEBRAIC
        inverse = exponential or importlib.import_module(f"dualcay.{chart}").ORDER <= 2
        least = {
            (function, size): value for function, values in known.items() if inverse or function in FORWARD
            for size, value in zip(GATED, values, strict=True)
        }  # fmt: skip
        yield from _gates(data, PART, (NUMPY, chart), ("SciPy", ""), least)
        further = {} if exponential else {("pose", 10_000): 3}
        yield from _gates(data, PART, (NUMPY, chart), ("pytransform3d", ""), further)
        small = {("pose", size): OF_SMALL_BATCH[exponential] for size in SMALL_SIZES}
        for peer in ("SciPy", "pytransform3d") if exponential or chart in CAYLEY else ():
            yield from _gates(data, SMALL, (NUMPY, chart), (peer, ""), small)


def of_compiled(data: Data) -> Iterator[Gate]:
    for chart in CAYLEY:
        sizes = [*data.ns(PART, COMPILED, "pose", chart)]
        for peer, least in OF_COMPILED.items():
            compared = ("pose",) if peer == "pytransform3d" else ("pose", "quaternion", "from_pose", "compose")
            wanted = {(function, size): least[size > FEW] for size in sizes for function in compared}
            yield from _gates(data, PART, (COMPILED, chart), (peer, ""), wanted)
        for function in FUNCTIONS:
            for ns in data.find(PART, COMPILED, function, chart):
                if 1 in ns.ns:
                    what = f"{function}, compiled, {label(chart)}, N = 1: {ALONE / 1e3:g} µs"
                    yield Gate(what, ALONE / ns.ns[1], 1, slower.ONE)


def of_rows(data: Data) -> Iterator[Gate]:
    for timed in data.find(kernels.ON_ROWS, NUMPY):
        forms = [(by, timed.chart) for by in (kernels.LAMBDIFY, kernels.FILLED, kernels.C_FORM)]
        ours, filled = (NUMPY, timed.chart), {(timed.function, size): 1.0 for size in timed.ns}
        gated = {(timed.function, 10_000): 1.3, (timed.function, LARGE): 2.5}, filled, {(timed.function, LARGE): 1 / 8}
        for form, least in zip(forms, gated, strict=True):
            yield from _gates(data, kernels.ON_ROWS, ours, form, least)


def of_given(data: Data) -> Iterator[Gate]:
    for timed in data.find(native.PART, native.OURS):
        least = {(timed.function, size): 1 / 1.15 for size in timed.ns}
        ours, loop = (native.OURS, timed.chart), (native.C_LOOP, timed.chart)
        yield from _gates(data, native.PART, ours, loop, least)
    for chart in CAYLEY:
        one, both = (f"threads: {count}" for count in (1, native.THREADS))
        yield from _gates(data, native.THREADED, (both, chart), (one, chart), {("pose", native.COUNT): 1.8})


def of_derivatives(data: Data) -> Iterator[Gate]:
    for timed in data.find(kernels.DERIVATIVES, NUMPY):
        for peer in (kernels.CALLED, kernels.JITTED):
            ours, other = (NUMPY, timed.chart), (peer, timed.chart)
            yield from _gates(data, kernels.DERIVATIVES, ours, other, {(timed.function, 1): 20})
