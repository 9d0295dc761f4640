"""Tests of K10: statuses, single entries, and what its file states beside the claims."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

import derive
from derive.claims.decide import decide
from derive.claims.equation import UndecidedError, characters
from derive.claims.result import Status
from derive.claims.sheet import Sheet, sheet
from derive.papers import PAPERS
from tests.support.command import dualcay
from tests.support.imports import ROOT

PAPER = PAPERS[1]
AMBIGUOUS = {"conclusion-22"}
ERRATA = {"14", "zero-components", "quadratic-expansion"}
HOLDS = {
    *("dual-number", "addition", "multiplication", "zero-divisors", "ring", "no-field", "sine", "cosine"),
    *("exponential", "dual-vector", "module", "dimension", "degenerate", "unit", "unit-vector", "study"),
    *("study-product", "length", "orthogonal-diagonals", "not-singular", "transposed", "orthogonal", "matrix"),
    *("vector", "product", "rhombus", "vertex-angle"),
}


@pytest.fixture(scope="module")
def results(karakilic: Path) -> dict[str, dict[str, Any]]:
    found = json.loads((karakilic / "errata.json").read_text(encoding="utf-8"))
    return {entry["equation"]: entry for entry in found["equations"]}


def test_statuses(results) -> None:
    found = {status: {n for n, r in results.items() if r["status"] == str(status)} for status in Status}
    assert found[Status.ERRATUM] == ERRATA
    assert found[Status.AMBIGUOUS] == AMBIGUOUS
    assert found[Status.HOLDS] == HOLDS


def test_all_but_two_are_decided_exactly(results) -> None:
    evidence = {number for number, result in results.items() if result["method"].startswith("evidence")}
    assert evidence <= {"exponential", "positions"}


@pytest.mark.parametrize("number", ["20", "21", "22", "conclusion-20", "conclusion-21", "conclusion-22"])
def test_dual_parameters_hold_below_a_half_turn(results, number: str) -> None:
    assert results[number]["condition"] == r"0 < \operatorname{Tan} \frac{f}{2}"


def test_domain_of_14_ends_at_a_half_turn(results) -> None:
    result = results["14"]
    assert result["claimed"] == r"0 < f ;\quad f < 2\, \pi"
    assert result["corrected"].startswith(r"0 < f ;\quad f < \pi \Rightarrow 1 - s_1^{2} \neq 0 \Rightarrow ")


def test_frame_is_not_chosen_if_components_are_read() -> None:
    components = {entry.number for entry in PAPER.entries() if entry.components}
    assert {"skew-entries", "matrix", "vector", "14", "18", "denominators"} <= components
    assert components.isdisjoint({"length", "module", "7", "positions"})


# ---- the file --------------------------------------------------------------------------------------------------------


def altered(old: str, new: str) -> Sheet:
    """Return the paper with one change in its text, which stands there once."""
    text = PAPER.request[0]
    assert text.count(old) == 1, old
    return sheet(text.replace(old, new), "altered.toml")


def test_whole_file_can_be_read() -> None:
    assert PAPER.problems == ()
    assert len(PAPER.entries()) == 88


@pytest.mark.parametrize(
    ("number", "old", "new", "reason"),
    [("10", "q3s == (p3s*norm(pr)**2 - p3*", "q3s == (p3s*norm(pr)**2 - p2*", "not have the characters of line 174"),
     ("18", "(slope - s2*b2s - s3*b3s)/s1", "(slope + s2*b2s - s3*b3s)/s1", "not have the characters of line 227"),
     ("real-norm", 'condition = "T >= 0"', 'condition = "T > 0"', "true outside its condition"),
     ("step-21", "u3*(h3 - (u3s*tan(f/2) + u3*slope))", "u3*(h3 - (u3s*tan(f/2) - u3*slope))", "has no correction"),
     ("quadratic-expansion", "1/2*Sum_all", "1/3*Sum_all", "correction is false"),
     ("no-field", "(e*ad)*e == 0", "(e*ad)*e == e", "supporting identity is not proved")],
)  # fmt: skip
def test_altered_entry_is_refused(number: str, old: str, new: str, reason: str) -> None:
    paper = altered(old, new)
    (entry,) = (entry for entry in paper.entries() if entry.number == number)
    with pytest.raises(UndecidedError, match=reason):
        decide(paper.slug, entry, paper.lost)


@pytest.mark.parametrize(
    ("old", "new", "problem"),
    [('line = 133', 'line = "133"', "equation 1: line is an integer, got str"),
     ('note = "over i < j"', 'remark = "over i < j"', "equation quadratic-expansion: unknown key remark"),
     ('condition = "T >= 0"', 'condition = "T >= "', "equation real-norm, column 1: condition: ")],
)  # fmt: skip
def test_what_cannot_be_read_is_one_line(old: str, new: str, problem: str) -> None:
    (found,) = altered(old, new).problems
    assert str(found).startswith(f"altered.toml: {problem}")


TRANSCRIPT = re.search(r"```toml\n(.*?)```", (ROOT / "docs/howto/extend.md").read_text("utf-8"), re.DOTALL)[1]
"""Example of the page on papers."""


def test_transcript_of_a_user_is_decided_without_registration(tmp_path: Path) -> None:
    wrong = '[[equation]]\nnumber = "4"\nlatex = "f = f^{*}"\nclaim = "f == fs"\n'
    (tmp_path / "mine.toml").write_text(TRANSCRIPT + wrong, encoding="utf-8")
    right, false = derive.verify(tmp_path / "mine.toml")
    assert (right.status, right.method, right.exact) == (Status.HOLDS_IF, "exact", True)
    assert false.status is Status.UNDECIDED
    assert false.method.startswith("(4) is false and has no correction: refuted at ")
    shown = dualcay("verify", str(tmp_path / "mine.toml"), "--strict")
    assert shown.returncode == 1
    assert "(4) is false" in shown.stdout


def test_characters_of_printed_latex() -> None:
    assert characters(r"\left\| \hat{b} \right\| = \frac{\hat{X}' - \hat{x}'}{2}") == r"\hat{b}={\hat{X}'-\hat{x}'}{2}"
    assert characters(r"\stackrel{\mathbf{r}}{b} \cdot Tan\frac{f}{2}, \quad \text{ of (14)}") == "b·tan{f}{2},"
