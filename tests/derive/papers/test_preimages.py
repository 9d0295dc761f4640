"""Preimages of the Cayley map of CP23, by the roots of a polynomial."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import pairwise

import pytest
import sympy

from derive.algebra.element import Element
from derive.claims.decide import decide
from derive.claims.equation import UndecidedError
from derive.papers import PAPERS
from derive.papers.condurache_popa_2023.definitions import preimages

LOST = PAPERS[0].lost
ENTRIES = {entry.number: entry for entry in PAPERS[0].entries()}
THEOREMS = ("theorem-11-onto", "theorem-12-branches")
QUATERNIONS = [(Fraction(3, 5), Fraction(4, 5)), (Fraction(-12, 13), Fraction(5, 13)), (Fraction(0), Fraction(-1))]
"""Scalar part, and coefficient of the vector part, of a quaternion."""


@pytest.mark.parametrize(
    "step",
    [lambda F, G, t: (F + 2 * t * G, G - t * F), lambda F, G, t: (F + t * G, G + t * F),
     lambda F, G, t: (F + G, G - F), lambda F, G, t: (F + t * t * G, G - t * F)],
)  # fmt: skip
def test_identity_fails_for_other_polynomials(step) -> None:
    assert not all(preimages._identities(step).values())


@pytest.mark.parametrize("number", [*THEOREMS, "breusing-vector"])
def test_theorem_is_proved_by_its_argument(number: str) -> None:
    assert "proved by the argument in" in decide("paper", ENTRIES[number], LOST).method


@pytest.mark.parametrize("number", THEOREMS)
def test_theorem_fails_without_its_identities(monkeypatch, number: str) -> None:
    def wrong(F: Element, G: Element, t: Element) -> tuple[Element, Element]:
        return F + t * G, G + t * F

    monkeypatch.setattr(preimages, "next_parts", wrong)
    with pytest.raises(UndecidedError, match="supporting identity is not proved"):
        decide("paper", ENTRIES[number], LOST)


def test_argument_needs_an_identity() -> None:
    with pytest.raises(UndecidedError, match="an argument leads on from an identity"):
        decide("paper", replace(ENTRIES["theorem-12-branches"], because=None), LOST)


@pytest.mark.parametrize(("c", "s"), QUATERNIONS)
def test_number_of_real_roots_by_sturm_sequences(c: Fraction, s: Fraction) -> None:
    """Compare with the number of roots by SymPy's Sturm sequences, and with the signs of G at the roots."""
    t = sympy.Symbol("t")
    F, G = sympy.Integer(0) - sympy.Rational(s), sympy.Integer(0) + sympy.Rational(c)
    for n in range(1, 9):
        F, G = (sympy.expand(part) for part in preimages.next_parts(F, G, t))
        infinite = c * c - s * s == (-1) ** n
        polynomial = sympy.Poly(F, t)
        assert polynomial.degree() == n - infinite
        assert polynomial.count_roots() == n - infinite
        at_zero = [G.subs(t, root.evalf(30)) > 0 for root in polynomial.real_roots()]
        assert all(first is not second for first, second in pairwise(at_zero))
