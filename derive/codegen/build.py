"""Pipeline from charts to checked kernels: prove -> lower -> print -> write -> check -> publish.

Each stage is a function from one frozen record to the next: chart, `Proved`, `Lowered`, `Module`, `Written`, `Counts`.
"""

from __future__ import annotations

import gc
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass, replace
from functools import partial
from itertools import tee
from pathlib import Path
from typing import TypeVar

from .. import about
from ..maps import Cayley
from ..maps.chart import Chart
from ..output import files
from ..output.shown import Progress, Step, bar, silent
from ..proof import prove
from ..workers import mapping, scratch
from . import catalogue
from .package import Counts, Facts, Module, Package, index_texts, module_texts, notices, shared_texts
from .signatures import Lowered, lower
from .targets import TARGETS, Target

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
        progress(4 * len(built)) as step,
    ):
        report = step if geometry in charts else partial(_told, step, geometry.name)
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


def _told(step: Step, name: str, line: str) -> None:
    """Report a step; of a chart that was not asked for, say why it is built."""
    what, colon, stage = line.partition(": ")
    step(f"{what} (checks the geometry that all charts share){colon}{stage}" if what == name else line)


def print_package(
    charts: Sequence[Chart], target: Target, progress: Progress = silent, tested: bool = True
) -> Package:
    """Prove, lower and print charts, with their tests if ``tested``, without checking."""
    with progress(2 * len(charts)) as report:
        lowered = map(lower, map(prove, announced(charts, "proving", report)))
        printed = (print_module(chart, target, tested) for chart in announced(lowered, "printing", report))
        return Package(shared_texts(target), tuple(printed))


def print_module(lowered: Lowered, target: Target, tested: bool = True) -> Module:
    return Module(target.file(lowered.name), lowered.proved, module_texts(Facts(lowered), target, tested))


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


def generate(
    orders: Iterable[int] | None = None,
    target: str = "numpy",
    output: str | Path | None = None,
    *,
    families: Iterable[str] = (),
    phi: str | None = None,
    name: str | None = None,
    force: bool = False,
    progress: Step | None = None,
    processes: int = 1,
) -> Package:
    """Write proven kernels of some charts into a folder, as a package that needs NumPy only.

    Parameters
    ----------
    orders : iterable of int, optional
        Orders n >= 1 of Cayley maps. Without orders, families and φ, the committed charts are written.
    target : str
        A key of `derive.codegen.targets.TARGETS`: ``"numpy"``, ``"c"``, ``"matlab"`` and so on.
    output : path, optional
        Folder of the package, made if missing. ``"numpy"`` has the default ``generated/dualcay`` of a checkout.
    families : iterable of str
        Names of parameterizations, such as ``"lambert"`` or ``"sine7"``.
    phi : str, optional
        Formula φ of a user's chart, such as ``"alpha/(1 + alpha**2/40)"``; the order is then the value of n in it.
    name : str, optional
        Name of the module of φ.
    force : bool
        Overwrite files that do not bear the generated header.
    progress : callable, optional
        Called with a line of text before each step. Without one, a terminal or a notebook shows a progress bar after
        two seconds.
    processes : int
        Number of processes that check printed charts, this one included. Others are spawned: a script that asks for
        more than one must call `generate` under ``if __name__ == "__main__":``.

    Returns
    -------
    Package
        Texts and proofs of the written modules.

    Raises
    ------
    ValueError, TypeError
        For a target, an order or a family that does not exist, or a missing folder where no default applies.
    ProofFailed, ValidationFailed, ChildProcessError
        If a formula or a printed kernel fails, or a worker process dies; nothing is written.
    RefusedError
        If an existing file is not generated, the folder holds another target, or a file cannot be written.

    Examples
    --------
    >>> import derive, tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     package = derive.generate([1], output=f"{folder}/kernels")
    >>> [module.name for module in package.modules]
    ['cayley1.py']
    """
    shown = bar if progress is None else lambda _: nullcontext(progress)
    asked = catalogue.charts(orders or (), families, phi, name) or catalogue.committed()
    return generate_charts(asked, target, output, force, shown, processes)


def generate_charts(
    charts: Sequence[Chart],
    target: str = "numpy",
    output: str | Path | None = None,
    force: bool = False,
    progress: Progress = bar,
    processes: int = 1,
) -> Package:
    """Write proven kernels of charts into a folder; `generate` describes the other parameters."""
    chosen, folder = _target(target), place(output, target)
    wanted = _with_bases(charts, chosen)
    for chart in wanted:
        chart.require_kernels()
    entry = notices(wanted, chosen)
    modules = (chosen.file(chart.name, table) for table in chosen.tables for chart in wanted)
    names = (*chosen.shared(), *chosen.index(()), *modules)
    files.refuse(folder, dict.fromkeys(names, "") | entry, force)  # before the long work
    built = build(wanted, chosen, progress, processes)
    package = indexed(built, chosen, wanted, catalogue.charts_in(folder, chosen))
    files.write(folder, package.texts, force, entry)
    return package


def place(output: str | Path | None, target: str) -> Path:
    """Return the folder to write, by default that of the committed kernels; raise ValueError if there is none."""
    if output:
        return Path(output)
    if (root := about.checkout()) and target == about.TARGET:
        return root / "generated" / "dualcay"
    raise ValueError("name a folder (output=, -o): only NumPy kernels have a default one, and only in a checkout")


def check_charts(
    folder: Path, charts: Sequence[Chart], target: str, progress: Progress = silent, cap: int = about.MAX_ORDER
) -> list[files.Difference]:
    """Prove and print the expected files of a folder and return the differences; no kernel is executed.

    The folder should hold the modules of the charts. Each further module with the generated header is printed by its
    own command, unless its order is above ``cap``.
    """
    chosen = _target(target)
    wanted = {chart.name: chart for chart in _with_bases(charts, chosen)}
    further = [chart for chart in catalogue.charts_in(folder, chosen) if chart.name not in wanted]
    reason = f"is above the cap {cap}, so not compared; raise it with --max-n"
    above = ((c, table) for c in further if c.order > cap for table in chosen.tables)
    unmade = {chosen.file(c.name, table): f"order {c.order} {reason}" for c, table in above}
    made = [*wanted.values(), *(chart for chart in further if chart.order <= cap)]
    package = indexed(print_package(made, chosen, progress), chosen, made, further)
    return list(files.compare(folder, package.texts, unmade))


def indexed(package: Package, target: Target, *charts: Iterable[Chart]) -> Package:
    """Add the files that list the charts of a folder, those written and those there before."""
    names = {chart.name for group in charts for chart in group}
    return replace(package, shared={**package.shared, **index_texts(target, names)})


def _with_bases(charts: Iterable[Chart], target: Target) -> list[Chart]:
    """Return the charts, preceded by the base charts of multiples if their modules import them."""
    bases = [chart.base for chart in charts if chart.base] if target.imports_bases else []
    return list({chart.name: chart for chart in (*bases, *charts)}.values())


def _target(name: str) -> Target:
    if name not in TARGETS:
        raise ValueError(f"target must be one of {', '.join(TARGETS)}, got {name!r}")
    return TARGETS[name]
