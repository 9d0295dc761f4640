"""Scalars of every chart at numbers, near v = 0 and beyond: slopes are derivatives, and all scalars fit one φ.

Proofs cover the formulas beyond, and the functions approximated by polynomials near v = 0. Tests evaluate both.
"""

from __future__ import annotations

from typing import Any

import mpmath
import pytest
import sympy

from derive.about import FAMILIES
from derive.algebra.arithmetic import PLAIN
from derive.codegen.catalogue import charts
from derive.maps.chart import Chart
from derive.maps.families import alpha
from derive.proof.scalars import BENDS, SLOPES, VALUES

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


def at(of: Chart, name: str, x: mpmath.mpf) -> mpmath.mpf:
    return mpmath.mpf(getattr(of.scalars(x, PLAIN), name))


def close(found: mpmath.mpf, expected: mpmath.mpf) -> bool:
    return bool(abs(found - expected) <= TOLERANCE * (1 + abs(expected)))


@pytest.mark.parametrize("of", PHI, indirect=True)
def test_scalars_match_the_angle(of: Any) -> None:
    with mpmath.workdps(40):
        for x in squares(of)[1:]:
            r = mpmath.sqrt(x)
            angle = mpmath.mpf(of.scalars(x, PLAIN).angle_of(r))
            assert close(length(of, angle) / r, mpmath.mpf(1))
            assert close(at(of, "s", x), mpmath.cos(angle / 2))
            assert close(at(of, "f", x), mpmath.sin(angle) / r)
            slope = mpmath.mpf(of.phi.diff(alpha).xreplace({alpha: sympy.Float(str(angle), 45)}).evalf(45))
            assert close(at(of, "rate", x), 1 / slope)


@pytest.mark.parametrize("of", ["3", "8", "11", "16", *FAMILIES, *PHI], indirect=True)
def test_slopes_are_twice_the_derivatives(of: Any) -> None:
    pairs = [*zip(SLOPES, VALUES, strict=True), *zip(BENDS, SLOPES[2:], strict=True), ("ratey", "rate")]
    with mpmath.workdps(40):
        for x in squares(of):
            for slope, value in pairs:
                expected = 2 * mpmath.diff(lambda y, value=value: at(of, value, y), x, h=mpmath.mpf("1e-9"))
                assert close(at(of, slope, x), expected), (slope, x)
