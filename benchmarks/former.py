"""The kernels against those of the former release, taken out of git: paired times and calls of NumPy.

Run ``python -m benchmarks.former`` from the checkout; ``--quick`` takes seconds, ``--noise`` compares the former
kernels with themselves. Both packages are imported side by side, and every function of the former runs in turn with its
present form on the same arrays: the median of the paired ratios, and of three runs the median. Nothing fails: a gate
that is missed is named.
"""

from __future__ import annotations

import argparse
import importlib
import importlib.util
import inspect
import io
import statistics
import subprocess
import sys
import tempfile
import zipfile
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from types import ModuleType
from typing import Any
from unittest import mock

import numpy as np
from numpy.typing import NDArray

from benchmarks.timing import Call, markdown, paired_ratio

REVISION = "bece627ce0dc324bab7291254cb0704216a800e4"
"""The former release."""

PACKAGE = "generated/dualcay"
ROOT = Path(__file__).parents[1]
PRESENT = ROOT / PACKAGE
"""Of this checkout, whichever is installed."""

COMMAND = "python -m benchmarks.former"

ORDERS = (1, 2, 3, 8)
RUNS = 3
SECONDS = 0.005
"""Of one form in one round, at least: short, so that both forms see the same neighbours."""

Array = NDArray[Any]


class Missing(Exception):
    """The former release cannot be had."""


@dataclass(frozen=True, slots=True)
class Layout:
    """So many poses, as rows into a given array or components last into a new one; the largest ratio allowed."""

    title: str
    batch: tuple[int, ...]
    rows: bool = False
    gate: float = float("inf")
    rounds: int = 16


LAYOUTS = (
    Layout("rows, 10^4", (10_000,), rows=True, gate=1.05),
    Layout("rows, 10^6", (1_000_000,), rows=True, gate=1.05, rounds=6),
    Layout("one pose", (), gate=1.10),
    Layout("last, 10^4", (10_000,)),
    Layout("last, 100", (100,)),
)
QUICK = tuple(layout for layout in LAYOUTS if layout.batch < (1_000_000,))
COUNTED = Layout("counted", (1000,), rows=True)
"""One block of the in-place form."""

MADE: dict[str, Callable[[ModuleType, Array], Array]] = {
    "q": lambda module, v: module.quaternion(v),
    "R": lambda module, v: module.tensor(v),
    "T": lambda module, v: module.pose(v),
    "r": lambda _, v: v[..., :3],
    "angle": lambda module, v: module.to_screw(v)[0],
    "line": lambda module, v: module.to_screw(v)[1],
}
"""Arguments by the name of their parameter, from a Rodrigues dual vector; all others are six-vectors like it."""


@dataclass(frozen=True, slots=True)
class Comparison:
    """A function of one order: its ratios by layout, one for each run, and calls of NumPy, the former's first."""

    order: int
    function: str
    calls: tuple[int, int]
    ratios: dict[str, list[float]] = field(default_factory=dict)

    def ratio(self, layout: Layout) -> float:
        return statistics.median(self.ratios[layout.title])

    def spread(self, layout: Layout) -> float:
        """Half of what the runs differ by."""
        return (max(self.ratios[layout.title]) - min(self.ratios[layout.title])) / 2

    def short(self, layouts: Sequence[Layout]) -> list[str]:
        """The gates it misses."""
        missed = [
            f"{layout.title}: {self.ratio(layout):.3f} of {layout.gate:.2f}"
            for layout in layouts
            if self.ratio(layout) > layout.gate
        ]
        before, after = self.calls
        return missed + ([f"calls: {after} of {before}"] if after > before else [])

    def row(self, layouts: Sequence[Layout]) -> tuple[str, ...]:
        ratios = (f"{self.ratio(layout):.3f}" for layout in layouts)
        before, after = self.calls
        return str(self.order), self.function, *ratios, f"{before} → {after}", "SHORT" if self.short(layouts) else "met"


# --- the packages -----------------------------------------------------------------------------------------------


