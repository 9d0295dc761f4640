"""Times of the compiled functions beneath the kernels, relative to libraries and to a C loop over the same arrays.

Run ``python -m benchmarks.native`` from the checkout. The package is generated and compiled first, which takes minutes.
"""

from __future__ import annotations

import importlib
import sys
import tempfile
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from functools import cache, partial
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np

from benchmarks.forms import c_form
from benchmarks.kernels import Gate, against, label, measured, per_pose
from benchmarks.peers import Poses, pytransform3d_call, scipy_call
from benchmarks.timing import Call, markdown
from derive.maps import Cayley, family
from tests.support.native import build, found

ORDERS = (2, 3)
CHARTS = (*map(Cayley, ORDERS), family("exponential"))
"""Charts with compiled functions, for this section and others."""

SIZES = (1, 10, 100, 1_000, 10_000, 1_000_000)
FUNCTIONS = {
    "pose": ("v",), "quaternion": ("v",), "tangent": ("v",), "rate": ("v", "w"), "from_pose": ("T",),
    "compose": ("w", "v"),
}  # fmt: skip
"""Measured functions, with their arguments as names of attributes of `Poses`."""

COMPARED = ("pose", "quaternion", "from_pose", "compose")
"""Functions that are compared with SciPy."""

SMALL = 1_000
LEAST = {"SciPy RigidTransform": (20, 12), "pytransform3d": (10, 6)}
"""Least ratios of a library's time to ours, for up to `SMALL` poses and for more."""

ALONE = 1.2e-6
"""Largest time of a call on one pose, in seconds."""

LOOP = 1 / 1.15
"""Least ratio of the time of a C loop to ours, beyond `SMALL` poses."""

THREADED = 10_000
THREADS, LINEAR = 2, 1.8
"""Number of threads, and least ratio of their total throughput to the throughput of one thread."""


def rows(numpy: Any, native: Any, size: int) -> Iterator[tuple[tuple[str, ...], list[Gate]]]:
    """Yield, for each function, its line of the table and its gates."""
    poses = Poses.draw(numpy, size)
    for function, names in FUNCTIONS.items():
        arguments = [getattr(poses, name) for name in names]
        made = getattr(numpy, function)(*arguments)
        compared = function in COMPARED
        times = measured({
            "ours": partial(getattr(native, function), *arguments),
            "numpy": partial(getattr(numpy, function), *arguments),
            "SciPy RigidTransform": scipy_call(function, poses) if compared else None,
            "pytransform3d": pytransform3d_call(function, poses) if function == "pose" else None,
            "given": partial(getattr(native, function), *arguments, out=np.empty_like(made)),
            "C": loop(numpy.ORDER, function, arguments, made) if size > 1 else None,
        }, size)  # fmt: skip
        where = f"{function}, n = {label(numpy)}, N = {size}"
        gates = [
            Gate(f"{where}: {peer}", times[peer] / times["ours"], least[size > SMALL])
            for peer, least in LEAST.items()
            if peer in times
        ]
        if size == 1:
            gates.append(Gate(f"{where}: {ALONE * 1e6:g} µs", ALONE / times["ours"], 1))
        if "C" in times and size > SMALL:
            gates.append(Gate(f"{where}: C loop, given result", times["C"] / times["given"], LOOP))
        peers = [against(times, peer, size) for peer in ("numpy", *LEAST)]
        given = [per_pose(times[name], size) if name in times else "–" for name in ("given", "C")]
        yield (label(numpy), function, str(size), per_pose(times["ours"], size), *peers, *given), gates


def loop(order: int, function: str, arguments: Sequence[Any], made: Any) -> Call | None:
    """Return a call of a C loop over the same arrays, pose by pose; None without a C compiler."""
    form = c_form(order)
    if form is None:
        return None
    given = [a.reshape(len(a), -1) for a in arguments]
    return partial(form.call, function, *given, out=np.empty_like(made).reshape(len(made), -1), layout="aos")


def threaded(native: Any, rounds: int = 9, repeats: int = 200) -> Gate:
    """Return the gate on the throughput of parallel threads, in wall-clock time: calls release the GIL."""
    poses = [Poses.draw(native, THREADED).v for _ in range(THREADS)]
    results = [native.pose(v) for v in poses]

    def work(index: int) -> None:
        for _ in range(repeats):
            native.pose(poses[index], out=results[index])

    def seconds(count: int) -> float:
        threads = [threading.Thread(target=work, args=(index,)) for index in range(count)]
        start = time.perf_counter()
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        return (time.perf_counter() - start) / count

    ratio = median(seconds(1) / seconds(THREADS) for _ in range(rounds))
    return Gate(f"pose, n = {label(native)}, N = {THREADED}: {THREADS} threads against one", ratio, LINEAR)


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


def section(sizes: Sequence[int] = SIZES) -> str:
    """Return the tables and missed gates, or a line that says why nothing was measured."""
    with ExitStack() as stack:
        try:
            package = stack.enter_context(compiled())
        except AssertionError as error:
            return f"Compiled functions were not measured, for they could not be built: {error}\n"
        return _section(package, sizes)


def _section(package: str, sizes: Sequence[int]) -> str:
    lines, gates = [], list[Gate]()
    for order in ORDERS:
        pair = [importlib.import_module(f"{name}.cayley{order}") for name in ("dualcay", package)]
        for size in sizes:
            for row, decided in rows(*pair, size):
                lines.append(row)
                gates += decided
        gates.append(threaded(pair[1]))
    head = ("n", "function", "N", "ours, ns per pose", "NumPy kernels", *LEAST, "given result", "C loop")
    short = [f"Falls short: {', '.join(gate.row()[:2])} of {gate.row()[2]}." for gate in gates if not gate.met]
    return "\n".join([
        markdown("Compiled functions", head, lines),
        markdown("Gates of compiled functions", ("ours", "times faster", "gate", ""), [gate.row() for gate in gates]),
        *(short or ["Every gate of compiled functions is met."]),
        "",
    ])  # fmt: skip


if __name__ == "__main__":
    sys.stdout.write(section())
