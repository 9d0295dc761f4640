"""``dualcay compare``: figures, page and plot."""

from __future__ import annotations

import json
import math
from pathlib import Path

import pytest

from derive import about
from derive.codegen import catalogue
from derive.pages import comparison_forms
from derive.pages.comparison import MEASURED, MEASUREMENTS, TIMED, Compared
from tests.support.command import ROOT, dualcay


def test_figures_of_some_charts():
    done = dualcay("compare", "-n", "2,3", "--family", "lambert", "--phi", "alpha/(1+alpha**2/40)", "--format", "json")
    assert done.returncode == 0
    found = {entry["chart"]: entry for entry in json.loads(done.stdout)}
    assert set(found) == {"cayley2", "cayley3", "lambert", "phi"}
    assert found["cayley2"]["stretch"]["π"]["condition"] == pytest.approx(1)
    assert found["lambert"]["range"] == 1
    assert found["phi"]["singular_angles"] == pytest.approx([6.283185307, 6.32455532])
    assert found["cayley3"]["operations"]["pose"] < found["phi"]["operations"]["pose"]
    assert found["phi"]["measured"] is None
    assert found["lambert"]["measured"] == json.loads((ROOT / MEASUREMENTS).read_text(encoding="utf-8"))["lambert"]


def test_tables_are_at_most_120_wide():
    done = dualcay("compare", "-n", "1", "--family", "exponential")
    assert done.returncode == 0
    assert "exponential" in done.stdout
    assert "nanoseconds for a pose of N, as measured" in done.stdout
    assert max(map(len, done.stdout.splitlines())) <= 120


def test_chart_without_kernels_is_compared_without_operations(monkeypatch):
    monkeypatch.setenv("COLUMNS", "120")  # narrower screens show lines instead of a table
    (chart,) = catalogue.charts(phi="alpha*(5 + tan(pi/2 - 1 - alpha**2/100))", name="mine")  # SymPy rewrites it as cot
    row = Compared(chart)
    assert set(row.operations.values()) == {None}
    found = row.stretches["π"]
    assert found is not None
    inside = 1 + math.pi**2 / 100
    slope = 5 + 1 / math.tan(inside) - math.pi**2 / 50 / math.sin(inside) ** 2
    assert found.along == pytest.approx(1 / slope, rel=1e-12)
    assert comparison_forms.FORMS["text"]([row]).count(" - │") == len(row.operations)


def test_a_plot_is_written(tmp_path: Path):
    pytest.importorskip("matplotlib")
    assert dualcay("compare", "-n", "2", "--plot", str(tmp_path / "plot.svg")).returncode == 0
    assert "<svg" in (tmp_path / "plot.svg").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (("--phi", "cos(alpha)"), "not odd by its structure"),
        (("--phi", "__import__('os')"), "not understood in phi"),
        (("--family", "none"), "a family is one of"),
    ],
)
def test_refusals_are_usage_errors(arguments: tuple[str, ...], reason: str):
    done = dualcay("compare", *arguments)
    assert done.returncode == 2
    assert reason in done.stderr


def test_committed_page_is_current():
    done = dualcay("compare", "--format", "markdown")
    assert done.stdout == (ROOT / "docs" / "parameterizations.md").read_text(encoding="utf-8")


def test_measurements_cover_every_committed_chart_within_the_gate():
    for row in map(Compared, catalogue.committed()):
        found = row.measured
        assert found is not None, f"{row.chart.name}: make parameterizations"
        reached = [name for name, stretch in row.stretches.items() if stretch]
        assert list(found["errors"]) == list(MEASURED)
        assert list(found["errors"]["pose"]) == list(found["errors"]["tangent"]) == reached
        assert all(0 < error <= 8 for errors in found["errors"].values() for error in errors.values())
        assert list(found["nanoseconds"]) == list(TIMED)


def test_no_measurements_outside_a_checkout(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(about, "checkout", lambda: None)
    row = Compared(*catalogue.charts((2,)))
    assert row.measured is None
    assert comparison_forms.measured([row], "errors")[1] == comparison_forms.measured([row], "nanoseconds")[1] == []
