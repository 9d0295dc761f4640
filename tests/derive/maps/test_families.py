"""Families v = φ(α) u: the Cayley map of a(v) gives the pose, T its twist, and the series continue T to α = 0."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest
import sympy

from derive.algebra import Dual, Quaternion, Tensor, Vector, functions
from derive.maps import closed_forms, first_principles
from derive.maps.any_phi.elementary import evaluate
from derive.maps.families import (
    Family,
    alpha,
    breusing,
    euler,
    isochoric,
    lambert,
    normal_rodrigues,
    orthographic,
    rodrigues,
    sine,
)
from derive.maps.kinematics import dexp, dexp_inv
from derive.maps.pose import Screw, tensor_from_screw

FAMILIES = [
    rodrigues(1), rodrigues(4), normal_rodrigues(1), normal_rodrigues(3), orthographic(), lambert(), sine(5),
    breusing(), euler(),
]  # fmt: skip
TINY = mpmath.mpf(10) ** -40

by_name = pytest.mark.parametrize("family", FAMILIES, ids=lambda family: family.name)


def screw(angle: str = "0.9") -> Screw:
    direction = [mpmath.mpf(c) / 7 for c in (2, 3, 6)]
    moment = [mpmath.mpf(c) / 4 for c in (3, -2, 0)]
    return Screw(Dual(mpmath.mpf(angle), mpmath.mpf("1.7")), Vector.dual(direction, moment))


def invert(family: Family, v: Vector) -> Tensor:
    """R(v) through α = φ⁻¹(|v|), by Newton steps on dual numbers."""
    length = v.magnitude()
    angle = Dual(mpmath.findroot(lambda a: family.at(a) - length.re, 0.9), mpmath.mpf(0))
    for _ in range(6):
        angle = angle - (family.at(angle) - length) / evaluate(family.slope, alpha, angle)
    return tensor_from_screw(Screw(angle, v / length))


@by_name
def test_scale_belongs_to_the_parameterization(family: Family, gap) -> None:
    at = screw()
    v = family.vector(at.angle, at.axis)
    a, n = family.scale_at(v.dot(v)), family.order
    assert gap(a, family.at(at.angle) * functions.cot(at.angle / (2 * n))) < TINY
    w = v / a
    s, t = closed_forms.quaternion(n, w.dot(w))
    half = at.angle / 2
    assert gap(Quaternion(s, w * t), Quaternion(functions.cos(half), at.axis * functions.sin(half))) < TINY


@by_name
def test_operator_is_the_derivative_of_the_pose(family: Family, gap) -> None:
    at, rate = screw(), Vector.dual((1, -2, 3), (2, 0, -1))
    v, step = family.vector(at.angle, at.axis), mpmath.mpf(10) ** -12
    before, after = (invert(family, v + rate * (k * step)) for k in (-1, 1))
    twist = first_principles.twist(invert(family, v), (after - before) / (2 * step))
    assert gap(family.operator(at.angle, at.axis) @ rate, twist) < mpmath.mpf(10) ** -20


@by_name
@pytest.mark.parametrize("angle", ["0.9", "0"])
def test_operators_are_inverse(family: Family, angle: str, gap) -> None:
    at = screw(angle)
    T, T_inv = (family.operator(at.angle, at.axis, inverse=inverse) for inverse in (False, True))
    assert gap(T @ T_inv, Tensor.identity()) < TINY
    if angle != "0":
        assert gap(T.det(), evaluate(family.determinant, alpha, at.angle)) < TINY


@by_name
def test_series_continue_the_coefficients(family: Family) -> None:
    c1, c3 = family.taylor(2)
    tangent, tangent_inv = family.series(4)
    first, first_inv = ([s[0] for s in series] for series in (tangent, tangent_inv))
    assert first == [1 / c1, 1 / (2 * c1**2), (sympy.Rational(1, 6) - 2 * c3 / c1) / c1**3]
    assert first_inv == [c1, -sympy.Rational(1, 2), 2 * c3 / c1**2 + 1 / (12 * c1)]
    small = mpmath.mpf(10) ** -4
    formulas = (*family.tangent, *family.tangent_inv)
    for formula, series in zip(formulas, (*tangent, *tangent_inv), strict=True):
        expected = sum(mpmath.mpf(int(c.p)) / int(c.q) * small ** (2 * k) for k, c in enumerate(series))
        assert abs(evaluate(formula, alpha, small) - expected) < mpmath.mpf(10) ** -26


def test_rodrigues_family_is_the_cayley_map() -> None:
    for n in (1, 2, 3, 6):
        family, t = rodrigues(n), sympy.Symbol("t")
        angle = 2 * n * sympy.atan(t)
        for formula, closed in ((family.tangent, closed_forms.tangent), (family.tangent_inv, closed_forms.tangent_inv)):
            for coefficient, value in zip(formula, closed(n, sympy.Rational(1, 9)).coefficients, strict=True):
                at = coefficient.subs(alpha, angle.subs(t, sympy.Rational(1, 3)))
                assert abs(sympy.N(at - value, 40)) < 1e-35


def test_euler_family_is_the_exponential(gap) -> None:
    at = screw()
    a = at.axis * at.angle
    assert gap(euler().operator(at.angle, at.axis), dexp(a)) < TINY
    assert gap(euler().operator(at.angle, at.axis, inverse=True), dexp_inv(a)) < TINY


def test_breusing_is_the_geometric_mean() -> None:
    for k in range(1, 6):
        angle = mpmath.mpf(k)
        assert abs(breusing().at(angle) - mpmath.sqrt(mpmath.tan(angle / 4) * mpmath.sin(angle / 4))) < TINY
        assert breusing().at(-angle) == -breusing().at(angle)


def test_poles_raise() -> None:
    with pytest.raises(ZeroDivisionError):
        evaluate(1 / alpha, alpha, Fraction(0))
    at = screw("0")
    turned = Dual(sympy.pi * 2, sympy.Integer(1))
    u = Vector.dual((sympy.Integer(1), sympy.Integer(0), sympy.Integer(0)), [sympy.Integer(0)] * 3)
    with pytest.raises(ZeroDivisionError):
        euler().operator(turned, u, inverse=True)
    assert euler().operator(at.angle, at.axis)[0, 0] == 1


def test_the_isochoric_parameterization_keeps_volumes() -> None:
    family = isochoric()
    cube = sympy.expand(family.phi**3)
    assert cube == 6 * alpha - 6 * sympy.sin(alpha)
    # det T = 2 (1 − cos α)/(φ′ φ²), and 3 φ² φ′ = (φ³)′
    assert sympy.expand(6 * (1 - sympy.cos(alpha)) - cube.diff(alpha)) == 0
    value = family.determinant.subs(alpha, sympy.Rational(13, 10)).evalf(40)
    assert abs(value - 1) < sympy.Float(10, 40) ** -35
