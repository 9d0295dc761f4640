"""Families v = φ(α) u: their pose equals the Cayley map of the converted vector a(v)."""

from __future__ import annotations

import mpmath
import pytest
import sympy

from derive.algebra import Dual, Quaternion, Vector, functions
from derive.maps import closed_forms, family
from derive.maps.elementary import evaluate
from derive.maps.families import alpha, breusing, isochoric, rodrigues
from derive.maps.pose import Screw

TINY = mpmath.mpf(10) ** -40


def screw(angle: str = "0.9") -> Screw:
    direction = [mpmath.mpf(c) / 7 for c in (2, 3, 6)]
    moment = [mpmath.mpf(c) / 4 for c in (3, -2, 0)]
    return Screw(Dual(mpmath.mpf(angle), mpmath.mpf("1.7")), Vector.dual(direction, moment))


@pytest.mark.parametrize("name", ["lambert", "breusing", "sine5", "scaled3", "exponential"])
def test_scale_belongs_to_the_parameterization(name: str, gap) -> None:
    chart, at = family(name), screw()
    a = evaluate(chart.scale, alpha, at.angle)
    w = at.axis * evaluate(chart.phi, alpha, at.angle) / a
    s, t = closed_forms.quaternion(chart.order, w.dot(w))
    half = at.angle / 2
    assert gap(Quaternion(s, w * t), Quaternion(functions.cos(half), at.axis * functions.sin(half))) < TINY


def test_rodrigues_family_is_the_cayley_map() -> None:
    for n in (1, 2, 3, 6):
        member, t = rodrigues(n), sympy.Symbol("t")
        angle = 2 * n * sympy.atan(t)
        for formula, closed in ((member.tangent, closed_forms.tangent), (member.tangent_inv, closed_forms.tangent_inv)):
            for coefficient, value in zip(formula, closed(n, sympy.Rational(1, 9)).coefficients, strict=True):
                at = coefficient.subs(alpha, angle.subs(t, sympy.Rational(1, 3)))
                assert abs(sympy.N(at - value, 40)) < 1e-35


def test_breusing_is_the_geometric_mean() -> None:
    for k in range(1, 6):
        angle = mpmath.mpf(k)
        assert abs(breusing().at(angle) - mpmath.sqrt(mpmath.tan(angle / 4) * mpmath.sin(angle / 4))) < TINY
        assert breusing().at(-angle) == -breusing().at(angle)


def test_the_isochoric_parameterization_keeps_volumes() -> None:
    cube = sympy.expand(isochoric().phi ** 3)
    assert cube == 6 * alpha - 6 * sympy.sin(alpha)
    # det T = 2 (1 − cos α)/(φ′ φ²), and 3 φ² φ′ = (φ³)′
    assert sympy.expand(6 * (1 - sympy.cos(alpha)) - cube.diff(alpha)) == 0
