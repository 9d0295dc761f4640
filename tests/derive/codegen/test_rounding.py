"""Numbers of many digits as long doubles: off by a unit in the last place at most."""

from __future__ import annotations

import random
from fractions import Fraction

import mpmath
import numpy as np
from derive.codegen.validation.rounding import long


def exactly(number: np.longdouble) -> Fraction:
    return Fraction(*number.as_integer_ratio())


def test_they_are_the_nearest_but_for_a_unit_in_the_last_place() -> None:
    draw = random.Random(5)
    with mpmath.workdps(50):
        numbers = [mpmath.mpf(draw.uniform(-1, 1)) / 3 * mpmath.mpf(2) ** draw.randint(-300, 300) for _ in range(200)]
        for number, found in zip(numbers, long(numbers), strict=True):
            wanted = int(mpmath.sign(number)) * int(number.man) * Fraction(2) ** int(number.exp)
            assert abs(exactly(found) - wanted) <= Fraction(float(np.finfo(np.longdouble).eps)) * abs(wanted)


def test_those_of_few_digits_are_exact_whatever_their_type() -> None:
    given = [3, -5, Fraction(1, 4), 0.375, mpmath.mpf(2) ** -1000, 0, 2**52 + 1]
    wanted = [3, -5, Fraction(1, 4), Fraction(3, 8), Fraction(1, 2**1000), 0, 2**52 + 1]
    with mpmath.workdps(50):
        assert [exactly(found) for found in long(given)] == wanted


def test_what_is_no_number_stays_none() -> None:
    infinite, opposite, none = long([mpmath.inf, -mpmath.inf, mpmath.nan])
    assert infinite == -opposite == np.inf
    assert np.isnan(none)
