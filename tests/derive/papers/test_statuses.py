"""Statuses of the papers' entries in docs/errata.json: all agree with the page, and a sample is decided anew."""

from __future__ import annotations

import json
import re
from collections import Counter
from typing import Any

import pytest

import derive
from derive import papers
from derive.claims.report import Report, data
from derive.claims.sheet import Sheet
from tests.support.imports import ROOT

PAGE = ROOT / "docs" / "errata.md"
ENTRIES: dict[str, dict[str, Any]] = {
    f"{entry['paper'][0]} {entry['equation']}": entry
    for entry in json.loads(PAGE.with_suffix(".json").read_text(encoding="utf-8"))["equations"]
}
"""Entries by the first letter of the paper and the number: c for CP23, k for K10."""

PAPERS = {"c": "CP23", "k": "K10"}
ORDER = ("erratum", "undecided", "unrefuted", "ambiguous", "holds-if", "holds")


@pytest.mark.parametrize("paper", papers.PAPERS, ids=lambda paper: paper.slug)
def test_a_sample_is_decided_as_recorded(paper: Sheet) -> None:
    numbers = [entry.number for entry in paper.entries()][5::24]
    report = Report.of([paper], derive.verify(paper.slug, numbers), [])
    assert json.loads(data(report))["equations"] == [ENTRIES[f"{paper.slug[0]} {number}"] for number in numbers]


@pytest.mark.parametrize("paper", PAPERS)
def test_page_counts_the_statuses_of_the_data(paper: str) -> None:
    found = Counter(entry["status"] for key, entry in ENTRIES.items() if key.startswith(paper))
    row = (PAPERS[paper], *(found[status] for status in ORDER), found.total())
    assert f"| {' | '.join(map(str, row))} |" in PAGE.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("key", "part", "text"),
    [
        *((f"c {name}onto", "method", "refuted at .*supporting identity is proved")
          for name in ("cayley-", "cayley-quaternion-", "cayley-half-")),
        *((f"c {number}", "method", "supporting identity is proved")
          for number in ("arc-tangent", "25", "42", "43")),
        ("c 105", "corrected", r"\\frac\{1 - \\left\|\\underline\{\\mathbf\{v\}\}\\right\|\^\{2\}\}\{4\}"),
        ("c 111", "corrected", r"16\\, \\underline"), ("c 125", "corrected", "45 - 34"),
        ("c 129", "corrected", r"\\frac\{1\}\{2\}\\, d"),
        *((f"k {number}", "condition", r"^0 < \\operatorname\{Tan\} \\frac\{f\}\{2\}$")
          for number in ("20", "21", "22", "conclusion-20", "conclusion-21", "conclusion-22")),
        ("k 14", "claimed", r"^0 < f ;\\quad f < 2\\, \\pi$"),
        ("k 14", "corrected", r"^0 < f ;\\quad f < \\pi \\Rightarrow 1 - s_1\^\{2\} \\neq 0 \\Rightarrow "),
    ],
)  # fmt: skip
def test_what_is_told_of_an_entry(key: str, part: str, text: str) -> None:
    assert re.search(text, ENTRIES[key][part])
    assert part != "corrected" or not re.search(text, ENTRIES[key]["printed"])


def test_second_reading_of_an_inverse_is_false() -> None:
    """Decide an entry whose other reading closes the bracket before the identity."""
    (result,) = derive.verify("condurache-popa-2023", "30")
    assert [verdict.true for verdict in result.verdicts] == [True, False]
