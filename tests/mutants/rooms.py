"""Rooms: where mutants are made, and which checks should kill them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Protocol

from . import road
from .checks import FEW, TEMPLATES, TESTS, Checks
from .mutant import Fate, Mutant
from .programs import Programs
from .python import Edit, python_mutants, same_code
from .statements import Statements
from .templates import template_mutants


class Room(Protocol):
    """Where mutants are made, and how one is tried, all of it inside a copy of the tree."""

    @property
    def name(self) -> str: ...
    @property
    def what(self) -> str:
        """What is mutated, and which checks should notice, for the report."""

    @property
    def unchanged(self) -> tuple[str, ...]:
        """Modules that, with all they import, no mutant changes."""

    @property
    def checks(self) -> Checks | None:
        """What has to look at the unchanged tree first; its tests decide, too."""

    def edit(self, mutant: Mutant) -> Edit | None:
        """What is changed on disk before the trial."""

    def mutants(self, folder: Path) -> Iterator[Mutant]:
        """All of them."""

    def is_one(self, mutant: Mutant) -> bool:
        """Whether a mutant is well formed and not the same code."""

    def limit(self, mutant: Mutant | None, knowledge: Any) -> float:
        """Seconds of processor time a trial may take."""

    def trial(self, mutant: Mutant | None, knowledge: Any, former: Fate | None = None) -> Fate:
        """What becomes of a mutant (None: of the unchanged tree), and what did in another tree."""


@dataclass(frozen=True)
class Files:
    """Mutants of files.

    Attributes
    ----------
    sources : tuple of str
        Folders whose files are mutated.
    apart : callable
        Names folders inside them that are left alone.
    """

    name: str
    what: str
    sources: tuple[str, ...]
    checks: Checks
    unchanged: tuple[str, ...] = ()
    apart: Callable[[], tuple[str, ...]] = tuple

    def again(self, tests: tuple[str, ...]) -> Files:
        """The same for mutants that survive all but these files of tests."""
        return replace(self, checks=self.checks.again(tests))

    def edit(self, mutant: Mutant) -> Edit | None:
        return mutant.site  # type: ignore[no-any-return]

    def mutants(self, folder: Path) -> Iterator[Mutant]:
        apart = self.apart()
        for source in self.sources:
            for path in sorted((folder / source).rglob("*")):
                name = str(path.relative_to(folder))
                if not name.startswith(apart):
                    if path.suffix == ".py":
                        yield from python_mutants(name, path.read_text(encoding="utf-8"))
                    elif path.suffix == ".j2":
                        yield from template_mutants(name, path.read_text(encoding="utf-8"))

    def is_one(self, mutant: Mutant) -> bool:
        before = Path(mutant.site.path).read_bytes()
        after = mutant.site.apply(before)
        if not mutant.site.path.endswith(".py"):
            return bool(before != after)
        try:
            return not same_code(before.decode(), after.decode())
        except SyntaxError:
            return False

    def limit(self, mutant: Mutant | None, knowledge: Any) -> float:
        return 20 + 2 * float(knowledge.processor(mutant.site if mutant else None))

    def trial(self, mutant: Mutant | None, knowledge: Any, former: Fate | None = None) -> Fate:
        return self.checks.fate(mutant.site if mutant else None, knowledge, former)


NUMBERS = "tests/derive/papers/test_theorem_numbers.py"
PROOF = Checks("proof", ("derive/proof",), ("tests/derive/proof", NUMBERS), ("proof", TESTS), controlled=True)
MAPS = Checks("maps", ("derive/maps",), ("tests/derive/maps", NUMBERS), ("proof", TESTS, "validation"))
REPORT = "derive/papers/report/test_report.py"
EMISSION = Checks(
    "emission",
    ("derive/codegen", "derive/output", TEMPLATES),
    tuple(f"tests/{name}" for name in ("derive/codegen", "derive/output", "derive/cli", "targets", REPORT)),
    ("validation", TESTS),
    emits=True,
    few=FEW,
)
VALIDATION = ("derive/codegen/cases", "derive/codegen/validation")
PAPERS = Checks(
    "papers", ("derive/papers",), ("tests/derive/papers", "tests/derive/cli/test_verify.py"), ("execution", TESTS)
)

ROOMS: Mapping[str, Room] = {
    room.name: room
    for room in (
        Programs(),
        Files(
            "proof",
            "derive/proof: by the proofs of the committed orders, then by tests/derive/proof and of equation numbers",
            ("derive/proof",),
            PROOF,
            ("derive.maps", "derive.output"),
        ),
        Files(
            "maps",
            "derive/maps: by proofs of committed orders, by tests/derive/maps and of equation numbers, then by NumPy "
            "kernels of some charts",
            ("derive/maps",),
            MAPS,
            ("derive.algebra", "derive.output"),
        ),
        Files(
            "codegen",
            "derive/codegen but for its checks, derive/output: by emission with validation, then by their tests and "
            "those of kernels",
            ("derive/codegen", "derive/output"),
            EMISSION,
            ("derive.proof",),
            lambda: VALIDATION,
        ),
        Files(
            "validation",
            "cases and checks of emission: by finding fault with what is right, or by tests",
            VALIDATION,
            EMISSION,
            ("derive.proof",),
        ),
        Files(
            "templates",
            "templates: by emission with validation, then by tests of codegen, of the report, and of kernels",
            ("templates",),
            EMISSION,
            ("derive.codegen",),
        ),
        Statements(),
        Files(
            "papers",
            "derive/papers but for the statements: by deciding every entry, then by tests/derive/papers",
            ("derive/papers",),
            PAPERS,
            ("derive.proof", "derive.output"),
            road.statement_folders,
        ),
    )
}
