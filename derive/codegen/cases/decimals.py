"""Numbers of 50 digits which kernels take inside object arrays, and how near to one another they have to be."""

from __future__ import annotations

import decimal
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import mpmath

from ...maps.chart import Chart
from .maps_at import Flat

DIGITS = 50

CONSTANTS = mpmath.mpf(10) ** -40
"""What constants of as many digits are off by."""

CONDITION = mpmath.mpf(10) ** 8
"""What errors of constants and scalars grow by, at most, in the results of the seeded cases."""


NUMBERS = decimal.Context(prec=DIGITS, Emin=decimal.MIN_EMIN, Emax=decimal.MAX_EMAX, traps=[])
"""What is not defined is NaN, and a quotient by zero infinite, for a selection computes both sides, and the one not
taken may divide by zero. Zeros have no sign that counts."""

TWO = decimal.Decimal(2)
NAN = decimal.Decimal("NaN")
LESS, GREATER = decimal.Decimal(-1), decimal.Decimal(1)


class Decimal:
    """A real number of 50 digits: + - * / with exact partners, comparison, ``abs`` and the functions of kernels.

    These but for ``sqrt`` are to as many digits as mpmath works with.
    """

    __slots__ = ("value",)

    def __init__(self, value: Any) -> None:
        self.value = value if isinstance(value, decimal.Decimal) else _of(value)

    @staticmethod
    def _value(other: object) -> decimal.Decimal:
        if isinstance(other, Decimal):
            return other.value
        if isinstance(other, int | Fraction):
            return _of(other)
        raise TypeError(f"a kernel mixed a 50-digit number with {type(other).__name__} {other!r}")

    def __add__(self, other: object) -> Decimal:
        return Decimal(NUMBERS.add(self.value, self._value(other)))

    def __sub__(self, other: object) -> Decimal:
        return Decimal(NUMBERS.subtract(self.value, self._value(other)))

    def __rsub__(self, other: object) -> Decimal:
        return Decimal(NUMBERS.subtract(self._value(other), self.value))

    def __mul__(self, other: object) -> Decimal:
        return Decimal(NUMBERS.multiply(self.value, self._value(other)))

    def __truediv__(self, other: object) -> Decimal:
        return Decimal(NUMBERS.divide(self.value, self._value(other)))

    def __rtruediv__(self, other: object) -> Decimal:
        return Decimal(NUMBERS.divide(self._value(other), self.value))

    __radd__, __rmul__ = __add__, __mul__

    def __neg__(self) -> Decimal:
        return Decimal(NUMBERS.minus(self.value))

    def __lt__(self, other: object) -> bool:
        return NUMBERS.compare(self.value, self._value(other)) == LESS

    def __gt__(self, other: object) -> bool:
        return NUMBERS.compare(self.value, self._value(other)) == GREATER

    def __eq__(self, other: object) -> bool:
        return self.value == self._value(other)

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
        return Decimal(mpmath.tan(_binary(self.value)))

    def arctan2(self, other: object) -> Decimal:
        return Decimal(mpmath.atan2(_binary(self.value), _binary(self._value(other))))

    def expm1(self) -> Decimal:
        return Decimal(mpmath.expm1(_binary(self.value)))

    def log1p(self) -> Decimal:
        return Decimal(mpmath.log1p(_binary(self.value)) if self > -1 else mpmath.nan)


def _of(value: Any) -> decimal.Decimal:
    """An int, a Fraction or a number of mpmath; nothing else is to so many digits."""
    if isinstance(value, int):
        return NUMBERS.create_decimal(value)
    if isinstance(value, Fraction):
        return NUMBERS.divide(decimal.Decimal(value.numerator), decimal.Decimal(value.denominator))
    if not isinstance(value, mpmath.mpf):
        raise TypeError(f"no number of {DIGITS} digits: {type(value).__name__} {value!r}")
    if not mpmath.isfinite(value):
        return decimal.Decimal(float(value))
    mantissa, exponent = value.man_exp
    digits = decimal.Decimal(int(-mantissa if value < 0 else mantissa))  # of its own type where gmpy2 is installed
    scale = NUMBERS.power(TWO, abs(exponent))
    return NUMBERS.multiply(digits, scale) if exponent > 0 else NUMBERS.divide(digits, scale)


def _binary(value: decimal.Decimal) -> Any:
    """The same as a number of mpmath, which has the functions."""
    return mpmath.mpf(str(value) if value.is_finite() else float(value))


def later(function: Callable[..., Flat], *arguments: Any) -> Callable[[], Flat]:
    """What computes a result to these digits, whenever it is asked for."""

    def computed() -> Flat:
        with mpmath.workdps(DIGITS):
            return function(*arguments)

    return computed


def tolerance(chart: Chart, remainder: float = 0.0) -> Decimal:
    """How far results of 50-digit numbers may be off, by 1 and their own size."""
    return Decimal(CONDITION * max(CONSTANTS, mpmath.mpf(chart.remainder), mpmath.mpf(remainder)))


def close(got: Any, expected: Any, tolerance: Decimal) -> bool:
    """Whether a result of 50-digit numbers is the expected one."""
    value, wanted = (number if isinstance(number, Decimal) else Decimal(number) for number in (got, expected))
    if wanted.value.is_nan():
        return value.value.is_nan()
    return abs(value - wanted) < tolerance * (1 + abs(wanted))
