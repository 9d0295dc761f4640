"""Ratios of times of NumPy kernels, this checkout over another checkout, function by function.

Run ``python -m benchmarks.recorded --against OTHER/generated/dualcay`` from this checkout. Both packages are imported
side by side and run in turn on the same arrays. A ratio below 1 means that this checkout is faster.
"""

from __future__ import annotations

import argparse
import importlib
import importlib.util
import inspect
import os
import statistics
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.page import write_section
from benchmarks.timing import Call, fix_allocator, markdown, paired_ratio

PRESENT = Path(__file__).parents[1] / "generated" / "dualcay"
COMMAND = "python -m benchmarks.recorded --against OTHER/generated/dualcay"
CHARTS = ("cayley2", "exponential")
SIZES = (20, 100, 300, 10_000)
RUNS = 3
SECONDS = 0.005  # time of one round; in a short round both packages suffer the same disturbances

MEDIAN_GATE, LARGEST_GATE = 1.05, 1.15  # limits of the median and of the largest ratio, for each chart and size

Array = NDArray[Any]

MADE: dict[str, Callable[[ModuleType, Array], Array]] = {
    "q": lambda module, v: module.quaternion(v),
    "R": lambda module, v: module.tensor(v),
    "T": lambda module, v: module.pose(v),
    "r": lambda _, v: v[..., :3],
    "t": lambda _, v: v[..., 0],
    "covariance": lambda _, v: v[..., :, None] * v[..., None, :],
    "angle": lambda module, v: module.to_screw(v)[0] if hasattr(module, "to_screw") else module.to_angle_axis(v)[0],
    "line": lambda module, v: module.to_screw(v)[1],
    "u": lambda module, v: module.to_angle_axis(v)[1],
}
"""Functions that compute an argument from a Rodrigues vector, by parameter; other parameters take the vector."""


def load(folder: Path, name: str, chart: str) -> ModuleType:
    """Import the package in a folder afresh under another name; return the module of a chart."""
    for known in [known for known in sys.modules if known.partition(".")[0] == name]:
        del sys.modules[known]
    root = folder / "__init__.py"
    spec = importlib.util.spec_from_file_location(name, root, submodule_search_locations=[str(folder)])
    if spec is None or spec.loader is None or not root.is_file():
        raise FileNotFoundError(f"no package at {folder}")
    sys.modules[name] = package = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(package)
    return importlib.import_module(f"{name}.{chart}")


def functions(*modules: ModuleType) -> list[str]:
    """Return the names of array functions that all modules share, without aliases."""

    def compared(name: str) -> bool:
        function = getattr(modules[0], name)
        return function.__name__ == name and "axis" in inspect.signature(function).parameters

    return [name for name in modules[0].__all__ if all(name in m.__all__ for m in modules) and compared(name)]


def calls(name: str, vectors: Sequence[Array], axis: int, *modules: ModuleType) -> Iterator[Call]:
    """Yield the function of each module, bound to the same arguments."""
    parameters = inspect.signature(getattr(modules[0], name)).parameters.values()
    given = [p.name for p in parameters if p.kind is not p.KEYWORD_ONLY and p.name != "branch"]
    values = [MADE[p](modules[0], v) if p in MADE else v for p, v in zip(given, vectors, strict=False)]
    if axis == 0:
        batch = vectors[0].ndim - 1
        values = [np.ascontiguousarray(np.moveaxis(a, range(batch), range(a.ndim - batch, a.ndim))) for a in values]
    for module in modules:
        yield partial(getattr(module, name), *values, axis=axis)


def draw(module: ModuleType, size: int, seed: int) -> list[Array]:
    """Return three random arguments: turns up to 3 rad about axes near the origin."""
    rng = np.random.default_rng([2011, seed])
    batch = () if size == 1 else (size,)
    length = module.identity().shape[-1]
    logarithms = rng.uniform(-1, 1, (3, *batch, length)) * np.repeat([3**0.5, 1], 3)[:length]
    return [module.from_exponential(w) for w in logarithms]


def compare(
    other: Path, charts: Sequence[str], sizes: Sequence[int], runs: int = RUNS, axis: int = -1, only: Sequence[str] = ()
) -> dict[tuple[str, int, str], list[float]]:
    """Return ratios by chart, size and function, one per run; each run imports both packages anew."""
    found: dict[tuple[str, int, str], list[float]] = {}
    for run in range(runs):
        for chart in charts:
            modules = load(other, "dualcay_other", chart), load(PRESENT, "dualcay_present", chart)
            for size in sizes:
                vectors = draw(modules[0], size, run)
                for name in (name for name in functions(*modules) if not only or name in only):
                    before, after = calls(name, vectors, axis, *modules)
                    ratio = paired_ratio(before, after, 5 if size > 100_000 else 15, SECONDS)
                    found.setdefault((chart, size, name), []).append(ratio)
    return found


def section(found: Mapping[tuple[str, int, str], Sequence[float]], axis: int = -1) -> str:
    """Return all ratios, their medians and the largest ones as Markdown."""
    ratios = {key: statistics.median(runs) for key, runs in found.items()}
    sizes = sorted({size for _, size, _ in ratios})
    summary, rows = [], []
    for chart, size in dict.fromkeys((chart, size) for chart, size, _ in ratios):
        here = [(ratio, key[2]) for key, ratio in ratios.items() if key[:2] == (chart, size)]
        median, (largest, where) = statistics.median(ratio for ratio, _ in here), max(here)
        gate = "met" if median <= MEDIAN_GATE and largest <= LARGEST_GATE else "SHORT"
        summary.append((chart, str(size), f"{median:.3f}", f"{largest:.3f}", where, gate))
    for chart, name in dict.fromkeys((chart, name) for chart, _, name in ratios):
        rows.append((chart, name, *(f"{ratios[chart, size, name]:.3f}" for size in sizes)))
    how = (
        f"Written by `{COMMAND}`: time of the present kernels over those of the other checkout, both in turn in one "
        f"process, `axis={axis}`. Gates: median at most {MEDIAN_GATE}, largest at most {LARGEST_GATE}."
    )
    head, every = ("chart", "N", "median", "largest", "function", "gate"), ("chart", "function", *map(str, sizes))
    return f"{how}\n\n{markdown('Ratios by chart', head, summary)}\n{markdown('Ratios by function', every, rows)}"


def main(given: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--against", type=Path, required=True, help="folder of the other package, generated/dualcay")
    listed = partial(str.split, sep=",")
    parser.add_argument("--charts", type=listed, default=CHARTS, help=f"modules (default: {','.join(CHARTS)})")
    parser.add_argument("--sizes", type=listed, default=SIZES, help="numbers of poses (default: 20,100,300,1e4)")
    parser.add_argument("--functions", type=listed, default=(), help="only these")
    parser.add_argument("--runs", type=int, default=RUNS, help=f"median of so many runs (default: {RUNS})")
    parser.add_argument("--axis", type=int, choices=(-1, 0), default=-1, help="components last (-1) or first (0)")
    parser.add_argument("-o", "--output", type=Path, help="page whose section is replaced")
    o = parser.parse_args(given)
    os.environ["DUALCAY_NATIVE"] = "0"
    found = compare(o.against, o.charts, [int(float(size)) for size in o.sizes], o.runs, o.axis, o.functions)
    text = section(found, o.axis)
    print(text)
    if o.output:
        write_section(o.output, "recorded", text)


if __name__ == "__main__":
    fix_allocator()
    main()
