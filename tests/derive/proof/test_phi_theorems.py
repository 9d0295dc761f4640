"""Theorems on every φ, and scalars of charts as their instances."""

from __future__ import annotations

from types import SimpleNamespace

import pytest
import sympy

from derive.maps import Cayley, family, x
from derive.maps.elementary import alpha
from derive.proof import ProofFailed, prove, root_of, scalars
from derive.proof.scalars import ScalarProofs, _at_origin

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
