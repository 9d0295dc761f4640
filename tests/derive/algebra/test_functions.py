"""Elementary functions of dual numbers, and exact angles: identities hold, values are those of real functions."""

from __future__ import annotations

import math
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy

from derive.algebra import Dual, ZeroDivisorError
from derive.algebra.element import Element, NotExactError
from derive.algebra.exact import AngleField
from derive.algebra.functions import atan, atan2, cos, cot, expm1, log1p, namespace, sin, sqrt, tan

A = Dual(mpmath.mpf("0.7"), mpmath.mpf("-1.3"))
EPS = mpmath.mpf(10) ** -13


def close(a, b) -> bool:
    difference = a - b
    return abs(difference.re) < EPS and abs(difference.du) < EPS


@pytest.mark.parametrize("quarter", range(8))
def test_atan2_inverts_the_circle_all_round(quarter: int) -> None:
    angle = Dual(mpmath.pi * (2 * quarter - 7) / 8, mpmath.mpf("1.7"))
    radius = Dual(mpmath.mpf("2.5"), mpmath.mpf("-0.4"))
    assert close(atan2(radius * sin(angle), radius * cos(angle)), angle)


@pytest.mark.parametrize("f", [sin, cos, tan, cot, atan, sqrt])
def test_dual_part_is_the_derivative(f) -> None:
    x = sympy.Symbol("x")
    derivative = f(x).diff(x).subs(x, sympy.Rational(3, 5))
    value = f(Dual(sympy.Rational(3, 5), sympy.Integer(1)))
    assert abs(sympy.N(value.du - derivative, 30)) < 1e-25


@pytest.mark.parametrize("f", [expm1, log1p])
def test_dual_parts_near_0_agree_with_central_differences(f) -> None:
    """Compare the dual parts of functions missing in SymPy with central differences of 50 digits."""
    for at in ("0.6", "1e-20"):
        with mpmath.workdps(50):
            x, step = mpmath.mpf(at), mpmath.mpf("1e-16")
            value = f(Dual(x, mpmath.mpf(1)))
            assert abs(value.du - (f(x + step) - f(x - step)) / (2 * step)) < 1e-30
    assert f(1e-300) == 1e-300


def test_the_library_follows_the_number() -> None:
    assert namespace(1, 2.0, Fraction(1, 2)) is math
    assert namespace(mpmath.mpf(1)) is mpmath
    assert namespace(Dual(mpmath.mpf(1), 0)) is mpmath
    assert namespace(np.float64(1)) is np
    assert namespace(sympy.Integer(1), 1.0) is sympy
    assert isinstance(sin(0.5), float)
    assert isinstance(sin(mpmath.mpf("0.5")), mpmath.mpf)
    assert atan2(1.0, -1.0) == math.atan2(1.0, -1.0)


def test_poles_and_zero_divisors_are_errors() -> None:
    with pytest.raises(ZeroDivisorError, match="zero divisor has no square root"):
        sqrt(Dual(0.0, 1.0))
    with pytest.raises(ZeroDivisorError, match="tan has a pole"):
        tan(Dual(sympy.pi / 2, sympy.Integer(1)))
    with pytest.raises(ZeroDivisorError, match="cot has a pole"):
        cot(0.0)


STEPS = 3
NEAR = 1e-3  # tolerance; at the reference point an angle and its tangent t ≤ 1/37 differ by t³/3


@pytest.fixture(scope="module")
def field() -> AngleField:
    return AngleField(("a", "b"), {"alpha": STEPS})


def at_reference(element: Element) -> float:
    at = element.ring.value
    return float(at(element.numerator) / at(element.denominator))


def test_reference_point_is_consistent(field: AngleField) -> None:
    values = {name: at_reference(field.symbol(name)) for name in field.names}
    assert values["pi"] == pytest.approx(math.pi, abs=1e-6)
    assert values["tan_alpha"] == pytest.approx(math.tan(values["alpha"] / (2 * STEPS)), rel=NEAR)
    assert len(set(values.values())) == len(values)
    assert min(values.values()) > 0


@pytest.mark.parametrize("k", range(-2 * STEPS, 2 * STEPS + 1))
def test_sine_and_cosine_at_the_reference_point(field: AngleField, k: int) -> None:
    share, length = field.symbol("alpha") * Fraction(k, STEPS), field.symbol("a")
    assert field.atan2(length * field.sin(share), length * field.cos(share)) == share
    for quarters in range(-1, 5):
        angle = share + field.symbol("pi") * Fraction(quarters, 2)
        assert at_reference(field.sin(angle)) == pytest.approx(math.sin(at_reference(angle)), abs=NEAR)
        assert at_reference(field.cos(angle)) == pytest.approx(math.cos(at_reference(angle)), abs=NEAR)
        assert field.sin(angle) ** 2 + field.cos(angle) ** 2 == 1


def test_other_angles_are_refused(field: AngleField) -> None:
    a, alpha = field.symbol("a"), field.symbol("alpha")
    for wrong in (a, alpha / (2 * STEPS), alpha * a, alpha + a, 1 / alpha, field.symbol("pi") / 3, field.constant(1)):
        with pytest.raises(NotExactError):
            field.sin(wrong)
    with pytest.raises(NotExactError):
        field.atan2(a, field.constant(1))
    with pytest.raises(NotExactError):
        field.atan2(-field.sin(alpha), a * field.cos(alpha))


def test_arithmetic_agrees_at_the_reference_point(field: AngleField) -> None:
    a, b = field.symbol("a"), field.symbol("b")
    x, y = at_reference(a), at_reference(b)
    made = [
        (a + b, x + y), (a - b, x - y), (2 - a, 2 - x), (a - 2, x - 2), (a * b, x * y), (a / b, x / y), (3 / a, 3 / x),
        (a**3, x**3), (a**-2, x**-2), (a**0, 1.0), (-a, -x), (+a, x), (abs(a - b), abs(x - y)),
        (abs(b - a), abs(x - y)), (a / b + b / a, x / y + y / x), (a / b + 1 / b, (x + 1) / y),
    ]  # fmt: skip
    for element, value in made:
        assert at_reference(element) == pytest.approx(value)
    root = ((a - b) * (a - b) / (4 * a * a)).sqrt()
    assert at_reference(root) == pytest.approx(abs(x - y) / (2 * x))
    assert (a * b) / (b * b) == a / b
    assert a != b
    assert not (a - a)
    with pytest.raises(ZeroDivisionError):
        a / (b - b)
