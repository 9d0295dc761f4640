"""Pipeline from charts to checked kernels: prove -> lower -> print -> write -> check; `publish` writes the files.

Each stage is a function from one frozen record to the next: chart, `Proved`, `Lowered`, `Module`, `Written`, `Counts`.
"""

from __future__ import annotations

import gc
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from itertools import tee
from pathlib import Path
from typing import TypeVar

from ..maps import Cayley
from ..maps.chart import Chart
from ..output import files
from ..output.shown import Progress, Step, silent
from ..proof import prove
from ..workers import mapping, scratch
from .lowered import Lowered, lower
from .package import Counts, Facts, Module, Package, module_name, module_texts, shared_texts
from .targets import Target

GEOMETRY = Cayley(3)
"""Chart that checks the shared geometry if no requested chart fits: the lowest order whose scalars all differ."""

GEOMETRY_ORDERS = range(GEOMETRY.order, 9)  # exact numbers are slow in higher orders
CHECKS = ("validate", "replay", "test")
"""Methods of a target that execute a module; the numbers that they return are the `Counts`."""

GC_THRESHOLD = 200_000  # number of allocations between two garbage collections while charts are built


@dataclass(frozen=True, slots=True)
class Written:
    """Module on disk, as a worker process receives it; with ``geometry`` it checks what all charts share too.

    Its own tests are compiled if ``tested``: a chart that was not asked for has none.
    """

    name: str
    chart: Chart
    target: Target
    folder: Path
    geometry: bool
    tested: bool


Record = TypeVar("Record", Chart, Lowered, Module, Written)


def build(charts: Sequence[Chart], target: Target, progress: Progress = silent, processes: int = 1) -> Package:
    """Prove, lower, print, write and check charts, without publishing, in a number of ``processes``.

    Charts pass through the stages one by one: a chart is proved while other processes check the charts before it. Raise
    `ProofFailed` or `ValidationFailed` if any chart fails.
    """
    if processes < 1:
        raise ValueError(f"processes must be an integer >= 1, got {processes}")
    geometry = geometry_chart(charts)
    built = charts if geometry in charts else [geometry, *charts]
    with (
        relaxed_gc(),
        scratch() as folder,
        mapping(check, processes) as results,
        progress(4 * len(built)) as report,
    ):
        shared = shared_texts(target)
        files.write(folder, shared)
        proved = map(prove, announced(built, "proving", report))
        lowered = map(lower, proved)
        printed, modules = tee(
            print_module(chart, target, chart.chart in charts) for chart in announced(lowered, "printing", report)
        )
        written = (write(module, target, folder, geometry, charts) for module in printed)
        found = results((name, module) for module in announced(written, "checking", report) for name in CHECKS)
        counted = (
            replace(module, counts=Counts(next(found) or 0, next(found) or 0, next(found))) for module in modules
        )
        checked = tuple(announced(counted, "checked", report))
    return Package(shared, tuple(module for module in checked if module.proved.formulas in charts))


def print_package(
    charts: Sequence[Chart], target: Target, progress: Progress = silent, tested: bool = True
) -> Package:
    """Prove, lower and print charts, with their tests if ``tested``, without checking."""
    with progress(2 * len(charts)) as report:
        lowered = map(lower, map(prove, announced(charts, "proving", report)))
        printed = (print_module(chart, target, tested) for chart in announced(lowered, "printing", report))
        return Package(shared_texts(target), tuple(printed))


def print_module(lowered: Lowered, target: Target, tested: bool = True) -> Module:
    return Module(module_name(lowered.chart, target), lowered.proved, module_texts(Facts(lowered), target, tested))


def write(module: Module, target: Target, folder: Path, geometry: Chart, asked: Sequence[Chart]) -> Written:
    """Write a module beside the files that it shares with others; ``geometry`` is the chart that checks these."""
    files.write(folder, module.texts)
    chart = module.proved.formulas
    return Written(module.name, chart, target, folder, chart == geometry, chart in asked)


def check(asked: tuple[str, Written]) -> int | None:
    """Execute a module on disk in the way of a method of its target; return the number of calls that agree."""
    name, written = asked
    if name == "test":
        return written.target.test(written.folder, written.chart) if written.tested else 0
    method: Callable[[Path, Chart, bool], int] = getattr(written.target, name)
    with relaxed_gc():
        return method(written.folder, written.chart, written.geometry)


def announced(records: Iterable[Record], stage: str, report: Step) -> Iterator[Record]:
    """Yield records; report each of them before the next stage takes it."""
    for record in records:
        report(f"{record.name}: {stage}")
        yield record


def geometry_chart(charts: Sequence[Chart]) -> Chart:
    """Return the chart that checks the shared geometry: the first Cayley map of a suitable order, or `GEOMETRY`."""
    return next((chart for chart in charts if chart.cayley and chart.order in GEOMETRY_ORDERS), GEOMETRY)


@contextmanager
def relaxed_gc() -> Iterator[None]:
    """Run the garbage collector less often: hardly any of the millions of objects is in a reference cycle."""
    first, *others = gc.get_threshold()
    gc.set_threshold(max(first, GC_THRESHOLD) if first else 0, *others)  # 0 disables collection
    try:
        yield
    finally:
        gc.set_threshold(first, *others)
