"""Numbers of 50 digits which kernels take inside object arrays, and how near to one another they have to be."""

from __future__ import annotations

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


class Decimal:
    """A real number of 50 digits: + - * / with exact partners, comparison, ``abs`` and the functions of kernels."""

    __slots__ = ("value",)

    def __init__(self, value: Any) -> None:
        self.value = mpmath.mpf(value.numerator) / value.denominator if isinstance(value, int | Fraction) else value

    @staticmethod
    def _value(other: object) -> Any:
        if isinstance(other, Decimal):
            return other.value
        if isinstance(other, int | Fraction):
            return Decimal(other).value
        raise TypeError(f"a kernel mixed a 50-digit number with {type(other).__name__} {other!r}")

    def __add__(self, other: object) -> Decimal:
        return Decimal(self.value + self._value(other))

    def __sub__(self, other: object) -> Decimal:
        return Decimal(self.value - self._value(other))

    def __rsub__(self, other: object) -> Decimal:
        return Decimal(self._value(other) - self.value)

    def __mul__(self, other: object) -> Decimal:
        return Decimal(self.value * self._value(other))

    def __truediv__(self, other: object) -> Decimal:
        return Decimal(_quotient(self.value, self._value(other)))

    def __rtruediv__(self, other: object) -> Decimal:
        return Decimal(_quotient(self._value(other), self.value))

    __radd__, __rmul__ = __add__, __mul__

    def __neg__(self) -> Decimal:
        return Decimal(-self.value)

    def __lt__(self, other: object) -> bool:
        return bool(self.value < self._value(other))

    def __gt__(self, other: object) -> bool:
        return bool(self.value > self._value(other))

    def __eq__(self, other: object) -> bool:
        return bool(self.value == self._value(other))

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return str(mpmath.nstr(self.value, DIGITS))

    def __abs__(self) -> Decimal:
        return Decimal(abs(self.value))

    def sqrt(self) -> Decimal:
        return Decimal(mpmath.sqrt(self.value) if self.value >= 0 else mpmath.nan)

    def tan(self) -> Decimal:
        return Decimal(mpmath.tan(self.value))

    def arctan2(self, other: object) -> Decimal:
        return Decimal(mpmath.atan2(self.value, self._value(other)))

    def expm1(self) -> Decimal:
        return Decimal(mpmath.expm1(self.value))

    def log1p(self) -> Decimal:
        return Decimal(mpmath.log1p(self.value) if self.value > -1 else mpmath.nan)


def _quotient(a: Any, b: Any) -> Any:
    """The IEEE quotient: a selection computes both sides, and the one not taken may divide by zero."""
    if b:
        return a / b
    return a * mpmath.inf if a else mpmath.nan


def later(function: Callable[..., Flat], *arguments: Any) -> Callable[[], Flat]:
    """What computes a result to these digits, whenever it is asked for."""

    def computed() -> Flat:
        with mpmath.workdps(DIGITS):
            return function(*arguments)

    return computed


def tolerance(chart: Chart, remainder: float = 0.0) -> Any:
    """How far results of 50-digit numbers may be off, by 1 and their own size."""
    return CONDITION * max(CONSTANTS, mpmath.mpf(chart.remainder), mpmath.mpf(remainder))


def close(got: Any, expected: Any, tolerance: Any) -> bool:
    """Whether a result of 50-digit numbers is the expected one."""
    value = got.value if isinstance(got, Decimal) else Decimal(got).value
    if mpmath.isnan(expected):
        return bool(mpmath.isnan(value))
    return bool(abs(value - expected) <= tolerance * (1 + abs(expected)))
