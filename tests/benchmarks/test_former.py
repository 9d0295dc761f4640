"""Kernels against former ones: every function is compared, what is slower or calls more is named, drift cancels."""

from __future__ import annotations

import contextlib
import importlib
import os
import shutil
from pathlib import Path

import pytest

from benchmarks import former, timing
from benchmarks.former import Layout
from tests.support.kernels import load

SMALL = (Layout("rows", (64,), rows=True, gate=1.5, rounds=3), Layout("one", (), gate=1.5, rounds=3))

SLOWER = """
_once = quaternion


def quaternion(v, *, axis=-1, out=None):
    for _ in range(9):
        _once(v, axis=axis)
    return _once(v, axis=axis, out=out)
"""


@pytest.fixture(autouse=True)
def _short(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(former, "SECONDS", 1e-4)


class Clock:
    """Time that passes as the calls say, faster and faster."""

    def __init__(self) -> None:
        self.now = 0.0
        self.speed = 1.0
        self.called: list[str] = []

    def call(self, name: str, seconds: float) -> timing.Call:
        def run() -> None:
            self.called.append(name)
            self.now += seconds * self.speed
            self.speed *= 1.001

        return run


def test_paired_ratios_are_of_neighbours_and_drift_cancels(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = Clock()
    monkeypatch.setattr(timing, "process_time", lambda: clock.now)
    calls = clock.call("former", 1.0), clock.call("present", 1.2)
    assert timing.paired_ratio(*calls, count=100, seconds=0.5) == pytest.approx(1.2, abs=1e-5)
    assert clock.called[-4:] == ["former", "present", "present", "former"]
    assert clock.speed > 1.2


def test_the_process_is_on_one_core_only_while_it_measures(monkeypatch: pytest.MonkeyPatch) -> None:
    cores, during = {0, 2, 3}, []

    def move(_: int, chosen: set[int]) -> None:
        nonlocal cores
        cores = chosen

    monkeypatch.setattr(os, "sched_getaffinity", lambda _: cores, raising=False)
    monkeypatch.setattr(os, "sched_setaffinity", move, raising=False)
    timing.rounds([lambda: during.append(cores)], count=1, seconds=1e-6)
    assert all(chosen == {3} for chosen in during)
    assert during
    assert cores == {0, 2, 3}
    monkeypatch.delattr(os, "sched_setaffinity")
    timing.rounds([lambda: during.append(cores)], count=1, seconds=1e-6)
    assert during[-1] == {0, 2, 3}


def test_every_function_on_arrays_is_compared() -> None:
    module = load(2)
    names = {name for _, name, _ in former.functions(module)}
    assert set(module.__all__) - names == {"dcay", "dcay_inv", "identity", "random", "singular_angles"}
    branches = [name for title, name, _ in former.functions(module) if title.endswith("branch 1")]
    assert branches == ["from_pose", "from_quaternion", "from_tensor"]


def test_kernels_against_themselves_have_ratios_for_every_layout_and_equal_calls() -> None:
    found = former.compare(former.PRESENT, former.PRESENT, (1, 2), SMALL, runs=2, only=("quaternion", "to_screw"))
    assert [(c.order, c.function) for c in found] == [(n, f) for n in (1, 2) for f in ("quaternion", "to_screw")]
    for comparison in found:
        assert {title: len(ratios) for title, ratios in comparison.ratios.items()} == {"rows": 2, "one": 2}
        before, after = comparison.calls
        assert before == after > 0


def test_more_work_misses_both_gates(tmp_path: Path) -> None:
    slower = tmp_path / "dualcay"
    shutil.copytree(former.PRESENT, slower)
    with (slower / "cayley2.py").open("a", encoding="utf-8") as file:
        file.write(SLOWER)
    (once,) = former.compare(former.PRESENT, slower, (2,), SMALL, runs=3, only=("quaternion",))
    assert once.calls[1] == 10 * once.calls[0]
    missed = once.short(SMALL)
    assert [line.split(":")[0] for line in missed] == ["rows", "one", "calls"]
    text = former.tables([once], SMALL)
    assert all(f"Falls short: quaternion, n = 2, {line}." in text for line in missed)
    assert "| SHORT |" in text


def test_both_packages_compute_in_one_scratch_memory() -> None:
    modules = former.pair(former.PRESENT, former.PRESENT, 2)
    assert modules[0] is not modules[1]
    memory = importlib.import_module("dualcay_former._kernel").SCRATCH
    inputs = former.Inputs(modules[0], former.COUNTED, 0)
    past, now = inputs.calls("pose", {}, *modules)
    past()
    (kept,) = memory._free
    now()
    assert memory._free == [kept]
    kept[:] = 0
    now()
    assert kept.any()


def test_without_git_a_line_says_what_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", "")
    line = former.section((2,), SMALL)
    assert line == (
        "Not measured, because it is missing: the history of git, revision bece627, for the kernels of the former "
        "release.\n"
    )


def test_the_former_release_has_the_orders_compared() -> None:
    with pytest.raises(former.Missing, match="revision 0000000"), former.former("0" * 40):
        pass
    with contextlib.suppress(former.Missing), former.former() as folder:  # it is missing in a source archive
        assert all((folder / f"cayley{order}.py").is_file() for order in former.ORDERS)
