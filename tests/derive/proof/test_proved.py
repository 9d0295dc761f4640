"""Proved charts, decisions of single identities, and formulas that people read: wrong ones are refused."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import FrozenInstanceError, replace
from fractions import Fraction
from typing import Any, cast

import pytest
import sympy
from latex2mathml.converter import convert

from derive.codegen.build import print_package
from derive.codegen.lowering.scalar_programs import SCALARS
from derive.codegen.targets import TARGETS
from derive.codegen.targets.python import formula_of
from derive.maps import Cayley, cayley, family, parameterization, x
from derive.maps.chart import Chart
from derive.maps.chart_formulas import DEFINITIONS, IDENTITIES
from derive.proof import ProofFailed, Proved, proofs, prove, shown, theorems
from derive.proof.identity import Check, Equation, Multiplier, Premise, Proof, decide, definition
from derive.proof.notation import n, p, q
from derive.proof.proved import MARKED, compared, shown_with
from docs.pages.controls import variants


def test_prove_returns_chart_and_proofs() -> None:
    cayley = Cayley(3)
    proved = prove(cayley)
    assert proved.formulas is cayley
    assert proved.proofs[: len(theorems())] == theorems()
    assert {proof.scope for proof in proved.proofs} == {"all n", "n = 3"}
    assert all(proof.proved for proof in proved.proofs)


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


def test_statements_are_typeset() -> None:
    for proof in proofs(Cayley(2)):
        assert "<math" in convert(proof.latex)
        assert proof.latex.count("{") == proof.latex.count("}")
        assert not re.search(r"(?<![\\a-z{])(?<!\\_)(point|along|vector|scalar)", proof.latex)


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
    assert sorted(map(str, variants(equation))) == ["p_n = 3 + 3*q_n", "p_n = 4 + 2*q_n", "p_n = 6 + 4*q_n"]
    assert str(Equation(p, sympy.Integer(0)).altered()) == "p_n = 1"
    assert str(Premise(equation, "sum", ((q, x),))) == "p_n = 3 + 2*q_n (theorem 'sum' at q_n -> x)"


def test_proofs_are_immutable() -> None:
    proof = decided(("sum", 1))
    with pytest.raises(FrozenInstanceError):
        proof.status = "proved"  # type: ignore[misc]


CHARTS = [
    *map(Cayley, (1, 2, 3, 4, 9, 12, 33)), *map(family, ("exponential", "lambert", "breusing", "sine3", "scaled2")),
    parameterization("alpha/(1 + alpha**2/40)", "rational"),
]  # fmt: skip


@pytest.mark.parametrize("of", CHARTS, ids=lambda of: of.name)
def test_shown_formulas_hold(of: Chart) -> None:
    assert all(proof.proved for proof in shown_with(of))
    assert "v(x)v" in formula_of("pose_scalars", of)


def _texts() -> Iterator[tuple[str, Cayley | None]]:
    """Yield every formula of the tables, for order 4 where it holds at an order."""
    four = Cayley(4)
    maps = [getattr(four, name) for name in DEFINITIONS]
    yield from ((text, four) for of in maps for text in (f"{of.symbol} = {of.definition}", *of.identities))
    yield from ((text, None) for texts in IDENTITIES.values() for text in texts)
    yield from ((text, None) for text in DEFINITIONS.values())
    for general, of_order in ((row.every, row.of_order) for row in SCALARS.values()):
        yield from ((text, None) for text in MARKED.findall(general))
        yield from ((text, four) for text in MARKED.findall(of_order))


def _refused(text: str, of: Cayley | None) -> bool:
    try:
        return not compared(text, of).proved
    except ValueError:
        return True


@pytest.mark.parametrize(("text", "of"), dict.fromkeys(_texts()))
def test_altered_formulas_are_refused(text: str, of: Cayley | None) -> None:
    """Raise each integer by one, exchange each sign, double each side."""
    integers = (f"{text[: i.start()]}{int(i[0]) + 1}{text[i.end() :]}" for i in re.finditer(r"\d+", text))
    signs = (f"{text[: i.start()]}{'-' if i[0] == '+' else '+'}{text[i.end() :]}" for i in re.finditer("[-+]", text))
    doubled = (f"{text[: i.end()]} 2 ({text[i.end() :]})" for i in re.finditer("= ", text) if "quad" not in text)
    assert compared(text, of).proved
    for altered in (*integers, *signs, *doubled):
        assert _refused(altered, of), altered


def test_generation_refuses_a_wrong_map_of_an_order(monkeypatch: pytest.MonkeyPatch) -> None:
    right = cayley._definitions

    def wrong(n: int) -> dict[str, str]:
        return {name: text.replace(f"2 q_{{{n}}}^2", f"3 q_{{{n}}}^2") for name, text in right(n).items()}

    monkeypatch.setattr(cayley, "_definitions", wrong)
    for order in (1, 3, 12):
        with pytest.raises(ProofFailed, match=rf"not proved: R = .*\[n = {order}\].*; dcay_n = .*\[n = {order}\]"):
            print_package([Cayley(order)], TARGETS["numpy"])


def test_proof_refuses_a_wrong_map_of_every_chart(monkeypatch: pytest.MonkeyPatch) -> None:
    wrong = DEFINITIONS["tensor"].replace("g = 2 w^2", "g = 3 w^2")
    monkeypatch.setitem(DEFINITIONS, "tensor", wrong)
    for of in (Cayley(3), family("lambert"), family("exponential"), family("scaled2")):
        with pytest.raises(ProofFailed, match=r"g = 3\*w\^2 \[every phi\]"):
            prove(of)


def test_generation_refuses_a_wrong_comment(monkeypatch: pytest.MonkeyPatch) -> None:
    """Alter a formula above a scalar program; `test_altered_formulas_are_refused` decides all of them."""
    row = SCALARS["quaternion_scalars"]
    assert "wy = 2 dw" in row.every
    altered = replace(row, every=row.every.replace("wy = 2 dw", "wy = 3 dw"))
    monkeypatch.setitem(cast(dict[str, Any], SCALARS), "quaternion_scalars", altered)
    with pytest.raises(ProofFailed, match="not proved: "):
        print_package([Cayley(9)], TARGETS["numpy"])


def test_formulas_need_marks_and_known_names() -> None:
    assert shown("size > 0 and e0 >= 0, `f = 2 s w`") == "size > 0 and e0 >= 0, f = 2 s w"
    for text, message in (
        ("g = 2 w^2", "without marks"), ("`2 w^2`", "no equation"), ("`f = 2 s k`", "not understood"),
        ("`f = 2(s w)`", "not understood"), ("`f = 2 s w)`", "not understood"),
    ):  # fmt: skip
        with pytest.raises(ValueError, match=message):
            shown(text)
