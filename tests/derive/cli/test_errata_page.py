"""Page of errata: columns, and numbers of readings."""

from __future__ import annotations

import re

import pytest

from derive.papers import PAPERS, Result, Status, verify
from derive.papers.language.printed import Symbol
from derive.papers.report import FORMATS, Report
from derive.papers.report.pages import differing_sides
from derive.papers.result import Verdict


@pytest.fixture(scope="module")
def results() -> list[Result]:
    return verify("karakilic-2010", ["14", "20", "half-angle", "5"])


def test_entry_of_an_erratum_has_printed_formula_above_corrected(results: list[Result]) -> None:
    page = FORMATS["markdown"](Report.of(PAPERS, results, (), ".."))
    errata = [result for result in results if result.status is Status.ERRATUM]
    assert errata
    for result in errata:
        (entry,) = re.findall(rf'<a id="{result.anchor}"></a>\n(.*?)</details>', page, re.S)
        printed, right = differing_sides(result)
        assert printed != right
        assert entry.startswith(f"Printed: $`{printed}`$\\\nRight: $`{right}`$\\\n")
        assert f"](#{result.anchor}), section {result.section} |" in page


def test_table_counts_statuses_by_paper(results: list[Result]) -> None:
    report = Report.of(PAPERS, results, (), "..")
    lines = FORMATS["markdown"](report).splitlines()
    (head,) = (line for line in lines if line.startswith("| paper |") and line.endswith("| all |"))
    statuses = [Status(word.strip()) for word in head.split("|")[2:-2]]
    for chapter in report.chapters:
        counts = " | ".join(str(chapter.counts[status]) for status in statuses)
        assert f"| {chapter.paper.short} | {counts} | {len(chapter.results)} |" in lines


def test_readings_are_counted_from_one(results: list[Result]) -> None:
    first = results[0]
    readings = tuple(Verdict(Symbol(name, "real"), name, name == "a", "") for name in "ab")
    unclear = Result(first.paper, first.equation, Status.AMBIGUOUS, "readings differ", readings)
    page = FORMATS["markdown"](Report.of(PAPERS, [unclear], (), ".."))
    decided = [line for line in page.splitlines() if line.startswith("Reading ")]
    assert decided == ["Reading 1 (a), true: $`a`$\\", "Reading 2 (b), false: $`b`$\\"]
