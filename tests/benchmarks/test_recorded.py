"""Tests of times relative to another checkout: all functions are compared, drift cancels, slow kernels miss gates."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from benchmarks import recorded, timing
from benchmarks.page import sections
from tests.support.kernels import load

SLOWER = """
_once = quaternion


def quaternion(v, *, axis=-1, out=None):
    for _ in range(9):
        _once(v, axis=axis)
    return _once(v, axis=axis, out=out)
"""


class Clock:
    """Simulated clock; each call adds its duration times a factor, which grows from call to call."""

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


def test_drift_cancels_in_paired_ratios(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = Clock()
    monkeypatch.setattr(timing, "process_time", lambda: clock.now)
    calls = clock.call("other", 1.0), clock.call("present", 1.2)
    assert timing.paired_ratio(*calls, count=100, seconds=0.5) == pytest.approx(1.2, abs=1e-5)
    assert clock.called[-4:] == ["other", "present", "present", "other"]
    assert clock.speed > 1.2


def test_every_function_on_arrays_is_compared() -> None:
    module = load(2)
    left_out = {"dcay", "dcay_inv", "identity", "random", "singular_angles"}
    assert set(module.__all__) - set(recorded.functions(module)) == left_out


def test_slower_kernels_miss_the_gates(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(recorded, "SECONDS", 1e-4)
    slower, page = tmp_path / "dualcay", tmp_path / "speed.md"
    shutil.copytree(recorded.PRESENT, slower)
    with (slower / "cayley2.py").open("a", encoding="utf-8") as file:
        file.write(SLOWER)
    monkeypatch.setattr(recorded, "PRESENT", slower)
    charts = ["--charts", "cayley2,rotation.cayley2", "--sizes", "1,64", "--runs", "1"]
    other = str(Path(recorded.__file__).parents[1] / "generated" / "dualcay")
    recorded.main(["--against", other, *charts, "--functions", "quaternion,interpolate", "-o", str(page)])
    lines = [
        [cell.strip() for cell in line.split("|")]
        for line in sections(page.read_text("utf-8"))["recorded"].splitlines()
    ]
    summary = {(line[1], line[2]): line[5:7] for line in lines if len(line) == 8 and line[6] in ("met", "SHORT")}
    assert summary["cayley2", "1"] == summary["cayley2", "64"] == ["quaternion", "SHORT"]
    assert set(summary) == {(chart, size) for chart in ("cayley2", "rotation.cayley2") for size in ("1", "64")}
