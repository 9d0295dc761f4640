"""The road from orders to files: prove, lower, print, put on disk, validate there, publish."""

from __future__ import annotations

import gc
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any, cast

from ..maps import Cayley
from ..maps.chart import Chart
from ..output import files
from ..proof import prove
from ..workers import each
from . import catalogue
from .facts import Facts
from .lowered import lower
from .module import companion_texts, module_name, module_text, notices, shared_texts
from .package import Counts, Module, Package
from .targets import TARGETS, Target

GC_THRESHOLD = 20_000
"""New objects after which Python looks for unreachable cycles."""

GEOMETRY_ORDERS = range(3, 9)
"""Orders that may show the shared geometry: below, some scalars are simpler; above, exact elements take long."""

Progress = Callable[[str], None]


def build(orders: Iterable[int], target: Target, progress: Progress | None = None) -> Package:
    """Prove, print and validate the modules of some orders, without touching any folder of the user's.

    Raises
    ------
    ProofFailed, ValidationFailed
        Nothing is returned unless every module passes both.
    """
    return build_charts([Cayley(n) for n in sorted(set(orders))], target, progress)


def build_charts(
    charts: Sequence[Chart], target: Target, progress: Progress | None = None, processes: int = 1
) -> Package:
    """Prove, print and execute the modules of any charts, in so many processes besides this one, or in this one alone.

    The shared geometry is validated and replayed once, in one of the charts or else in the Cayley map of order 3. Every
    other chart is executed as far as it is its own.
    """
    if processes < 1:
        raise ValueError(f"processes must be an integer >= 1, got {processes}")
    report, several = progress or _silent, min(processes, len(charts))
    with relaxed_gc(), tempfile.TemporaryDirectory() as folder:
        shared = shared_texts(target)
        staging = Path(folder)
        files.write(staging, shared)
        first = geometry_chart(charts)
        shown = [] if first in charts else [first]
        modules: list[Module] = []

        def calls() -> Iterator[tuple[Chart, Target, Path, bool]]:
            for chart in (*shown, *charts):
                told = _silent if chart in shown else report
                modules.append(_printed(chart, target, told))
                files.write(staging, modules[-1].texts)
                told(f"{chart.name}: validating")
                yield without_caches(chart), target, staging, chart == first

        executed: list[Module] = []
        for counts in each(_execute, calls(), several):
            executed.append(modules[len(executed)].counted(counts))
            if len(executed) > len(shown):
                report(f"{executed[-1].proved.formulas.name}: replayed")
    return Package.of(shared, executed[len(shown) :])


def print_charts(charts: Sequence[Chart], target: Target, progress: Progress | None = None) -> Package:
    """Prove and print the modules of charts, and execute nothing: enough to tell whether files are what is printed."""
    printed = [_printed(chart, target, progress or _silent) for chart in charts]
    return Package.of(shared_texts(target), printed)


def _silent(line: str) -> None:
    """What no one is told."""


def _printed(chart: Chart, target: Target, report: Progress) -> Module:
    report(f"{chart.name}: proving")
    name, proved = module_name(chart, target), prove(chart)
    report(f"{chart.name}: emitting")
    facts = Facts(proved, lower(proved))
    return Module(name, proved, module_text(facts, target), companion_texts(facts, target))


def without_caches(chart: Chart) -> Chart:
    """Return the same chart with nothing computed yet: cached functions cannot be sent to another process."""
    return cast(Chart, replace(cast(Any, chart)))


def geometry_chart(charts: Iterable[Chart]) -> Chart:
    """Return the chart that shows the shared geometry."""
    fit = (chart for chart in charts if chart.cayley and chart.order in GEOMETRY_ORDERS)
    return min(fit, key=lambda chart: chart.order, default=Cayley(3))


def _execute(chart: Chart, target: Target, staging: Path, geometry: bool) -> Counts:
    """Validate, replay and test one module, with the geometry that all charts share or without."""
    with relaxed_gc():
        validated = target.validate(staging, chart, geometry)
        return validated, target.replay(staging, chart, geometry), target.test(staging, chart)


