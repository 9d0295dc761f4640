"""Tests of CP23: all errata, and statuses and single entries of sections 2 to 6 and 9."""

from __future__ import annotations

import importlib
from pathlib import Path

import pytest

from derive.papers import Result, Status, verify
from derive.papers.condurache_popa_2023 import PAPER

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
    modules = (importlib.import_module(f"{PAPER.package}.sections.{section}") for section in SECTIONS)
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
