"""Times of pose, from_pose and compose for one to a million poses, in our kernels and other libraries.

All libraries, and our exponential chart, take exponential coordinates; the chart n = 2 takes its own vector.
SymForce converts only the rotation and keeps the translation, which is less work. Libraries without functions on
arrays are called in a loop, for at most a thousand poses. The plot is docs/benchmarks.png.
"""

from __future__ import annotations

import importlib
import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack, suppress
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.kernels import measured, per_pose
from benchmarks.native import compiled
from benchmarks.peers import LIBRARIES, Poses, load
from benchmarks.timing import Call, markdown
from derive.codegen import generate
from derive.maps import Cayley, family
from derive.maps.chart import Chart

PLOT = Path(__file__).parents[1] / "docs" / "benchmarks.png"
SIZES = (1, 10, 100, 1_000, 10_000, 100_000, 1_000_000)

FUNCTIONS = {"pose": ("v",), "from_pose": ("T",), "compose": ("w", "v")}
CHARTS = (Cayley(2), family("exponential"))
TITLES = {"pose": "vector to pose", "from_pose": "pose to vector", "compose": "product of two vectors"}

Lines = dict[str, dict[int, float]]
"""Type of measured seconds, by name of a line and number of poses."""


def ours(packages: Mapping[str, str], function: str, size: int) -> Iterator[tuple[str, Call]]:
    """Yield calls of our function in every chart and every form (NumPy, Numba, compiled)."""
    for chart in CHARTS:
        poses = Poses.draw(importlib.import_module(f"dualcay.{chart.name}"), size)
        arguments = [getattr(poses, name) for name in FUNCTIONS[function]]
        for form, package in packages.items():
            kernel = getattr(importlib.import_module(f"{package}.{chart.name}"), function)
            yield f"{form}, {label(chart)}", partial(kernel, *arguments)


def label(chart: Chart) -> str:
    """Return the label of a chart in lines and tables."""
    return f"n = {chart.order}" if chart.cayley else chart.name


def libraries(function: str, size: int) -> Iterator[tuple[str, Call | None]]:
    """Yield each library with its call on common poses."""
    poses = Poses.draw(importlib.import_module("dualcay.exponential"), size)
    for name, library in LIBRARIES.items():
        yield library.label(name), library.call(function, poses)


def labels() -> list[str]:
    """Return the labels of all libraries in lines and tables."""
    return [library.label(name) for name, library in LIBRARIES.items()]


FLOOR = "copying the result"

MARGIN = 1.15
"""Least ratio for which a library counts as faster; ratios on other machines vary by some 15 %."""


def lines(packages: Mapping[str, str], function: str, sizes: Sequence[int]) -> Lines:
    """Return the times of a function for every line of its plot."""
    found: Lines = {}
    for size in sizes:
        calls: dict[str, Call | None] = dict(ours(packages, function, size))
        calls |= dict(libraries(function, size))
        results = [call() for call in calls.values() if call]  # the first call may compile
        made: Any = results[0]
        calls[FLOOR] = partial(np.copyto, np.empty_like(made), made)
        for name, seconds in measured(calls, size).items():
            found.setdefault(name, {})[size] = seconds
    return found


# --- text and figure ------------------------------------------------------------------------------------------------


def table(function: str, found: Lines, sizes: Sequence[int]) -> str:
    """Return a table of nanoseconds per pose."""
    head = ("", *(f"N = {size:,}" for size in sizes))
    body = [(name, *(per_pose(at[n], n) if n in at else "–" for n in sizes)) for name, at in found.items()]
    return markdown(f"{TITLES[function].capitalize()} ({function}), ns per pose", head, body)


def faster(function: str, found: Lines, forms: Sequence[str]) -> Iterator[str]:
    """Yield a sentence for each library that is faster than a form of our exponential chart."""
    for form in forms:
        mine = found[f"{form}, exponential"]
        for name in labels():
            where = [size for size, seconds in found.get(name, {}).items() if MARGIN * seconds < mine[size]]
            if where:
                times = ", ".join(f"N = {size:,} ({mine[size] / found[name][size]:.2g} x)" for size in where)
                yield f"- {function}: {name} is faster than {form}, exponential at {times}."