@contextmanager
def relaxed_gc() -> Iterator[None]:
    """Look for unreachable cycles less often: of millions of objects hardly one is part of one."""
    first, *others = gc.get_threshold()
    gc.set_threshold(max(first, GC_THRESHOLD) if first else 0, *others)  # 0 is never
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
    progress: Progress | None = None,
    processes: int = 1,
) -> Package:
    """Write proven kernels of some charts into a folder, as a package that needs NumPy only.

    Parameters
    ----------
    orders : iterable of int, optional
        Orders n >= 1 of Cayley maps. Without orders and families, the committed charts.
    target : str
        ``"numpy"``, ``"array-api"``, ``"numba"``, ``"c"`` or ``"native"``.
    output : path, optional
        Folder of the package, made if missing; ``generated/dualcay`` of a checkout by default, for no other target.
    families : iterable of str
        Names of parameterizations, such as ``"lambert"`` or ``"sine7"``.
    phi : str, optional
        A further one, ``"alpha/(1 + alpha**2/40)"``; then an order is the n in it.
    name : str, optional
        The name of its module.
    force : bool
        Overwrite files which do not bear the generated header.
    progress : callable, optional
        Called with a line of text before each stage.
    processes : int
        How many processes execute what was printed, several charts at once; the result is the same. They are spawned:
        a script that asks for more than one does it under ``if __name__ == "__main__":``.

    Returns
    -------
    Package
        Texts and proofs of what was written.

    Raises
    ------
    ValueError, TypeError
        For a target, an order or a family that does not exist; without a folder where none is the kernels' own, as
        where the toolkit is installed.
    ProofFailed, ValidationFailed
        If a formula or a printed kernel fails; nothing is written.
    RefusedError
        If a file in the way is not a generated one, the folder holds kernels of another target, or it cannot be
        written; nothing is written.
    ChildProcessError
        If one of several processes dies; nothing is written.

    Examples
    --------
    >>> import derive, tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     package = derive.generate([1], output=f"{folder}/kernels")
    >>> package
    <Package of cayley1.py: 18 files>
    """
    asked = catalogue.charts(orders or (), families, phi, name) or catalogue.committed()
    return generate_charts(asked, target, output, force=force, progress=progress, processes=processes)


def generate_charts(
    charts: Sequence[Chart],
    target: str = "numpy",
    output: str | Path | None = None,
    *,
    force: bool = False,
    progress: Progress | None = None,
    processes: int = 1,
) -> Package:
    """The same for charts as they are."""
    chosen = _target(target)
    if output is None and not catalogue.has_place(target):
        raise ValueError(f"name an output folder: only {catalogue.TARGET} kernels have a place, in a checkout")
    folder, entry = Path(output or catalogue.COMMITTED), notices(charts, chosen)
    files.refuse(folder, entry | {module_name(chart, chosen): "" for chart in charts}, force)  # before long work
    package = build_charts(charts, chosen, progress, processes=processes)
    files.write(folder, package.texts, force, entry)
    return package


def check(
    folder: Path,
    orders: Iterable[int] | None = None,
    target: str = "numpy",
    progress: Progress | None = None,
    cap: int = catalogue.MAX_ORDER,
    *,
    families: Iterable[str] = (),
    phi: str | None = None,
    name: str | None = None,
) -> list[files.Difference]:
    """Print again what a folder should hold and compare: files that are missing or stale, then what does not belong.

    Formulas are proved again; no text is executed, since each was before it was written, and one that differs is stale.
    It should hold the modules of the given orders and families (by default the committed ones), and every further
    module that bears our header is printed by the command in it, unless its order is above the cap.
    """
    asked = catalogue.charts(orders or (), families, phi, name) or catalogue.committed()
    return check_charts(folder, *expected(folder, asked, target, cap), target, progress)


def expected(
    folder: Path, asked: Iterable[Chart], target: str, cap: int = catalogue.MAX_ORDER
) -> tuple[list[Chart], dict[str, str]]:
    """The charts whose modules a folder should hold, and by file name why others are not printed."""
    chosen, wanted = _target(target), {chart.name: chart for chart in asked}
    further = {chart.name: chart for chart in _charts_in(folder, chosen) if chart.name not in wanted}
    above = [chart for chart in further.values() if chart.order > cap]
    reason = f"is above the cap {cap}, so not compared; raise it with --max-n"
    unmade = {module_name(chart, chosen): f"order {chart.order} {reason}" for chart in above}
    return [*wanted.values(), *(chart for chart in further.values() if chart not in above)], unmade


def check_charts(
    folder: Path, charts: Sequence[Chart], unmade: Mapping[str, str], target: str, progress: Progress | None = None
) -> list[files.Difference]:
    """The same for charts as they are, and reasons why a file is none of theirs."""
    package = print_charts(charts, _target(target), progress)
    return list(files.compare(folder, package.texts, unmade))


def _charts_in(folder: Path, target: Target) -> Iterator[Chart]:
    """The charts of the modules in a folder, by the commands in those that bear their own."""
    for path in sorted(folder.glob(f"*.{target.extension}")):
        command = files.header_command(path) or ""
        chart = catalogue.chart_of(command)
        if chart and module_name(chart, target) == path.name and catalogue.command(target.name, chart) == command:
            yield chart


def _target(name: str) -> Target:
    if name not in TARGETS:
        raise ValueError(f"target must be one of {', '.join(TARGETS)}, got {name!r}")
    return TARGETS[name]
