"""Any φ at 0, and φ⁻¹ near 0 and beyond: what is fitted is as near as it says, by what it was fitted before."""

from __future__ import annotations

import mpmath
import pytest
import sympy

from derive.algebra.arithmetic import PLAIN
from derive.maps import parameterization
from derive.maps.edges import DIGITS, angle_of, edge_of
from derive.maps.families import Family, alpha
from derive.maps.general import General

FITTED = {
    "alpha/(1 + alpha**2/40)": "21 47/32 2.98e-19 fold 3",
    "2*sinh(alpha/2)": "20 7/16 2.85e-19 cut 5",
    "alpha + alpha**3/20": "22 7/16 3.12e-19 cut 4",
    "tan(alpha/5) + alpha/10": "18 5/32 1.03e-18 pole 3",
}
"""Degree near 0, limit of x, remainder; the way beyond, and Newton's steps there."""


@pytest.fixture(scope="module", params=list(FITTED))
def phi(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture(scope="module")
def chart(phi: str) -> General:
    found = parameterization(phi, "of_user")
    assert isinstance(found, General)
    return found


def test_it_is_fitted_as_before(phi, chart) -> None:
    near, far = chart.near, chart.far
    degree = len(near.polynomials[0].levels[0]) - 1
    assert f"{degree} {near.limit} {near.remainder:.3g} {far.kind} {far.steps}" == FITTED[phi]


def test_near_0_the_ratio_and_its_derivatives_are_within_the_remainder(chart) -> None:
    def ratio(x):
        return angle_of(chart.phi, edge_of(chart.phi), mpmath.sqrt(x)) / mpmath.sqrt(x)

    limit = mpmath.mpf(chart.near.limit.numerator) / chart.near.limit.denominator
    with mpmath.workdps(2 * DIGITS):
        for share in ("0.05", "0.5", "0.97"):
            x = limit * mpmath.mpf(share)
            exact = mpmath.taylor(ratio, x, len(chart.near.polynomials) - 1)
            for k, polynomial in enumerate(chart.near.polynomials):
                assert abs(polynomial.value(x) - exact[k] * mpmath.factorial(k)) <= chart.near.remainder


def test_limits_are_the_first_coefficients_of_the_series(chart) -> None:
    of_series = Family("of user", 1, chart.phi, chart.scale, "").series(1)
    assert chart.limits == tuple(tuple(coefficients[0] for coefficients in part) for part in of_series)


def test_at_a_known_angle_next_to_a_fold_no_digit_is_lost() -> None:
    """To 4 eps. From x, of which a rounding moves the angle by its root, 1e-6 before the fold h_i is off by 1e-9."""
    chart = parameterization("alpha/(1 + alpha**2/40)", "of_user")
    angle = float(40**0.5) - 1e-6
    at = {alpha: sympy.Float(angle, DIGITS)}
    size, fi, _, hi = (c.subs(at).evalf(DIGITS) for c in (chart.phi, *chart.tangent_inv.coefficients))
    x, exact = float(size**2), float(2 * hi)
    known = chart.at_angle(x, float(2 * fi), angle, PLAIN)
    assert known.hi == pytest.approx(exact, rel=1e-15)
    assert chart.scalars(x, PLAIN).hi != pytest.approx(exact, rel=1e-9)
