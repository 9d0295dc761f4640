from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
import sympy

from derive.algebra import arithmetic
from derive.maps import Cayley
from derive.proof import citing, evaluation, theorems
from derive.proof.displacement_theorems import DOUBLE_ANGLE, EXPONENTIAL
from derive.proof.identity import Equation, definition
from derive.proof.map_theorems import BRACKET_SUMS, POWERS, SLOPES, SUMS
from derive.proof.methods import Theorem, decided
from derive.proof.notation import I, R, alpha, dcay, dcay_inv, det, n, p, q, skew, u, v, x
from derive.proof.proved import STATED
from docs.pages.controls import controls
from tests.support.theorems import known


def theorem(name: str) -> Theorem:
    return next(found for found in STATED if found.name == name)


@pytest.mark.parametrize("number", [51, 88])
def test_citing_proves_only_what_is_needed(number: int) -> None:
    assert citing({number}) == tuple(proof for proof in theorems() if number in proof.equations)
    assert citing({number})
    assert citing({}) == ()


@pytest.mark.parametrize(
    ("name", "index", "change"),
    [("tensor", 0, "sign"), ("tensor", 2, "factor"), ("tangent", 0, "factor"), ("tangent", 1, "sign"),
     ("tangent", 2, "sign"), ("tangent_inv", 1, "factor"), ("tangent_inv", 2, "sign")],
)  # fmt: skip
def test_a_wrong_coefficient_fails(name: str, index: int, change: str) -> None:
    right = getattr(evaluation, name)

    def wrong(n: Any, x: Any, p: Any, q: Any) -> tuple[Any, ...]:
        coefficients = list(right(n, x, p, q))
        coefficients[index] = -coefficients[index] if change == "sign" else coefficients[index] * n
        return tuple(coefficients)

    symbol = {"tensor": R, "tangent": dcay, "tangent_inv": dcay_inv}[name]
    before, after = (evaluation.defined(symbol, formula) for formula in (right, wrong))
    altered = [
        replace(t, premises=tuple(after if e.equation.right == before.equation.right else e for e in t.premises))
        for t in STATED
    ]
    failed = [proof for proof in decided(altered) if not proof.proved]
    assert failed
    assert all(proof.failures for proof in failed)


def test_printed_claim_is_decided() -> None:
    right = theorem("determinant")
    nine = Equation(det(dcay), 9 * n * q**2 / (1 + x) ** (n + 1))
    assert right.decide(known()).statement == "det(dcay_n) = 8*n*q_n^2/(1 + x)^(1 + n)"
    assert not right.with_claim(0, nine).decide(known()).proved
    assert nine.text == "det(dcay_n) = 9*n*q_n^2/(1 + x)^(1 + n)"


def test_a_wrong_recurrence_fails() -> None:
    def with_recurrence(found: Theorem) -> Theorem:
        wrong = tuple(
            definition(e.left, p + x * q) if e.right == arithmetic.following((p, q), x)[0] else premise
            for premise in found.premises
            for e in (premise.equation,)
        )
        return replace(found, premises=wrong)

    for found in (POWERS, SUMS, SLOPES):
        assert with_recurrence(found) != found
        assert not with_recurrence(found).decide(known()).proved


def test_altered_theorem_is_no_premise() -> None:
    right = theorem("twist")
    place = next(i for i, premise in enumerate(right.premises) if premise.theorem == "slopes")
    altered = right.premises[place].altered()
    failed = right.with_premise(place, altered).decide(known())
    assert not failed.proved
    assert any(residue.label == "premise by slopes" for residue in failed.failures)
    assert not right.decide({}).proved


def test_controls_detect_an_unused_premise() -> None:
    padded = replace(theorem("axis"), premises=(*theorem("axis").premises, definition(u, v)))
    unnoticed = [control for control in controls([padded], known()) if not control.noticed]
    assert [control.alteration for control in unnoticed] == ["premise u = 2*v in place of u = v (definition)"]


def test_multipliers_are_named_and_certified() -> None:
    found = {multiplier.text: multiplier for multiplier in known()["inverse"].multipliers}
    assert set(found) == {"x", "1 + x", "n", "q_n", "q_n^2*x + p_n^2"}
    assert all(multiplier.nonzero for multiplier in found.values())
    zeroed = theorem("inverse").decide(known(), zeroed=1 + x)
    assert not zeroed.failures  # every equation became 0 = 0
    assert not zeroed.proved  # but a zero multiplier proves nothing


def test_initial_values_matter() -> None:
    sine, cosine = 7 * sympy.sin(alpha), 7 * sympy.cos(alpha)
    seven = Equation(EXPONENTIAL.claim[0].left, I + sine * skew(u) + (1 - cosine) * skew(u) ** 2)
    assert not EXPONENTIAL.with_claim(0, seven).decide({}).proved
    doubled = DOUBLE_ANGLE.with_claim(0, Equation(sympy.cos(alpha), 2 - 4 * sympy.sin(alpha / 2) ** 2))
    doubled = doubled.with_claim(1, Equation(sympy.sin(alpha), 4 * sympy.sin(alpha / 2) * sympy.cos(alpha / 2)))
    failed = doubled.decide({})  # 2 cos α and 2 sin α solve the differential equation
    assert [residue.label for residue in failed.failures] == ["start, cos(alpha)"]


def test_indices_of_binomial_sums_matter() -> None:
    right = BRACKET_SUMS.claim[1]
    for shift in (1, -1, 2):
        changed = right.right.function.replace(sympy.binomial, lambda a, b, by=shift: sympy.binomial(a, b + by))
        wrong = Equation(right.left, sympy.Sum(changed, *right.right.limits))
        assert not BRACKET_SUMS.with_claim(1, wrong).decide(known()).proved
    late = Equation(right.left, sympy.Sum(right.right.function, (right.right.limits[0][0], 2, sympy.oo)))
    assert not BRACKET_SUMS.with_claim(1, late).decide(known()).proved


@pytest.mark.parametrize("order", range(1, 9))
def test_slopes_match_the_polynomials(order: int) -> None:
    at = sympy.Rational(3, 7)
    pair = Cayley(order).p, Cayley(order).q
    values = [e.subs(x, at) for e in (*pair, *(e.diff(x) for e in pair))]
    for equation, slope in zip(SLOPES.claim, values[2:], strict=True):
        assert equation.right.subs({n: order, x: at, p: values[0], q: values[1]}) == slope
