"""Real numbers of expected values: balls of flint in the working precision, ten times faster than numbers of mpmath.

A comparison is true where it is certain; a number that was rounded equals none. Numbers without rounding are exact.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator
from contextlib import AbstractContextManager, contextmanager
from fractions import Fraction
from typing import Any

import mpmath
from flint import arb, ctx

Real = arb
NAN, INFINITE = Real.nan(), Real.pos_inf()


@contextmanager
def bits(count: int) -> Iterator[None]:
    """Set the working precision, of mpmath too, which inverts φ."""
    before = ctx.prec, mpmath.mp.prec
    ctx.prec = mpmath.mp.prec = count
    try:
        yield
    finally:
        ctx.prec, mpmath.mp.prec = before


def digits(count: int) -> AbstractContextManager[None]:
    """Set the working precision by its decimal digits."""
    return bits(mpmath.libmp.dps_to_prec(count))


def precision() -> int:
    """Return the number of working bits."""
    return int(ctx.prec)


def rounding(share: float = 1) -> Any:
    """Return the machine epsilon of the working precision, or a number of that ``share`` of its digits."""
    return Real(2) ** (Real(share) * (1 - precision()))


def nearest(number: Any) -> int:
    """Return the nearest integer; of two, the even one."""
    mantissa, exponent = Real(number).mid().man_exp()
    return round(Fraction(int(mantissa)) * Fraction(2) ** int(exponent))


def exact(numbers: Iterable[Any]) -> tuple[Any, ...]:
    """Return the midpoints of numbers, as kernels take them."""
    return tuple(number.mid() if isinstance(number, Real) else number for number in numbers)


def key(value: Any) -> Hashable:
    """Return what stands for a value in a cache: a number has no hash."""
    if isinstance(value, Real):
        return value.mid().man_exp() if value.is_finite() else str(value)
    return tuple(map(key, value)) if isinstance(value, tuple) else value
