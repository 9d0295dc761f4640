"""The checks of a room: what they reach in the unchanged tree, and what they say of a change."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from . import road, suite
from .knowledge import Knowledge, NotControlled, Watched
from .mutant import EQUIVALENT, KILLED, PROSE, SURVIVED, Fate
from .python import Edit
from .reach import Reach
from .tree import Deciding, deciding, forget

KERNELS = ("tests/generated",)
FEW = 2
"""Cases of each test, where kernels are emitted."""

LONG, LONG_FIXTURE = 5.0, 30.0
"""Seconds of processor time: a longer test, or one with a longer fixture, is asked of what survives all else."""

TOO_LONG, TOO_LONG_FIXTURE = 40.0, 240.0
"""The same of what is left out of trials."""

SLOWER = 20.0
"""Seconds of processor time that a check which is no test may take more than it did while it was watched."""

TESTS = "tests"
LAST = "long tests"
TEMPLATES = "templates"
VALIDATING = "validating"
CONTROLLING = "controls of proofs"
COMMENT = {".py.j2": "# one more comment\n", ".h.j2": "// one more comment\n"}


@dataclass(frozen=True)
class Checks:
    """Stages, one of which are tests; inside a copy of the tree.

    Attributes
    ----------
    watched : tuple of str
        Folders whose lines are watched.
    tests : tuple of str
        Files and folders of tests.
    stages : tuple of str
        In their order: "tests", and what is no test, of those in `road`.
    emits : bool
        Whether what is watched decides what is emitted: survivors are compared by that, and the tests of kernels run
        on it.
    controlled : bool
        Whether what is watched also makes controls of proofs: survivors are compared by those.
    few : int, optional
        Cases of each test that are run; all by default.
    later : bool
        Whether these are files of tests that changed since a mutant survived all others.
    """

    name: str
    watched: tuple[str, ...]
    tests: tuple[str, ...]
    stages: tuple[str, ...] = (TESTS,)
    emits: bool = False
    controlled: bool = False
    few: int | None = None
    later: bool = False

    @property
    def deciding(self) -> Callable[[Path], Deciding]:
        """What decides, in a tree; tests of kernels decide all fates."""
        return lambda root: deciding(root, self.tests, KERNELS if self.emits else ())

    def again(self, tests: tuple[str, ...]) -> Checks:
        """The same for mutants that survive all but these files of tests."""
        name = f"{self.name}-again"
        return replace(self, name=name, tests=tests, stages=(TESTS,), emits=False, controlled=False, later=True)

    @property
    def looks(self) -> Mapping[str, Callable[[Path], Any]]:
        """What has to look at the unchanged tree, each in a process of its own; the longest first."""
        looks: dict[str, Callable[[Path], Any]] = {"watched": self._watched}
        if TEMPLATES in self.watched:
            looks["commented"] = self._commented
        if self.emits:
            looks |= {"kernels": lambda _: suite.run_all(KERNELS, few=FEW), "prints": lambda _: road.prints()}
        return looks

    def knowledge(self, found: Mapping[str, Any]) -> Knowledge:
        """What those have found, taken together."""
        watched: Watched = found["watched"]
        tests, kernels = watched.tests, found.get("kernels", suite.Times())
        too_long = [*tests.longer(TOO_LONG, TOO_LONG_FIXTURE), *kernels.longer(LONG, LONG_FIXTURE)]
        left_out = {
            "takes long": too_long,
            "fails unchanged": sorted({*tests.failed, *kernels.failed} - {*too_long}),
            "fails for one more comment in what is emitted": sorted({*found.get("commented", ())} - {*tests.failed}),
            "starts a program of its own": sorted(watched.starters),
        }
        out = {name for names in left_out.values() for name in names}
        long = {*tests.longer(LONG, LONG_FIXTURE)}
        quick, last = tests.without(out | long), tests.without(out | tests.seconds.keys() - long)
        seconds = {**watched.first, TESTS: quick, "kernels": kernels.without(out), LAST: last}
        if not (quick or last or self.later):
            raise NotControlled(f"no test of {', '.join(self.tests)} can be used: {left_out}")
        setups, apart = tests.setups + kernels.setups, (watched.printing, watched.controlling)
        return Knowledge(seconds, setups, watched.table, *apart, watched.controls, left_out, found.get("prints", {}))

    def _watched(self, folder: Path) -> Watched:
        """Run everything but the tests of kernels once, and watch."""
        reach = Reach(folder, [f"{source}/*" for source in self.watched])
        with reach.open():
            road.import_all()
            first = {stage: self._first_stage(stage, reach) for stage in self.stages if stage != TESTS}
            with reach.by(CONTROLLING):
                controls = road.controls() if self.controlled else ()
            tests = suite.run_all(self.tests, reach, few=self.few)
        table = reach.table([name for stage in (*first.values(), tests.seconds) for name in stage])
        apart = _apart(reach, set().union(*first.values()))
        return Watched(first, tests, table, *apart, controls, frozenset(reach.starters & tests.seconds.keys()))

    def _first_stage(self, stage: str, reach: Reach) -> dict[str, float]:
        def around(name: str, validate: Any) -> Any:
            def watched(*arguments: Any) -> Any:
                with reach.by(f"{VALIDATING} {name}"):
                    return validate(*arguments)

            return watched

        checks = road.first_stage(stage, self.emits, around)
        return {name: _timed(reach, name, check) for name, check in checks.items()}

    def _commented(self, folder: Path) -> list[str]:
        """Tests that fail for one more comment in every template: they would kill whatever changes a byte."""
        before = {}
        for path in sorted((folder / TEMPLATES).rglob("*.j2")):
            if comment := COMMENT.get("".join(path.suffixes[-2:])):
                before[path] = path.read_bytes()
                path.write_bytes(before[path] + comment.encode())
        try:
            return suite.run_all(self.tests, few=self.few).failed
        finally:
            for path, content in before.items():
                path.write_bytes(content)

    def fate(self, edit: Edit | None, knowledge: Knowledge, former: Fate | None = None) -> Fate:
        """What becomes of an edit (None: of the unchanged tree); what killed it in another tree is asked first."""
        plan = knowledge.plan(edit)
        if former and (by := self._asked_again(former, plan, knowledge)):
            return Fate(KILLED, former.stage, by)
        emitted = _Emitted(knowledge, edit) if self.emits else None
        for stage in self.stages:
            if stage == TESTS and emitted and emitted.differs == "text":
                return Fate(PROSE, by="what is emitted is the same but for comments, layout and names of variables")
            if by := self._first_failure(stage, plan[stage], knowledge, emitted):
                return Fate(KILLED, stage, by)
        if edit and knowledge.controls_only(edit) and _controls() == knowledge.controls:
            return Fate(EQUIVALENT, by="another control of the same theorem, which fails as well")
        if edit and emitted and emitted.prints_only and not emitted.differs:
            return Fate(EQUIVALENT, by="every emitted text is the same")
        if emitted and (edit is None or (emitted.differs and road.write_kernels(Path("generated", "dualcay")))):
            forget("dualcay")
            if by := suite.first_failure(plan["kernels"]):
                return Fate(KILLED, "kernels", by)
        if by := suite.first_failure(plan[LAST]):
            return Fate(KILLED, TESTS, by)
        return Fate(SURVIVED)

    def _asked_again(self, former: Fate, plan: Mapping[str, Sequence[str]], knowledge: Knowledge) -> str | None:
        """What a check says that killed the same mutant before; None if it is not among those that reach it now."""
        planned = (*plan.get(former.stage, ()), *(plan[LAST] if former.stage == TESTS else ()))
        names = [name for name in planned if f"{former.by}: ".startswith(f"{name}: ")]
        return self._first_failure(former.stage, names, knowledge) if former.stage in self.stages else None

    def _first_failure(
        self, stage: str, names: Sequence[str], knowledge: Knowledge, emitted: _Emitted | None = None
    ) -> str | None:
        if stage == TESTS:
            return suite.first_failure(names)
        limits = {name: SLOWER + knowledge.seconds[stage][name] for name in names}
        return _first_error(stage, limits, self.emits, emitted)


class _Emitted:
    """What is emitted with an edit; the same as without it needs no validation, if the edit is in what makes texts."""

    def __init__(self, knowledge: Knowledge, edit: Edit | None) -> None:
        self.prints_only = edit is not None and knowledge.prints_only(edit)
        self.differs = ""
        self._known = knowledge.prints

    def is_known(self, name: str) -> bool:
        """Whether the code that a check validates is that of the unchanged tree, and so is the validation."""
        found = road.difference(name, self._known)
        self.differs = max(self.differs, found, key=road.DIFFERENCES.index)
        return self.prints_only and found != "code"


def _timed(reach: Reach, name: str, check: road.Check) -> float:
    started = suite.processor()
    with reach.by(name, f"{VALIDATING} {name}"):
        check()
    return suite.processor() - started


def _apart(reach: Reach, builds: set[str]) -> tuple[frozenset[tuple[str, int]], frozenset[tuple[str, int]]]:
    """Lines that run when texts are made, and not when they are validated; those that run for controls alone.

    Neither run while modules are imported.
    """
    inside = {place: names for place, names in reach.contexts().items() if "" not in names}
    validating = {place for place, names in inside.items() if any(name.startswith(VALIDATING) for name in names)}
    building = {place for place, names in inside.items() if names & builds}
    controlling = {place for place, names in inside.items() if CONTROLLING in names}
    return frozenset(building - validating), frozenset(controlling - building)


def _controls() -> Sequence[str]:
    try:
        return road.controls()
    except Exception:
        return ()


def _first_error(
    stage: str, limits: Mapping[str, float], everything: bool, emitted: _Emitted | None = None
) -> str | None:
    """The first of these checks that fails, or takes longer than it may, and is not known to pass."""
    if not limits:
        return None
    try:
        checks = road.first_stage(stage, everything)
    except Exception as error:
        return f"import: {type(error).__name__}"
    for name, limit in limits.items():
        try:
            with suite.limited(limit):
                if not (emitted and emitted.is_known(name)):
                    checks[name]()
        except Exception as error:
            return f"{name}: {type(error).__name__}"
    return None
