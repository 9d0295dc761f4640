from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from latex2mathml.converter import convert

from derive.maps import Cayley, x
from derive.proof import ProofFailed, Proved, proofs, prove, theorems


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
