"""The road from orders to files: prove, lower, print, put on disk, validate there, publish."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import partial
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
    compiled code: 0 where the target has none of its own, None where nothing could compile it.
    """

    name: str
    proved: Proved
    text: str
    companions: dict[str, str]
    validated: int
    replayed: int
    tested: int | None


@dataclass(frozen=True, slots=True)
class Package:
    """All files of a package of kernels, by name, and the modules among them."""

    texts: dict[str, str]
    modules: tuple[Module, ...]


def build(orders: Iterable[int], target: Target, progress: Progress | None = None) -> Package:
    """Prove, print and validate the modules of some orders, without touching any folder of the user's.

    Raises
    ------
    ProofFailed, ValidationFailed
        Nothing is returned unless every module passes both.
    """
    return build_charts([Cayley(n) for n in sorted(set(orders))], target, progress)


def build_charts(charts: Sequence[Chart], target: Target, progress: Progress | None = None) -> Package:
    """The same for any charts."""
    report = progress or (lambda line: None)
    texts = dict(shared_texts(target))
    with tempfile.TemporaryDirectory() as staging:
        files.write(Path(staging), texts)
        seen = Seen()
        modules = tuple(_module(chart, target, Path(staging), report, seen) for chart in charts)
    for module in modules:
        texts |= module.companions | {module.name: module.text}
    return Package(texts, modules)


def _module(chart: Chart, target: Target, staging: Path, report: Progress, seen: Seen) -> Module:
    """One module; what is the same in all of them is validated and replayed in the first that has it."""
    first = not seen.programs
    report(f"{chart.name}: proving")
    name, proved = module_name(chart, target), prove(chart)
    report(f"{chart.name}: emitting")
    facts = Facts(proved, lower(proved))
    text, companions = module_text(facts, target), companion_texts(chart, target)
    files.write(staging, companions | {name: text})
    report(f"{chart.name}: validating")
    validated = target.validate(staging, chart, partial(seen.new, facts.lowered))
    report(f"{chart.name}: replaying")
    replayed, tested = target.replay(staging, chart, first), target.test(staging, chart)
    return Module(name, proved, text, companions, validated, replayed, tested)


def generate(
    orders: Iterable[int] = catalogue.ORDERS,
    target: str = "numpy",
    output: str | Path | None = None,
    *,
    force: bool = False,
    progress: Progress | None = None,
) -> Package:
    """Write proven kernels of the given orders into a folder, as a package that needs NumPy only.

    Parameters
    ----------
    orders : iterable of int
        Orders n >= 1; the committed ones by default.
    target : str
        ``"numpy"``, ``"array-api"``, ``"numba"`` or ``"c"``.
    output : path, optional
        Folder of the package, made if missing; ``generated/dualcay`` of a checkout by default, for no other target.
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
        For a target or an order that does not exist; without a folder where none is the kernels' own, as where the
        toolkit is installed.
    ProofFailed, ValidationFailed
        If a formula or a printed kernel fails; nothing is written.
    RefusedError
        If a file in the way is not a generated one, the folder holds kernels of another target, or it cannot be
        written; nothing is written.
    """
    chosen, asked = _target(target), sorted(set(orders))
    if output is None and not catalogue.has_place(target):
        raise ValueError(f"name an output folder: only {catalogue.TARGET} kernels have a place, in a checkout")
    package = build(asked, chosen, progress)
    files.write(Path(output or catalogue.COMMITTED), package.texts, force, notices([Cayley(n) for n in asked], chosen))
    return package


def check(
    folder: Path,
    orders: Iterable[int] = catalogue.ORDERS,
    target: str = "numpy",
    progress: Progress | None = None,
    cap: int = catalogue.MAX_ORDER,
) -> list[files.Difference]:
    """Regenerate what a folder should hold and compare: files that are missing or stale, then what does not belong.

    It should hold the modules of the given orders (by default the committed ones), and every further module that bears
    our header is regenerated by the command in it, unless its order is above the cap.
    """
    chosen = _target(target)
    further = _orders_in(folder, chosen) - set(orders)
    unmade = {
        module_name(Cayley(n), chosen): f"order {n} is above the cap {cap}, so not compared; raise it with --max-n"
        for n in further
        if n > cap
    }
    package = build({n for n in further if n <= cap} | set(orders), chosen, progress)
    return list(files.compare(folder, package.texts, unmade))


def _orders_in(folder: Path, target: Target) -> set[int]:
    """Orders of the modules in a folder, by the commands in those that bear their own."""
    commands = {path.name: files.header_command(path) or "" for path in folder.glob(f"*.{target.extension}")}
    orders = {name: catalogue.order_of(command) for name, command in commands.items()}
    return {
        n
        for name, n in orders.items()
        if n and module_name(Cayley(n), target) == name and catalogue.command(target.name, Cayley(n)) == commands[name]
    }


def _target(name: str) -> Target:
    if name not in TARGETS:
        raise ValueError(f"target must be one of {', '.join(TARGETS)}, got {name!r}")
    return TARGETS[name]
