"""Edges of φ, and φ⁻¹ below them: in closed form where there is one, and by fits with bounded errors."""

from __future__ import annotations

import re
from functools import cache
from typing import Any

import mpmath
import pytest
import sympy

from derive.algebra.arithmetic import PLAIN
from derive.maps import PhiError, parameterization
from derive.maps.angle import angle_of, real_value
from derive.maps.any_phi import first_guess
from derive.maps.any_phi.edges import PHI_DIGITS, Edge, closed_inverse, edge_of
from derive.maps.any_phi.general import General
from derive.maps.any_phi.intervals import precise
from derive.maps.elementary import alpha

EDGES = [
    (sympy.sin(alpha / 6), Edge(3 * sympy.pi, "fold")),
    (sympy.sin(3 * alpha / 7), Edge(7 * sympy.pi / 6, "fold")),
    (alpha / (1 + alpha**2 / 40), Edge(sympy.sqrt(40), "fold")),
    (sympy.tan(alpha / 6), Edge(3 * sympy.pi, "pole")),
    (alpha / (3 - alpha**2), Edge(sympy.sqrt(3), "pole")),
]


@pytest.mark.parametrize(("phi", "edge"), EDGES)
def test_edges_have_exact_names(phi: sympy.Expr, edge: Edge):
    assert edge_of(phi) == edge


def test_an_edge_without_a_name_is_a_decimal():
    phi = sympy.sin(alpha / 2) + alpha / 50
    found = edge_of(phi)
    assert found.kind == "fold"
    assert isinstance(found.angle, sympy.Float)
    with mpmath.workdps(PHI_DIGITS):  # cos(α/2)/2 + 1/50 = 0
        assert abs(mpmath.mpf(found.angle) - 2 * mpmath.acos(-mpmath.mpf(1) / 25)) < mpmath.mpf(10) ** -45


@pytest.mark.parametrize(("phi", "edge"), [*EDGES, (sympy.sinh(alpha), Edge(sympy.oo, ""))])
def test_angles_are_found_up_to_the_edge(phi: sympy.Expr, edge: Edge):
    with mpmath.workdps(PHI_DIGITS):
        end = 5 if edge.angle.is_infinite else mpmath.mpf(edge.angle.evalf(PHI_DIGITS + 5))
        for share in ("1e-20", "0.3", "0.999"):
            angle = mpmath.mpf(share) * end
            # at 0.999 times the fold angle, an error of eps in |v| changes α by about 1e6 eps
            found = angle_of(phi, edge.angle, phi.evalf(PHI_DIGITS, subs={alpha: angle}))
            assert abs(found / angle - 1) < mpmath.mpf(10) ** -40
        assert angle_of(phi, edge.angle, mpmath.mpf(0)) == 0


# --- closed inverses --------------------------------------------------------------------------------------------------

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


FITTED = (
    "alpha/(1 + alpha**2/40)", "2*sinh(alpha/2)", "10*tanh(alpha/10)", "alpha + alpha**3/20",
    "alpha + alpha**3", "alpha + 9*sin(alpha)/10", "tan(alpha/5) + alpha/10",
    "(3*(alpha - sin(alpha))/4)**(1/3)",
)  # fmt: skip
"""Texts of φ with fits of every kind: of folds, poles, lengths and logarithms, by halvings, and in closed form."""
QUICK = 4
"""Every fourth φ is tested in normal runs."""


@pytest.fixture(
    scope="module",
    params=[pytest.param(phi, marks=pytest.mark.thorough if k % QUICK else ()) for k, phi in enumerate(FITTED)],
)
def phi(request: pytest.FixtureRequest) -> str:
    return str(request.param)


chart_of: Any = cache(lambda phi: parameterization(phi, "of_user"))
"""Chart of a φ, whose fits are made once."""


@pytest.fixture(scope="module")
def chart(phi: str) -> General:
    found = chart_of(phi)
    assert isinstance(found, General)
    return found


def _degree(chart: General) -> int:
    return len(chart.near.polynomials[0].levels[0]) - 1


