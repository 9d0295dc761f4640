"""Theorems on every φ, scalars of charts as their instances, and Cayley maps of growing order."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import mpmath
import pytest
import sympy

from derive.algebra import Isotropic, Tensor, Vector
from derive.algebra.arithmetic import PLAIN
from derive.maps import Cayley, family, x
from derive.maps.elementary import alpha
from derive.proof import ProofFailed, prove, root_of, scalars
from derive.proof.scalars import ScalarProofs, _at_origin


def test_wrong_coefficient_is_no_instance():
    chart = family("breusing")
    right = chart.tangent
    chart.__dict__["tangent"] = replace(right, coefficients=(*right.coefficients[:2], 2 * right.coefficients[2]))
    with pytest.raises(ProofFailed, match=r"tangent\[2\]"):
        prove(chart)


HALF_ODD = sympy.sin(alpha / 4) + sympy.sin(alpha / 4) ** 2


@pytest.mark.parametrize(
    ("phi", "failing"), [(HALF_ODD, "[phi](alpha -> -alpha) = -phi"), (alpha + 1, "[phi](alpha -> 0) = 0")]
)
def test_phi_at_zero_is_decided(phi: sympy.Expr, failing: str):
    proof = _at_origin(SimpleNamespace(phi=phi, name="mistaken"))
    assert failing in [residue.label for residue in proof.failures]
    assert failing in proof.statement


@pytest.mark.parametrize("phi", [sympy.sin(alpha / 4) + 1, sympy.sin(alpha / 4) ** 3, sympy.cos(alpha)])
def test_phi_with_another_start_fails(phi: sympy.Expr):
    class Mistaken(type(family("breusing"))):
        pass

    Mistaken.phi = phi
    with pytest.raises(ProofFailed, match="phi"):
        prove(Mistaken())


# --- limit for growing order ------------------------------------------------------------------------------------------

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
    return {"tensor": _tensor(1 - r * r * at.g, at.f, at.g, v), "tangent": _tensor(at.f, at.g, at.h, v)}


def _tensor(a, b, c, v):
    return Isotropic(a, b, c, v.dot(v)).tensor(v)


@pytest.mark.parametrize("n", [1, 2, 3, 4, 9, 16])
def test_scalars_of_cayley_maps_are_proved(n: int) -> None:
    proofs = list(ScalarProofs(Cayley(n)).proofs())
    assert [len(proof.residues) for proof in proofs] == [11, 7, 7, 5, 3]
    assert all(proof.proved for proof in proofs)
    assert {proof.scope for proof in proofs} == {f"n = {n}"}


@pytest.mark.parametrize("place", [0, 1, 2])
def test_printed_claim_on_the_angle_is_decided(place: int, monkeypatch: pytest.MonkeyPatch) -> None:
    altered = tuple(e.altered() if k == place else e for k, e in enumerate(scalars.ANGLE))
    monkeypatch.setattr(scalars, "ANGLE", altered)
    *_, proof = ScalarProofs(Cayley(3)).proofs()
    assert [residue.label for residue in proof.failures] == [altered[place].text]


def test_the_root_of_formulas() -> None:
    assert root_of([x / (1 + x) ** 2, sympy.Integer(3)]) == 0
    assert root_of([x, x / (1 + x) ** sympy.Rational(3, 2)]) == 1
    assert root_of([sympy.sqrt(1 - x), (1 - x) ** sympy.Rational(5, 2)]) == -1
    for expressions in ([sympy.sqrt(2 + x)], [sympy.sqrt(1 + x), sympy.sqrt(1 - x)], [sympy.root(1 + x, 3) + x]):
        with pytest.raises(ValueError, match="may hold the square root of"):
            root_of(expressions)
