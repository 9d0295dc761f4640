"""``dualcay verify``: report, exit codes and files."""

from __future__ import annotations

import ast
import json
import shlex
import sys
from pathlib import Path

import pytest

from derive.claims.equation import UndecidedError
from tests.support.command import dualcay, in_a_process

K10 = ("verify", "--paper", "karakilic-2010")


@pytest.mark.smoke
def test_report_is_on_stdout_and_stderr_is_silent() -> None:
    done = dualcay(*K10, "--eq", "14,22")
    assert done.returncode == 0
    assert done.stderr == ""
    assert "K10, erratum: false as printed" in done.stdout
    assert "(22)" in done.stdout


def test_strict_fails_for_errata_only() -> None:
    assert dualcay(*K10, "--eq", "14", "--strict").returncode == 1
    assert dualcay(*K10, "--eq", "22", "--strict").returncode == 0


def test_json_with_the_proofs_of_the_orders_asked_for() -> None:
    done = dualcay(*K10, "--eq", "7", "-n", "2", "--format", "json")
    data = json.loads(done.stdout)
    assert [e["equation"] for e in data["equations"]] == ["7"]
    assert {p["scope"] for p in data["proofs"]} == {"all n", "n = 2"}
    assert {p["status"] for p in data["proofs"]} == {"proved"}


def test_files_are_written_checked_and_reported_stale(tmp_path: Path) -> None:
    page = tmp_path / "out" / "errata.md"
    write = (*K10, "--eq", "14,22", "--format", "markdown", "-o", str(page), "--data")
    assert dualcay(*write, "--check").returncode == 1
    assert not page.exists()
    done = dualcay(*write)
    assert (done.returncode, done.stdout) == (0, "")
    assert done.stderr == f"{page}: 2 decided, 0 unread: 1 erratum, 1 holds-if\n"
    done = dualcay(*write, "--check")
    assert (done.returncode, done.stderr) == (0, f"{page}: up to date\n")
    facts = json.loads(page.with_suffix(".json").read_text(encoding="utf-8"))
    assert [row["status"] for row in facts["equations"]] == ["erratum", "holds-if"]
    for file in (page, page.with_suffix(".json")):
        text = file.read_text(encoding="utf-8")
        file.write_text(text.replace("22", "23"), encoding="utf-8")
        stale = dualcay(*write, "--check")
        assert stale.returncode == 1
        assert f"+++ {file}" in stale.stdout or str(file) in stale.stdout
        assert f"accept with:  dualcay {shlex.join(write)}\n" in stale.stderr
        file.write_text(text, encoding="utf-8")
    assert sorted(p.name for p in page.parent.iterdir()) == ["errata.json", "errata.md"]


def test_undecided_entry_is_exit_1(monkeypatch, capsys) -> None:
    from derive.cli import commands

    def undecided(*_: object) -> None:
        raise UndecidedError("(22): no point on both sides of its domain")

    monkeypatch.setattr("derive.papers.verify", undecided)
    monkeypatch.setattr(sys, "argv", ["dualcay", *K10, "--eq", "22"])
    assert commands.run() == 1
    assert "no point on both sides" in capsys.readouterr().err


@pytest.mark.parametrize(("claim", "code"), [("dot(v, w) == dot(w, v)", 0), ("cross(v, w) == cross(w, v)", 1)])
def test_check_is_verify_of_one_claim(claim: str, code: int) -> None:
    given = ("--let", "v=vector", "--let", "w=vector", "--domain", "norm(v) != 0", "--format", "json", "--strict")
    alone, option = dualcay("check", claim, *given), dualcay("verify", "--claim", claim, *given)
    assert (alone.returncode, alone.stdout, alone.stderr) == (code, option.stdout, option.stderr)


LOADED = """
import sys
from derive.cli import commands
for given in ("--claim", "1 == 2"), ("--eq", "112"):
    sys.argv[1:] = ["verify", *given]
    commands.run()
    print({name.split(".")[1] for name in sys.modules if name.startswith("derive.")})
"""


def test_claims_load_no_charts_theorems_and_papers_and_one_equation_no_code_generator() -> None:
    done = in_a_process(code=LOADED, COLUMNS="120")
    assert "where they differ" in done.stdout
    assert "\nclaim: false\n" in done.stdout
    assert "refuted at point 1 of short numbers" in done.stdout
    assert "proofs" not in done.stdout  # no theorem concerns this equation
    claim, equation = (ast.literal_eval(line) for line in done.stdout.splitlines() if line.startswith("{"))
    assert not {"maps", "proof", "papers", "codegen", "pages"} & claim
    assert "codegen" not in equation


@pytest.mark.parametrize("width", [71, 200])
def test_report_fits_the_screen(monkeypatch, width: int) -> None:
    monkeypatch.setenv("COLUMNS", str(width))
    lines = dualcay(*K10, "--eq", "14,22", "--format", "text").stdout.splitlines()
    assert max(map(len, lines)) <= min(width, 120)
    assert any("corrected: 0 < f" in line for line in lines) == (width < 72)