def test_ratio_and_derivatives_near_zero_are_within_the_remainder(chart) -> None:
    edge = edge_of(chart.phi)

    def ratio(x):
        return angle_of(chart.phi, edge.angle, mpmath.sqrt(x)) / mpmath.sqrt(x)

    limit = mpmath.mpf(chart.near.limit.numerator) / chart.near.limit.denominator
    with mpmath.workdps(2 * PHI_DIGITS):
        for share in ("0.05", "0.5", "0.97"):
            x = limit * mpmath.mpf(share)
            exact = mpmath.taylor(ratio, x, len(chart.near.polynomials) - 1)
            for k, polynomial in enumerate(chart.near.polynomials):
                off = abs(polynomial.at(x, PLAIN, "") - exact[k] * mpmath.factorial(k))
                assert off * limit**k <= chart.near.remainder * chart.limits[0][0], k


@pytest.mark.thorough
def test_the_length_near_zero_is_within_its_remainder() -> None:
    """Take φ/α and two derivatives by α² of the homochoric vector, which kernels use where α − sin α loses digits."""
    chart: Any = parameterization("(3*(alpha - sin(alpha))/4)**(1/3)", "of_user")
    near = chart.beside_zero
    limit = mpmath.mpf(near.limit.numerator) / near.limit.denominator
    assert chart.inverse(mpmath.sqrt(float(chart.near.limit))) ** 2 < limit

    def ratio(square):
        angle = mpmath.sqrt(square)
        return mpmath.cbrt(3 * (angle - mpmath.sin(angle)) / 4) / angle

    with mpmath.workdps(2 * PHI_DIGITS):
        for share in ("0.05", "0.5", "1"):
            square = limit * mpmath.mpf(share)
            exact = mpmath.taylor(ratio, square, 2)
            for k in range(3):
                off = abs(near.polynomials[k].at(square, PLAIN, "") - exact[k] * mpmath.factorial(k))
                assert off * limit**k <= near.remainder / 2, k


@pytest.mark.thorough
@pytest.mark.parametrize("phi", ["40*sinh(alpha)", "1/40*(sin(alpha/2) + alpha/50)"])
def test_fits_do_not_depend_on_the_unit_of_v(phi) -> None:
    """Allow a factor of two in remainders, because limits of x are rounded down by up to 25 %."""
    scaled, alone = (parameterization(text, "of_user") for text in (phi, phi.partition("*")[2]))
    assert _degree(scaled) == _degree(alone)
    assert scaled.near.remainder == pytest.approx(alone.near.remainder, rel=1)
    assert (type(scaled.far), scaled.far.steps) == (type(alone.far), alone.far.steps)


@pytest.mark.parametrize(("phi", "reason"), [
    ("1e-6*sinh(alpha)", "too small near 0, 1.7e-6: take a multiple of it"),
    ("1e6*sinh(alpha)", "too large near 0, 1.7e+6: take a multiple of it"),
    ("sinh(400*alpha)", "nothing proves that the inverse of phi = sinh(400*alpha) is analytic near 0: phi/alpha needs"),
])  # fmt: skip
def test_phi_without_a_fit_near_zero_is_refused(phi, reason) -> None:
    with pytest.raises(PhiError, match=re.escape(reason)):
        _ = parameterization(phi, "of_user").near


def test_a_fit_that_newton_cannot_use_is_not_proved() -> None:
    """Expect no proof for plain steps from a fit: the slope falls to a tenth, and they diverge at some angles."""
    chart = parameterization("alpha + 9*sin(alpha)/10", "of_user")
    with precise() as at:
        limit = mpmath.mpf(chart.near.limit.numerator) / chart.near.limit.denominator
        fits = list(first_guess._guesses(chart.phi, chart._edge, limit, 4 * mpmath.pi))[:2]
        assert all(first_guess._proved(at, chart._edge, fit, mpmath.mpf(1)) is None for fit in fits)


def test_known_angle_near_a_fold_keeps_all_digits() -> None:
    """Allow 4 eps for h_i from a known angle, 1e-6 before the fold; from x alone, its error exceeds 1e-9."""
    chart = chart_of("alpha/(1 + alpha**2/40)")
    angle = float(40**0.5) - 1e-6
    at = {alpha: sympy.Float(angle, PHI_DIGITS)}
    size, fi, _, hi = (c.subs(at).evalf(PHI_DIGITS) for c in (chart.phi, *chart.tangent_inv.coefficients))
    x, exact = float(size**2), float(2 * hi)
    known = chart.at_known(x, float(2 * fi), angle, PLAIN)
    assert known.hi == pytest.approx(exact, rel=1e-15)
    assert chart.scalars(x, PLAIN).hi != pytest.approx(exact, rel=1e-9)
