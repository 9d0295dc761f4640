"""Dual numbers: a commutative ring; zero divisors are the numbers with real part zero."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

from derive.algebra import Dual, Vector, ZeroDivisorError, dual_part, real_part

fractions = st.fractions(min_value=-9, max_value=9, max_denominator=9)
duals = st.builds(Dual, fractions, fractions)
invertible = duals.filter(lambda a: a.re != 0)
few = settings(max_examples=20)


@few
@given(duals, duals, duals)
def test_ring_laws(a: Dual, b: Dual, c: Dual) -> None:
    assert a + b == b + a
    assert a * b == b * a
    assert (a + b) + c == a + (b + c)
    assert (a * b) * c == a * (b * c)
    assert a * (b + c) == a * b + a * c
    assert a + 0 == a
    assert a * 1 == a
    assert a - a == 0
    assert a + -a == 0


def test_epsilon_squares_to_zero() -> None:
    assert Dual(0, 1) ** 2 == 0
    assert Dual(0, 1) * Dual(0, 5) == 0
    assert Dual(2, 3) * Dual(5, 7) == Dual(10, 29)


@few
@given(duals, invertible)
def test_quotient_undoes_product(a: Dual, b: Dual) -> None:
    assert a / b * b == a
    assert b * b.inverse() == 1
    assert 3 / b == 3 * b.inverse()
    assert a / 3 * 3 == a


@pytest.mark.parametrize("divide", [lambda z: 1 / z, lambda z: Dual(0, 1) / z, lambda z: z.inverse(), lambda z: z**-1])
@pytest.mark.parametrize("zero", [0, 0.0, Fraction(0), mpmath.mpf(0), sympy.Integer(0)])
def test_division_by_zero_divisor_names_the_reason(divide, zero) -> None:
    with pytest.raises(ZeroDivisorError, match="real part zero: it is a zero divisor"):
        divide(Dual(zero, 1))
    assert issubclass(ZeroDivisorError, ZeroDivisionError)


@few
@given(invertible, st.integers(-6, 6))
def test_power_is_repeated_product(a: Dual, n: int) -> None:
    product = Dual(Fraction(1))
    for _ in range(abs(n)):
        product *= a
    assert a**n == (product if n >= 0 else product.inverse())


def test_power_of_a_zero_divisor() -> None:
    assert Dual(0, 3) ** 0 == 1
    assert Dual(0, 3) ** 1 == Dual(0, 3)


@pytest.mark.parametrize("exponent", [0.5, Fraction(1, 2), True])
def test_only_integer_powers(exponent) -> None:
    with pytest.raises(TypeError):
        Dual(2, 3) ** exponent


@few
@given(duals)
def test_magnitude_squares_to_the_square(a: Dual) -> None:
    assert abs(a) ** 2 == a**2
    assert abs(a).re >= 0
    assert (a.re != 0 or abs(a) == Dual(0, abs(a.du)))
    assert abs(a) == abs(-a)


def test_plain_numbers_are_dual_numbers_without_dual_part() -> None:
    assert Dual(3, 0) == 3
    assert Dual(3) == 3
    assert hash(Dual(3, 0)) == hash(3)
    assert Dual(3, 1) != 3
    assert Dual(3, 1) != Dual(3, 2)
    assert (real_part(7), dual_part(7)) == (7, 0)
    assert (real_part(Dual(7, 8)), dual_part(Dual(7, 8))) == (7, 8)


RING_X = sympy.ring("x", sympy.ZZ)[1]
FIELD_X = sympy.field("x", sympy.QQ)[1]
SCALARS = [2, 2.5, Fraction(2, 3), mpmath.mpf("2.5"), sympy.Symbol("s"), RING_X, FIELD_X, np.float64(2.5)]


@pytest.mark.parametrize("scalar", SCALARS, ids=lambda s: type(s).__name__)
def test_every_number_type_mixes_from_both_sides(scalar) -> None:
    a = Dual(scalar, 3)
    for result in (scalar * a, a * scalar):
        assert isinstance(result, Dual)
        assert result == Dual(scalar * scalar, 3 * scalar)
    assert scalar + a == a + scalar == Dual(scalar + scalar, 3)
    assert scalar - a == -(a - scalar) == Dual(0, -3)
    assert isinstance(scalar * Vector(1, 2, 3), Vector)
    assert scalar * Vector(1, 2, 3) == Vector(1, 2, 3) * scalar


def test_apply_is_value_and_slope() -> None:
    assert Dual(3, 5).apply(lambda a: a**3, lambda a: 3 * a**2) == Dual(3, 5) ** 3


@few
@given(invertible, duals)
def test_nested_dual_numbers_give_the_second_derivative(a: Dual, b: Dual) -> None:
    x = Dual(Dual(a.re, 1), Dual(1, 0))
    y = x**4
    assert y.du.du == 12 * a.re**2
    assert (b + x) - x == b + (x - x)
