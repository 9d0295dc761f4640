"""Tests of K10: statuses, single entries, and entries with separate components."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from derive.papers import Status
from derive.papers.karakilic_2010 import PAPER, k10_notation
from derive.papers.language.printed import Apply, Symbol, walk
from derive.papers.numbers.quantities import QUANTITIES

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


def test_all_but_three_are_decided_exactly(results) -> None:
    evidence = {number for number, result in results.items() if result["method"].startswith("evidence")}
    assert evidence <= {"exponential", "positions", "every-orthogonal"}


@pytest.mark.parametrize("number", ["20", "21", "22", "conclusion-20", "conclusion-21", "conclusion-22"])
def test_dual_parameters_hold_below_a_half_turn(results, number: str) -> None:
    assert results[number]["condition"] == r"0 < \operatorname{Tan} \frac{f}{2}"


def test_domain_of_14_ends_at_a_half_turn(results) -> None:
    result = results["14"]
    assert result["printed"].endswith(r"0 < f < 2\, \pi")
    assert result["corrected"].endswith(r"1 - s_1^{2} \neq 0, \quad 0 < f < \pi")


def test_frame_is_not_chosen_if_components_are_read() -> None:
    marks = {"K10 entry", "K10 component", "K10 matrix", "K10 sum over i and j", "K10 everywhere"}
    for entry in PAPER.entries():
        heads = {node.operator.name for r in entry.readings for node in walk(r.statement) if isinstance(node, Apply)}
        symbols = {f"{x}{i}{star}" for x in "bs" for i in (1, 2, 3) for star in ("", "*")}
        defined = {d.symbol.name for d in entry.where if d.arguments}
        takes_apart = heads & marks or any(_names(reading.statement) & symbols & defined for reading in entry.readings)
        free = [symbol for r in entry.readings for symbol in entry.free(r.statement)]
        free_tensor = any(symbol.quantity is QUANTITIES["tensor"] for symbol in free)
        if takes_apart and not free_tensor and entry.number != "dimension":
            assert entry.components, entry.number


def _names(statement) -> set[str]:
    return {node.name for node in walk(statement) if isinstance(node, Symbol)}


def test_characters_shown_by_the_extraction() -> None:
    assert k10_notation.shown(r"\left\| \hat{b} \right\| = \frac{\hat{X}' - \hat{x}'}{2}") == "b̂={X̂'-x̂'}{2}"
    assert k10_notation.shown(r"\stackrel{\mathbf{r}}{b} \cdot \mathbf{r}^{*}") == "b·r^{*}"
