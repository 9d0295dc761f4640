"""Drafts of files of claims: a formula is read surely or not at all, and a proposal stands under its caution."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from derive.claims import proposal
from derive.claims.draft import draft
from derive.claims.report import FORMATS, LINEWISE, Report
from derive.claims.run import check_sheets
from derive.claims.sheet import load
from tests.support.command import dualcay

LETTERS = {"v": "vector", "w": "vector", "n": "unit vector", "R": "rotation", "A": "tensor", "q": "unit quaternion",
           "a": "angle", "b": "real", "c": "real", "theta": "angle", "v_1": "vector"}  # fmt: skip
READ = {
    r"\tilde{v} w = v \times w.": "skew(v)*w == cross(v, w)",
    r"R &= I + \sin\theta\,\tilde n \\ &\quad + (1-\cos\theta)\,\tilde{n}^2": None,
    r"R &= I + \sin\theta\,\tilde n \\ & + (1-\cos\theta)\,\tilde{n}^2":
        "R == I + sin(theta)*skew(n) + (1 - cos(theta))*skew(n)**2",
    r"\left(\sin a\right)^2 + (\cos a)^{2} = 1": "sin(a)**2 + cos(a)**2 == 1",
    r"\|v\|^2 = v\cdot v = v^\top v": "norm(v)**2 == dot(v, v) == transpose(v)*v",
    r"\tfrac12 b + \frac{1}{2} b \leq |b|": "1/2*b + 1/2*b <= norm(b)",
    r"R^{-1} = R^T": "R**(-1) == transpose(R)", r"\dot R = R\,\tilde w": "rate(R) == R*skew(w)",
    r"A = \cos\theta I": "A == cos(theta)*I",
    r"v_1 \times (v \times w) = \operatorname{tr} A \, v": None,
    r"\operatorname{tr}(A) \neq \det A": "trace(A) != det(A)", "b^12 = b": "b**1*2 == b",
    r"G(v, w)\, n = \sqrt{b^2}\, G(w, v)\, n": "G(v, w)*n == sqrt(b**2)*G(w, v)*n",
    r"\frac123 b = \frac{1}{23} b": "1/2*3*b == 1/23*b", r"\frac{b c}34 b = 10\,240 c": "b*c/3*4*b == 10240*c",
    r"2\,\sin a\cos b\; v\times w = 0": "2*sin(a)*cos(b)*cross(v, w) == 0",
    r"a &= b \\ &\; + c \\ &= c": "a == b + c == c",
    r"-a b + c = c - b a": "-(a*b) + c == c - b*a", r"\hat q\,\hat{q}^{*} = 1": "q*conjugate(q) == 1",
}  # fmt: skip
NOT_READ = {
    r"\hat v \times w = 0": r"\hat", r"x = 1": "x", r"v_2 = v": "v", r"a / b = c": "/", r"a = b \quad b = c": r"\quad",
    r"a = b, \; c = b": ",", r"a = b \\ c = b": r"\\", r"\sin^2 a = b": "^", r"\sin(a)^2 = b": "^", r"\cos 2a = b": "a",
    r"\exp\tilde{v} w = w": "w", r"\det A A = A": "A", r"v \times w \times n = 0": r"\times", r"b = 2.5": ".",
    r"R v \times w = w": "w", r"v \cdot w\, n = n": "n", r"\sqrt[3]{b} = c": r"\sqrt", r"b! = 1": "!", "b' = 1": "'",
    r"R = \begin{bmatrix} 1 \end{bmatrix}": r"\begin", r"a =": "the end", "= a": "=", "a + b": "the end", "}": "}",
    r"\frac": "the end", r"v w = b": "read as", r"a \times b = c": "read as", r"e^{a} = b": "e",
    r"G v = w": "v", r"\mathbf A = \mathrm{A}": r"\mathbf",
    "a" + "b" * 4000 + "= c": "a formula of", "(" * 990 + "a": "too many",
    "{a + b} c = c": "{", r"\sin{2a} = b": "{", "a &= b & c &= b": "&",
    r"a &= b \\ c &= b": r"\\", "a &= b & -c &= b": "&",
    r"a \cdot v = b": "read as", r"b \varepsilon = c": r"\varepsilon",
    r"α = b": "α", r"[v]_\times w = 0": "_", r"\int_0^1 b = c": r"\int", r"\text{so } a = b": r"\text",
}  # fmt: skip


def drafted(folder: Path, *formulas: str) -> tuple[Path, list[dict[str, object]]]:
    """Return the draft of a document with these formulas, and its equations."""
    source = folder / "paper.tex"
    definition = "% dualcay: definition G(u, z) = I + dyad(u, z)\n"
    source.write_text(definition + "\n".join(f"$${formula}$$" for formula in formulas), encoding="utf-8")
    text, problems = draft(source, LETTERS)
    assert problems == []
    file = folder / "sheet.toml"
    file.write_text(text, encoding="utf-8")
    sheet = load(file)
    assert sheet.problems == ()
    return file, [*sheet.entries(), *sheet.unread]


@pytest.mark.parametrize("formula", READ)
def test_formula_is_proposed_where_each_sign_is_understood(formula: str, tmp_path: Path) -> None:
    file, [entry] = drafted(tmp_path, formula)
    claim = re.search("^claim = '(.*)'\nproposed = true$", file.read_text(), re.M)
    assert (claim[1] if claim else None) == READ[formula]
    if claim:
        assert (entry.number, entry.at, entry.proposed) == ("line 2", f"{tmp_path / 'paper.tex'}:2", True)


@pytest.mark.parametrize("formula", NOT_READ)
def test_first_sign_that_is_not_understood_is_named(formula: str, tmp_path: Path) -> None:
    file, [row] = drafted(tmp_path, formula)
    [said] = re.findall('^claim = ""  # not understood: (.*)$', file.read_text(), re.M)
    assert said.startswith(NOT_READ[formula])
    assert (row["number"], row["latex"]) == ("line 2", formula)


@pytest.mark.parametrize(
    ("table", "sign", "other", "formula"),
    [("PRODUCTS", r"\cdot", "cross", r"v \cdot w = 0"), ("RELATIONS", "<", "<=", "b < c"),
     ("ACCENTS", r"\dot", "skew", r"\dot v = \dot w"), ("FUNCTIONS", r"\sin", "cos", r"\sin a = b")],
)  # fmt: skip
def test_sign_that_is_read_as_another_one_is_found_by_the_print(
    table: str, sign: str, other: str, formula: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert "proposed = true\n" in drafted(tmp_path, formula)[0].read_text()
    monkeypatch.setitem(getattr(proposal, table), sign, other)
    assert f'claim = ""  # not understood: {sign}: ' in drafted(tmp_path, formula)[0].read_text()


def test_letter_printed_in_two_ways_is_not_read(tmp_path: Path) -> None:
    _, rows = drafted(tmp_path, r"\mathbf{v} \times w = 0", r"v = |\mathbf v|", r"w \times w = 0")
    assert [getattr(row, "number", None) for row in rows] == ["line 4", None, None]
    assert (tmp_path / "sheet.toml").read_text().count("the letter v is printed in several ways") == 2


def test_every_part_of_a_draft_is_text(tmp_path: Path) -> None:
    _, [first, second] = drafted(tmp_path, "\x07 \\label{it's \"\\a\" é} ''' \x1b \x7f", "\x1b \x7f")
    assert first["number"] == "it's \"\\a\" é"
    assert (first["latex"], second["latex"]) == ("\x07 ''' \x1b \x7f", "\x1b \x7f")


@pytest.mark.parametrize(("side", "silent"), [("0", ("latex", *LINEWISE)), ("v", ("latex",))])
def test_caution_stands_beside_the_verdict_until_the_mark_is_deleted(
    tmp_path: Path, side: str, silent: tuple[str, ...]
) -> None:
    file, _ = drafted(tmp_path, rf"v \times v = {side}", r"\hat v = v")
    results = check_sheets([load(file)])
    for mark, form in ((mark, form) for mark in (True, False) for form in FORMATS if form not in silent):
        if not mark:
            file.write_text(file.read_text().replace("proposed = true\n", ""))
            results = check_sheets([load(file)])
        text = FORMATS[form](Report.of([load(file)], results, (), unread=load(file).unread))
        shown = "read this before you believe it" in text
        said = json.loads(text)["equations"][0]["proposed"] if form == "json" else shown
        assert said is mark, form
        assert "line 3" in text or form in LINEWISE
        assert "1 decided, 1 unread" in text or form in ("json", "sarif")
        assert ("1 proposed" in text or '"proposed": 1' in text) is mark or form not in LINEWISE
    assert ("read this" in str(results[0].cells())) is False


def test_command_writes_a_draft_and_keeps_what_stands_there(tmp_path: Path) -> None:
    text = "<!-- dualcay: letters z = rael -->\n$$v \\times v = 0$$\n<!-- dualcay: clam -->\n"
    text += "$$x = y$$\n<!-- dualcay: claim 1 == 1 -->\n"
    (tmp_path / "paper.md").write_text(text)
    command = ("draft", "paper.md", "--let", "v=vector", "-o", "sheet.toml")
    done = dualcay(*command, cwd=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.splitlines() == [
        "sheet.toml: 2 equations, 0 unread",
        "paper.md:3: comment, column 14: expected letters, definition, claim, domain, corrected, remark, got 'clam'",
        "paper.md:1: letter z, column 27: no kind 'rael' of z: expected real",
    ]  # fmt: skip
    text = (tmp_path / "sheet.toml").read_text()
    assert text.count("\nproposed = true") == 1
    assert "exists" in dualcay(*command, cwd=tmp_path).stderr
    assert (tmp_path / "sheet.toml").read_text() == text
    assert dualcay(*command, "--force", cwd=tmp_path).returncode == 2
    assert dualcay("draft", "paper.md", "--let", "v=vector", cwd=tmp_path).stdout == text
    assert dualcay("draft", "none.md", cwd=tmp_path).returncode == 3
    assert "expected a document" in dualcay("draft", "sheet.toml", cwd=tmp_path).stderr
