"""Scaled charts tend to the exponential one like 1/n², as far as is said."""

from __future__ import annotations

import mpmath
import pytest
import sympy

from derive.algebra.arithmetic import PLAIN
from derive.maps import family, limits
from derive.maps.families import alpha, of_angle


def test_the_limit_is_the_exponential_chart():
    expected = of_angle(alpha)
    for name, value in limits.exponential().items():
        difference = value.subs(limits.r, alpha) - getattr(expected, name)
        assert sympy.expand(sympy.expand_trig(difference.subs(alpha, 2 * alpha))) == 0


@pytest.mark.parametrize("length", ["0.01", "1.3", "3"])
def test_the_difference_is_what_is_said_to_first_order(length: str):
    """Of scaled charts as they are computed, at n = 1000 and 2000: what is left goes with 1/n⁴."""
    with mpmath.workdps(60):
        x = mpmath.mpf(length) ** 2
        exponential = family("exponential").scalars(x, PLAIN)
        for name, slope in limits.deviation().items():
            first = mpmath.mpf(slope.subs(limits.r, sympy.Float(length, 70)).evalf(60))
            left = []
            for n in (1000, 2000):
                difference = getattr(family(f"scaled{n}").scalars(x, PLAIN), name) - getattr(exponential, name)
                epsilon = mpmath.mpf(1) / (4 * n * n)
                left.append(difference / epsilon - first)
                assert abs(left[-1]) < 20 * epsilon * (1 + x) ** 3
            if abs(left[1]) > mpmath.mpf(10) ** -12:  # of the exponential, which cuts off 1e-24, divided by ε
                assert abs(left[0] / left[1] - 4) < 0.001
