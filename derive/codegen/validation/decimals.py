"""Numbers of 50 digits which kernels take inside object arrays, and how near to one another they have to be."""

from __future__ import annotations

import decimal
from collections.abc import Callable
from fractions import Fraction
from functools import lru_cache, partial
from typing import Any

import mpmath

from ...maps.chart import Chart

DIGITS = 50

CONSTANTS = mpmath.mpf(10) ** -40
"""What constants of as many digits are off by."""

CONDITION = mpmath.mpf(10) ** 8
"""What errors of constants and scalars grow by, at most, in the results of the seeded cases."""


NUMBERS = decimal.Context(prec=DIGITS, Emin=decimal.MIN_EMIN, Emax=decimal.MAX_EMAX, traps=[])
"""What is not defined is NaN, and a quotient by zero infinite, for a selection computes both sides, and the one not
taken may divide by zero. Zeros have no sign that counts."""

ONE, TWO = decimal.Decimal(1), decimal.Decimal(2)
NAN = decimal.Decimal("NaN")
LESS, GREATER = decimal.Decimal(-1), decimal.Decimal(1)


def _operation(compute: Callable[..., decimal.Decimal], swapped: bool = False) -> Callable[[Decimal, object], Decimal]:
    """An operation with an exact partner; each step of a kernel is one, so it makes its result without more calls."""

    def operation(self: Decimal, other: object) -> Decimal:
        value = other.value if type(other) is Decimal else _partner(other)
        result = _new(Decimal)
        result.value = compute(value, self.value) if swapped else compute(self.value, value)
        return result

    return operation


def _partner(other: object) -> decimal.Decimal:
    if isinstance(other, int):
        return _integer(other)
    if isinstance(other, Fraction):
        return _of(other)
    raise TypeError(f"a kernel mixed a 50-digit number with {type(other).__name__} {other!r}")


_new = object.__new__
_integer = lru_cache(maxsize=256)(NUMBERS.create_decimal)


class Decimal:
    """A real number of 50 digits: + - * / with exact partners, comparison, ``abs`` and the functions of kernels.

    These but for ``sqrt`` are to as many digits as mpmath works with.
    """

    __slots__ = ("value",)

    def __init__(self, value: Any) -> None:
        self.value = _of(value)

    __add__ = __radd__ = _operation(NUMBERS.add)
    __mul__ = __rmul__ = _operation(NUMBERS.multiply)
    __sub__, __rsub__ = _operation(NUMBERS.subtract), _operation(NUMBERS.subtract, swapped=True)
    __truediv__, __rtruediv__ = _operation(NUMBERS.divide), _operation(NUMBERS.divide, swapped=True)

    def __neg__(self) -> Decimal:
        return Decimal(NUMBERS.minus(self.value))

    def __lt__(self, other: object) -> bool:
        return NUMBERS.compare(self.value, _value(other)) == LESS

    def __gt__(self, other: object) -> bool:
        return NUMBERS.compare(self.value, _value(other)) == GREATER

    def __eq__(self, other: object) -> bool:
        return self.value == _value(other)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return str(self.value)

    def __abs__(self) -> Decimal:
        return Decimal(NUMBERS.abs(self.value))

    def sqrt(self) -> Decimal:
        return Decimal(NUMBERS.sqrt(self.value))

    def tan(self) -> Decimal:
        if not self.value.is_finite():  # mpmath would raise a flag that NumPy warns of
            return Decimal(NAN)
        return _computed(mpmath.tan, mpmath.mp.prec, self.value)

    def arctan2(self, other: object) -> Decimal:
        return _computed(mpmath.atan2, mpmath.mp.prec, self.value, _value(other))

    def expm1(self) -> Decimal:
        return _computed(mpmath.expm1, mpmath.mp.prec, self.value)

    def log1p(self) -> Decimal:
        return _computed(mpmath.log1p, mpmath.mp.prec, self.value) if self > -1 else Decimal(NAN)


@lru_cache(maxsize=4096)  # every form of a program, in every layout, asks for the same
def _computed(function: Callable[..., Any], precision: int, *values: decimal.Decimal) -> Decimal:
    """A function of mpmath, which works with so many bits."""
    return Decimal(function(*map(_binary, values)))


def _value(other: object) -> decimal.Decimal:
    return other.value if isinstance(other, Decimal) else _partner(other)


def _of(value: Any) -> decimal.Decimal:
    """A decimal number, an int, a Fraction or a number of mpmath; nothing else is to so many digits."""
    if isinstance(value, decimal.Decimal):
        return value
    if isinstance(value, int):
        return NUMBERS.create_decimal(value)
    if isinstance(value, Fraction):
        return NUMBERS.divide(decimal.Decimal(value.numerator), decimal.Decimal(value.denominator))
    if not isinstance(value, mpmath.mpf):
        raise TypeError(f"no number of {DIGITS} digits: {type(value).__name__} {value!r}")
    sign, mantissa, exponent, _ = value._mpf_
    if not mantissa:
        return decimal.Decimal(float(value))  # 0, infinite or none
    digits = decimal.Decimal(int(-mantissa if sign else mantissa))  # of its own type where gmpy2 is installed
    scale = _power_of_two(abs(exponent))
    return NUMBERS.multiply(digits, scale) if exponent > 0 else NUMBERS.divide(digits, scale)


_power_of_two = lru_cache(maxsize=1024)(partial(NUMBERS.power, TWO))


def _binary(value: decimal.Decimal) -> Any:
    """The same as a number of mpmath, which has the functions."""
    if not value.is_finite():
        return mpmath.mpf(float(value))
    places = DIGITS - value.adjusted()  # of a whole number with all its digits
    return mpmath.mpf(int(NUMBERS.scaleb(value, places))) / _power_of_ten(places, mpmath.mp.prec)


@lru_cache(maxsize=256)
def _power_of_ten(exponent: int, precision: int) -> Any:
    """In the working precision, which is named for what is kept."""
    return mpmath.mpf(10) ** exponent


def tolerance(chart: Chart, remainder: float = 0.0) -> Decimal:
    """How far results of 50-digit numbers may be off, by 1 and their own size."""
    return Decimal(CONDITION * max(CONSTANTS, mpmath.mpf(chart.remainder), mpmath.mpf(remainder)))


def close(got: Any, expected: Any, tolerance: Decimal) -> bool:
    """Whether a result of 50-digit numbers is the expected one."""
    value, wanted = (number.value if isinstance(number, Decimal) else _of(number) for number in (got, expected))
    if wanted.is_nan():
        return value.is_nan()
    most = NUMBERS.multiply(tolerance.value, NUMBERS.add(ONE, NUMBERS.abs(wanted)))
    return NUMBERS.compare(NUMBERS.abs(NUMBERS.subtract(value, wanted)), most) == LESS
