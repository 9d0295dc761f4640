"""Numbers of 50 digits: long and foreign ones, comparison with a tolerance, undefined results by IEEE rules."""

from __future__ import annotations

import decimal
from fractions import Fraction

import mpmath
import pytest

from derive.codegen.validation.decimals import EXACT_DIGITS, Decimal, close

pytestmark = pytest.mark.smoke

NAN, INFINITE = Decimal(mpmath.nan), Decimal(mpmath.inf)


def exactly(number: Decimal) -> Fraction:
    return Fraction(number.value)


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
