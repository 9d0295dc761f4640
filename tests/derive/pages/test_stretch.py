"""Singular values of Re T, the φ with values nearest to 1, and the figures, page and plot of ``dualcay compare``."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest
import sympy

from benchmarks.nearest import best, bound, searched, worst
from derive import about
from derive.codegen import catalogue
from derive.maps import Cayley, family, parameterization
from derive.maps.elementary import alpha
from derive.pages import comparison_forms
from derive.pages.comparison import MEASURED, MEASUREMENTS, NEAREST, TIMED, Compared, measurements, stretch
from dualcay import cayley2, exponential, lambert
from tests.support.command import ROOT, dualcay

CHARTS = [(Cayley(2), cayley2), (family("exponential"), exponential), (family("lambert"), lambert)]


@pytest.mark.parametrize(("chart", "kernels"), CHARTS)
@pytest.mark.parametrize("angle", [0.0, 0.7, 2.9])
def test_singular_values_match_the_kernels(chart, kernels, angle: float):
    found = stretch(chart.phi, angle)
    v = np.array([0.0, found.size, 0, 1, 2, 3])
    values = np.linalg.svd(kernels.tangent(v)[0], compute_uv=False)
    expected = sorted([found.along, found.across, found.across], reverse=True)
    np.testing.assert_allclose(values, expected, rtol=1e-12)
    assert found.condition == pytest.approx(values[0] / values[-1], rel=1e-12)


@pytest.mark.parametrize("angle", [math.pi / 2, math.pi])
def test_best_phi_is_above_the_bound_and_generates(angle: float):
    """Expect the squared bound for the exponential chart, and values between bound and square for sines and cubics."""
    tangent, sine, cubic = best(angle, (3,))
    assert tangent.phi == "alpha"
    assert tangent.worst == pytest.approx(bound(angle) ** 2, rel=1e-12)
    assert bound(angle) < min(sine.worst, cubic.worst)
    assert max(sine.worst, cubic.worst) < tangent.worst
    for found in (sine, cubic):
        chart = parameterization(found.phi, "found")
        most = max(worst(stretch(chart.phi, angle * k / 50)) for k in range(51))
        assert most == pytest.approx(found.worst, rel=1e-3)


@pytest.mark.parametrize("angle", [0.5, math.pi / 2, math.pi, 5.0])
def test_lamberts_chart_is_the_best_of_sines(angle: float):
    """Expect reciprocal singular values, with ``1/cos(α/4)`` along the axis; a smaller or larger c is worse."""
    _, sine = best(angle, ())
    assert sine.phi == "4*sin(alpha/4)"
    assert sine.worst == pytest.approx(1 / math.cos(angle / 4), rel=1e-14)
    at = stretch(4 * family("lambert").phi, angle)
    assert at.along == pytest.approx(1 / at.across, rel=1e-14)
    for c in (3.9, 4.1):
        assert worst(stretch(c * sympy.sin(alpha / sympy.Float(c)), angle)) > worst(at) * 1.0001


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


def test_chart_without_kernels_is_compared_with_the_reason(monkeypatch):
    monkeypatch.setenv("COLUMNS", "120")  # narrower screens show lines instead of a table
    (chart,) = catalogue.charts(phi="atanh(alpha/5)", name="mine")
    row = Compared(chart)
    assert set(row.operations.values()) == {None}
    assert row.range == math.inf
    assert row.measured is None
    assert "grows like a logarithm" in row.refusal
    found = row.stretches["π"]
    assert found is not None
    assert found.along == pytest.approx(5 - math.pi**2 / 5, rel=1e-12)
    assert comparison_forms.FORMS["text"]([row]).count(" - │") == len(row.operations)


def test_the_reason_is_said_beside_the_figures():
    done = dualcay("compare", "--phi", "atanh(alpha/5)")
    assert done.returncode == 0
    assert "condition of Re T" in done.stdout
    assert "grows like a logarithm near its edge" in done.stderr


def test_a_plot_is_written(tmp_path: Path):
    pytest.importorskip("matplotlib")
    assert dualcay("compare", "-n", "2", "--plot", str(tmp_path / "plot.svg")).returncode == 0
    assert "<svg" in (tmp_path / "plot.svg").read_text(encoding="utf-8")


def test_committed_page_is_current():
    done = dualcay("compare", "--format", "markdown")
    assert done.stdout == (ROOT / "docs" / "parameterizations.md").read_text(encoding="utf-8")


def test_measured_phi_are_those_that_the_search_finds():
    assert measurements(NEAREST) == searched()


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
