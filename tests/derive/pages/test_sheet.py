"""Formula sheet: lines of proved theorems only, under names of the page of theorems."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from itertools import chain
from pathlib import Path

import pytest
import sympy

from derive.maps import Cayley
from derive.pages import sheet
from derive.pages.theorems import title
from derive.proof import ProofFailed
from derive.proof.identity import Proof
from derive.proof.proved import CLAIMS
from derive.proof.theorem import decided

THEOREMS = (Path(__file__).parents[3] / "docs" / "theorems.md").read_text(encoding="utf-8")
TABLES = (sheet.MAPS_OF_ORDER, sheet.MOTION_OF_ORDER, sheet.EVERY_PHI)
WANTED = [wanted for table in TABLES for wanted in chain.from_iterable(table.values())]


@pytest.fixture(scope="module")
def known() -> Mapping[str, Proof]:
    return {proof.name: proof for proof in decided(CLAIMS)}


@pytest.fixture(scope="module")
def pages() -> tuple[sheet.Page, ...]:
    return sheet.sheet()


def test_lines_have_formulas_of_theorems_on_the_page_of_theorems(pages: tuple[sheet.Page, ...]) -> None:
    lines = [line for page in pages for block in page.blocks for line in block.lines]
    on_page = set(re.findall(r"^### (.+)$", THEOREMS, re.M))
    order = re.compile(r"(?<=[(\s])[12](?=[)\]])")  # the page shows the proofs at n = 3
    shown = {name if (name := line.theorem) in on_page else order.sub("3", name) for line in lines}
    assert len(pages) == 4
    assert len(lines) > 100
    assert all(line.formulas for line in lines)
    assert shown - on_page == {"coefficients in alpha [exponential]"}


def test_numbers_are_those_of_the_theorems(pages: tuple[sheet.Page, ...]) -> None:
    numbers = {line.theorem: line.numbers for page in pages for block in page.blocks for line in block.lines}
    assert numbers["tangent"] == (88,)
    assert numbers["Cayley(3).tangent [n = 3]"] == (88, 111)
    assert numbers["composition at n = 2 [n = 2]"] == (41,)


@pytest.mark.parametrize("wanted", WANTED, ids=lambda wanted: wanted[0])
def test_lines_of_an_unproved_theorem_are_refused(known: Mapping[str, Proof], wanted: sheet.Wanted) -> None:
    assert all(line.theorem == title(known[wanted[0]]) for line in sheet._lines([wanted], known))
    failed = replace(known[wanted[0]], status="failed")
    with pytest.raises(ProofFailed, match=re.escape(failed.statement[:20])):
        list(sheet._lines([wanted], {**known, wanted[0]: failed}))


@pytest.mark.parametrize("name", ["twist", "any phi: inverse"])
def test_altered_theorem_is_refused(name: str) -> None:
    altered = [t.with_claim(0, t.claim[0].altered()) if t.name == name else t for t in CLAIMS]
    with pytest.raises(ProofFailed, match="not proved"):
        sheet.sheet(altered)


@pytest.mark.parametrize("name", sheet.MAPS)
def test_altered_formula_of_an_order_is_refused(stated, known: Mapping[str, Proof], name: str) -> None:
    formula = getattr(Cayley(2), name)
    wrong = replace(formula, coefficients=(formula.coefficients[0] + 1, *formula.coefficients[1:]))
    with pytest.raises(ProofFailed, match=re.escape(f"Cayley(2).{name}")):
        list(sheet._of_order(stated(2, **{name: wrong}), known))


def test_step_to_a_branch_needs_its_theorem(known: Mapping[str, Proof]) -> None:
    even, odd = (known[f"shadow, {which} branch"] for which in ("even", "odd"))
    swapped = {**known, "shadow, even branch": odd, "shadow, odd branch": even}
    assert len(list(sheet._step(3, 1, known))) == 2
    with pytest.raises(ValueError, match="branch 1 of order 3 is not a case"):
        list(sheet._step(3, 1, swapped))


@pytest.mark.parametrize(("order", "branch"), [(2, 1), (3, 1), (3, 2)])
def test_step_adds_an_angle(known: Mapping[str, Proof], order: int, branch: int) -> None:
    r, angle = sympy.Rational(1, 7), branch * sympy.pi / order
    step = next(given.equation for given in known["Moebius step"].premises if given.equation.left == sheet.r_k)
    found = step.right.xreplace({sheet.beta: angle, sympy.Symbol("r"): r})
    assert abs(sympy.N(found - sympy.tan(sympy.atan(r) + angle), 30)) < 1e-28  # two roads of 30 digits
