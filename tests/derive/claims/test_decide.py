"""Computed statuses of entries, and refusal of entries that contradict their computed status."""

from __future__ import annotations

import dataclasses
import sys

import pytest

from derive.claims.decide import decide
from derive.claims.deciding.conditions import is_sharp
from derive.claims.equation import Entry, Reading, UndecidedError, equation, faithful
from derive.claims.language.matrices import either, greater
from derive.claims.language.operator_table import (
    Re,
    both,
    cases,
    cos,
    cot,
    cross,
    det,
    dot,
    equal,
    implies,
    negated,
    nonzero,
    norm,
    root,
    sin,
    skew,
    tan,
)  # fmt: skip
from derive.claims.language.operator_table import identity as I
from derive.claims.language.printed import Symbol, latex
from derive.claims.result import Result, Status
from derive.papers import PAPERS

a, b, c = (Symbol(name, "dual number") for name in "abc")
v, w = Symbol("v", "dual vector"), Symbol("w", "dual vector")
alpha, u = Symbol("alpha", "angle"), Symbol("u", "unit vector")
square_of_sum = equal((a + b) ** 2, a**2 + 2 * (a * b) + b**2)

LOST = PAPERS[0].lost


def decided(statement, **rest) -> Result:
    said = "" if "extract" in rest else "in words"
    return decide("paper", equation("1", statement, said=said, **rest), LOST)


def test_identity_holds_exactly() -> None:
    result = decided(square_of_sum)
    assert (result.status, result.method) == (Status.HOLDS, "exact")


def test_status_cannot_be_given() -> None:
    assert "status" not in {field.name for field in dataclasses.fields(Entry)}
    with pytest.raises(TypeError):
        equation("1", square_of_sum, status="holds")
    with pytest.raises(dataclasses.FrozenInstanceError):
        decided(square_of_sum).status = Status.ERRATUM


# ---- readings -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("statement", "extract"),
    [(equal(a, 1 / (1 + b)), "a = 1 1 + b"), (equal(skew(v) ** 2, dot(w, v)), "v ~ _ 2 = w · v"),
     (equal(a, root(b - 1)), "a _ = b 1"), (equal(cross(v, w), v), "v × w = v")],
)  # fmt: skip
def test_faithful_readings(statement, extract: str) -> None:
    assert faithful(statement, extract, LOST)


@pytest.mark.parametrize(
    ("statement", "extract"),
    [(equal(a, 1 / (1 - b)), "a = 1 1 + b"), (equal(a, 1 / (2 + b)), "a = 1 1 + b"), (equal(a, b), "b = a"),
     (equal(a, 1 / (1 + b**2)), "a = 1 1 + b"), (equal(cross(v, w), v), "v w = v"), (equal(a, b), "a = ± b")],
)  # fmt: skip
def test_unfaithful_readings(statement, extract: str) -> None:
    assert not faithful(statement, extract, LOST)


def test_true_reading_is_enough() -> None:
    readings = (Reading(equal(a - b * b, a * b - b**2), "none"), Reading(equal((a - b) * b, a * b - b**2), "bracket"))
    result = decided(readings, extract="a b b = a b b 2")
    assert result.status is Status.HOLDS
    assert [verdict.true for verdict in result.verdicts] == [True, False]
    assert [r["verdict"] for r in result.as_json()["readings"]] == ["true", "false"]


def test_claim_in_words_with_a_true_and_a_false_reading_is_ambiguous() -> None:
    readings = (Reading(equal((a - b) * b, a * b - b**2)), Reading(equal(a - b * b, a * b - b**2)))
    assert decided(readings).status is Status.AMBIGUOUS


def test_two_false_readings_are_an_erratum() -> None:
    readings = (Reading(equal((a + b) ** 2, a**2 + b**2)), Reading(equal((a + b) ** 2, a**2 + b)))
    assert decided(readings, corrected=square_of_sum).status is Status.ERRATUM


# ---- errata -------------------------------------------------------------------------------------------------------


def test_erratum_has_a_correction_that_is_proved() -> None:
    result = decided(equal((a + b) ** 2, a**2 + b**2), corrected=square_of_sum)
    assert result.status is Status.ERRATUM
    assert result.corrected == latex(square_of_sum)
    assert result.method == "refuted at point 1 of short numbers; correction exact"


def test_erratum_shows_the_words_of_the_paper() -> None:
    with pytest.raises(UndecidedError, match="shows the words of the paper"):
        decide("paper", equation("1", equal((a + b) ** 2, a**2 + b**2), corrected=square_of_sum), LOST)


# ---- conditions ---------------------------------------------------------------------------------------------------

quotient, wrong = equal(a / b * b, a), equal((a + b) ** 2, a**2 + b**2)


@pytest.mark.parametrize(
    ("statement", "rest", "message"),
    [(wrong, {}, "false and has no correction"),
     (quotient, {}, "false and has no correction: refuted at b: 0: no value"),
     (square_of_sum, {"extract": "a + b 2 = a 2 + a b + b 2"}, "does not have the characters of line"),
     (wrong, {"corrected": equal((a + b) ** 2, a**2 - b**2)}, "the correction is false"),
     (quotient, {"condition": both(nonzero(Re(b)), nonzero(Re(a)))}, "true outside its condition"),
     (square_of_sum, {"condition": equal(a, a)}, "no point outside its condition"),
     (quotient, {"claimed": nonzero(Re(b))}, "words that state it"),
     (square_of_sum, {"because": equal(a, b)}, "supporting identity is not proved: refuted at")],
)  # fmt: skip
def test_entry_that_contradicts_its_status_is_refused(statement, rest, message: str) -> None:
    with pytest.raises(UndecidedError, match=message):
        decided(statement, **rest)


