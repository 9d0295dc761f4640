"""Conditions of the proofs about φ, each with a function that breaks it and keeps the others."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath
import pytest
import sympy

from derive.algebra.arithmetic import PLAIN
from derive.maps import PhiError, parameterization
from derive.maps.any_phi import edges, first_guess, near_zero
from derive.maps.any_phi.expressions import parsed
from derive.maps.any_phi.guesses import Fitted
from derive.maps.any_phi.intervals import Intervals, precise
from derive.maps.elementary import alpha

ONE, HALF = mpmath.mpf(1), mpmath.mpf("0.5")
BEFORE = ONE - edges.WINDOW
WIDE = 10**20 * (sympy.sin(alpha) ** 2 + sympy.cos(alpha) ** 2 - 1)
"""Zero, with wide enclosures."""
TINY = sympy.Rational(1, 10**90)

BROKEN: dict[str, Callable[[Intervals], Any]] = {
    "a zero in the window": lambda at: edges._zero(at, alpha - 2, ONE),
    "a change of sign at the zero": lambda at: edges._zero(at, alpha - 1 - sympy.Rational(1, 10**9) + WIDE, ONE),
    "one zero in the window": lambda at: edges._zero(at, (alpha - 1) ** 2 - sympy.Rational(1, 2**104), ONE),
    "a double zero, exactly": lambda at: edges._zero(at, 1 + (1 - TINY) * sympy.cos(alpha), mpmath.pi),
    "a march up to the pole": lambda at: edges._is_regular(
        at, (alpha - 1 + sympy.Rational(1, 2**51)) ** 2, BEFORE, ONE
    ),
    "a lower bound at the pole": lambda at: edges._is_regular(at, 1 - alpha, BEFORE, ONE),
    "no other zero in the circle": lambda at: near_zero.smallest(alpha + 100 * alpha**3, HALF),
    "no pole in the disc": lambda at: near_zero.is_analytic(alpha + alpha / (1 + 100 * alpha**2) / 10, HALF),
}
"""Conditions, and the proofs of them that must fail."""


@pytest.mark.parametrize("condition", BROKEN)
def test_no_proof_without_its_condition(condition: str) -> None:
    with precise() as at:
        assert not BROKEN[condition](at)


NEAR = ("alpha + alpha/(1 + 100*alpha**2)/10", "alpha*(1 + alpha**2/(1 + 30*alpha**2))")
"""Functions φ with poles near the imaginary axis, which samples on the real axis do not show."""


def test_a_length_with_poles_in_the_disc_is_refused() -> None:
    with pytest.raises(PhiError, match="nothing proves that"):
        near_zero.length_ratio(parsed(NEAR[0]), ONE)


@pytest.mark.parametrize("text", NEAR)
def test_fits_near_poles_beside_the_real_axis_are_refused_or_within_their_bound(text: str) -> None:
    """Require the bound of every derivative, as the polynomials state it; a disc that held the pole would break it."""
    chart: Any = parameterization(text, "mine")
    near = chart.near
    with mpmath.workdps(60):
        limit = mpmath.mpf(near.limit.numerator) / near.limit.denominator
        for share in ("0.03", "0.6", "1"):
            x, most = limit * mpmath.mpf(share), near.remainder * chart.limits[0][0]
            exact = chart.inverse(mpmath.sqrt(x)) / mpmath.sqrt(x)
            assert abs(near.polynomials[0].at(x, PLAIN, "") - exact) <= most


def test_bounds_of_derivatives_hold_on_short_ellipses() -> None:
    """Take 1/(c − t) on [0, 1], which has its largest third derivative at the end: Cauchy's term must bound it."""
    c = mpmath.mpf("1.2")
    half_sum = 4 * (c - HALF)
    rho = half_sum / 2 + mpmath.sqrt(half_sum**2 / 4 - 1)
    degree = 10
    nodes = near_zero.chebyshev_points(0, 1, degree + 1)
    within = (c + 1) / 2  # the function is at most 1/(c − within) in the ellipse up to this point
    half_sum = 4 * (within - HALF)
    rho = half_sum / 2 + mpmath.sqrt(half_sum**2 / 4 - 1)
    fit = near_zero.interpolated(nodes, [1 / (c - t) for t in nodes])
    third = sum(k * (k - 1) * (k - 2) * a for k, a in enumerate(fit))
    off = abs(third - 6 / (c - 1) ** 4)
    assert off <= near_zero._error_bound(1 / (c - within), rho, degree)
    assert off > 4 / (c - within) * rho**-degree / (rho - 1)


def test_a_step_is_shorter_than_the_way_to_the_edge(monkeypatch: pytest.MonkeyPatch) -> None:
    """Take a guess whose error is a third of the way: its first step may reach the edge, and is then left out."""
    chart: Any = parameterization("sin(alpha/2) + alpha/1000", "mine")
    with precise() as at:
        angle = chart.far.edge - mpmath.mpf("0.1")
        for share, proved in ((3, False), (8, True)):
            error = (chart.far.edge - angle) / share
            monkeypatch.setattr(Fitted, "error", lambda *_, error=error: error)
            found = first_guess._needed(at, chart._edge, chart.far, angle, angle, 1)
            assert (found is not None) == proved
