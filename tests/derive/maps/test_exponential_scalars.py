"""Scalars of the exponential beyond its series: what rounding took from the angle is put back."""

from __future__ import annotations

import mpmath
import pytest

from derive.maps.exponential_chart import ExponentialScalars, PrincipalScalars
from tests.support.sharp import Sharp

EPS = 2.0**-52
SQUARES = [17 + 0.07 * k for k in range(310)]
"""Of angles from 4 to 2π, where a float is off by up to 2 eps."""


class Lossy(ExponentialScalars):
    """The same with nothing put back."""

    def _bounded(self, left: float) -> float:
        return 0.0


def worst(kind: type[ExponentialScalars]) -> float:
    """The largest error of ``sin α`` and ``1 − cos α``, in eps."""
    largest = 0.0
    for x in SQUARES:
        at = kind(x, Sharp())
        with mpmath.workdps(40):
            angle = mpmath.sqrt(mpmath.mpf(x))
            off = abs(at.f - mpmath.sin(angle) / angle) * angle, abs(at.g * mpmath.mpf(x) - 1 + mpmath.cos(angle))
        largest = max(largest, float(max(off) / EPS))
    return largest


@pytest.mark.parametrize("kind", [ExponentialScalars, PrincipalScalars])
def test_a_rounded_root_costs_nothing(kind: type[ExponentialScalars]) -> None:
    """Within 2 eps: tangent, sum, quotient, correction, quotient, half each; the 2 eps of the angle are not in it."""
    assert worst(kind) <= 2


def test_it_would_if_nothing_were_put_back() -> None:
    assert worst(Lossy) > 2.5
