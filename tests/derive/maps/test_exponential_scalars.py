"""Scalars of the exponential chart beyond the limit of the series: correction of the angle's rounding error."""

from __future__ import annotations

import mpmath
import pytest

from derive.maps.exponential import ExponentialScalars, PrincipalScalars
from tests.support.sharp import Sharp

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
