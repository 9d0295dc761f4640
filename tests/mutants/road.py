"""What the road from formula to file says of itself: proofs, and the validation of what is emitted.

This module alone knows how the toolkit is called; it is imported inside a copy of the tree only.
"""

from __future__ import annotations

import hashlib
import importlib
import pkgutil
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from tests.support.packages import EXECUTED, Otherwise, unvalidated

from .texts import code

Check = Callable[[], object]
"""Raises where something is wrong."""

Around = Callable[[str, Any], Any]

ERRATA = "docs/errata.md"

Which = int | str
"""A chart: the order of a Cayley map, or the name of another one."""

COMMITTED = (3, 2, 4, 1, 5, 8)
GEOMETRY = (3, 4, 2, 1)
"""Orders with which what all charts share is tried."""

ORDERS = (*GEOMETRY, 16)
"""Orders of NumPy kernels: one more, for which programs are made in another way."""

FEW = (3,)
"""Orders of the other targets."""

Prints = Mapping[str, tuple[str, str]]
DIFFERENCES = ("", "text", "code")
"""Of what is emitted: none, in comments, docstrings, layout and names of variables only, any."""

FURTHER = {"further": "alpha/(1 + alpha**2/40)"}
"""Charts of φ without a name of their own, as users bring them: what their modules are called, and φ."""


def import_all() -> None:
    """Import every module of the toolkit, so that nothing is imported inside of a check."""
    derive = importlib.import_module("derive")
    for module in pkgutil.walk_packages(derive.__path__, "derive."):
        if not module.name.endswith("__main__"):
            importlib.import_module(module.name)


def warm(modules: Sequence[str]) -> None:
    """Import these and decide the theorems for every order, so that no trial has to."""
    for name in modules:
        importlib.import_module(name)
    if "derive.proof" in sys.modules:
        importlib.import_module("derive.proof").theorems()


def chart(which: Which) -> Any:
    """The chart of an order or a name."""
    charts = importlib.import_module("derive.codegen.catalogue").charts
    if isinstance(which, int):
        return charts([which])[0]
    return charts(phi=FURTHER[which], name=which)[0] if which in FURTHER else charts((), [which])[0]


def label(which: Which) -> str:
    """What it is called."""
    return f"n = {which}" if isinstance(which, int) else which


def families() -> tuple[str, ...]:
    """The charts with names that are no Cayley maps, committed ones first."""
    about, named = (importlib.import_module(f"derive.{name}") for name in ("about", "maps.named"))
    return tuple(dict.fromkeys((*about.FAMILIES, *named.SINGLE)))


def kinds() -> list[str]:
    """One of each kind of these."""
    return list({type(chart(name)): name for name in reversed(families())}.values())


def proofs() -> dict[str, Check]:
    """Proofs of the committed charts, and of the others that have a name."""
    prove = importlib.import_module("derive.proof").prove
    return {
        f"proof of {label(which)}": lambda which=which: prove(chart(which))  # type: ignore[misc]
        for which in (*COMMITTED, *families())
    }


def controls() -> list[str]:
    """What the controls of all theorems are of; every one must fail, for a reason."""
    command, identity = (importlib.import_module(f"derive.proof.{name}") for name in ("__main__", "identity"))
    theorems = command.claims()
    known = {proof.name: proof for proof in command.decided(theorems)}
    found = [*command.controls(theorems, known), *command.controlled_at(command.SHOWN)]
    for control in found:
        if control.proof.proved or any(residue.label == identity.NO_VALUE for residue in control.proof.residues):
            raise AssertionError(f"not noticed: {control}")
    return sorted(f"{control.theorem} [{control.proof.scope}]" for control in found)


def validations(everything: bool, around: Around) -> dict[str, Check]:
    """Emission with validation, of everything or of some NumPy kernels.

    ``around`` is put between the road and the execution that ends it.
    """

    def check(name: str, target: Any, which: Which) -> Check:
        watched = Otherwise(target, **{part: around(name, getattr(target, part)) for part in EXECUTED})
        return lambda: build(which, watched)

    return {name: check(name, targets()[target], which) for name, (target, which) in emissions(everything).items()}


def emissions(everything: bool = True) -> dict[str, tuple[str, Which]]:
    """What is emitted, target and chart, by the name of its validation: everything, or some NumPy kernels.

    Charts that differ most come first.
    """
    charts: Mapping[str, Sequence[Which]] = dict.fromkeys(targets(), FEW) if everything else {}
    orders, others = (ORDERS, ()) if everything else (GEOMETRY, (*FURTHER, *kinds(), *families()))
    numpy = dict.fromkeys((orders[0], *others, *kinds(), *orders[1:]))
    return {
        f"{target}, {label(which)}": (target, which)
        for target, found in {**charts, "numpy": tuple(numpy)}.items()
        for which in found
    }


