"""Numbers of 50 digits follow real arithmetic; undefined results follow IEEE rules."""

from __future__ import annotations

import decimal
import operator
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import mpmath
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from derive.codegen.validation.decimals import EXACT_DIGITS, Decimal, close

pytestmark = pytest.mark.smoke

few = settings(max_examples=30)
RATIONALS = st.fractions(-(10**6), 10**6, max_denominator=10**6)
ROUNDING = Fraction(1, 2 * 10 ** (EXACT_DIGITS - 1))
NAN, INFINITE = Decimal(mpmath.nan), Decimal(mpmath.inf)


def exactly(number: Decimal) -> Fraction:
    return Fraction(number.value)


@few
@given(a=RATIONALS, b=RATIONALS)
@pytest.mark.parametrize("operation", [operator.add, operator.sub, operator.mul, operator.truediv])
def test_operations_are_rounded_to_50_digits(operation: Callable[..., Any], a: Fraction, b: Fraction) -> None:
    if operation is operator.truediv and not b:
        return
    wanted = operation(a, b)
    for first, second in ((Decimal(a), Decimal(b)), (a, Decimal(b)), (Decimal(a), b)):
        apart = abs(exactly(operation(first, second)) - wanted)
        if operation in (operator.add, operator.sub):  # both terms and the result are rounded
            assert apart <= ROUNDING * (1 + ROUNDING) * (abs(a) + abs(b) + abs(wanted))
        else:
            assert apart <= 3 * ROUNDING * (1 + 4 * ROUNDING) * abs(wanted)


@few
@given(a=RATIONALS, b=RATIONALS)
def test_comparison_negation_and_absolute_value_are_exact(a: Fraction, b: Fraction) -> None:
    first, second = Decimal(a), Decimal(b)
    assert ((first < second), (first > second), (first == second)) == ((a < b), (a > b), (a == b))
    assert (first < b, first > b, first == b) == (a < b, a > b, a == b)
    assert (exactly(-first), exactly(abs(first))) == (-exactly(first), abs(exactly(first)))


@few
@given(bits=st.integers(-(2**200), 2**200), shift=st.integers(-1200, 1200))
def test_mpmath_numbers_are_converted_to_50_digits(bits: int, shift: int) -> None:
    with mpmath.workprec(200):
        value = mpmath.ldexp(mpmath.mpf(bits), shift)
        exact = bits * Fraction(2) ** shift
        assert abs(exactly(Decimal(value)) - exact) <= 5 * ROUNDING * abs(exact)  # the power of 2 adds one unit


class Limb:
    """Integer type other than int, like the mpz that mpmath takes from gmpy2."""

    def __init__(self, value: int) -> None:
        self.value = value

    def __int__(self) -> int:
        return self.value

    def __neg__(self) -> Limb:
        return Limb(-self.value)


def test_decimals_accept_foreign_integers() -> None:
    for sign, wanted in ((0, Fraction(3, 4)), (1, Fraction(-3, 4))):
        assert exactly(Decimal(mpmath.mp.make_mpf((sign, Limb(3), -2, 2)))) == wanted


def test_long_numbers_are_rounded_before_anything_else() -> None:
    assert Decimal(10**5000).value.adjusted() == 5000
    assert exactly(Decimal(10**60 + 1)) == 10**60
    with mpmath.workdps(EXACT_DIGITS):
        for number in (10**7, 10**12):  # an exact power of 2 would take too long
            wanted = int(mpmath.floor(number / mpmath.ln(10)))
            assert Decimal(number).expm1().value.adjusted() == wanted
        assert Decimal(10**5000).tan().value.is_finite()
        tiny = Decimal(decimal.Decimal("1e-3000000"))  # the fraction has three million digits
        assert abs(tiny.tan() / tiny - 1) < Fraction(1, 10**48)


@pytest.mark.parametrize("name", ["sqrt", "tan", "expm1", "log1p"])
def test_functions_match_mpmath(name: str) -> None:
    with mpmath.workdps(EXACT_DIGITS):
        for number in (mpmath.mpf(7) / 9, mpmath.mpf(3) * 10**-30, mpmath.mpf(2) ** 70):
            wanted = getattr(mpmath, name)(number)
            if (mpmath.isfinite(wanted) and number < 1) or name != "expm1":
                assert close(getattr(Decimal(number), name)(), wanted, Decimal(mpmath.mpf(10) ** -45))


def test_arctan2_agrees_with_mpmath() -> None:
    with mpmath.workdps(EXACT_DIGITS):
        for y, x in ((3, -4), (-3, -4), (0, -1), (5, 0)):
            found = Decimal(y).arctan2(Decimal(x))
            assert close(found, mpmath.atan2(y, x), Decimal(mpmath.mpf(10) ** -48))


def test_undefined_results_are_nan() -> None:
    one, zero = Decimal(1), Decimal(0)
    outside = [zero / zero, Decimal(-1).sqrt(), Decimal(-2).log1p(), INFINITE - INFINITE]
    for number in (*outside, NAN * 0, NAN + one, NAN.log1p()):
        assert [number == number, number < one, number > one] == [False] * 3
    assert [one / zero, -one / zero, one / INFINITE] == [INFINITE, -INFINITE, zero]
    assert NAN.tan() != NAN.tan()
    for other in (1.5, "1", None):
        with pytest.raises(TypeError, match="a kernel mixed a 50-digit number with"):
            one + other
        with pytest.raises(TypeError, match="no number of 50 digits: "):
            close(other, one, one)


def test_close_tolerance_is_relative_to_1_plus_size() -> None:
    pairs = {
        True: [(Fraction(10009, 10000), 1), (100, Fraction(1001, 10)), (mpmath.nan, NAN), (NAN, mpmath.nan)],
        False: [(Fraction(1003, 1000), 1), (99, 100), (NAN, 1), (1, NAN), (INFINITE, 1), (1, INFINITE)],
    }
    for wanted, numbers in pairs.items():
        for got, expected in numbers:
            assert close(got, expected, Decimal(Fraction(1, 1000))) is wanted, (got, expected)