def test_condition_is_tested_on_both_sides() -> None:
    result = decided(quotient, condition=nonzero(Re(b)))
    assert result.status is Status.HOLDS_IF
    assert result.condition == latex(nonzero(Re(b)))
    assert result.exact


def test_points_outside_the_claimed_domain_do_not_count() -> None:
    assert decided(quotient, claimed=nonzero(Re(b)), stated="for Re b ≠ 0").status is Status.HOLDS


@pytest.mark.parametrize(
    ("condition", "statement"),
    [(nonzero(Re(b)), equal(a / b, c)), (nonzero(b), equal(a / b, c)),
     (nonzero(Re(b)), both(equal(a, c), equal(c, a / (2 / b)))), (nonzero(Re(sin(alpha))), equal(a, cot(alpha))),
     (nonzero(Re(b)), equal(a / (b**2 * c), c)), (nonzero(Re(b)), equal(a / (c * b**2), c)),
     (both(nonzero(Re(b)), nonzero(Re(c))), equal(a / (c * b), c)), (nonzero(Re(v)), equal(v / norm(v) ** 2, v)),
     (nonzero(Re(1 - b)), equal(a / root((1 - b) ** 3), a)),
     (nonzero(Re(cos(alpha / 2))), equal(v, tan(alpha / 2) * u)),
     (nonzero(Re(b)), equal(b ** (-1), a)), (nonzero(Re(det(I + skew(v)))), equal((I + skew(v)) ** (-1), I))],
    ids=str,
)  # fmt: skip
def test_condition_on_a_denominator_is_sharp(condition, statement) -> None:
    assert is_sharp(condition, statement)


@pytest.mark.parametrize(
    ("condition", "statement"),
    [(nonzero(Re(a)), equal(a / b, c)), (implies(nonzero(Re(b)), nonzero(Re(b))), equal(a / b, c)),
     (both(nonzero(Re(b)), nonzero(Re(a))), equal(a / b, c)),
     (nonzero(Re(b)), equal(a / (b + 1), c)),
     (nonzero(Re(b)), equal(a, cases(a / b, nonzero(Re(b)), a))),
     (nonzero(Re(sin(alpha / 2))), equal(v, tan(alpha / 2) * u)), (equal(b, 1), equal(a / b, c))],
    ids=str,
)  # fmt: skip
def test_condition_without_a_matching_denominator_is_not_sharp(condition, statement) -> None:
    assert not is_sharp(condition, statement)


def test_condition_with_a_true_point_outside_is_not_sharp() -> None:
    result = decided(both(implies(nonzero(Re(a)), quotient), square_of_sum), condition=nonzero(Re(b)))
    assert result.status is Status.HOLDS_IF
    assert not result.exact
    assert result.method.endswith("also true at a, b = 0")


def test_value_is_refused_if_the_form_states_none(monkeypatch) -> None:
    monkeypatch.setattr(sys.modules["derive.claims.deciding.finding"], "is_sharp", lambda *_: True)
    with pytest.raises(UndecidedError, match="its form says no value, but there is one"):
        decided(equal(norm(a) * norm(a) / norm(a), a), condition=greater(Re(a), 0))


def test_two_symbols_are_special_at_once() -> None:
    (entry,) = (entry for entry in PAPERS[0].entries() if entry.number == "59")
    with pytest.raises(UndecidedError, match=r"refuted at w: 0.*: no value"):
        decide("paper", dataclasses.replace(entry, condition=None), LOST)


# ---- methods ------------------------------------------------------------------------------------------------------


def test_statement_that_may_fail_at_special_symbols_is_unrefuted() -> None:
    result = decided(either(equal(a * b, b * a), nonzero(a)))
    assert result.status is Status.UNREFUTED
    assert result.method.startswith("true at ")


def test_logic_and_cases_are_proved_by_their_parts() -> None:
    statements = (
        both(implies(nonzero(Re(a)), equal(b / a * a, b)), equal(b, b)), implies(equal(a * b, 0), equal(b * a, 0)),
        equal(cases(b, nonzero(Re(a)), b * 1), b), negated(both(nonzero(a), equal(a, 0))),
    )  # fmt: skip
    assert {decided(statement).method for statement in statements} == {"exact"}
    assert decided(implies(nonzero(Re(c)), equal(b / a * a, b)), condition=nonzero(Re(a))).method.startswith("exact")


def test_roots_of_dual_numbers_are_exact() -> None:
    statement = equal(root(1 + norm(v)) * root(1 + norm(v)), 1 + norm(v))
    assert decided(statement, claimed=nonzero(Re(v)), stated=(1, "for Re v ≠ 0")).method == "exact"


def test_trigonometry_is_exact() -> None:
    assert decided(equal(sin(alpha) ** 2 + cos(alpha) ** 2, 1)).method == "exact"


@pytest.mark.parametrize("parts", [2, 3, 5, 6, 8])
def test_fractions_of_angles_are_exact(parts: int) -> None:
    part = alpha / parts
    assert decided(equal(2 * (sin(part) * cos(part)), sin(2 * alpha / parts))).method == "exact"
