"""Dual numbers: zero divisors are the numbers with real part zero; numbers of every type mix with them."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy

from derive.algebra import Dual, Vector, ZeroDivisorError, dual_part, real_part


@pytest.mark.parametrize("divide", [lambda z: 1 / z, lambda z: Dual(0, 1) / z, lambda z: z.inverse(), lambda z: z**-1])
@pytest.mark.parametrize("zero", [0, 0.0, Fraction(0), mpmath.mpf(0), sympy.Integer(0)])
def test_division_by_zero_divisor_names_the_reason(divide, zero) -> None:
    with pytest.raises(ZeroDivisorError, match="real part zero: it is a zero divisor"):
        divide(Dual(zero, 1))
    assert issubclass(ZeroDivisorError, ZeroDivisionError)


def test_power_of_a_zero_divisor() -> None:
    assert Dual(0, 3) ** 0 == 1
    assert Dual(0, 3) ** 1 == Dual(0, 3)


@pytest.mark.parametrize("exponent", [0.5, Fraction(1, 2), True])
def test_only_integer_powers(exponent) -> None:
    with pytest.raises(TypeError):
        Dual(2, 3) ** exponent


def test_magnitude_squares_to_the_square() -> None:
    assert (abs(Dual(-2, 3)), abs(Dual(2, 3)), abs(Dual(0, -3))) == (Dual(2, -3), Dual(2, 3), Dual(0, 3))


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
