"""Papers as files: the command and the calls on good, ill-formed and unreadable files, and the limit of time."""

from __future__ import annotations

import json
import re
import warnings
from pathlib import Path

import pytest

import derive
from derive.claims.language.names import ClaimError
from derive.claims.report import FORMATS, Report
from derive.claims.result import Result, Status
from derive.claims.run import check_sheets
from derive.claims.sheet import SheetError, load
from tests.support.command import dualcay

GOOD = """
[paper]
slug = "sheet"
title = "Formula sheet"
[letters]
v = "vector"
w = "vector"
c = "constant real"
[definitions]
"G(w)" = "I + (1 - cos(norm(w)))/norm(w)**2*skew(w) + (norm(w) - sin(norm(w)))/norm(w)**3*skew(w)**2"
omega = "vect(rate(exp(skew(v)))*transpose(exp(skew(v))))"
[[equation]]
number = "17"
at = "sheet.tex:411"
latex = '\\Gamma^{-1}(-v)'
claim = "inverse(G(-v)) == inverse(G(v)) + skew(v)"
domain = "norm(v) != 0"
[[equation]]
number = "18"
claim = "omega == transpose(G(v))*rate(v)"
corrected = "omega == G(v)*rate(v)"
[[equation]]
number = 19
claim = "rate(c*v) == c*rate(v)"
[[equation]]
number = "20"
claim = "skew(v)*w == cross(w, v)"
"""
STATUSES = {"17": "holds-if", "18": "erratum", "19": "holds", "20": "false"}
BAD = """
[[equation]]
number = "21"
claim = "v.x == __import__('os').system('touch pwned')"
[[equation]]
number = "17"
claim = "v == v"
[[equation]]
number = "22"
claim = "cross(v, c) == v"
"""


@pytest.fixture(scope="module")
def sheet(tmp_path_factory) -> Path:
    file = tmp_path_factory.mktemp("sheets") / "sheet.toml"
    file.write_text(GOOD, encoding="utf-8")
    return file


@pytest.fixture(scope="module")
def mixed(sheet: Path) -> Path:
    file = sheet.with_name("mixed.toml")
    file.write_text(GOOD + BAD, encoding="utf-8")
    return file


@pytest.fixture(scope="module")
def results(sheet: Path) -> list[Result]:
    return derive.verify(sheet)


def test_file_is_decided_by_the_call(results) -> None:
    assert {result.equation.number: str(result.status) for result in results} == STATUSES
    first, erratum, _, false = results
    assert "2*k*pi" in first.found or "2*pi" in first.found
    assert repr(first).startswith("<Result sheet (17): holds-if: ")
    assert "G" in first.printed
    assert "G" in (erratum.corrected or "")
    assert false.counterexample is not None
    assert any("cross" in change or "sign" in change for change in false.changes)


def test_ill_formed_equations_are_named_and_the_others_decided(mixed: Path, monkeypatch, tmp_path) -> None:
    monkeypatch.chdir(tmp_path)
    done = dualcay("verify", str(mixed), "--eq", "19,20", "--format", "json")
    assert done.returncode == 2
    data = json.loads(done.stdout)
    assert data["schema"] == 4
    assert [equation["status"] for equation in data["equations"]] == ["holds", "false"]
    assert [(error["equation"], error["column"]) for error in data["errors"]] == [
        ("equation 21", 1), ("equation 17", None), ("equation 22", 10),
    ]  # fmt: skip
    claims = [n for n, line in enumerate((GOOD + BAD).split("\n"), 1) if line.startswith("claim")][4:]
    places = [re.match(rf"{mixed}:(\d+): equation ", line) for line in done.stderr.splitlines()]
    assert [int(place[1]) for place in places if place] == claims == [error["line"] for error in data["errors"]]
    assert not list(tmp_path.iterdir())
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        derive.verify(mixed, "19")
    assert "equation 22, column 10: cross takes a vector, got a number" in str(found[-1].message)


@pytest.mark.parametrize(
    ("content", "message"),
    [(b"", "expected one or more tables"), (b"\xff", "expected UTF-8"), (b"a = = b", "not TOML"),
     (b"x = " + b"[" * 5000, "not TOML"), (b"[foo]\n", "unknown table 'foo'"),
     (b"letters = 3\n[[equation]]\n", "[letters]"), (b"equation = 3", "expected one or more"),
     (b"[letters]\nv = 3\n[[equation]]\n", "a text in quotes"),
     (b"[paper]\nname = 'x'\n[[equation]]\n", "unknown key name")],
)  # fmt: skip
def test_file_that_is_no_such_file_is_one_line(tmp_path: Path, content: bytes, message: str) -> None:
    file = tmp_path / "a.toml"
    file.write_bytes(content)
    with pytest.raises(SheetError, match="^" + str(file)) as error:
        load(file)
    assert message in str(error.value)
    assert "\n" not in str(error.value)


def test_strict_fails_for_a_false_claim() -> None:
    assert dualcay("verify", "--claim", "x == x + 1", "--let", "x=real", "--strict").returncode == 1


@pytest.mark.parametrize("form", ["text", "markdown", "html", "latex"])
def test_report_shows_claims_in_every_format(sheet: Path, results, form: str) -> None:
    text = FORMATS[form](Report.of([load(sheet)], results, ()))
    assert "sheet.tex:411" in text or form in ("text", "latex")
    assert "true with" in text
    assert "Undefined" not in text


def test_slow_equation_is_undecided(tmp_path: Path) -> None:
    file = tmp_path / "slow.toml"
    file.write_text('[letters]\nx = "real"\n[[equation]]\nnumber = "1"\nclaim = "sum(k, 0, 999999999, x**k) == x"\n'
                    '[[equation]]\nnumber = "2"\nclaim = "x == x"\n')
    first, second = check_sheets([load(file)], seconds=2)
    assert (first.status, first.method) == (Status.UNDECIDED, "not decided within 2 s of processor time")
    assert second.status is Status.HOLDS


def test_one_claim() -> None:
    found = derive.check("sqrt(x**2) == x", domain="x > 0", x="real")
    assert found.status is Status.HOLDS
    with pytest.raises(ClaimError, match="column 6: unknown letter"):
        derive.check("x == y", x="real")
