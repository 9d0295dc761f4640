"""Compiled functions beneath the kernels: their build, their times beside a C loop, and with threads.

`maps` measures them beside libraries.
"""

from __future__ import annotations

import importlib
import tempfile
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cache, partial
from pathlib import Path
from statistics import median
from time import perf_counter

import numpy as np

from benchmarks.forms import c_form
from benchmarks.peers import Poses
from benchmarks.times import ORDERS, Key, Timed, timed
from benchmarks.timing import Call
from derive.maps import Cayley, family
from tests.support.native import build, found

PART, THREADED = "given", "threads"
CHARTS = (*map(Cayley, ORDERS), family("exponential"))
SIZES = (10_000, 1_000_000)
OURS, C_LOOP = "compiled", "C loop"
FUNCTIONS = {
    "pose": ("v",), "quaternion": ("v",), "tangent": ("v",), "rate": ("v", "w"), "from_pose": ("T",),
    "compose": ("w", "v"),
}  # fmt: skip
"""Functions that are compared with a C loop, with their arguments as names of attributes of `Poses`."""

COUNT = 10_000
THREADS = 2
"""Numbers of poses and of threads."""


def measure(package: str, sizes: Sequence[int] = SIZES, orders: Sequence[int] = ORDERS) -> Iterator[Timed]:
    """Yield times with a given result, components last, beside a C loop over the same arrays."""
    cases = [(size, order, function) for size in sizes for order in orders for function in FUNCTIONS]
    yield from timed(PART, ((function, size, calls(package, order, function, size)) for size, order, function in cases))
    for order in orders:
        yield from threaded(package, order)


def calls(package: str, order: int, function: str, size: int) -> dict[Key, Call]:
    """Return the call of a compiled function and that of a C loop, which needs a compiler."""
    chart = f"cayley{order}"
    kernel = getattr(importlib.import_module(f"{package}.{chart}"), function)
    poses, names = Poses.draw(importlib.import_module(f"dualcay.{chart}"), size), FUNCTIONS[function]
    given = [getattr(poses, name) for name in names]
    made, form = np.empty_like(kernel(*given)), c_form(order)
    found: dict[Key, Call] = {(OURS, chart, f"{chart}.{function}({', '.join(names)}, out=out)"): partial(
        kernel, *given, out=made
    )}  # fmt: skip
    if form is not None:
        flat = [a.reshape(size, -1) for a in given]
        loop = partial(form.call, function, *flat, out=np.empty_like(made).reshape(size, -1), layout="aos")
        found[C_LOOP, chart, f"for (j = 0; j < n; ++j) dualcay_{chart}_{function}(…)"] = loop
    return found


def threaded(package: str, order: int, rounds: int = 9, repeats: int = 200) -> Iterator[Timed]:
    """Yield wall-clock times per pose of one thread and of parallel ones: calls release the GIL."""
    native = importlib.import_module(f"{package}.cayley{order}")
    poses = [Poses.draw(native, COUNT).v for _ in range(THREADS)]
    results = [native.pose(v) for v in poses]

    def work(index: int) -> None:
        for _ in range(repeats):
            native.pose(poses[index], out=results[index])

    def seconds(count: int) -> float:
        threads = [threading.Thread(target=work, args=(index,)) for index in range(count)]
        start = perf_counter()
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        return (perf_counter() - start) / count

    times = [(seconds(1), seconds(THREADS)) for _ in range(rounds)]
    one, ratio = median(first for first, _ in times), median(first / both for first, both in times)
    for count, spent in ((1, one), (THREADS, one / ratio)):
        ns = float(f"{spent / repeats / COUNT * 1e9:.4g}")
        text = f"cayley{order}.pose(v, out=out)"
        yield Timed(THREADED, f"threads: {count}", f"cayley{order}", "pose", text, {COUNT: ns})


@contextmanager
def compiled() -> Iterator[str]:
    """Yield the name of a package of kernels with compiled functions of the charts.

    Raises
    ------
    AssertionError
        If the functions could not be built; the message is the build's output.
    """
    with found("dualcay_native_measured", Path(_built().name, "site")) as package:
        yield package


@cache
def _built() -> tempfile.TemporaryDirectory[str]:
    """Build the functions once, in a folder that is removed when the process ends."""
    folder = tempfile.TemporaryDirectory(prefix="dualcay-native-")
    build(Path(folder.name), CHARTS)
    return folder
