"""Display of results at a Python prompt and in a notebook."""

from __future__ import annotations

import html
import inspect
import re

import pytest

import derive
from derive.codegen import Package
from derive.output.listing import Listing
from derive.proof import Proof, theorems
from tests.support import examples

LONGEST = 120


@pytest.fixture
def package(without_validation: None) -> Package:
    """Return the package that the example in the docstring of `generate` writes."""
    names: dict[str, Package] = {}
    assert examples.failures(inspect.getdoc(derive.generate), "generate", names) == ""
    return names["package"]


def test_results_are_short_at_a_prompt(package: Package) -> None:
    result, other = derive.verify("karakilic-2010", ["14", "22"])
    assert repr(result) == "<Result karakilic-2010 (14): erratum>"
    assert repr(result.equation) == "<Equation (14): b1* from the others>"
    assert repr(other) == "<Result karakilic-2010 (22): holds-if>"
    assert repr(theorems()[2]) == "<Proof [all n] norm: proved>"
    module, = package.modules
    assert re.fullmatch(r"<Module cayley1.py: \d+ proofs, \d+ calls validated>", repr(module))
    assert repr(package) == f"<Package of cayley1.py: {len(package.texts)} files>"
    assert repr(module.proved) == f"<Proved cayley1: {len(module.proved.proofs)} proofs>"


def test_list_has_a_line_for_each_result() -> None:
    proofs = derive.Cayley(2).prove()
    lines = repr(proofs).splitlines()
    assert len(lines) == len(proofs)
    assert max(map(len, lines)) <= LONGEST
    assert repr(Listing[Proof]()) == "[]"


def test_proof_is_a_formula_in_a_notebook() -> None:
    norm = theorems()[2]
    assert norm._repr_latex_() == rf"$\displaystyle \text{{proved [all n]:}}\quad {norm.latex}$"


FOUND = (derive.Cayley(1).prove, derive.family("lambert").prove, lambda: derive.verify("karakilic-2010", ["14", "22"]))


@pytest.mark.parametrize("found", FOUND)
def test_list_is_a_table_in_a_notebook(found) -> None:
    items = found()
    table = items._repr_html_()
    assert table.count("<tr>") == len(items) + 1
    assert table.count("<td") == len(items) * table.count("<th")
    for item in items:
        for text in item.cells().values():
            assert f">{html.escape(text)}<" in table
    assert Listing[Proof]()._repr_html_() == "<table>\n</table>"


def test_less_than_sign_is_escaped() -> None:
    table = derive.verify("karakilic-2010", ["14"])._repr_html_()
    assert "0 &lt; f" in table
    assert set(re.findall(r"</?(\w+)", table)) == {"table", "tr", "th", "td"}
