"""Stumpff functions below the limit of their series, and the scalars of the exponential chart beyond it."""

from __future__ import annotations

import mpmath
import pytest

from derive.algebra.arithmetic import PLAIN
from derive.maps import stumpff
from derive.maps.exponential import ExponentialScalars, PrincipalScalars
from tests.support.sharp import Sharp


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


# --- scalars beyond the limit of the series ---------------------------------------------------------------------------

EPS = 2.0**-52
SQUARES = [17 + 0.07 * k for k in range(310)]
"""Squares of angles from 4 to 2π; the error of their roots reaches 2 eps."""


class Lossy(ExponentialScalars):
    """Scalars without correction of the rounding error of the angle."""

    def _bounded(self, left: float) -> float:
        return 0.0


def worst(kind: type[ExponentialScalars]) -> float:
    """Return the largest error of ``sin α`` or ``1 − cos α``, in eps."""
    largest = 0.0
    for x in SQUARES:
        at = kind(x, Sharp())
        with mpmath.workdps(40):
            angle = mpmath.sqrt(mpmath.mpf(x))
            off = abs(at.f - mpmath.sin(angle) / angle) * angle, abs(at.g * mpmath.mpf(x) - 1 + mpmath.cos(angle))
        largest = max(largest, float(max(off) / EPS))
    return largest


@pytest.mark.parametrize("kind", [ExponentialScalars, PrincipalScalars])
def test_rounding_of_the_root_is_corrected(kind: type[ExponentialScalars]) -> None:
    """Allow 2 eps, eps/2 for each rounded operation; the correction removes the error of the angle, also 2 eps."""
    assert worst(kind) <= 2


def test_without_correction_digits_are_lost() -> None:
    assert worst(Lossy) > 2.5
