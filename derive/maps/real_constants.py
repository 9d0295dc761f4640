"""Real constants and polynomials, written with small integers that every number type holds; limits of rounding noise.

A coefficient is split into levels of `BITS` bits, ``c = (n0 + (n1 + n2/B)/B)/2^k`` with ``B = 2^BITS``. Exact numbers
and floats compute with the same rational coefficients.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import Any

import mpmath
import sympy

from ..algebra import Coefficient
from ..algebra.arithmetic import Arithmetic

BITS, LEVELS = 22, 3
SMALL = 2**24
"""Largest integer that every number type holds exactly."""


CONSTANT_DIGITS = 60
"""Decimal digits of a real constant before it is split."""


def number(expression: sympy.Expr) -> Any:
    """Return a constant as a fraction of small integers, or else as an mpmath number."""
    if expression.is_Rational:
        fraction = Fraction(int(expression.p), int(expression.q))
        if is_small(fraction):
            return fraction
    with mpmath.workdps(CONSTANT_DIGITS):
        return mpmath.mpf(expression.evalf(CONSTANT_DIGITS))


def shifted(value: Coefficient, bits: int, m: Arithmetic) -> Coefficient:
    """Return ``value/2^bits``, by powers of two that are small integers."""
    while bits > BITS:
        value, bits = m.div(value, 2**BITS), bits - BITS
    while bits < -BITS:
        value, bits = value * 2**BITS, bits + BITS
    return value * 2**-bits if bits < 0 else m.div(value, 2**bits) if bits else value


@dataclass(frozen=True)
class Polynomial:
    """Polynomial ``Σ c_k t^k`` in ``t = (x − centre)/2^scale``, with coefficients split into levels."""

    levels: tuple[tuple[int, ...], ...]
    shift: int  # the first level is divided by 2^shift
    scale: int
    centre: Fraction = Fraction(0)

    def at(self, x: Coefficient, m: Arithmetic, name: str) -> Coefficient:
        centred = x - self.centre if self.centre else x
        t = m.name(f"{name}_t", shifted(centred, self.scale, m))
        unit = m.name(f"{name}_unit", t - t + 1) if self._is_long else 1
        total: Coefficient = 0
        for place, level in reversed(list(enumerate(self.levels))):
            value: Coefficient = 0
            for coefficient in reversed(level):
                value = value * t + coefficient * unit
            below = self.shift if place == 0 else BITS
            total = shifted(value + total, below, m)
        return m.name(name, total)

    @property
    def _is_long(self) -> bool:
        """Tell whether this is a constant with several levels, whose powers of two exceed the integers of float32."""
        return not any(any(level[1:]) for level in self.levels) and any(any(level) for level in self.levels[1:])

    @cached_property
    def coefficients(self) -> list[Any]:
        parts = [mpmath.ldexp(1, -self.shift - BITS * place) for place in range(len(self.levels))]
        return [mpmath.fdot(digits, parts) for digits in zip(*self.levels, strict=True)]

    @property
    def rounding(self) -> Any:
        """Bound of the error of splitting the coefficients, for |t| ≤ 1."""
        return len(self.levels[0]) * mpmath.mpf(2) ** (-self.shift - BITS * (len(self.levels) - 1) - 1)


def polynomial(
    coefficients: Sequence[Any], scale: int = 0, levels: int = LEVELS, centre: Fraction = Fraction(0)
) -> Polynomial:
    """Return the polynomial with these coefficients of powers of ``(x − centre)/2^scale``, split into levels."""
    with mpmath.workprec(max(mpmath.mp.prec, BITS * (levels + 1))):  # a lower precision would truncate the last level
        largest = max(map(abs, coefficients))
        shift = BITS - 1 - int(mpmath.ceil(mpmath.log(largest, 2))) if largest else 0
        rest, found = [c * mpmath.mpf(2) ** shift for c in coefficients], []
        for _ in range(levels):
            level = tuple(int(mpmath.nint(c)) for c in rest)
            found.append(level)
            rest = [(c - n) * 2**BITS for c, n in zip(rest, level, strict=True)]
    return Polynomial(tuple(found), shift, scale, centre)


@lru_cache(maxsize=256)
def _split(number: Any, levels: int, precision: int) -> Polynomial:
    return polynomial([number], levels=levels)


def times(number: Any, value: Coefficient, m: Arithmetic, name: str, levels: int = LEVELS) -> Coefficient:
    if is_small(number):
        return m.div(number.numerator * value, number.denominator)
    split = _split(number, levels, mpmath.mp.prec)
    total: Coefficient = 0
    for place, (digit,) in reversed(list(enumerate(split.levels))):
        total = shifted(digit * value + total, split.shift if place == 0 else BITS, m)
    return m.name(name, total)


def plus(value: Coefficient, number: Any, m: Arithmetic, name: str, levels: int = LEVELS) -> Coefficient:
    """Return a value plus a real number; no power of two multiplies the value, which may be near overflow."""
    if is_small(number):
        return value + number
    split = _split(number, levels, mpmath.mp.prec)
    total, below = m.name(f"{name}_of", value), split.shift
    one = m.name(f"{name}_one", value - value + 1)
    for (digit,) in split.levels:
        total = total + shifted(digit * one, below, m)
        below += BITS
    return m.name(name, total)


def is_small(number: Any) -> bool:
    return isinstance(number, int | Fraction) and max(abs(number.numerator), number.denominator) <= SMALL


NOISE = 64
"""Divisor in the test for rounding noise: a term is noise if ``sum + term/NOISE`` equals the sum.

Noise is below 16 to 32 eps of the sum. At half a turn, errors are up to 4 eps of the length for v, 4π eps for α, and
2π eps for ``cot(α/2)``.
"""

NOISE_GIVEN = NOISE // 4
"""Divisor for noise in given quaternions and matrices: a side that inverse maps take is one that v keeps."""

NOISE_OF_ANGLE = NOISE // 8
"""Divisor for noise in a given angle at the edge, where φ has the side of θ = α/2n ≤ π/2.

The rule lets α be off by 8 roundings of the edge, so θ by 8 π/2 < 13 roundings. `NOISE` allows 32 for cos θ.
"""

NOISE_OF_STEPS = 16 * NOISE
"""Divisor for noise across the axis at a whole turn, where a thousand steps add up their errors."""


def at_turn(sine: Coefficient, cosine: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
    """Return 1 where ``sin(α/2)`` is noise beside ``cos(α/2) > 0``, and 0 elsewhere.

    Where a pole of φ is a whole turn, its product with r = φ is not 0: nothing is lost there.
    """
    length = m.name("beside_turn", m.abs(m.where(m.less(m.abs(r), 1), sine, r * sine)))
    clear = m.name("clear_of_turn", m.less(cosine, m.beside(cosine, m.div(length, NOISE_GIVEN))))
    return m.where(clear, 0, 1)


def near_turn(fi: Coefficient, ai: Coefficient, m: Arithmetic) -> Any:
    """Return whether f_i is so large, beside ``a_i = 2 φ′``, that α is near a whole turn other than 0."""
    return m.name("turning", m.less(2 * ai, m.abs(fi)))
