"""Proved charts, and decisions of single identities."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import FrozenInstanceError, replace
from fractions import Fraction
from typing import Any

import pytest
import sympy
from latex2mathml.converter import convert

from derive.maps import Cayley, x
from derive.proof import ProofFailed, Proved, proofs, prove, theorems
from derive.proof.identity import Check, Multiplier, Proof, decide
from derive.proof.notation import n, p, q
from derive.proof.statement import Equation, Premise, definition


def test_prove_returns_chart_and_proofs() -> None:
    cayley = Cayley(3)
    proved = prove(cayley)
    assert proved.formulas is cayley
    assert proved.proofs[: len(theorems())] == theorems()
    assert {proof.scope for proof in proved.proofs} == {"all n", "n = 3"}
    assert all(proof.proved for proof in proved.proofs)


def test_backends_agree_on_proofs() -> None:
    pytest.importorskip("flint")
    assert proofs(Cayley(5), backend="flint") == proofs(Cayley(5), backend="sympy")


def test_only_prove_makes_a_proved_chart() -> None:
    proved = prove(Cayley(2))
    with pytest.raises(TypeError, match=r"only derive\.proof\.prove"):
        Proved(Cayley(2), proved.proofs)
    with pytest.raises(TypeError, match=r"only derive\.proof\.prove"):
        replace(proved, formulas=Cayley(3), token=None)


def test_a_wrong_formula_is_not_proved(stated: Callable[[int], Any]) -> None:
    right = stated(4)
    a, b, c = right.tangent.coefficients
    wrong = right.with_map("tangent", (a, b, c + x))
    decided = proofs(wrong)
    failed = [proof for proof in decided if not proof.proved]
    assert {proof.scope for proof in failed} == {"n = 4"}
    with pytest.raises(ProofFailed, match=r"not proved: .*tangent.*residue") as error:
        prove(wrong)
    assert [proof.statement for proof in error.value.failed] == [proof.statement for proof in failed]


def test_wrong_polynomials_are_not_proved(stated: Callable[..., Any]) -> None:
    right = stated(6)
    for name in ("p", "q", "c", "d"):
        with pytest.raises(ProofFailed, match=rf": Cayley\(6\)\.{name}, residue"):
            prove(stated(6, **{name: getattr(right, name) + x}))


def test_statements_are_typeset() -> None:
    for proof in proofs(Cayley(2)):
        assert "<math" in convert(proof.latex)
        assert proof.latex.count("{") == proof.latex.count("}")
        assert not re.search(r"(?<![\\a-z{])(point|along|vector|scalar)", proof.latex)


# --- decisions of identities ------------------------------------------------------------------------------------------


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