@contextmanager
def former(revision: str = REVISION) -> Iterator[Path]:
    """The folder of the former kernels; Missing where there is no git, or no such revision in its history."""
    command = ["git", "-C", str(ROOT), "archive", "--format=zip", revision, PACKAGE]
    try:
        archive = subprocess.run(command, capture_output=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        raise Missing(f"the history of git, revision {revision[:7]}, for the kernels of the former release") from None
    with tempfile.TemporaryDirectory(prefix="dualcay-former-") as folder:
        zipfile.ZipFile(io.BytesIO(archive)).extractall(folder)
        yield Path(folder, PACKAGE)


def load(folder: Path, name: str, order: int) -> ModuleType:
    """The kernels of an order in the package at a folder, imported anew under a name of its own."""
    for known in [known for known in sys.modules if known.split(".")[0] == name]:
        del sys.modules[known]
    root, places = folder / "__init__.py", [str(folder)]
    spec = importlib.util.spec_from_file_location(name, root, submodule_search_locations=places)
    assert spec is not None
    assert spec.loader is not None
    sys.modules[name] = package = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(package)
    return importlib.import_module(f"{name}.cayley{order}")


def pair(before: Path, after: Path, order: int) -> tuple[ModuleType, ModuleType]:
    """The kernels of both packages, with one scratch memory: where it happens to lie can make a tenth of the time."""
    modules = load(before, "dualcay_former", order), load(after, "dualcay_present", order)
    kernels: list[Any] = [importlib.import_module("._kernel", module.__package__) for module in modules]
    kernels[1].SCRATCH = kernels[0].SCRATCH
    return modules


def functions(module: ModuleType) -> Iterator[tuple[str, str, dict[str, int]]]:
    """Title, name and options of what is compared: public functions on arrays, inverse maps on a branch also."""
    for name in module.__all__:
        function = getattr(module, name)
        parameters = inspect.signature(function).parameters
        if "axis" not in parameters or function.__name__ != name:  # about no arrays, or another's second name
            continue
        yield name, name, {}
        if "branch" in parameters and not parameters["branch"].default:
            yield f"{name}, branch 1", name, {"branch": 1}


class Inputs:
    """Random arguments in a layout; what is made of them is made by the former kernels."""

    def __init__(self, module: ModuleType, layout: Layout, seed: int) -> None:
        rng = np.random.default_rng([2011, seed])
        self.module = module
        self.layout = layout
        self.vectors = [module.from_screw(*_screws(layout.batch, rng)) for _ in range(3)]

    def calls(self, name: str, options: dict[str, int], *modules: ModuleType) -> tuple[Call, ...]:
        """The function of each module, ready to be called on the same arrays."""
        parameters = inspect.signature(getattr(self.module, name)).parameters.values()
        given = [p for p in parameters if p.kind is not p.KEYWORD_ONLY and p.name != "branch"]
        values = [self._value(parameter.name, v) for parameter, v in zip(given, self.vectors)]
        keywords: dict[str, Any] = dict(options)
        if self.layout.rows:
            keywords["axis"] = 0
            if any(parameter.name == "out" for parameter in parameters):
                keywords["out"] = getattr(self.module, name)(*values, **keywords)
        return tuple(partial(getattr(module, name), *values, **keywords) for module in modules)

    def _value(self, name: str, v: Array) -> Array:
        value = MADE[name](self.module, v) if name in MADE else v
        return np.ascontiguousarray(np.moveaxis(value, 0, -1) if self.layout.rows else value)


def _screws(batch: tuple[int, ...], rng: np.random.Generator) -> tuple[Array, Array]:
    """Dual angles up to 3 and axes near the origin."""
    direction, point = rng.normal(size=(2, *batch, 3))
    direction /= np.linalg.norm(direction, axis=-1, keepdims=True)
    line = np.concatenate([direction, np.cross(point, direction)], axis=-1)
    return rng.uniform((0, -1), (3, 1), (*batch, 2)), line


# --- calls of NumPy ---------------------------------------------------------------------------------------------


class Counted:
    """A function of NumPy that counts its calls."""

    def __init__(self, function: Callable[..., Any]) -> None:
        self.function = function
        self.calls = 0

    def __call__(self, *arguments: Any, **options: Any) -> Any:
        self.calls += 1
        return self.function(*arguments, **options)

    def __getattr__(self, name: str) -> Any:
        return getattr(self.function, name)


def counted_calls(folder: Path, order: int) -> dict[str, int]:
    """Ufuncs and copies that the in-place form of every function calls for a block, by title."""
    names = [name for name, value in vars(np).items() if isinstance(value, np.ufunc)]
    counters: dict[str, Any] = {name: Counted(getattr(np, name)) for name in (*names, "copyto")}
    with mock.patch.multiple(np, **counters):  # so whatever name an imported module gives them counts
        module = load(folder, "dualcay_counted", order)
        inputs = Inputs(module, COUNTED, 0)
        counts = {}
        for title, name, options in functions(module):
            (call,) = inputs.calls(name, options, module)
            before = sum(counter.calls for counter in counters.values())
            call()
            counts[title] = sum(counter.calls for counter in counters.values()) - before
    return counts


# --- the comparison ---------------------------------------------------------------------------------------------


def compare(
    before: Path, after: Path, orders: Sequence[int], layouts: Sequence[Layout], runs: int, only: Sequence[str] = ()
) -> list[Comparison]:
    """Every function of those orders, or only some; a run goes through all before the next."""
    found: dict[tuple[int, str], Comparison] = {}
    for order in orders:
        counts = [counted_calls(folder, order) for folder in (before, after)]
        found |= {(order, title): Comparison(order, title, (n, counts[1][title])) for title, n in counts[0].items()}
    for run in range(runs):
        for order in orders:
            modules = pair(before, after, order)
            chosen = [f for f in functions(modules[0]) if not only or f[1] in only]
            for layout in layouts:
                inputs = Inputs(modules[0], layout, run)
                for title, name, options in chosen:
                    past, now = inputs.calls(name, options, *modules)
                    ratio = paired_ratio(past, now, layout.rounds, SECONDS)
                    found[order, title].ratios.setdefault(layout.title, []).append(ratio)
    return [comparison for comparison in found.values() if comparison.ratios]


def summary(comparisons: Sequence[Comparison], layout: Layout) -> tuple[str, ...]:
    """One line for a layout."""
    ratios = [comparison.ratio(layout) for comparison in comparisons]
    spread = [comparison.spread(layout) for comparison in comparisons]
    gate = f"{layout.gate:.2f}" if np.isfinite(layout.gate) else "–"
    largest = f"{max(ratios):.3f}", f"± {max(spread):.3f}"
    middle = f"{statistics.median(ratios):.3f}", f"± {statistics.median(spread):.3f}"
    return layout.title, gate, middle[0], largest[0], middle[1], largest[1]


def tables(comparisons: Sequence[Comparison], layouts: Sequence[Layout]) -> str:
    """The gates that are missed and all ratios, as Markdown."""
    short = [
        f"Falls short: {comparison.function}, n = {comparison.order}, {missed}."
        for comparison in comparisons
        for missed in comparison.short(layouts)
    ]
    head = ("layout", "gate", "ratio, median", "largest", "runs differ by, median", "largest")
    every = ("n", "function", *(layout.title for layout in layouts), "calls", "gates")
    return "\n".join([
        *(short or ["Every gate against the former release is met."]),
        "",
        markdown("Present time to former, by layout", head, [summary(comparisons, layout) for layout in layouts]),
        markdown("Present time to former, by function", every, [c.row(layouts) for c in comparisons]),
    ])  # fmt: skip


def section(
    orders: Sequence[int] = ORDERS,
    layouts: Sequence[Layout] = LAYOUTS,
    runs: int = RUNS,
    only: Sequence[str] = (),
    noise: bool = False,
) -> str:
    """The section of the page, or a line that says what is missing for it."""
    try:
        with former() as folder:
            comparisons = compare(folder, folder if noise else PRESENT, orders, layouts, runs, only)
    except Missing as what:
        return f"Not measured, because it is missing: {what}.\n"
    which = "The former kernels against themselves" if noise else "The present kernels against the former"
    how = (
        f"{which}, by `{COMMAND}`: both in turn in one process, the median of paired ratios, and of {runs} runs the "
        "median; below 1 is faster. `rows` are (6, N) with `out=`, `last` is (N, 6) into a new array; `calls` are "
        "those of NumPy's ufuncs and `copyto` for one block of the in-place form, former → present, of which none "
        "may be added."
    )
    return f"## Against the former release, {REVISION[:7]}\n\n{how}\n\n{tables(comparisons, layouts)}"


def main(given: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0], prog=COMMAND)
    parser.add_argument("-n", dest="orders", type=int, nargs="+", choices=ORDERS, help="orders")
    parser.add_argument("-f", dest="functions", nargs="+", default=(), help="only these functions")
    parser.add_argument("--quick", action="store_true", help="one run without 10^6, of order 3 unless -n says others")
    parser.add_argument("--noise", action="store_true", help="the former kernels against themselves")
    options = parser.parse_args(given)
    layouts, runs, orders = (QUICK, 1, (3,)) if options.quick else (LAYOUTS, RUNS, ORDERS)
    print(section(options.orders or orders, layouts, runs, options.functions, options.noise))


if __name__ == "__main__":
    main()