def first_stage(
    stage: str, everything: bool = True, around: Around = lambda name, validate: validate
) -> dict[str, Check]:
    """Checks of a stage that are no tests: "proof", "execution", "validation" of everything or some NumPy kernels."""
    if stage == "execution":
        return executions()
    return proofs() if stage == "proof" else validations(everything, around)


def executions() -> dict[str, Check]:
    """Every entry of the papers decided again: the page of errata must say the same of it."""
    papers, decide, report = (importlib.import_module(f"derive.papers{name}") for name in ("", ".decide", ".report"))
    page = Path(ERRATA).read_text(encoding="utf-8")

    def check(paper: Any, entry: Any) -> None:
        result = decide.decide(paper.slug, entry, paper.lost)
        text = report.FORMATS["markdown"](report.Report.of([paper], [result], (), ".."))
        if text[text.index("\n#### ") :].strip() not in page:
            raise AssertionError(f"{paper.short} {entry.number} is decided otherwise")

    return {
        f"{paper.short} {entry.number}": lambda paper=paper, entry=entry: check(paper, entry)  # type: ignore[misc]
        for paper in papers.PAPERS
        for entry in paper.entries()
    }


def statement_folders() -> tuple[str, ...]:
    """The packages that hold the papers' statements."""
    papers = importlib.import_module("derive.papers").PAPERS
    return tuple("/".join(paper.package.split(".")[:3]) + "/" for paper in papers)


def targets() -> Mapping[str, Any]:
    """Every target, NumPy first and C last, which has to compile."""
    found = importlib.import_module("derive.codegen.targets").TARGETS
    return {name: found[name] for name in sorted(found, key=lambda name: (name == "c", name != "numpy"))}


def build(which: Which, target: Any) -> Any:
    """Everything that is emitted for a chart."""
    return importlib.import_module("derive.codegen.build").build([chart(which)], target)


def programs() -> Iterator[tuple[Which | None, str, Any]]:
    """Every program of the NumPy target: its chart (None: of the geometry), what prints it, and itself."""
    lowered = importlib.import_module("derive.codegen.lowered")
    yield from ((None, "two_forms", program) for program in lowered.geometry().values())
    for which in (*sorted(COMMITTED), *families()):
        found = lowered.lower_chart(chart(which))
        yield from ((which, "two_scalar_forms", program) for program in found.scalars.values())


@contextmanager
def printed_otherwise(
    printer: str, which: Which | None, name: str, change: Callable[[Any, Any], Any]
) -> Iterator[None]:
    """While it lasts, one program of the NumPy target is printed by ``change``, given the printer and the program."""
    module = importlib.import_module("derive.codegen.targets.numpy")
    shared = set(map(id, importlib.import_module("derive.codegen.lowered").geometry().values()))
    original = getattr(module, printer)

    def instead(program: Any) -> Any:
        meant = program.name == name and (id(program) in shared) == (which is None)
        return change(original, program) if meant else original(program)

    setattr(module, printer, instead)
    try:
        yield
    finally:
        setattr(module, printer, original)


def texts(name: str) -> Mapping[str, str]:
    """What the check of this name validates."""
    target, which = emissions()[name]
    return build(which, unvalidated(targets()[target])).texts  # type: ignore[no-any-return]


def prints() -> dict[str, Prints]:
    """By check: of every file it validates, a digest of its text and one of its code."""
    return {
        name: {file: (_digest(text), _digest(code(file, text))) for file, text in texts(name).items()}
        for name in emissions()
    }


def difference(name: str, expected: Mapping[str, Prints]) -> str:
    """How what a check validates differs from what was expected; one of `DIFFERENCES`."""
    emitted, before = texts(name), expected[name]
    if emitted.keys() != before.keys():
        return "code"
    others = {file: text for file, text in emitted.items() if _digest(text) != before[file][0]}
    if any(_digest(code(file, text)) != before[file][1] for file, text in others.items()):
        return "code"
    return "text" if others else ""


def _digest(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()


def write_kernels(folder: Path) -> bool:
    """Put what is emitted for NumPy where the committed kernels are; whether any of their code has changed."""
    target = unvalidated(targets()["numpy"])
    committed = (*sorted(COMMITTED), *importlib.import_module("derive.about").FAMILIES)
    emitted = {file: text for which in committed for file, text in build(which, target).texts.items()}
    changed = False
    for file, text in emitted.items():
        path = folder / file
        changed |= code(file, path.read_text(encoding="utf-8")) != code(file, text)
        path.write_text(text, encoding="utf-8")
    return changed
