"""Report in every format; docs/errata.md, which `make check-errata` compares, shows all of Markdown."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from collections import Counter
from dataclasses import replace
from pathlib import Path

import pytest
from rich.cells import cell_len

from derive.claims.language.printed import Symbol
from derive.claims.report import FORMATS, Report
from derive.claims.report.forms import mathml
from derive.claims.report.plain import escape, plain
from derive.claims.result import Result, Status, Verdict
from derive.claims.run import check_sheets
from derive.claims.sheet import load
from derive.papers import PAPERS, verify
from derive.proof import theorems

SAMPLE = ("14", "20", "orthogonal", "positions", "5")


@pytest.fixture(scope="module")
def report() -> Report:
    results = verify("karakilic-2010", SAMPLE)
    first = results[0]
    readings = (Verdict(Symbol("a", "real"), "one", True, ""), Verdict(Symbol("b", "real"), "other", False, ""))
    unclear = Result(first.paper, first.equation, Status.AMBIGUOUS, "readings differ", readings)
    return Report.of(PAPERS, [*results, unclear], theorems()[:2], "..")


def test_every_entry_can_be_rendered() -> None:
    for paper in PAPERS:
        for entry in paper.entries():
            statements = [reading.statement for reading in entry.readings]
            for term in (*statements, entry.corrected, entry.condition):
                if term is not None:
                    latex = Verdict(term, "", True, "").latex
                    assert "\\" not in mathml(latex), entry.number
                    assert not re.search(r"[\\{}$]", plain(latex)), entry.number
            for text in (entry.title, entry.remark, entry.fixed_by, entry.said):
                assert not re.search(r"[^\x00-\u017f]|\[[a-z ]+\]", escape(text)), (entry.number, text)


@pytest.mark.parametrize("name", ["markdown", "html", "latex"])
def test_section_of_proofs_is_present_only_with_proofs(report, name) -> None:
    assert ("Proofs" in FORMATS[name](report)) is True
    assert ("Proofs" in FORMATS[name](replace(report, proofs=()))) is False


def test_json_has_the_documented_fields(report) -> None:
    data = json.loads(FORMATS["json"](report))
    assert data["schema"] == 4
    fields = {"paper", "equation", "title", "status", "printed", "corrected", "claimed", "condition", "exact"}
    fields |= {"stated", "said", "readings", "reading_count", "capped", "counterexample", "method", "anchor"}
    for equation in data["equations"]:
        assert fields <= set(equation)
        assert (equation["corrected"] is not None) == (equation["status"] == "erratum")
        assert equation["condition"] is not None or equation["status"] != "holds-if"
        assert (equation["claimed"] is None) == (equation["stated"] is None)
        assert (equation["counterexample"] is not None) == (equation["status"] == "erratum")
        assert not (equation["capped"] and equation["status"] == "erratum")
        assert {tuple(reading) for reading in equation["readings"]} == {("latex", "verdict", "note")}
    assert all(set(p) == {"statement", "scope", "status", "method", "seconds"} for p in data["proofs"])
    assert len(data["proofs"]) == 2


def test_text_shows_counts_and_corrections_side_by_side(report) -> None:
    text = FORMATS["text"](report)
    statuses = Counter(str(result.status) for result in report.results)
    counts = [statuses[status] for status in ("erratum", "unrefuted", "ambiguous", "holds-if", "holds")]
    assert re.search(r"K10 +│ +" + r" │ +".join(str(n) for n in (*counts, len(report.results)) if n) + " │", text)
    assert "b₁* = (s₁* Tan f/2 + s₁ s₂ b₂* + s₁ s₃" in text
    assert "0 < f ; f < π" in text
    assert "\\" not in text
    assert max(map(cell_len, text.splitlines())) <= 120


@pytest.mark.parametrize("form", ["markdown", "html", "latex"])
def test_pages_hold_every_entry_and_nothing_undefined(report, form: str) -> None:
    page = FORMATS[form](report)
    for result in report.results:
        if form != "latex" or result.status is not Status.HOLDS:
            assert result.equation.number in page
    for proof in report.proofs:
        assert proof.name in page
        assert form != "latex" or proof.latex in page
    assert "None" not in page


def test_words_of_the_paper_are_beside_a_claim_in_words(report) -> None:
    result = next(result for result in report.results if result.status is Status.ERRATUM)
    equation = replace(result.equation, said="If one of them is equal to zero")
    said = Report.of(PAPERS, [replace(result, equation=equation)], [])
    for form in ("markdown", "html"):
        assert "In the paper: “If one of them is equal to zero" in FORMATS[form](said)
    assert "In the paper: ``If one of them" in FORMATS["latex"](said)


def test_html_needs_no_network(report) -> None:
    page = FORMATS["html"](report)
    assert not re.search(r"(src|href)=\"(https?:)?//|<link|@import|url\(", page)
    assert not re.search(r"<article[^>]* hidden", page)  # all entries are visible without the script


HOSTILE = """\ufeff
[paper]
title = "<script>a</script> | b"
source = "[x](javascript:a) costs $5"
[letters]
x = "real"
[[equation]]
number = "<b>"
title = "<script>a & b_c</script>"
at = "page | <img src=x>"
latex = 'a|b ` $x$ <script> {'
claim = "x == x + 1"
remark = "costs $5 <script> [a](javascript:b) | *x*, and $a_1|b$"
[[equation]]
number = "unknown"
claim = "foo(x) == 1"
"""


@pytest.mark.parametrize("form", ["text", "markdown", "html", "latex"])
def test_texts_of_a_file_are_shown_and_have_no_effect(form: str, tmp_path: Path) -> None:
    (file := tmp_path / "hostile.toml").write_text(HOSTILE, encoding="utf-8")
    paper = load(file)
    page = FORMATS[form](Report.of([paper], check_sheets([paper]), (), "", paper.problems))
    assert "unknown operation" in page
    for wanted in {"text": ["a|b ` $x$ <script> {", "left 1, right 2"],
                   "markdown": ["$`a|b ' $x$ <script> {`$", "`x = 1; left 1, right 2`",
                                r"\| \*x\*, and $`a_1\vert b`$"],
                   "html": ["a|b ` $x$ &lt;script&gt; {", "left 1, right 2", "&lt;script&gt;a &amp; b_c"],
                   "latex": [r"\texttt{a|b ` \$x\$ <script> \{}", "left 1, right 2"]}[form]:  # fmt: skip
        assert wanted in page
    outside = re.sub(r"(?<!\\)(`+).*?(?<!\\)\1", "", page)  # code and formulas have no effect
    if form == "markdown":
        assert not re.search(r"<script|<img|(?<!\\)\]\(javascript|(?<!\\)\$5", outside)
    if form == "html":
        assert page.count("<script>") == 1
    assert form != "latex" or page.replace(r"\{", "").count("{") == page.count("}")


def test_latex_sheet_compiles(report, tmp_path: Path) -> None:
    sheet = FORMATS["latex"](report)
    assert sheet.count("{") == sheet.count("}")
    compiler = shutil.which("pdflatex")
    if compiler is None:  # needs TeX; brackets are checked above without it
        return
    (tmp_path / "errata.tex").write_text(sheet, encoding="utf-8")
    command = [compiler, "-interaction=nonstopmode", "-halt-on-error", "errata.tex"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout[-2000:]
    assert "Missing character" not in (tmp_path / "errata.log").read_text(encoding="utf-8", errors="replace")
