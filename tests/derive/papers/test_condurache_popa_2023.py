"""Tests of CP23: all errata, statuses and entries of sections 2 to 6 and 9, and preimages of the Cayley map."""

from __future__ import annotations

import importlib
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from pathlib import Path

import pytest
import sympy

from derive.algebra.element import Element
from derive.claims.decide import decide
from derive.claims.equation import UndecidedError
from derive.claims.result import Result, Status
from derive.papers import PAPERS, verify
from derive.papers.condurache_popa_2023.definitions import preimages

PAPER = PAPERS[0]
LOST = PAPER.lost
SECTIONS = tuple(s for s in PAPER.sections if not s.startswith(("s07", "s08", "s10")))
ERRATA = {
    *("cayley-onto", "cayley-domain", "rodrigues-domain", "cayley-quaternion-onto", "38-domain", "cayley-half-onto"),
    *("44-domain", "105", "111", "112", "118", "119", "124", "125", "129", "130", "131", "six-equations"),
    *("nature-of-95-to-98", "theorem-11-onto", "theorem-12-branches", "theorem-12-preimages", "56", "62", "65"),
    *("theorem-15-branches", "normal-quaternion", "normal-tensor", "limit-tensor", "lambert-tensor", "breusing-vector"),
    *("theorem-12-reference", "theorem-13-reference", "theorem-16-reference", "corollary-5-reference"),
    "dexp-inverse-domain",
}
"""All errata of the paper."""
AMBIGUOUS = {"no-transcendental-functions"}
HOLDS_IF = {
    *("magnitude", "tangent", "6", "line-free", "18-axis", "general-screw", "31", "32", "cayley-quaternion-inverse"),
    *("39", "40", "41", "44", "45", "92", "99", "106", "113", "120", "126", "127", "128"),
}
EVIDENCE = {"arc-tangent", "quaternion-norm", "25", "42", "43"}
SAMPLE = 6  # stride of the sample: tests decide every sixth entry that holds; `make check` decides all


@pytest.fixture(scope="module")
def numbers() -> list[str]:
    modules = (importlib.import_module(f"derive.papers.{PAPER.name}.sections.{section}") for section in SECTIONS)
    return [entry.number for module in modules for entry in module.ENTRIES]


@pytest.fixture(scope="module")
def results(numbers) -> dict[str, Result]:
    told = ERRATA | AMBIGUOUS | HOLDS_IF | EVIDENCE | {"30"}
    chosen = [entry.number for entry in PAPER.entries() if entry.number in told | set(numbers[::SAMPLE])]
    return {result.equation.number: result for result in verify(PAPER.slug, chosen)}


def test_statuses(results) -> None:
    found = {status: {n for n, r in results.items() if r.status is status} for status in Status}
    assert found[Status.ERRATUM] == ERRATA
    assert found[Status.AMBIGUOUS] == AMBIGUOUS
    assert found[Status.HOLDS_IF] == HOLDS_IF


def test_page_counts_all_statuses() -> None:
    page = (Path(__file__).parents[3] / "docs" / "errata.md").read_text("utf-8")
    assert "| paper | erratum | ambiguous | holds-if | holds | all |" in page
    assert f"| CP23 | {len(ERRATA)} | {len(AMBIGUOUS)} | 71 | 208 | 316 |" in page
    assert "| K10 | 3 | 1 | 57 | 27 | 88 |" in page


def test_all_but_a_few_are_decided_exactly(results) -> None:
    assert {number for number, result in results.items() if "evidence" in result.method} == EVIDENCE


def test_evidence_has_a_proved_supporting_identity(results) -> None:
    for number in EVIDENCE - {"quaternion-norm"}:
        assert "supporting identity proved exactly" in results[number].method


@pytest.mark.parametrize("number", ["cayley-onto", "cayley-quaternion-onto", "cayley-half-onto"])
def test_elements_without_a_preimage_are_proved(results, number: str) -> None:
    result = results[number]
    assert "refuted at" in result.method
    assert "supporting identity proved exactly" in result.method


@pytest.mark.parametrize(
    ("number", "fragment"),
    [("105", r"\frac{1 - \left|\underline{\mathbf{v}}\right|^{2}}{4}"), ("111", r"16\, \underline{\mathbf{v}}"),
     ("125", "45 - 34"), ("129", r"\frac{1}{2}\, d")],
)  # fmt: skip
def test_corrections(results, number: str, fragment: str) -> None:
    result = results[number]
    assert fragment in result.corrected
    assert fragment not in result.printed


def test_second_inverse_reading_closes_the_bracket_before_the_identity(results) -> None:
    first, second = results["30"].verdicts
    assert (first.true, second.true) == (True, False)  # true readings precede false ones


# --- preimages of the Cayley map of order n, by the roots of a polynomial ---------------------------------------------

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
