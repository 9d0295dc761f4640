from __future__ import annotations

from dataclasses import replace

import pytest
import sympy

from derive.maps import Cayley
from derive.proof import citing, theorems
from derive.proof.displacement_theorems import DOUBLE_ANGLE, EXPONENTIAL
from derive.proof.identity import Equation, definition
from derive.proof.map_theorems import BRACKET_SUMS, SLOPES
from derive.proof.methods import Theorem
from derive.proof.notation import I, alpha, n, p, q, skew, u, v, x
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