def draw(every: Mapping[str, Lines], path: Path) -> None:
    """Draw the picture, if matplotlib is installed."""
    figure = load("matplotlib.figure")
    if figure is None:
        return
    made = figure.Figure(figsize=(13, 5.2), layout="constrained")
    panels = made.subplots(1, len(every), sharey=True)
    for axes, (function, found) in zip(panels, every.items(), strict=True):
        for name, at in found.items():
            colour, style, mark = LOOKS[name]
            each = [seconds / size * 1e9 for size, seconds in at.items()]
            axes.loglog(list(at), each, style, color=colour, marker=mark, ms=5, label=name)
        axes.set(title=TITLES[function], xlabel="poses in a call")
        axes.grid(alpha=0.25)
    panels[0].set_ylabel("ns per pose")
    known = {line.get_label(): line for axes in panels for line in axes.get_lines()}
    made.legend([known[name] for name in LOOKS if name in known], [name for name in LOOKS if name in known],
                loc="outside lower center", ncols=6, frameon=False)  # fmt: skip
    made.savefig(path, dpi=110, metadata={"Software": None})


BLUE, GREEN, RED = "#0072B2", "#009E73", "#D55E00"
LOOKS = {
    "NumPy, n = 2": (BLUE, "-", "o"), "NumPy, exponential": (BLUE, "--", "o"),
    "Numba, n = 2": (GREEN, "-", "s"), "Numba, exponential": (GREEN, "--", "s"),
    "compiled, n = 2": (RED, "-", "^"), "compiled, exponential": (RED, "--", "^"),
    "SciPy": ("#E69F00", ":", "v"), "pytransform3d": ("#8C510A", ":", "P"), "jaxlie, jitted": ("#CC79A7", ":", "X"),
    "pinocchio, pose by pose": ("#7F7F7F", ":", "d"), "SymForce, pose by pose": ("#000000", ":", "*"),
    FLOOR: ("#BBBBBB", "-", ""),
}  # fmt: skip
"""Colour, line style and marker by name of line; lines of other libraries are dotted."""


def section(sizes: Sequence[int] = SIZES, plot: Path = PLOT) -> str:
    """Return the section of the page: tables, the plot, and sentences on faster libraries."""
    with tempfile.TemporaryDirectory(prefix="dualcay-numba-") as folder, ExitStack() as stack:
        packages = {"NumPy": "dualcay", **_numba(Path(folder))}
        with suppress(AssertionError):  # a failed build is reported by the section on compiled functions
            packages["compiled"] = stack.enter_context(compiled())
        every = {function: lines(packages, function, sizes) for function in FUNCTIONS}
    draw(every, plot)
    words = [line for function, found in every.items() for line in faster(function, found, list(packages))]
    missing = [name for name in labels() if not any(name in found for found in every.values())]
    return "\n".join([
        "## Beside other libraries, from one pose to a million", "",
        f"![ns per pose against poses in a call]({plot.name})", "",
        "Our exponential chart takes the vectors that libraries take, n = 2 others of the same poses; SymForce's leave "
        "the translation as it is, which is less work. Times are of the processor, all threads of a library added; "
        "jaxlie is compiled by JAX and on arrays of JAX, pinocchio and SymForce (`sym`) are called from Python, one "
        "pose at a time.",
        *([f"Not installed: {', '.join(missing)}."] if missing else []), "",
        *(table(function, found, sizes) for function, found in every.items()),
        f"Where a library takes less than 1/{MARGIN} of the time of our exponential chart:", "",
        *(words or ["- nowhere."]), "",
    ])  # fmt: skip


def _numba(folder: Path) -> dict[str, str]:
    """Generate a package of the charts for Numba, if it is installed; return its name by form."""
    if load("numba") is None:
        return {}
    generate([2], "numba", folder / "dualcay_numba_measured", families=["exponential"])
    sys.path.insert(0, str(folder))
    return {"Numba": "dualcay_numba_measured"}


if __name__ == "__main__":
    sys.stdout.write(section())
