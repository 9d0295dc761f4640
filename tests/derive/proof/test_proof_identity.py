from __future__ import annotations

from dataclasses import FrozenInstanceError
from fractions import Fraction

import pytest

from derive.proof.identity import Claim, decide

CLAIM = Claim("two and two are four", "2 + 2 = 4", "arithmetic", (1, 2))


def test_zero_residues_prove() -> None:
    proof = decide(CLAIM, lambda: [("sum", 2 + 2 - 4), ("halves", Fraction(1, 2) + Fraction(1, 2) - 1)], "n = 7")
    assert proof.proved
    assert proof.status == "proved"
    assert proof.failures == ()
    assert (proof.statement, proof.latex, proof.scope, proof.method, proof.equations) == (
        "two and two are four",
        "2 + 2 = 4",
        "n = 7",
        "arithmetic",
        (1, 2),
    )
    assert str(proof) == "proved [n = 7] two and two are four (arithmetic)"


def test_a_residue_fails_and_is_kept() -> None:
    proof = decide(CLAIM, lambda: [("sum", 0), ("other", 5)])
    assert proof.status == "failed"
    assert proof.scope == "all n"
    assert [(residue.label, residue.value) for residue in proof.failures] == [("other", 5)]


def test_nothing_checked_is_nothing_proved() -> None:
    assert not decide(CLAIM, list).proved


def test_proofs_are_immutable() -> None:
    proof = decide(CLAIM, lambda: [("sum", 1)])
    with pytest.raises(FrozenInstanceError):
        proof.status = "proved"  # type: ignore[misc]
