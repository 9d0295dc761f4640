"""Bounds of |φ| on circles: they are valid, close, and refused unless φ is analytic inside."""

from __future__ import annotations

import random

import mpmath
import pytest
import sympy

from derive.maps.any_phi import near_zero
from derive.maps.any_phi.expressions import parsed
from derive.maps.families import alpha

PHI = [
    "sin(alpha/2)", "tan(alpha/5)", "asin(alpha/4)", "alpha*acos(alpha**2/20)", "atan(alpha/3)", "sinh(alpha/2)",
    "alpha*cosh(alpha/4)", "tanh(alpha/6)", "alpha*cos(alpha/3)", "alpha*sqrt(1 + alpha**2/9)", "alpha*exp(alpha**2/9)",
    "alpha*log(3 + alpha**2/9)", "alpha/(1 + alpha**2/40)", "alpha/(1 + alpha**2/9)**(3/2)", "alpha + alpha**3/50",
]  # fmt: skip
RADIUS = mpmath.mpf("1.5")


def points(seed: int, count: int = 100) -> list[mpmath.mpc]:
    """Return points on a quarter of the circle, with both ends."""
    draw = random.Random(seed)
    return [RADIUS * mpmath.expjpi(share / 2) for share in (0, 1, *(draw.random() for _ in range(count)))]


def at(phi: sympy.Expr, z: mpmath.mpc) -> mpmath.mpc:
    return mpmath.mpc(complex(phi.evalf(20, subs={alpha: sympy.Float(z.real) + sympy.I * sympy.Float(z.imag)})))


@pytest.mark.parametrize("text", PHI)
def test_bound_on_a_circle_is_close_and_below_all_points(text: str):
    """Allow 20 %; arcs of length 1/80 and |φ′/φ| ≤ 4 make bounds about 10 % too low."""
    phi = parsed(text)
    least = near_zero.smallest(phi, RADIUS)
    assert near_zero.is_analytic(phi, RADIUS)
    found = min(abs(at(phi, z)) for z in points(1, 60))
    assert 0.8 * found < least <= found * (1 + mpmath.mpf(2) ** -40)


@pytest.mark.parametrize(
    "text",
    ["tan(2*alpha)", "asin(alpha)", "alpha*acos(alpha**2)", "atan(alpha)", "tanh(2*alpha)", "alpha*sqrt(1 + alpha**2)",
     "alpha/(1 + alpha**2)", "alpha*log(1 + alpha**2)", "alpha/(1 - 3*alpha**2/2 + 9*alpha**4/10)", "sin(3*alpha)",
     "alpha + alpha/(100*(4*alpha**2 - 1)**2)"],
)  # fmt: skip
def test_phi_not_analytic_or_not_increasing_has_no_bound(text: str):
    phi = parsed(text)
    assert near_zero.smallest(phi, RADIUS) is None or not near_zero.is_analytic(phi, RADIUS)


def test_cells_cover_a_quarter_of_the_disc_and_arcs_of_the_circle():
    arcs, cells = list(near_zero._arcs(RADIUS)), list(near_zero._cells(RADIUS))
    for z in points(2):
        assert any(z.real in arc.real and z.imag in arc.imag for arc in arcs)
        for share in (0, "0.01", "0.5", "0.9", "0.999", 1):
            inside = z * mpmath.mpf(share)
            assert any(inside.real in cell.real and inside.imag in cell.imag for cell in cells), inside
    far = max(abs(mpmath.mpc(cell.real.b, cell.imag.b)) for cell in cells)
    assert far < RADIUS * (1 + mpmath.sqrt(2) / 12 + mpmath.mpf("0.001"))
