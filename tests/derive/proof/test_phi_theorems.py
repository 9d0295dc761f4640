"""Theorems on every φ, scalars of charts as their instances, and Cayley maps of growing order."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import pytest
import sympy

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
