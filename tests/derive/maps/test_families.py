"""Families v = φ(α) u: the Cayley map of a(v) gives the pose."""

from __future__ import annotations

import mpmath
import pytest
import sympy

from derive.algebra import Dual, Quaternion, Vector, functions
from derive.maps import closed_forms, x
from derive.maps.any_phi.elementary import evaluate
from derive.maps.families import (
    Family,
    alpha,
    breusing,
    isochoric,
    lambert,
    normal_rodrigues,
    orthographic,
    rodrigues,
    sine,
)
from derive.maps.pose import Screw

FAMILIES = [
    rodrigues(1), rodrigues(4), normal_rodrigues(1), normal_rodrigues(3), orthographic(), lambert(), sine(5),
    breusing(),
]  # fmt: skip
TINY = mpmath.mpf(10) ** -40

by_name = pytest.mark.parametrize("family", FAMILIES, ids=lambda family: family.name)


def screw(angle: str = "0.9") -> Screw:
    direction = [mpmath.mpf(c) / 7 for c in (2, 3, 6)]
    moment = [mpmath.mpf(c) / 4 for c in (3, -2, 0)]
    return Screw(Dual(mpmath.mpf(angle), mpmath.mpf("1.7")), Vector.dual(direction, moment))


@by_name
def test_scale_belongs_to_the_parameterization(family: Family, gap) -> None:
    at = screw()
    v = family.vector(at.angle, at.axis)
    a, n = evaluate(family.scale, x, v.dot(v)), family.order
    assert gap(a, family.at(at.angle) * functions.cot(at.angle / (2 * n))) < TINY
    w = v / a
    s, t = closed_forms.quaternion(n, w.dot(w))
    half = at.angle / 2
    assert gap(Quaternion(s, w * t), Quaternion(functions.cos(half), at.axis * functions.sin(half))) < TINY


def test_rodrigues_family_is_the_cayley_map() -> None:
    for n in (1, 2, 3, 6):
        family, t = rodrigues(n), sympy.Symbol("t")
        angle = 2 * n * sympy.atan(t)
        for formula, closed in ((family.tangent, closed_forms.tangent), (family.tangent_inv, closed_forms.tangent_inv)):
            for coefficient, value in zip(formula, closed(n, sympy.Rational(1, 9)).coefficients, strict=True):
                at = coefficient.subs(alpha, angle.subs(t, sympy.Rational(1, 3)))
                assert abs(sympy.N(at - value, 40)) < 1e-35


def test_breusing_is_the_geometric_mean() -> None:
    for k in range(1, 6):
        angle = mpmath.mpf(k)
        assert abs(breusing().at(angle) - mpmath.sqrt(mpmath.tan(angle / 4) * mpmath.sin(angle / 4))) < TINY
        assert breusing().at(-angle) == -breusing().at(angle)


def test_the_isochoric_parameterization_keeps_volumes() -> None:
    family = isochoric()
    cube = sympy.expand(family.phi**3)
    assert cube == 6 * alpha - 6 * sympy.sin(alpha)
    # det T = 2 (1 − cos α)/(φ′ φ²), and 3 φ² φ′ = (φ³)′
    assert sympy.expand(6 * (1 - sympy.cos(alpha)) - cube.diff(alpha)) == 0
