"""Limit of Cayley maps for growing order, and rate of convergence."""

from __future__ import annotations

import mpmath
import pytest
import sympy

from derive.algebra import Isotropic, Tensor, Vector
from derive.algebra.arithmetic import PLAIN
from derive.maps import family
from derive.maps.families import alpha
from derive.proof.controls import controls
from derive.proof.displacement_theorems import DOUBLE_ANGLE, EXPONENTIAL, VERSOR_EXPONENTIAL
from derive.proof.limit_theorems import GROWING_ORDER
from derive.proof.theorem import decided

RESTING_ON = (DOUBLE_ANGLE, EXPONENTIAL, VERSOR_EXPONENTIAL)


def test_theorems_hold_and_controls_fail():
    known = {proof.name: proof for proof in decided([*RESTING_ON, *GROWING_ORDER])}
    assert {proof.status for proof in known.values()} == {"proved"}
    found = [*controls(GROWING_ORDER, known)]
    assert len(found) > 40
    assert [str(control) for control in found if not control.noticed] == []


def test_scaled_charts_solve_the_differential_equation():
    """Check φ′ = 1 + φ²/(2n)² and φ(0) = 0 for symbolic n, and the chart of order 3 as an instance."""
    n = sympy.Symbol("n", positive=True)
    phi = 2 * n * sympy.tan(alpha / (2 * n))
    assert sympy.expand(phi.diff(alpha) - 1 - (phi / (2 * n)) ** 2) == 0
    assert phi.subs(alpha, 0) == 0
    assert family("scaled3").phi == phi.subs(n, 3)


@pytest.mark.parametrize("length", ["0.01", "1.3", "3"])
def test_difference_to_the_limit_has_the_stated_slope(length: str):
    """Check that the remainder falls as 1/n⁴, from scalars of the scaled charts at n = 1000 and 2000."""
    with mpmath.workdps(60):
        r = mpmath.mpf(length)
        u = Vector(mpmath.mpf(2) / 7, mpmath.mpf(3) / 7, mpmath.mpf(6) / 7)
        rotation = _tensor(mpmath.cos(r), mpmath.sin(r), 1 - mpmath.cos(r), u)
        stated = {
            "tensor": rotation @ Tensor.skew(u) * (-(r**3) / 3),
            "tangent": (rotation + 2 * Tensor.dyad(u, u)) * (-r * r / 3),
        }
        limits = _maps(family("exponential"), r, u)
        for name, slope in stated.items():
            left = []
            for n in (1000, 2000):
                epsilon = mpmath.mpf(1) / (4 * n * n)
                change = (_maps(family(f"scaled{n}"), r, u)[name] - limits[name]) * (1 / epsilon)
                left.append(max(abs(entry) for entry in change - slope))
                assert left[-1] < 20 * epsilon * (1 + r * r) ** 3
            if left[1] > mpmath.mpf(10) ** -12:  # below, the exponential's series dominates: it ends at 1e-24
                assert abs(left[0] / left[1] - 4) < 0.001


def _maps(chart, r, u):
    at, v = chart.scalars(r * r, PLAIN), u * r
    return {
        "tensor": _tensor(1 - r * r * at.g, at.f, at.g, v),
        "tangent": _tensor(at.f, at.g, at.h, v),
    }


def _tensor(a, b, c, v):
    return Isotropic(a, b, c, v.dot(v)).tensor(v)
