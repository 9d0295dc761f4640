"""The road from orders to files: prove, lower, print, put on disk, validate there, publish."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from ..maps import Cayley
from ..maps.chart import Chart
from ..output import files
from ..proof import Proved, prove
from . import catalogue
from .facts import Facts
from .lowered import lower
from .module import companion_texts, module_name, module_text, notices, shared_texts
from .targets import TARGETS, Target
from .validation import Seen

Progress = Callable[[str], None]


@dataclass(frozen=True, slots=True)
class Module:
    """A kernel module on its way: proved, printed, and how many calls of it were compared with its formula.

    ``companions`` are further files by name. ``replayed`` counts the calls on floats that agree, ``tested`` those of
    compiled code: 0 where the target has none of its own, None where nothing could compile it. A module that is only
    to be compared with what is on disk is not executed, and all of them are 0.
    """

    name: str
    proved: Proved
    text: str
    companions: dict[str, str]
    validated: int = 0
    replayed: int = 0
    tested: int | None = 0

    def __repr__(self) -> str:
        return f"<Module {self.name}: {len(self.proved.proofs)} proofs, {self.validated} calls validated>"


@dataclass(frozen=True, slots=True)
class Package:
    """All files of a package of kernels, by name, and the modules among them."""

    texts: dict[str, str]
    modules: tuple[Module, ...]

    def __repr__(self) -> str:
        return f"<Package of {', '.join(module.name for module in self.modules)}: {len(self.texts)} files>"


def build(orders: Iterable[int], target: Target, progress: Progress | None = None) -> Package:
    """Prove, print and validate the modules of some orders, without touching any folder of the user's.

    Raises
    ------
    ProofFailed, ValidationFailed
        Nothing is returned unless every module passes both.
    """
    return build_charts([Cayley(n) for n in sorted(set(orders))], target, progress)


def build_charts(
    charts: Sequence[Chart], target: Target, progress: Progress | None = None, seen: Seen | None = None
) -> Package:
    """The same for any charts; ``seen`` is what has been shown of the geometry of the target, and grows."""
    report, seen = progress or _silent, Seen() if seen is None else seen
    shared = shared_texts(target)
    with tempfile.TemporaryDirectory() as staging:
        files.write(Path(staging), shared)
        modules = [_executed(_printed(chart, target, report), target, Path(staging), report, seen) for chart in charts]
    return _package(shared, modules)


def print_charts(charts: Sequence[Chart], target: Target, progress: Progress | None = None) -> Package:
    """Prove and print the modules of charts, and execute nothing: enough to tell whether files are what is printed."""
    return _package(shared_texts(target), [_printed(chart, target, progress or _silent) for chart in charts])


def _silent(line: str) -> None:
    """What no one is told."""


def _package(shared: Mapping[str, str], modules: Sequence[Module]) -> Package:
    texts = dict(shared)
    for module in modules:
        texts |= module.companions | {module.name: module.text}
    return Package(texts, tuple(modules))


def _printed(chart: Chart, target: Target, report: Progress) -> Module:
    report(f"{chart.name}: proving")
    name, proved = module_name(chart, target), prove(chart)
    report(f"{chart.name}: emitting")
    facts = Facts(proved, lower(proved))
    return Module(name, proved, module_text(facts, target), companion_texts(facts, target))


def _executed(module: Module, target: Target, staging: Path, report: Progress, seen: Seen) -> Module:
    """One module, put on disk; what is the same in all of them is validated and replayed in the first that has it."""
    chart, first = module.proved.formulas, not seen.by_table
    files.write(staging, module.companions | {module.name: module.text})
    report(f"{chart.name}: validating")
    validated = target.validate(staging, chart, seen.new)
    report(f"{chart.name}: replaying")
    replayed, tested = target.replay(staging, chart, first), target.test(staging, chart)
    return replace(module, validated=validated, replayed=replayed, tested=tested)


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

    Examples
    --------
    >>> import derive, tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     package = derive.generate([1], output=f"{folder}/kernels")
    >>> package
    <Package of cayley1.py: 17 files>
    """
    asked = catalogue.charts(orders or (), families, phi, name) or catalogue.committed()
    return generate_charts(asked, target, output, force=force, progress=progress)


def generate_charts(
    charts: Sequence[Chart],
    target: str = "numpy",
    output: str | Path | None = None,
    *,
    force: bool = False,
    progress: Progress | None = None,
) -> Package:
    """The same for charts as they are."""
    chosen = _target(target)
    if output is None and not catalogue.has_place(target):
        raise ValueError(f"name an output folder: only {catalogue.TARGET} kernels have a place, in a checkout")
    folder, entry = Path(output or catalogue.COMMITTED), notices(charts, chosen)
    files.refuse(folder, entry | {module_name(chart, chosen): "" for chart in charts}, force)  # before long work
    package = build_charts(charts, chosen, progress)
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
    chosen, wanted = _target(target), {chart.name: chart for chart in asked}
    further = {chart.name: chart for chart in _charts_in(folder, chosen) if chart.name not in wanted}
    above = [chart for chart in further.values() if chart.order > cap]
    reason = f"is above the cap {cap}, so not compared; raise it with --max-n"
    unmade = {module_name(chart, chosen): f"order {chart.order} {reason}" for chart in above}
    made = [*wanted.values(), *(chart for chart in further.values() if chart not in above)]
    package = print_charts(made, chosen, progress)
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
