"""Closed forms of φ⁻¹ return the angle of a length, up to the edge."""

from __future__ import annotations

import mpmath
import pytest
import sympy

from derive.maps import parameterization
from derive.maps.angle_of_length import real_value
from derive.maps.any_phi.edges import PHI_DIGITS, closed_inverse
from derive.maps.families import alpha

INVERSES = {
    "3*sin(alpha/5)": "5*asin(alpha/3)",
    "tan(alpha/7)/2": "7*atan(2*alpha)",
    "2*sinh(alpha/2)": "2*asinh(alpha/2)",
    "10*tanh(alpha/10)": "10*atanh(alpha/10)",
    "asin(alpha/20)": "20*sin(alpha)",
    "atan(alpha/3)": "3*tan(alpha)",
    "sin(tan(alpha/8))": "8*atan(asin(alpha))",
    "alpha/(1 + alpha**2/40)": None,
    "alpha/(1 - alpha**2/40)": None,
    "alpha/sqrt(1 + alpha**2/40)": None,
    "alpha*sqrt(1 + alpha**2)": None,
    "alpha*sqrt((1 + alpha**2)/(3 + alpha**2))": None,
}
"""Closed inverses by φ; None if the form of the inverse is not compared."""


@pytest.mark.parametrize("phi", list(INVERSES))
def test_inverse_returns_the_angle_up_to_the_edge(phi: str) -> None:
    chart = parameterization(phi, "of_user")
    inverse = closed_inverse(chart.phi)
    assert INVERSES[phi] in (None, str(inverse))
    with mpmath.workdps(PHI_DIGITS):
        end = min(mpmath.mpf(chart.edge.evalf(PHI_DIGITS)), 4 * mpmath.pi)
        for share in ("1e-9", "0.1", "0.5", "0.9", "0.999"):
            angle = end * mpmath.mpf(share)
            size = real_value(chart.phi, angle, chart.phi)
            found = inverse.subs(alpha, sympy.Float(size, PHI_DIGITS)).evalf(PHI_DIGITS)
            assert abs(mpmath.mpf(found) / angle - 1) < mpmath.mpf(10) ** (6 - PHI_DIGITS), share


@pytest.mark.parametrize(
    "phi", ["alpha + sin(alpha)/2", "alpha*cosh(alpha)", "alpha + alpha**3", "sin(alpha + alpha**3)"]
)
def test_phi_without_closed_inverse_has_none(phi: str) -> None:
    assert closed_inverse(parameterization(phi, "of_user").phi) is None


def test_inverse_of_the_angle_is_the_length() -> None:
    assert closed_inverse(alpha) == alpha
