"""Publish kernels into a folder, or compare a folder with the kernels that would be written."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from contextlib import nullcontext
from pathlib import Path

from .. import about
from ..maps.chart import Chart
from ..output import files
from ..output.shown import Progress, Step, bar, silent
from . import catalogue
from .build import build, print_package
from .package import Package, module_name, notices
from .rows import inside
from .targets import TARGETS, Target


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
        ``"numpy"``, ``"array-api"``, ``"numba"``, ``"c"`` or ``"native"``.
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
    modules = (inside(table, module_name(chart, chosen)) for table in chosen.tables for chart in wanted)
    files.refuse(folder, dict.fromkeys((*chosen.shared(), *modules), "") | entry, force)  # before the long work
    package = build(wanted, chosen, progress, processes)
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
    unmade = {module_name(c, chosen): f"order {c.order} {reason}" for c in further if c.order > cap}
    made = [*wanted.values(), *(chart for chart in further if chart.order <= cap)]
    return list(files.compare(folder, print_package(made, chosen, progress).texts, unmade))


def _with_bases(charts: Iterable[Chart], target: Target) -> list[Chart]:
    """Return the charts, preceded by the base charts of multiples if their modules import them."""
    bases = [chart.base for chart in charts if chart.base] if target.imports_bases else []
    return list({chart.name: chart for chart in (*bases, *charts)}.values())


def _target(name: str) -> Target:
    if name not in TARGETS:
        raise ValueError(f"target must be one of {', '.join(TARGETS)}, got {name!r}")
    return TARGETS[name]
