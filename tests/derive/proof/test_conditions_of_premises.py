"""Conditions for citing a theorem: its orders, definitions of symbols and relations must apply."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy

from derive.proof.displacement_theorems import TURNED
from derive.proof.identity import Equation, Premise, definition
from derive.proof.map_theorems import (
    ADDITION,
    ANGLES,
    BINOMIAL,
    BRACKET_SUMS,
    COSINE,
    NORM,
    RECURRENCE,
    RISE,
    SINE,
    SUMS,
    TURN,
    TWICE,
)
from derive.proof.methods import Identity, Theorem
from derive.proof.notation import Shifted, m, n, p, p_double, p_m, p_sum, q, q_double, q_m, q_sum, v, x
from derive.proof.proved import STATED
from derive.proof.setting import Setting, Symbols
from docs.pages.controls import controls
from tests.support.theorems import known

ORIGIN = (definition(Shifted(p, x, 0), 1), definition(Shifted(q, x, 0), n))
ONE = sympy.Integer(1)


def test_a_theorem_at_one_order_is_no_premise_for_others() -> None:
    at_one = (definition(p, 1), definition(q, 1))
    special = Theorem("special", (Equation(p, q),), at_one, Identity(Symbols(())), "n = 1")
    proved = {"special": special.decide({})}
    general = Theorem("general", (Equation(p, q),), (special.premise(0),), Identity(Symbols((q,))))
    assert proved["special"].proved
    assert not general.decide(proved).proved
    assert replace(general, scope="n = 1").decide(proved).proved


@pytest.mark.parametrize(
    "instance",
    [
        ((m, 2 * n), *TWICE[1:]),
        (*TWICE[1:],),
        (TWICE[0], (p_m, q), *TWICE[2:]),
        (*TWICE[:3], (p_sum, q_double), (q_sum, p_double)),
        (*TWICE, (x, x**2)),
        ((n, n + 1),),
    ],
    ids=str,
)
def test_an_instance_with_terms_of_another_index_is_no_premise(
    instance: tuple[tuple[sympy.Expr, sympy.Expr], ...],
) -> None:
    premises = tuple(ADDITION.premise(place, *instance) for place in (0, 1))
    claim = (premises[0].equation,)
    symbols = Identity(Symbols((p_double, q_double, p_m, q_m, p_sum, q_sum, p, q, x)))
    proof = Theorem("wrong", claim, premises, symbols).decide(known())
    assert [residue.label for residue in proof.failures][:2] == 2 * ["premise by addition"]


@pytest.mark.parametrize("theorem", [TURNED, next(t for t in STATED if t.name == "inverse")])
def test_instances_replace_all_symbols_of_an_index(theorem: Theorem) -> None:
    premise = theorem.premise(0, (n, 2 * n), (p, p_double), (q, q_double))
    symbols = Identity(Symbols((p_double, q_double, x, n), (v,), (x,)))
    proof = Theorem("wrong", (premise.equation,), (premise,), symbols).decide(known())
    assert proof.failures[0].label == f"premise by {theorem.name}"


def test_cited_theorems_need_equal_definitions() -> None:
    symbols = Identity(Symbols((COSINE, SINE, TURN, RISE), free=(TURN, RISE)))
    right = Theorem("angles", ANGLES.claim, (definition(x, RISE**2 / TURN**2), *ANGLES.given()), symbols)
    assert right.decide(known()).proved
    other = right.with_premise(0, definition(x, 5))
    assert [residue.label.split(",")[0] for residue in other.decide(known()).failures] == ["required"]
    between = Theorem("between", ANGLES.claim[:1], (ANGLES.premise(0),), symbols)  # nothing defines x
    proved = known() | {"between": between.decide(known())}
    assert proved["between"].proved
    resting = Theorem("resting", between.claim, (definition(x, 5), between.premise(0)), symbols)
    assert [residue.label.split(",")[0] for residue in resting.decide(proved).failures] == ["required"]


def test_sums_need_a_start_and_a_step() -> None:
    for missing in range(4):
        fewer = tuple(premise for place, premise in enumerate(RECURRENCE) if place != missing)
        proof = replace(SUMS, premises=(*fewer, BINOMIAL)).decide({})
        assert [residue.label for residue in proof.failures] == [f"what determines {'pq'[missing // 2]}_n"]
    seven = tuple(Equation(e.left, sympy.Sum(7 * e.right.function, *e.right.limits)) for e in SUMS.claim)
    assert not replace(SUMS, claim=seven, premises=(RECURRENCE[1], RECURRENCE[3], BINOMIAL)).decide({}).proved


def test_sums_without_recurrence_need_an_equation() -> None:
    rest = tuple(premise for premise in BRACKET_SUMS.premises if premise.theorem != "brackets")
    proof = replace(BRACKET_SUMS, premises=rest).decide(known())
    assert [residue.label for residue in proof.failures] == ["what determines c_n", "what determines d_n"]


def test_multipliers_of_relations_are_certified() -> None:
    y = sympy.Symbol("y")
    premises = (*ORIGIN, definition(y**2, 1 / (p - q)))  # p = q at n = 1
    claim = (Equation((p - q) * y**2, ONE),)
    proof = Theorem("t", claim, premises, Identity(Symbols((y, p, q, x, n), (), (x,)))).decide({})
    assert not proof.failures
    assert [multiplier.nonzero for multiplier in proof.multipliers] == [False]
    assert not proof.proved


def test_reducible_relations_prove_nothing() -> None:
    claim = (Equation((x**3 - 1) / (x - 1), x + 2),)
    proof = Theorem("t", claim, (definition(x**2, 1),), Identity(Symbols((x,), (), (x,)))).decide({})
    assert any("is irreducible" in residue.label for residue in proof.failures)


@pytest.mark.parametrize(
    ("others", "label"),
    [
        ((definition(m, 1), definition(m, 2)), "left sides that occur twice"),
        ((definition(SINE**2, 2), definition(COSINE * SINE, 1)), "relations that reduce the same symbol"),
        ((definition(SINE**2, 2), definition(2 * SINE**2, 1)), "relations that reduce the same symbol"),
    ],
)
def test_contradictory_premises_prove_nothing(others: tuple[Premise, ...], label: str) -> None:
    claim = (Equation(x + SINE, x + SINE),)
    symbols = Identity(Symbols((SINE, COSINE, x)))
    assert Theorem("t", claim, others[:1], symbols).decide({}).proved
    proof = Theorem("t", claim, others, symbols).decide({})
    assert label in [residue.label for residue in proof.failures]


def test_factors_of_unknown_symbols_are_not_certified() -> None:
    at = Setting(Symbols((p, q, x, n, TURN), (), (x,)), ORIGIN).ring
    one = at.constant(1) / (at.generator(TURN) - at.generator(q))
    assert [multiplier.nonzero for multiplier in at.multipliers(one.denominator)] == [False]


@pytest.mark.parametrize(("base", "certified"), [(p - q, False), (1 + x, True)], ids=str)
def test_powers_are_certified_with_their_base(base: sympy.Expr, certified: bool) -> None:
    at = Setting(Symbols((p, q, x, n), (), (x,)), ORIGIN, [Equation(base**n, ONE)])
    one = 1 / at.value(base**n)
    assert [multiplier.nonzero for multiplier in at.ring.multipliers(one.denominator)] == [certified]


def test_order_is_not_free() -> None:
    with pytest.raises(ValueError, match="n is an order"):
        Setting(Symbols((p, q, x, n), (), (x, n)), ORIGIN)


def test_controls_detect_an_unused_theorem() -> None:
    axis = next(theorem for theorem in STATED if theorem.name == "axis")
    padded = replace(axis, premises=(*axis.premises, NORM.premise(0)))
    unnoticed = [control for control in controls([padded], known()) if not control.noticed]
    assert [control.proof.premises[-1].equation.left for control in unnoticed] == [(1 + x) ** n]


def test_controls_detect_a_needless_free_symbol() -> None:
    axis = next(theorem for theorem in STATED if theorem.name == "axis")
    assert isinstance(axis.method, Identity)
    symbols = replace(axis.method.symbols, scalars=(*axis.method.symbols.scalars, TURN), free=(x, TURN))
    wider = replace(axis, method=replace(axis.method, symbols=symbols))
    unnoticed = [control.alteration for control in controls([wider], known()) if not control.noticed]
    assert unnoticed == ["cos(theta) not free"]
