"""Tests of the accuracy suite: the worst inputs are stored exactly, and the page names missed gates."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from benchmarks.accuracy import certified, curves, measure, report, worst
from benchmarks.accuracy.__main__ import DOCS
from tests.support import cases, errors, sampling
from tests.support.cases import DTYPES, Case
from tests.support.kernels import load
from tests.support.trial import Trial, gate


@pytest.mark.parametrize("dtype", DTYPES.values(), ids=DTYPES)
def test_arguments_are_kept_to_the_last_bit(dtype: type, tmp_path: Path) -> None:
    for regime in sampling.REGIMES:
        trial = Trial(load(3), 3, regime, dtype)
        call = next(trial.calls("from_pose"))
        case = Case.of(trial, call, 0.5)
        cases.write([case], 7, tmp_path / "cases.json")
        kept, searched = cases.read(tmp_path / "cases.json")
        assert (kept, searched) == ([case], 7)
        again = kept[0].call(load(3))
        assert (again.given[0].dtype, again.branch) == (dtype, call.branch)
        assert again.given[0].tolist() == call.given[0].tolist()
    assert np.signbit(cases.decode(cases.encode(dtype(-0.0)), dtype))


@pytest.mark.parametrize(
    ("table", "functions"), [("", ("twist", "transform_point", "shadow")), ("rotation", ("rate",))]
)
def test_kept_case_reproduces_its_error(table: str, functions: tuple[str, ...]) -> None:
    module = load(3, table=table)
    trials = [Trial(module, 3, regime, count=1) for regime in ("below pi", "coordinate axes")]
    for function in functions:
        found = measure.measured(trials, function)
        assert found is not None
        assert (found.table, found.case.key) == (table, (table, function, True))
        again = found.case.call(module)
        assert again.error(again.among()) == pytest.approx(found.error, rel=0.5)
        every = [call.error(call.among()) for trial in trials for call in trial.calls(function)]
        assert found.error == pytest.approx(max(every))
        assert all(call.error(call.among()) <= call.bound() for trial in trials for call in trial.calls(function))


def case(fraction: float, regime: str = "uniform", argument: str = "0x1p+0") -> Case:
    return Case("pose", 2, "float64", regime, ((argument,),), fraction)


def test_worst_inputs_of_each_function_are_kept() -> None:
    first, second, third = (case(fraction, argument=f"0x1p+{place}") for place, fraction in enumerate((0.5, 0.7, 0.6)))
    assert cases.worst([first, second, third]) == [second, third]
    again = replace(second, fraction=0.4)  # the same input, measured in another batch
    assert cases.worst([again, first, second]) == [second, first]
    outside = case(0.3, regime="shadow")
    assert cases.worst([first, second, outside]) == [second, first, outside]


def measurements(scale: float) -> list[measure.Measurement]:
    """Return measurements with errors of ``scale`` times the gate, for every function in two regimes."""
    return [
        measure.Measurement(row.name, 2, "float64", regime, scale * gate(row.source), gate(row.source),
                            case(scale, regime), table.name)
        for table in cases.TABLES.values()
        for row in table.public.values()
        for regime in ("uniform", "shadow")
    ]  # fmt: skip


@pytest.mark.smoke
def test_missed_gates_are_named() -> None:
    assert worst.short_of_gate(measurements(0.9)) == []
    found = worst.short_of_gate(measurements(1.1))
    assert "quaternion, n = 2, float64, uniform: 2.2 eps, gate 2 FALLS SHORT" in found
    assert "from_angle_axis, rotations alone, n = 2, float64, shadow: 8.8 eps, gate 8 FALLS SHORT" in found
    drawn = curves.Drawn([("a.png", "A caption. More.")], ["Standing."])
    page = report.page(measurements(1.1), drawn)
    assert all(f"- {line}" in page for line in found)
    assert "**2.2 u**" in page
    assert "| pose of v, at half a turn and on shadows | 14.7 (8.8 eps) |" in page
    assert "<summary>float64 (eps = 2.22e-16), rotations alone, at π and beyond</summary>" in page
    assert "| derivatives of T and T⁻¹ | 8 | 8.8, " in page
    assert "![A caption](a.png)" in page
    assert "- all gates are met by what is in range" in report.page(measurements(0.9), curves.Drawn([], []))
    other = report.beside(page, curves.Drawn([("b.png", "Another. More.")], ["Elsewhere."]))
    assert other.partition(report.BESIDE)[0] == page.partition(report.BESIDE)[0]
    assert other.endswith(f"{report.BESIDE}\n\nElsewhere.\n\nAnother. More.\n\n![Another](b.png)\n")


def test_facts_beside_the_page_are_its_tables() -> None:
    page = (DOCS / "accuracy.md").read_text(encoding="utf-8")
    assert worst.data(page) == (DOCS / "accuracy.json").read_text(encoding="utf-8")
    assert certified.renewed(page) == page
    rows = json.loads(worst.data(report.page(measurements(1.1), curves.Drawn([], []))))["errors"]
    row = next(row for row in rows if row["function"] == "quaternion" and not row["beyond half a turn"])
    assert (row["gate"], row["errors"]) == ("2", {"n = 2": [2.2, "uniform"]})


@pytest.mark.parametrize(("panel", "index"), [("small", 40), ("whole", 31), ("to pi", 20)])
def test_accuracy_curves_stay_within_their_gates(panel: str, index: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(curves, "libraries", list)
    _, _, point = curves.point((panel, index))
    assert {name for _, name in point} == {*(f"n = {n}" for n in curves.ORDERS), "exponential"}
    assert max(point.values()) < errors.GENERAL
    assert max(point.values()) > 0.01


def test_the_search_finds_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    """Add 9 eps to one entry of Q and of ρ; expect them as errors, by their scales √3 and |T|, from 1 to √3."""
    ours, eps = curves.peers.ours(), np.finfo(float).eps
    assert all(0.5 < error < 4 for error in curves.searched(500).values())
    off = np.zeros((4, 4))
    off[0, 0] = off[0, 3] = 9 * eps
    monkeypatch.setattr(curves.peers, "ours", lambda: curves.peers.Peer("off", lambda xi: ours.exp(xi) + off, np.copy))
    found = curves.searched(500)
    assert 9 / np.sqrt(3) < found["Q"] < 9 / np.sqrt(3) + 4
    assert 9 / np.sqrt(3) < found["ρ"] < 9 + 4
