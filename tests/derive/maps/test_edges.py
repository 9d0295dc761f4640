"""Edges of φ: kind and exact angle; φ⁻¹ below the edge, in closed form where there is one."""

from __future__ import annotations

from typing import Any

import mpmath
import pytest
import sympy

from derive.maps import angle_of_length, parameterization
from derive.maps.angle_of_length import angle_of, real_value
from derive.maps.any_phi.edges import PHI_DIGITS, Edge, closed_inverse, edge_of
from derive.maps.families import alpha

EDGES = [
    (sympy.sin(alpha / 6), Edge(3 * sympy.pi, "fold")),
    (sympy.sin(3 * alpha / 7), Edge(7 * sympy.pi / 6, "fold")),
    (alpha / (1 + alpha**2 / 40), Edge(sympy.sqrt(40), "fold")),
    (sympy.tan(alpha / 6), Edge(3 * sympy.pi, "pole")),
    (alpha / (3 - alpha**2), Edge(sympy.sqrt(3), "pole")),
]


@pytest.mark.parametrize(("phi", "edge"), EDGES)
def test_edges_have_exact_names(phi: sympy.Expr, edge: Edge):
    assert edge_of(phi) == edge


LENGTHS = [
    (sympy.tan(alpha / 6), 3 * sympy.pi, ("1e-20", "0.3", "5", "1e15", "1e100")),
    (sympy.sin(alpha / 4), 2 * sympy.pi, ("1e-20", "0.3", "0.99")),
    (alpha + alpha**3, sympy.oo, ("1e-20", "0.3", "5")),
]


@pytest.mark.parametrize(("phi", "edge", "lengths"), LENGTHS, ids=str)
def test_angles_take_few_steps_in_many_digits(phi, edge, lengths, monkeypatch: pytest.MonkeyPatch):
    """Allow 6 evaluations in many digits after a start in floats, and 6 more near a pole, where the start may fail."""
    taken = set()
    evaluated = angle_of_length.real_value

    def watched(expression: sympy.Expr, at: Any, of: sympy.Expr) -> Any:
        taken.update([at] if expression == phi and isinstance(at, mpmath.mpf) else [])
        return evaluated(expression, at, of)

    monkeypatch.setattr(angle_of_length, "real_value", watched)
    for length in lengths:
        taken.clear()
        with mpmath.workdps(PHI_DIGITS):
            angle_of(phi, edge, mpmath.mpf(length))
        assert len(taken) <= 6 + (mpmath.mpf(length) > 10**9) * 6, length


def test_an_edge_without_a_name_is_a_decimal():
    phi = sympy.sin(alpha / 2) + alpha / 50
    found = edge_of(phi)
    assert found.kind == "fold"
    assert isinstance(found.angle, sympy.Float)
    with mpmath.workdps(PHI_DIGITS):  # cos(α/2)/2 + 1/50 = 0
        assert abs(mpmath.mpf(found.angle) - 2 * mpmath.acos(-mpmath.mpf(1) / 25)) < mpmath.mpf(10) ** -45


@pytest.mark.parametrize(("phi", "edge"), [*EDGES, (sympy.sinh(alpha), Edge(sympy.oo, ""))])
def test_angles_are_found_up_to_the_edge(phi: sympy.Expr, edge: Edge):
    with mpmath.workdps(PHI_DIGITS):
        end = 5 if edge.angle.is_infinite else mpmath.mpf(edge.angle.evalf(PHI_DIGITS + 5))
        for share in ("1e-20", "0.3", "0.999"):
            angle = mpmath.mpf(share) * end
            # at 0.999 times the fold angle, an error of eps in |v| changes α by about 1e6 eps
            found = angle_of(phi, edge.angle, phi.evalf(PHI_DIGITS, subs={alpha: angle}))
            assert abs(found / angle - 1) < mpmath.mpf(10) ** -40
        assert angle_of(phi, edge.angle, mpmath.mpf(0)) == 0


# --- closed inverses --------------------------------------------------------------------------------------------------

INVERSES = {
    "3*sin(alpha/5)": "5*asin(alpha/3)",
    "tan(alpha/7)/2": "7*atan(2*alpha)",
    "2*sinh(alpha/2)": "2*asinh(alpha/2)",
    "10*tanh(alpha/10)": "10*atanh(alpha/10)",
    "asin(alpha/20)": "20*sin(alpha)",
    "atan(alpha/3)": "3*tan(alpha)",
    "sin(tan(alpha/8))": "8*atan(asin(alpha))",
    "alpha/(1 + alpha**2/40)": None,
    "alpha/(1 - alpha**2/40)": None,
    "alpha/sqrt(1 + alpha**2/40)": None,
    "alpha*sqrt(1 + alpha**2)": None,
    "alpha*sqrt((1 + alpha**2)/(3 + alpha**2))": None,
}
"""Closed inverses by φ; None if the form of the inverse is not compared."""


@pytest.mark.parametrize("phi", list(INVERSES))
def test_inverse_returns_the_angle_up_to_the_edge(phi: str) -> None:
    chart = parameterization(phi, "of_user")
    inverse = closed_inverse(chart.phi)
    assert INVERSES[phi] in (None, str(inverse))
    with mpmath.workdps(PHI_DIGITS):
        end = min(mpmath.mpf(chart.edge.evalf(PHI_DIGITS)), 4 * mpmath.pi)
        for share in ("1e-9", "0.1", "0.5", "0.9", "0.999"):
            angle = end * mpmath.mpf(share)
            size = real_value(chart.phi, angle, chart.phi)
            found = inverse.subs(alpha, sympy.Float(size, PHI_DIGITS)).evalf(PHI_DIGITS)
            assert abs(mpmath.mpf(found) / angle - 1) < mpmath.mpf(10) ** (6 - PHI_DIGITS), share


@pytest.mark.parametrize(
    "phi", ["alpha + sin(alpha)/2", "alpha*cosh(alpha)", "alpha + alpha**3", "sin(alpha + alpha**3)"]
)
def test_phi_without_closed_inverse_has_none(phi: str) -> None:
    assert closed_inverse(parameterization(phi, "of_user").phi) is None


def test_inverse_of_the_angle_is_the_length() -> None:
    assert closed_inverse(alpha) == alpha
