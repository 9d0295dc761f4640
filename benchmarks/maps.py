"""Times of maps in our kernels and in other libraries, from one pose to a million; components last, a new result.

Our exponential chart takes the vectors that libraries take, other charts vectors of the same poses. For each function
and number of poses, all calls take turns; a call of a library is measured once.
"""

from __future__ import annotations

import importlib
import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from functools import lru_cache, partial
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.native import compiled
from benchmarks.peers import LIBRARIES, Poses, load
from benchmarks.times import CHARTS, ORDERS, Key, Timed, label, timed
from benchmarks.timing import Call
from derive.codegen import generate

PART, SMALL = "maps", "small batches"
SMALL_SIZES = (20, 50, 100, 300)
"""Numbers of poses between those of `SIZES`, where the calls of NumPy cost more than its arithmetic."""

SIZES = tuple(10**k for k in range(7))
FUNCTIONS = {
    "pose": ("v",), "quaternion": ("v",), "tangent": ("v",), "rate": ("v", "w"), "from_pose": ("T",),
    "from_quaternion": ("q",), "compose": ("w", "v"),
}  # fmt: skip
"""Measured functions, with their arguments as names of attributes of `Poses`."""

NUMPY, COMPILED, NUMBA, COPY = "NumPy", "compiled", "Numba", "copy of the result"
CAYLEY = tuple(f"cayley{order}" for order in ORDERS)
FURTHER = ("orthographic", "lambert", "breusing", "wiener_milenkovic")
FORMS = {NUMPY: (*CAYLEY, "exponential", *FURTHER), COMPILED: (*CAYLEY, "exponential"), NUMBA: CHARTS}
"""Charts that are measured in each form of our kernels."""


def measure(packages: Mapping[str, str], sizes: Sequence[int] = SIZES) -> Iterator[Timed]:
    """Yield the times of all calls; packages of kernels by their form."""
    groups = ((function, size, calls(packages, function, size)) for size in sizes for function in FUNCTIONS)
    yield from timed(PART, groups)


def on_small_batches(packages: Mapping[str, str]) -> Iterator[Timed]:
    """Yield the times of ``pose`` in NumPy and in libraries for some small batches."""
    numpy = {NUMPY: packages[NUMPY]}
    yield from timed(SMALL, (("pose", size, calls(numpy, "pose", size)) for size in SMALL_SIZES))


def calls(packages: Mapping[str, str], function: str, size: int) -> dict[Key, Call]:
    """Return all calls of a function: ours, those of libraries, and a copy of the result."""
    found: dict[Key, Call] = {}
    for form, package in packages.items():
        for chart in FORMS[form]:
            kernel = getattr(importlib.import_module(f"{package}.{chart}"), function)
            text = f"{chart}.{function}({', '.join(FUNCTIONS[function])})"
            found[form, chart, text] = partial(kernel, *arguments(function, drawn(chart, size)))
    made: Any = next(iter(found.values()))()
    for name, library in LIBRARIES.items():
        for text, call in library.calls(function, drawn("exponential", size), size).items():
            found[name, "", text] = call
    return found | {(COPY, "", "np.copyto(out, result)"): partial(np.copyto, np.empty_like(made), made)}


@lru_cache(len(FORMS[NUMPY]))
def drawn(chart: str, size: int) -> Poses:
    """Return the poses of a chart; they are the same in every chart."""
    return Poses.draw(importlib.import_module(f"dualcay.{chart}"), size)


def arguments(function: str, poses: Poses) -> list[Any]:
    return [getattr(poses, name) for name in FUNCTIONS[function]]


@contextmanager
def forms() -> Iterator[dict[str, str]]:
    """Yield the packages of kernels by form: NumPy, and compiled functions and Numba where they can be built."""
    packages = {NUMPY: "dualcay"}
    with tempfile.TemporaryDirectory(prefix="dualcay-numba-") as folder, ExitStack() as stack:
        try:
            packages[COMPILED] = stack.enter_context(compiled())
        except AssertionError as error:
            print(f"No functions were compiled: {error}", file=sys.stderr)
        if load("numba"):
            generate([2], "numba", Path(folder) / "dualcay_numba_measured", families=["exponential"])
            sys.path.insert(0, folder)
            packages[NUMBA] = "dualcay_numba_measured"
        yield packages
        sys.path[:] = [entry for entry in sys.path if entry != folder]


def name(of: Timed) -> str:
    """Return the label of a line: who makes the call, and the chart."""
    return f"{of.by}, {label(of.chart)}" if of.chart else of.by
