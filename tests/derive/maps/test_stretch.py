"""Singular values of Re T, and the φ that keeps them nearest to 1."""

from __future__ import annotations

import math

import numpy as np
import pytest

from derive.maps import Cayley, family, parameterization
from derive.maps.stretch import best, bound, stretch
from dualcay import cayley2, exponential, lambert

CHARTS = [(Cayley(2), cayley2), (family("exponential"), exponential), (family("lambert"), lambert)]


@pytest.mark.parametrize(("chart", "kernels"), CHARTS)
@pytest.mark.parametrize("angle", [0.0, 0.7, 2.9])
def test_they_are_those_of_the_kernels(chart, kernels, angle: float):
    found = stretch(chart.phi, angle)
    v = np.array([0.0, found.size, 0, 1, 2, 3])
    values = np.linalg.svd(kernels.tangent(v)[0], compute_uv=False)
    expected = sorted([found.along, found.across, found.across], reverse=True)
    np.testing.assert_allclose(values, expected, rtol=1e-12)
    assert found.condition == pytest.approx(values[0] / values[-1], rel=1e-12)


def test_the_second_order_is_conformal():
    assert all(stretch(Cayley(2).phi, a).condition == pytest.approx(1, rel=1e-14) for a in (0.1, 3.0, 6.0))


@pytest.mark.parametrize("angle", [math.pi / 2, math.pi])
def test_what_is_best_is_above_the_bound_and_can_be_generated(angle: float):
    """The exponential has the square of the bound, polynomials less; a third degree is enough to see it."""
    scaled, cubic = best(angle, (3,))
    assert scaled.phi == "alpha"
    assert scaled.worst == pytest.approx(bound(angle) ** 2, rel=1e-12)
    assert bound(angle) < cubic.worst < scaled.worst
    chart = parameterization(cubic.phi, "cubic")
    worst = max(stretch(chart.phi, angle * k / 50).worst for k in range(51))
    assert worst == pytest.approx(cubic.worst, rel=1e-3)


def test_no_slope_does_better():
    """The bound at π: a φ of slopes that all obey it is too long there, or too short."""
    rng = np.random.default_rng(1)
    least = bound(math.pi)
    for _ in range(50):
        m = least * 0.999
        slopes = rng.uniform(1 / m, m, 400)
        size = slopes.mean() * math.pi
        assert size / 2 > m or size * m < math.pi
