from __future__ import annotations

from collections.abc import Iterator
from dataclasses import FrozenInstanceError
from fractions import Fraction
from typing import Any

import pytest
import sympy

from derive.proof.identity import Check, Multiplier, Proof, decide
from derive.proof.notation import n, p, q, x
from derive.proof.statement import Equation, Premise, definition


def decided(*checks: Check | Multiplier, scope: str = "all n") -> Proof:
    claim = (Equation(p, q + x / 2, (2, 1)), Equation(q, n))
    return decide("sum", claim, "arithmetic", lambda: checks, scope, (definition(x, 2),))


def test_zero_residues_prove() -> None:
    proof = decided(("sum", 2 + 2 - 4), ("halves", Fraction(1, 2) + Fraction(1, 2) - 1), scope="n = 7")
    assert proof.proved
    assert proof.status == "proved"
    assert proof.failures == ()
    assert (proof.statement, proof.latex, proof.scope, proof.method, proof.equations) == (
        "p_n = x/2 + q_n; q_n = n",
        r"p_{n} = \frac{x}{2} + q_{n};\; q_{n} = n",
        "n = 7",
        "arithmetic",
        (1, 2),
    )
    assert str(proof) == "proved [n = 7] p_n = x/2 + q_n; q_n = n (arithmetic)"
    assert [str(premise) for premise in proof.premises] == ["x = 2 (definition)"]


def test_nonzero_residues_fail() -> None:
    proof = decided(("sum", 0), ("other", 5))
    assert proof.status == "failed"
    assert proof.scope == "all n"
    assert [(residue.label, residue.value) for residue in proof.failures] == [("other", 5)]


def test_no_residues_prove_nothing() -> None:
    assert not decided().proved


def test_a_multiplier_must_be_certified() -> None:
    proof = decided(("sum", 0), Multiplier(1 + x, 1, True), Multiplier(1 + x, 2, True))
    assert proof.proved
    assert [str(multiplier) for multiplier in proof.multipliers] == ["(1 + x)^2"]
    assert not decided(("sum", 0), Multiplier(1 + x, 1, False)).proved


def test_undefined_residue_fails() -> None:
    def checks() -> Iterator[Any]:
        yield "sum", 0
        yield "quotient", Fraction(1) / 0

    assert not decide("t", (), "", checks).proved


def test_altered_equations_differ() -> None:
    equation = Equation(p, 2 * q + 3, (4,))
    assert str(equation.altered()) == "p_n = 6 + 4*q_n"
    assert equation.altered().numbers == ()
    assert sorted(map(str, equation.variants())) == ["p_n = 3 + 3*q_n", "p_n = 4 + 2*q_n", "p_n = 6 + 4*q_n"]
    assert str(Equation(p, sympy.Integer(0)).altered()) == "p_n = 1"
    assert str(Premise(equation, "sum", ((q, x),))) == "p_n = 3 + 2*q_n (theorem 'sum' at q_n -> x)"


def test_proofs_are_immutable() -> None:
    proof = decided(("sum", 1))
    with pytest.raises(FrozenInstanceError):
        proof.status = "proved"  # type: ignore[misc]
