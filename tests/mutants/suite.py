"""Tests of some folders, run inside this process: chosen ones in a given order until one fails, or all, with times."""

from __future__ import annotations

import hashlib
import os
import signal
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from types import FrameType
from typing import Any

import pytest

from .reach import Reach

PATIENCE = 600
"""Seconds of processor time after which a fixture is given up."""

BORED = 40
"""The same of a watched test, which is much longer than one that may take part."""

QUIET = (
    "-q", "--tb=no", "-p", "no:cacheprovider", "-p", "no:terminalreporter", "-p", "no:unraisableexception",
    "--hypothesis-profile=ci", "-W", "ignore::pytest.PytestAssertRewriteWarning",
)  # fmt: skip


def processor() -> float:
    """Seconds of processor time, of ended children too."""
    return sum(os.times()[:4])


@dataclass(eq=False)
class Times:
    """Seconds of processor time of each test, those of the longest of its fixtures apart, all setups, what failed."""

    seconds: dict[str, float] = field(default_factory=dict)
    fixtures: dict[str, float] = field(default_factory=dict)
    failed: list[str] = field(default_factory=list)
    setups: float = 0.0

    def longer(self, limit: float, fixture: float) -> list[str]:
        """Tests that take longer than a limit, or have a fixture that takes longer than another."""
        return sorted(name for name in self.seconds if self.seconds[name] > limit or self.fixtures[name] > fixture)

    def without(self, names: set[str]) -> dict[str, float]:
        """The other tests, quick ones first."""
        ranked = sorted(self.seconds.items(), key=lambda item: (round(item[1], 1), item[0]))
        return {name: seconds for name, seconds in ranked if name not in names}


class _Verdicts(Times):
    """Filled in by a run."""

    def __init__(self) -> None:
        super().__init__()
        self._longest: dict[str, float] = {}

    @pytest.hookimpl(wrapper=True, tryfirst=True)
    def pytest_runtest_setup(self) -> Iterator[None]:
        started = processor()
        try:
            return (yield)
        finally:
            self.setups += processor() - started

    @pytest.hookimpl(wrapper=True, tryfirst=True)
    def pytest_fixture_setup(self, fixturedef: Any) -> Iterator[None]:
        started, name = processor(), fixturedef.argname
        try:
            return (yield)
        finally:
            self._longest[name] = max(self._longest.get(name, 0.0), processor() - started)

    @pytest.hookimpl(wrapper=True, tryfirst=True)
    def pytest_runtest_call(self, item: pytest.Item) -> Iterator[None]:
        started = processor()
        try:
            return (yield)
        finally:
            self.seconds[item.nodeid] = processor() - started
            names = getattr(item, "fixturenames", ())
            self.fixtures[item.nodeid] = max((self._longest.get(name, 0.0) for name in names), default=0.0)

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        if report.failed and report.nodeid not in self.failed:
            self.failed.append(report.nodeid)

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        if report.failed:
            self.failed.append(f"{report.nodeid} cannot be imported")


class _Chosen:
    """Tests in a given order; all others are left out."""

    def __init__(self, names: Sequence[str]) -> None:
        self.rank = {name: rank for rank, name in enumerate(names)}

    @pytest.hookimpl(trylast=True)
    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        items[:] = sorted((i for i in items if i.nodeid in self.rank), key=lambda item: self.rank[item.nodeid])


class _Few:
    """Of each test function a few cases, drawn by their names."""

    def __init__(self, count: int) -> None:
        self.count = count

    @pytest.hookimpl(trylast=True)
    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        functions: dict[str, list[pytest.Item]] = {}
        for item in items:
            functions.setdefault(item.nodeid.partition("[")[0], []).append(item)
        drawn = {
            item.nodeid
            for cases in functions.values()
            for item in sorted(cases, key=lambda case: hashlib.sha256(case.nodeid.encode()).digest())[: self.count]
        }
        items[:] = [item for item in items if item.nodeid in drawn]


class _Recorded:
    """Tells what each test reaches: its own lines, and those of its fixtures."""

    def __init__(self, reach: Reach) -> None:
        self.reach = reach

    @pytest.hookimpl(wrapper=True)
    def pytest_fixture_setup(self, fixturedef: Any) -> Iterator[None]:
        with self.reach.by(f"fixture {fixturedef.argname}"), limited(PATIENCE):
            return (yield)

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[None]:
        fixtures = getattr(item, "fixturenames", ())
        with self.reach.by(item.nodeid, *(f"fixture {name}" for name in fixtures)):
            return (yield)

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_call(self) -> Iterator[None]:
        with limited(BORED):
            return (yield)


class limited:
    """Raises where it stands after so many seconds of processor time; inside of another one, that goes on later."""

    def __init__(self, seconds: float) -> None:
        self.seconds = seconds

    def __enter__(self) -> None:
        self.before = signal.signal(signal.SIGPROF, self._late)
        self.left, _ = signal.setitimer(signal.ITIMER_PROF, self.seconds)

    def __exit__(self, *_: object) -> None:
        signal.signal(signal.SIGPROF, self.before)
        signal.setitimer(signal.ITIMER_PROF, self.left)

    def _late(self, number: int, frame: FrameType | None) -> None:
        raise TimeoutError(f"longer than {self.seconds} s")


def first_failure(names: Sequence[str]) -> str | None:
    """Run these tests in this order; the first that fails, None if all pass."""
    if not names:
        return None
    verdicts = _Verdicts()
    places = sorted({name.partition("::")[0] for name in names})
    code = pytest.main([*QUIET, "-x", *places], [verdicts, _Chosen(names)])
    if verdicts.failed:
        return verdicts.failed[0]
    return None if code == pytest.ExitCode.OK else f"pytest: {code!r}"


def run_all(folders: Sequence[str], reach: Reach | None = None, few: int | None = None) -> Times:
    """Run the tests of folders."""
    verdicts = _Verdicts()
    plugins: list[Any] = [verdicts, *([_Recorded(reach)] if reach else []), *([_Few(few)] if few else [])]
    present = [folder for folder in folders if Path(folder).exists()]
    if present:
        code = pytest.main([*QUIET, *present], plugins)
        if code not in (pytest.ExitCode.OK, pytest.ExitCode.TESTS_FAILED):
            raise RuntimeError(f"tests of {', '.join(present)} do not run: {code!r}, {verdicts.failed}")
    return Times(verdicts.seconds, verdicts.fixtures, verdicts.failed, verdicts.setups)
