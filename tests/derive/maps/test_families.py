"""Families v = φ(α) u: their pose equals the Cayley map of the converted vector a(v)."""

from __future__ import annotations

import mpmath
import pytest
import sympy

from derive.algebra import Dual, Quaternion, Vector, functions
from derive.maps import closed_forms, family
from derive.maps.elementary import evaluate
from derive.maps.families import alpha, of_angle
from derive.maps.named import SYMBOLIC
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
        scalars, angle = of_angle(sympy.tan(alpha / (2 * n))), 2 * n * sympy.atan(sympy.Rational(1, 3))
        tangent = closed_forms.tangent(n, sympy.Rational(1, 9)).coefficients
        tangent_inv = closed_forms.tangent_inv(n, sympy.Rational(1, 9)).coefficients
        found = (scalars.f, scalars.g, scalars.h, scalars.fi / 2, scalars.hi / 2)
        for coefficient, value in zip(found, (*tangent, *tangent_inv[::2]), strict=True):
            assert abs(sympy.N(coefficient.subs(alpha, angle) - value, 40)) < 1e-35


def test_breusing_is_the_geometric_mean() -> None:
    for k in range(1, 6):
        angle = mpmath.mpf(k)
        at = evaluate(family("breusing").phi, alpha, angle)
        assert abs(at - mpmath.sqrt(mpmath.tan(angle / 4) * mpmath.sin(angle / 4))) < TINY
        assert evaluate(family("breusing").phi, alpha, -angle) == -at


def test_the_isochoric_parameterization_keeps_volumes() -> None:
    cube = sympy.expand(SYMBOLIC["isochoric"] ** 3)
    assert cube == 6 * alpha - 6 * sympy.sin(alpha)
    # det T = 2 (1 − cos α)/(φ′ φ²), and 3 φ² φ′ = (φ³)′
    assert sympy.expand(6 * (1 - sympy.cos(alpha)) - cube.diff(alpha)) == 0
