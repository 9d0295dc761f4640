"""Pipeline from charts to kernels: prove -> lower -> print -> write -> check. `publish` writes them into a folder."""

from __future__ import annotations

import gc
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

from ..maps import Cayley
from ..maps.chart import Chart
from ..output import files
from ..output.progress import Step, no_op
from ..proof import prove
from ..workers import each
from .package import Counts, Facts, Module, Package, module_name, module_texts, shared_texts
from .targets import Target

GEOMETRY = Cayley(3)
"""Chart that checks the shared geometry if no requested chart fits: the lowest order whose scalars all differ."""

GEOMETRY_ORDERS = range(GEOMETRY.order, 9)  # exact numbers are slow in higher orders

GC_THRESHOLD = 20_000
"""Number of allocations between two garbage collections while charts are built."""

STEPS = 4
"""Lines of progress for each chart."""


def build(charts: Sequence[Chart], target: Target, progress: Step | None = None, processes: int = 1) -> Package:
    """Prove, lower, print and check charts, without publishing; ``processes`` is the number of workers that check.

    Raise `ProofFailed` or `ValidationFailed` if any chart fails.
    """
    if processes < 1:
        raise ValueError(f"processes must be an integer >= 1, got {processes}")
    report, printed, modules = progress or no_op, list[Module](), list[Module]()

    def checks() -> Iterator[tuple[Chart, Target, Path, bool]]:
        for chart in with_geometry(charts):
            printed.append(print_module(chart, target, report))
            files.write(staging, printed[-1].texts)
            report(f"{chart.name}: checking")
            yield chart, target, staging, chart == geometry_chart(charts)

    with relaxed_gc(), tempfile.TemporaryDirectory() as folder:
        staging, shared = Path(folder), shared_texts(target)
        files.write(staging, shared)
        for counts in each(check, checks(), processes):
            modules.append(replace(printed[len(modules)], counts=counts))
            report(f"{modules[-1].proved.formulas.name}: checked")
    return Package(shared, tuple(module for module in modules if module.proved.formulas in charts))


def print_package(charts: Sequence[Chart], target: Target, progress: Step | None = None) -> Package:
    """Prove, lower and print charts without checking: enough to compare a folder with the printed texts."""
    return Package(shared_texts(target), tuple(print_module(chart, target, progress or no_op) for chart in charts))


def print_module(chart: Chart, target: Target, report: Step) -> Module:
    """Prove, lower and print a chart."""
    report(f"{chart.name}: proving")
    proved = prove(chart)
    report(f"{chart.name}: printing")
    return Module(module_name(chart, target), proved, module_texts(Facts(proved), target))


def check(chart: Chart, target: Target, folder: Path, geometry: bool) -> Counts:
    """Execute a chart's module on disk; with ``geometry`` check the functions that all charts share too."""
    with relaxed_gc():
        validated, replayed = target.validate(folder, chart, geometry), target.replay(folder, chart, geometry)
        return Counts(validated, replayed, target.test(folder, chart))


def geometry_chart(charts: Sequence[Chart]) -> Chart:
    """Return the chart that checks the shared geometry: the first Cayley map of a suitable order, or `GEOMETRY`."""
    return next((chart for chart in charts if chart.cayley and chart.order in GEOMETRY_ORDERS), GEOMETRY)


def with_geometry(charts: Sequence[Chart]) -> Sequence[Chart]:
    """Return the charts to build, including one that checks the shared geometry."""
    return charts if geometry_chart(charts) in charts else [GEOMETRY, *charts]


@contextmanager
def relaxed_gc() -> Iterator[None]:
    """Run the garbage collector less often: hardly any of the millions of objects is in a reference cycle."""
    first, *others = gc.get_threshold()
    gc.set_threshold(max(first, GC_THRESHOLD) if first else 0, *others)  # 0 disables collection
    try:
        yield
    finally:
        gc.set_threshold(first, *others)
