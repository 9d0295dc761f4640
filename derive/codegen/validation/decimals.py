"""Numbers of 50 digits that kernels take in object arrays, and the tolerance of their results."""

from __future__ import annotations

import decimal
from collections.abc import Callable
from fractions import Fraction
from functools import lru_cache, partial
from typing import Any

import mpmath

from ...maps.chart import Chart
from .reals import Real

EXACT_DIGITS = 50
SCALARS_ERROR = mpmath.mpf(10) ** -40  # error of scalars of 50 digits, of which cancellation takes ten at most
CONDITION_MAX = mpmath.mpf(10) ** 8  # largest growth of errors from scalars to results
NUMBERS = decimal.Context(prec=EXACT_DIGITS, Emin=decimal.MIN_EMIN, Emax=decimal.MAX_EMAX, traps=[])
"""Context without traps: a selection also computes the side not taken, where results may be NaN or infinite."""

ONE, TWO = decimal.Decimal(1), decimal.Decimal(2)


def _operation(compute: Callable[..., decimal.Decimal], swapped: bool = False) -> Callable[[Decimal, object], Decimal]:
    """Return an operation of a `Decimal` with an exact number; inlined for speed, as kernels consist of these steps."""

    def operation(self: Decimal, other: object) -> Decimal:
        value = other.value if type(other) is Decimal else _partner(other)
        result = _new(Decimal)
        result.value = compute(value, self.value) if swapped else compute(self.value, value)
        return result

    return operation


def _partner(other: object) -> decimal.Decimal:
    if not isinstance(other, Decimal | int | Fraction):
        raise TypeError(f"a kernel mixed a 50-digit number with {type(other).__name__} {other!r}")
    return other.value if isinstance(other, Decimal) else _of(other)


_new = object.__new__
_integer = lru_cache(maxsize=256)(NUMBERS.create_decimal)


class Decimal:
    """Real number of 50 digits: + - * / with exact numbers, comparison, ``abs`` and the functions of kernels."""

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
        return NUMBERS.compare(self.value, _partner(other)) == -1

    def __gt__(self, other: object) -> bool:
        return NUMBERS.compare(self.value, _partner(other)) == 1

    def __eq__(self, other: object) -> bool:
        return self.value == _partner(other)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return str(self.value)

    def __abs__(self) -> Decimal:
        return Decimal(NUMBERS.abs(self.value))

    def sqrt(self) -> Decimal:
        return Decimal(NUMBERS.sqrt(self.value))

    def tan(self) -> Decimal:  # tan of infinity in mpmath would raise a flag that makes NumPy warn
        return _computed(mpmath.tan, mpmath.mp.prec, self.value) if self.value.is_finite() else Decimal(mpmath.nan)

    def arctan2(self, other: object) -> Decimal:
        return _computed(mpmath.atan2, mpmath.mp.prec, self.value, _partner(other))

    def expm1(self) -> Decimal:
        return _computed(mpmath.expm1, mpmath.mp.prec, self.value)

    def log1p(self) -> Decimal:
        return _computed(mpmath.log1p, mpmath.mp.prec, self.value) if self > -1 else Decimal(mpmath.nan)


@lru_cache(maxsize=4096)  # calls in different layouts repeat the arguments
def _computed(function: Callable[..., Any], precision: int, *values: decimal.Decimal) -> Decimal:
    """Return the value of a function of mpmath; ``precision`` is the working precision, a key of the cache."""
    return Decimal(function(*map(_binary, values)))


def _of(value: Any) -> decimal.Decimal:
    """Convert a decimal number, an int, a Fraction, a number of mpmath or flint; refuse types of fewer digits."""
    if isinstance(value, decimal.Decimal):
        return value
    if isinstance(value, int):
        return _integer(value)
    if isinstance(value, Fraction):
        return NUMBERS.divide(decimal.Decimal(value.numerator), decimal.Decimal(value.denominator))
    if isinstance(value, Real):
        mantissa, exponent = map(int, value.mid().man_exp() if value.is_finite() else (0, 0))
    elif isinstance(value, mpmath.mpf):
        sign, mantissa, exponent, _ = value._mpf_
        mantissa = int(-mantissa if sign else mantissa)  # an mpz if gmpy2 is installed
    else:
        raise TypeError(f"no number of {EXACT_DIGITS} digits: {type(value).__name__} {value!r}")
    if not mantissa:
        return decimal.Decimal(float(value))  # 0, infinite or NaN
    digits = decimal.Decimal(mantissa)
    scale = _power_of_two(abs(exponent))
    return NUMBERS.multiply(digits, scale) if exponent > 0 else NUMBERS.divide(digits, scale)


_power_of_two = lru_cache(maxsize=1024)(partial(NUMBERS.power, TWO))


def _binary(value: decimal.Decimal) -> Any:
    """Return the mpmath number of a decimal number; mpmath has ``tan`` and other functions."""
    if not value.is_finite():
        return mpmath.mpf(float(value))
    places = EXACT_DIGITS - value.adjusted()  # shift that makes the number an integer with all its digits
    return mpmath.mpf(int(NUMBERS.scaleb(value, places))) / mpmath.mpf(10) ** places


def tolerance(chart: Chart, remainder: float = 0.0) -> Decimal:
    """Return the largest allowed error of 50-digit results, relative to 1 plus their size."""
    return Decimal(CONDITION_MAX * max(SCALARS_ERROR, mpmath.mpf(chart.remainder), mpmath.mpf(remainder)))


def close(got: Any, expected: Any, tolerance: Decimal) -> bool:
    """Tell whether a 50-digit result agrees with the expected one within a tolerance."""
    value, wanted = (number.value if isinstance(number, Decimal) else _of(number) for number in (got, expected))
    if wanted.is_nan():
        return value.is_nan()
    bound = NUMBERS.multiply(tolerance.value, NUMBERS.add(ONE, NUMBERS.abs(wanted)))
    return NUMBERS.compare(NUMBERS.abs(NUMBERS.subtract(value, wanted)), bound) == -1
