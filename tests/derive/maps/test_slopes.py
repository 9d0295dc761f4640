"""Scalars of every chart at numbers: slopes are derivatives, all fit one φ; Stumpff functions and their series.

Proofs cover the formulas beyond, and the functions approximated by polynomials near v = 0. Tests evaluate both.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import mpmath
import pytest
import sympy

from derive.about import FAMILIES
from derive.algebra.arithmetic import PLAIN
from derive.codegen.catalogue import charts
from derive.maps import exponential
from derive.maps.elementary import alpha
from derive.maps.exponential import ExponentialScalars, PrincipalScalars
from derive.proof.scalars import BENDS, SLOPES, VALUES
from tests.support.sharp import Sharp

PHI = {
    "fold": "alpha*cos(alpha/9)**3",
    "pole": "tan(alpha/5) + alpha/20",
    "cut": "alpha + alpha**3/100",
    "turning": "alpha/(1 + alpha**2/40)",
    "arc": "atan(10*alpha/17)",
    "root": "alpha*sqrt(1 + alpha**2/50)",
    "power": "alpha/(1 + alpha**2/9)**(3/2)",
    "halves": "alpha*acos(alpha**2/500)",
    "arcsine": "asin(alpha/20) + alpha",
}
"""Texts of φ, with every kind of edge and every function that kernels compute; "arc" has a pole near 0."""

SHARES = ("1e-5", "0.1", "0.3", "0.9")
"""Tested angles, as shares of the edge or of three quarters of a turn, whichever is less."""

TOLERANCE = 1e-11
"""Tolerance for second slopes of polynomials with errors up to 1e-17 and nodes at least 1e-3 apart.

Differences with step 1e-9 add only an error of the square of the step.
"""


@pytest.fixture(scope="module")
def of(request: pytest.FixtureRequest) -> Any:
    """Chart by name, with polynomials fitted in advance: fitting takes as long as all tests of the chart."""
    name: str = request.param
    if name in PHI:
        (made,) = charts(phi=PHI[name], name=name)
        assert made.near.limit
        assert made.far.steps
        return made
    return charts([int(name)])[0] if name.isdigit() else charts((), [name])[0]


def squares(of: Any) -> list[mpmath.mpf]:
    """Return the tested values of ``x = v · v``; the first is 0."""
    end = mpmath.mpf(sympy.Min(of.edge, 3 * sympy.pi / 2).evalf(40))
    return [mpmath.mpf(0), *(length(of, mpmath.mpf(share) * end) ** 2 for share in SHARES)]


def length(of: Any, angle: mpmath.mpf) -> mpmath.mpf:
    return mpmath.mpf(of.phi.xreplace({alpha: sympy.Float(str(angle), 45)}).evalf(45))


def close(found: mpmath.mpf, expected: mpmath.mpf) -> bool:
    return bool(abs(found - expected) <= TOLERANCE * (1 + abs(expected)))


def drawn(*names: str) -> list[Any]:
    """Return parameters; normal runs fit the polynomials of one text of φ."""
    return [pytest.param(name, marks=pytest.mark.thorough if name in {*PHI} - {"arc"} else ()) for name in names]


@pytest.mark.parametrize("of", drawn(*PHI), indirect=True)
def test_scalars_match_the_angle(of: Any) -> None:
    with mpmath.workdps(40):
        for x in squares(of)[1:]:
            r = mpmath.sqrt(x)
            at = of.scalars(x, PLAIN)
            angle = mpmath.mpf(at.angle_of(r))
            assert close(length(of, angle) / r, mpmath.mpf(1))
            assert close(at.s, mpmath.cos(angle / 2))
            assert close(at.f, mpmath.sin(angle) / r)
            slope = mpmath.mpf(of.phi.diff(alpha).xreplace({alpha: sympy.Float(str(angle), 45)}).evalf(45))
            assert close(at.rate, 1 / slope)


@pytest.mark.parametrize("of", drawn("3", "11", *FAMILIES[::2], *PHI), indirect=True)
def test_slopes_are_twice_the_derivatives(of: Any) -> None:
    pairs = [*zip(SLOPES, VALUES, strict=True), *zip(BENDS, SLOPES[2:], strict=True), ("ratey", "rate")]
    with mpmath.workdps(40):
        step = mpmath.mpf("1e-9")
        for x in squares(of):
            before, at, after = (of.scalars(y, PLAIN) for y in (x - step, x, x + step))
            for slope, value in pairs:
                expected = (getattr(after, value) - getattr(before, value)) / step
                assert close(getattr(at, slope), expected), (slope, x)


def exact(k: int, xi: mpmath.mpf) -> mpmath.mpf:
    return mpmath.nsum(lambda j: (-xi) ** int(j) / mpmath.factorial(2 * int(j) + k), [0, 80])


@pytest.mark.parametrize("share", ["0", "1e-9", "0.4", "1"])
def test_series_agree_with_sine_and_cosine(share: str):
    """Allow 100 times the truncation error of c₇ at a quarter of the limit."""
    with mpmath.workdps(60):
        xi = mpmath.mpf(share) * exponential.LIMIT
        found = exponential.Stumpff(xi / 4, PLAIN)
        for k in range(8):
            assert abs(getattr(found, f"C{k}") - exact(k, xi / 4)) <= 100 * exponential.REMAINDER
        for k in range(3, 8):
            assert abs(getattr(found, f"c{k}") - exact(k, xi)) <= 100 * exponential.REMAINDER


def test_truncation_error_is_the_bound():
    with mpmath.workdps(60):
        zeta = mpmath.mpf(exponential.LIMIT) / 4
        miss = abs(exponential.series(zeta, PLAIN) - exact(7, zeta))
        assert exponential.REMAINDER / 2 < miss < exponential.REMAINDER


def test_number_of_terms_is_the_least_for_long_doubles():
    """Expect a truncation error of ``7! c₇`` ≈ 1 below eps, and above eps with one term fewer."""
    share = 5040 * exponential.REMAINDER
    one_less = share * (2 * exponential.TERMS + 6) * (2 * exponential.TERMS + 7) / (exponential.LIMIT / 4)
    assert share < 2.0**-63 < one_less


EPS = 2.0**-52
SQUARES = [17 + 0.07 * k for k in range(310)]
"""Squares of angles from 4 to 2π; the error of their roots reaches 2 eps."""


class Lossy(ExponentialScalars):
    """Scalars without correction of the rounding error of the angle."""

    @cached_property
    def _lost(self) -> float:
        return 0.0


def worst(kind: type[ExponentialScalars]) -> float:
    """Return the largest error of ``sin α`` or ``1 − cos α``, in eps."""
    largest = 0.0
    for x in SQUARES:
        at = kind(x, Sharp())
        with mpmath.workdps(40):
            angle = mpmath.sqrt(mpmath.mpf(x))
            off = abs(at.f - mpmath.sin(angle) / angle) * angle, abs(at.g * mpmath.mpf(x) - 1 + mpmath.cos(angle))
        largest = max(largest, float(max(off) / EPS))
    return largest


@pytest.mark.parametrize("kind", [ExponentialScalars, PrincipalScalars])
def test_rounding_of_the_root_is_corrected(kind: type[ExponentialScalars]) -> None:
    """Allow 2 eps, eps/2 for each rounded operation; the correction removes the error of the angle, also 2 eps."""
    assert worst(kind) <= 2


def test_without_correction_digits_are_lost() -> None:
    assert worst(Lossy) > 2.5
