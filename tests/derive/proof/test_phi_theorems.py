"""Theorems on every φ, and charts in α as their instances."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import pytest
import sympy

from derive.maps import family
from derive.maps.families import alpha
from derive.proof import ProofFailed, prove
from derive.proof.controls import controls
from derive.proof.phi_theorems import ANY_PHI, any_phi
from derive.proof.scalars import _at_origin


def test_theorems_hold():
    assert {proof.status for proof in any_phi()} == {"proved"}
    assert {proof.scope for proof in any_phi()} == {"every phi"}


@pytest.mark.parametrize("theorem", ANY_PHI[2:6:3], ids=lambda theorem: theorem.name)
def test_controls_fail(theorem):
    """Run the controls of two theorems; `make check-theorems` runs all controls."""
    found = [*controls([theorem], {proof.name: proof for proof in any_phi()})]
    assert found
    assert [str(control) for control in found if not control.noticed] == []


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
