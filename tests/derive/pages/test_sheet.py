"""Formula sheet: lines of proved theorems only, and the files that ``dualcay show --what sheet`` writes."""

from __future__ import annotations

import html
import json
import re
import subprocess
from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import chain
from pathlib import Path
from unittest import mock

import pytest
import sympy

from derive.maps import Cayley
from derive.output.files import RefusedError
from derive.pages import sheet, sheet_files
from derive.pages.sheet_files import FLAGS, pieces
from derive.proof import ProofFailed
from derive.proof.identity import Proof
from derive.proof.methods import decided
from derive.proof.proved import CLAIMS
from derive.workers import SlowError
from docs._ext import sheet as site
from tests.support import browsers
from tests.support.command import ROOT, dualcay

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
    on_page = set(re.findall(r"^<details><summary><b>(.+)</b></summary>$", THEOREMS, re.M))
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


def test_lines_of_an_unproved_theorem_are_refused(known: Mapping[str, Proof]) -> None:
    for wanted in WANTED:
        assert all(line.theorem == known[wanted[0]].title for line in sheet.lines([wanted], known))
        failed = replace(known[wanted[0]], status="failed")
        with pytest.raises(ProofFailed, match=re.escape(failed.statement[:20])):
            list(sheet.lines([wanted], {**known, wanted[0]: failed}))


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


WIDE = r"""<script>addEventListener("load", () => {
  const box = node => node.getBoundingClientRect();
  const formulas = [...document.querySelectorAll("math")];
  document.body.dataset.probe = JSON.stringify({
    formulas: formulas.length,
    flat: formulas.filter(node => box(node).width < 3 || box(node).height < 5).length,
    wide: formulas.filter(node => box(node).right > box(node.closest(".line")).right + 1).map(node => node.textContent),
    overflow: document.documentElement.scrollWidth - innerWidth,
  });
});</script>"""


@pytest.fixture(scope="module")
def written(pages: tuple[sheet.Page, ...], tmp_path_factory: pytest.TempPathFactory) -> Path:
    output = tmp_path_factory.mktemp("sheet") / "sheet.html"
    with mock.patch.object(sheet_files, "sheet", return_value=pages):
        done = dualcay("show", "--what", "sheet", "-o", str(output))
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    return output


def test_html_has_four_pages_with_theorems(written: Path) -> None:
    text = written.read_text(encoding="utf-8")
    assert text.count("<section>") == 4
    assert "Cayley(3).tangent [n = 3] · (88), (111)" in text
    assert "def · Jacobian of the rate" in text
    assert "http" not in text.replace("http://www.w3.org/1998/Math/MathML", "")
    assert 'mathvariant="bold"' not in text


def test_altered_theorem_leaves_the_file_as_it_was(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    altered = [t.with_claim(0, t.claim[0].altered()) if t.name == "twist" else t for t in CLAIMS]
    monkeypatch.setattr("derive.pages.sheet.CLAIMS", altered)
    output = tmp_path / "sheet.html"
    output.write_text("old", encoding="utf-8")
    done = dualcay("show", "--what", "sheet", "-o", str(output))
    assert done.returncode == 1
    assert "not proved: omega = " in done.stderr
    assert output.read_text(encoding="utf-8") == "old"


@pytest.mark.parametrize("browser", ["", "false"])
def test_pdf_needs_a_browser_that_prints(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, browser: str) -> None:
    monkeypatch.setattr(sheet_files, "page", lambda: "")
    monkeypatch.setenv("CHROMIUM", browser)
    monkeypatch.setattr("shutil.which", lambda _: None)
    done = dualcay("show", "--what", "sheet", "-o", str(tmp_path / "sheet.pdf"))
    assert done.returncode == 3
    assert ("printed nothing" if browser else "needs Chromium or Chrome") in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_browser_that_computes_without_end_is_stopped(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def slow(command: Sequence[str], seconds: int) -> None:
        raise SlowError(f"{command[0]} was stopped after {seconds} s")

    monkeypatch.setenv("CHROMIUM", "browser")
    for name, function in {"run": slow, "page": str}.items():
        monkeypatch.setattr(sheet_files, name, function)
    with pytest.raises(RefusedError, match=r"browser printed nothing: browser was stopped after 120 s"):
        sheet_files.write_pdf(tmp_path / "sheet.pdf")
    assert not list(tmp_path.iterdir())


def test_formulas_break_at_outer_signs_only() -> None:
    text = r"R = \left(1 - x\right) I + \frac{a + b}{c} v - w"
    assert list(pieces(text)) == ["R", r"= \left(1 - x\right) I", r"+ \frac{a + b}{c} v", "- w"]


@pytest.mark.browser
@pytest.mark.thorough
def test_pdf_has_four_pages_of_a4(tmp_path: Path) -> None:
    assert dualcay("show", "--what", "sheet", "-o", "sheet.pdf", cwd=tmp_path).returncode == 0
    printed = (tmp_path / "sheet.pdf").read_bytes()
    assert len(re.findall(rb"/Type /Page\b(?!s)", printed)) == 4
    width, height = map(float, re.search(rb"/MediaBox \[0 0 ([\d.]+) ([\d.]+)\]", printed).groups())
    assert (round(width), round(height)) == (595, 842)
    assert [path.name for path in tmp_path.iterdir()] == ["sheet.pdf"]


@pytest.mark.browser
@pytest.mark.thorough
@pytest.mark.parametrize("width", [390, 800])
def test_no_formula_is_wider_than_its_column(written: Path, tmp_path: Path, width: int) -> None:
    text = written.read_text(encoding="utf-8").replace("</body>", f"{WIDE}</body>")
    (tmp_path / "sheet.html").write_text(text, encoding="utf-8")
    options = (*FLAGS, f"--window-size={width},900", f"--user-data-dir={tmp_path}/profile", "--dump-dom")
    command = [str(browsers.find()), *options, (tmp_path / "sheet.html").as_uri()]
    done = subprocess.run(command, capture_output=True, text=True)
    seen = json.loads(html.unescape(re.search(r'data-probe="([^"]*)"', done.stdout).group(1)))
    assert seen["formulas"] > 300
    assert (seen["flat"], seen["wide"] if width == 800 else [], max(seen["overflow"], 0)) == (0, [], 0)


@pytest.mark.parametrize("browser", [None, "browser"])
def test_site_has_the_sheets_to_which_it_links(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], browser: str | None
) -> None:
    replaced = {"find_browser": lambda: browser, "write_html": Path.touch, "write_pdf": Path.touch}
    for name, function in replaced.items():
        monkeypatch.setattr(sheet_files, name, function)
    app = mock.Mock(outdir=tmp_path, tags=set())
    site.setup(app)
    site.write(app, None)
    page = (ROOT / "docs" / "sheet.md").read_text(encoding="utf-8")
    page = page if "pdf" in app.tags else re.sub(r"^::::\{only\} pdf$.*?^::::$", "", page, flags=re.S | re.M)
    assert re.findall(r"\{button-link\} (\S+)", page) == sorted((p.name for p in tmp_path.iterdir()), reverse=True)
    assert capsys.readouterr().out == ("" if browser else "skipped: the sheet as PDF needs Chromium or Chrome\n")
