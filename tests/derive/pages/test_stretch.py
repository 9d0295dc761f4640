"""Singular values of Re T, and the φ with singular values nearest to 1."""

from __future__ import annotations

import math

import numpy as np
import pytest
import sympy

from derive.maps import Cayley, family, parameterization
from derive.maps.families import alpha
from derive.pages.stretch import best, bound, stretch
from dualcay import cayley2, exponential, lambert

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


def test_second_order_is_conformal():
    assert all(stretch(Cayley(2).phi, a).condition == pytest.approx(1, rel=1e-14) for a in (0.1, 3.0, 6.0))


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
        worst = max(stretch(chart.phi, angle * k / 50).worst for k in range(51))
        assert worst == pytest.approx(found.worst, rel=1e-3)


@pytest.mark.parametrize("angle", [0.5, math.pi / 2, math.pi, 5.0])
def test_lamberts_chart_is_the_best_of_sines(angle: float):
    """Expect reciprocal singular values, with ``1/cos(α/4)`` along the axis; a smaller or larger c is worse."""
    _, sine = best(angle, ())
    assert sine.phi == "4*sin(alpha/4)"
    assert sine.worst == pytest.approx(1 / math.cos(angle / 4), rel=1e-14)
    at = stretch(4 * family("lambert").phi, angle)
    assert at.along == pytest.approx(1 / at.across, rel=1e-14)
    for c in (3.9, 4.1):
        assert stretch(c * sympy.sin(alpha / sympy.Float(c)), angle).worst > at.worst * 1.0001


@pytest.mark.parametrize("n", [2, 3, 8])
def test_tangents_of_any_order_are_worse_than_the_exponential(n: int):
    assert stretch(2 * n * sympy.tan(alpha / (2 * n)), 3.0).worst > stretch(alpha, 3.0).worst


def test_no_phi_is_better_than_the_bound():
    """Draw φ with slopes just within the bound; at π, the length of each φ violates the bound."""
    rng = np.random.default_rng(1)
    least = bound(math.pi)
    for _ in range(50):
        m = least * 0.999
        slopes = rng.uniform(1 / m, m, 400)
        size = slopes.mean() * math.pi
        assert size / 2 > m or size * m < math.pi
