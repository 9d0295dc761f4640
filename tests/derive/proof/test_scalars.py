"""Scalars of charts: proofs cover every way of computing them, and wrong scalars fail."""

from __future__ import annotations

import pytest
import sympy

from derive.maps import Cayley, x
from derive.proof import root_of, scalars
from derive.proof.controls import controls_of
from derive.proof.scalars import ScalarProofs


@pytest.mark.parametrize("backend", ["flint", "sympy"])
@pytest.mark.parametrize("n", [1, 2, 3, 4, 9, 16])
def test_scalars_of_cayley_maps_are_proved(n: int, backend: str) -> None:
    pytest.importorskip("flint" if backend == "flint" else "sympy")
    proofs = list(ScalarProofs(Cayley(n), backend).proofs())
    assert [len(proof.residues) for proof in proofs] == [11, 7, 7, 5, 3]
    assert all(proof.proved for proof in proofs)
    assert {proof.scope for proof in proofs} == {f"n = {n}"}


def test_controls_fail_at_order_11() -> None:
    assert [str(control) for control in controls_of(Cayley(11)) if not control.noticed] == []


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
