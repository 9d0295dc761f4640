"""Stumpff functions below the limit of their series, and the truncation error of the series."""

from __future__ import annotations

import mpmath
import pytest

from derive.algebra.arithmetic import PLAIN
from derive.maps import stumpff


def exact(k: int, xi: mpmath.mpf) -> mpmath.mpf:
    return mpmath.nsum(lambda j: (-xi) ** int(j) / mpmath.factorial(2 * int(j) + k), [0, 80])


@pytest.mark.parametrize("share", ["0", "1e-9", "0.4", "1"])
def test_series_agree_with_sine_and_cosine(share: str):
    """Allow 100 times the truncation error of c₇ at a quarter of the limit."""
    with mpmath.workdps(60):
        xi = mpmath.mpf(share) * stumpff.LIMIT
        found = stumpff.Stumpff(xi / 4, PLAIN)
        for k in range(8):
            assert abs(getattr(found, f"C{k}") - exact(k, xi / 4)) <= 100 * stumpff.REMAINDER
        for k in range(3, 8):
            assert abs(getattr(found, f"c{k}") - exact(k, xi)) <= 100 * stumpff.REMAINDER


def test_truncation_error_is_the_bound():
    with mpmath.workdps(60):
        zeta = mpmath.mpf(stumpff.LIMIT) / 4
        miss = abs(stumpff.series(zeta, PLAIN) / 5040 - exact(7, zeta))
        assert stumpff.REMAINDER / 2 < miss < stumpff.REMAINDER


def test_number_of_terms_is_the_least_for_long_doubles():
    """Expect a truncation error of ``7! c₇`` ≈ 1 below eps, and above eps with one term fewer."""
    share = 5040 * stumpff.REMAINDER
    one_less = share * (2 * stumpff.TERMS + 6) * (2 * stumpff.TERMS + 7) / (stumpff.LIMIT / 4)
    assert share < 2.0**-63 < one_less
