"""Tests of times relative to another checkout: all functions are compared, slow kernels miss gates."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from benchmarks import recorded
from benchmarks.page import sections
from tests.support.kernels import load

SLOWER = """
_once = quaternion


def quaternion(v, *, axis=-1, out=None):
    for _ in range(9):
        _once(v, axis=axis)
    return _once(v, axis=axis, out=out)
"""


def test_every_function_on_arrays_is_compared() -> None:
    module = load(2)
    left_out = {"dcay", "dcay_inv", "identity", "random", "singular_angles"}
    assert set(module.__all__) - set(recorded.functions(module)) == left_out


@pytest.mark.thorough
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
