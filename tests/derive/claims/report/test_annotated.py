"""Annotations of lines: each on its line, escaped as GitHub demands; SARIF as its standard has it."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from urllib.parse import unquote

import pytest

from derive.claims.lines import Lines
from derive.claims.report import FORMATS, Report
from derive.claims.report.annotated import RULES, remarks
from derive.claims.result import Result, Status, Verdict
from derive.claims.sheet import SheetError, sheet, unreadable
from tests.support.command import dualcay

HEAD = "[letters]\nv = 'vector'\nx = 'real'\n"
PLACES = [
    HEAD + '[[equation]]\nnumber = "1"\nclaim = "x == x" #@0\n[[equation]]\nnumber = "2"\n"claim" = "v == v" #@1\n',
    HEAD + " [[ 'equation' ]]#@0\nnumber = '1'\n[[\"equation\"]]\nnumber = 2\n\t'claim'='''#@1\nx == x'''\n",
    HEAD + '[[equation]]\nnumber = "1"\nremark = """\n[[equation]]\nclaim = 3\n"claim" = 4\n"""\nclaim = "x == x" #@0\n'
    "[[equation]]\nlatex = '''\n'claim' = 1\n# claim = 2\n[[equation]]'''\nnumber = '2'\nclaim = 'x == x' #@1\n",
    HEAD + '# [[equation]]\n[[equation]] # claim = 1\r\nnumber = "1"\r\nclaim = """ #@0\r\nx == \\\r\n  x"""\r\n'
    '[[equation]]\r\nnumber="2"\r\nlatex="[[equation]]"\r\nclaim="x == x" #@1\r\n',
    'equation = [ #@0 #@1\n  {number = "1", claim = "x == x"},\n  {number = "2", claim = "x == 2"},\n]\n' + HEAD,
    HEAD + "[[equation]]\nnumber = '1'\nreading = [ #@0\n {claim = 'x == x'},\n]\nlatex = [\n\"a\", \"= b\",\n]\n"
    "[[equation]]#@1\nnumber = '2'\n[[equation.reading]]\nclaim = 'x == x'\n",
]  # fmt: skip
"""Sheets with marks on the lines of their equations."""


@pytest.mark.parametrize("text", PLACES)
def test_lines_of_equations_are_found_beside_texts_that_look_like_them(text: str):
    lines, read = Lines(text), sheet(text, "a.toml")
    for place, number in enumerate(read.numbers):
        marked = [n for n, row in enumerate(text.split("\n"), 1) if f"#@{place}" in row]
        assert [lines.of_equation(place)] == [read.line(number)] == marked


def test_what_cannot_be_read_has_a_line_too():
    text = (HEAD.replace("'real'", "'rael' #@") + "[definitions]\n'omega' = \"2*\" #@\n"
            "[[equation]]\nclaim = 'v == v' #@\n[[equation]]\nnumber = 3\nclaim = 'v == y' #@\n")  # fmt: skip
    marked = [n for n, row in enumerate(text.split("\n"), 1) if row.endswith("#@")]
    assert [problem.line for problem in sheet(text, "a.toml").problems] == marked
    with pytest.raises(SheetError) as error:
        sheet("[letters]\nx = = 3", "b.toml")
    assert unreadable("b.toml", error.value).line == 2
    assert str(unreadable("c.tex", SheetError("c.tex:7: too long"))) == "c.tex:7: too long"
    assert unreadable("b.toml", SheetError("b.toml: unknown table 'x (at line 9, column 1)': expected x")).line is None


NASTY = ("a,b:c%0A.toml", "ü d/100%.toml", "/abs/a:1.toml")
"""Names of files that could end a command, or are no URI."""


@pytest.fixture
def report() -> Report:
    """Return results of every status, whose method could end a command too."""
    text = '[[equation]]\nnumber = "e,q:1"\nclaim = "1 == 1"\n'
    papers = [replace(sheet(text, name), slug=name) for name in NASTY]
    verdicts = (Verdict(papers[0].entries()[0].readings[0].statement, "", False, ""),)
    results = [
        Result(paper.slug, entry, status, "::error::x\r\n%25, a: b", verdicts)
        for paper in papers for entry in paper.entries() for status in Status
    ]  # fmt: skip
    return Report.of(papers, results, (), "", (unreadable("c\nd.toml", SheetError("e\nf")),))


def test_commands_of_github_carry_every_remark_in_one_line_each(report: Report):
    *lines, last = FORMATS["github"](report).splitlines()
    statuses = ("false", "erratum", "undecided", "unrefuted", "ambiguous", "holds-if", "holds")
    assert last == f"15 decided, 0 unread, 1 not understood: {', '.join(f'3 {status}' for status in statuses)}"
    for line, remark in zip(lines, remarks(report), strict=True):
        assert not re.search(r"[\r\n]|%(?!25|0D|0A|3A|2C)", line)
        weight, properties, text = re.fullmatch(r"::(\w+) ([^:]*)::(.*)", line).groups()
        found = {name: unquote(value) for name, value in (part.split("=") for part in properties.split(","))}
        expected = {"file": remark.file, "line": str(remark.line or ""), "title": remark.title}
        assert (weight, unquote(text)) == (RULES[remark.rule][0], remark.text)
        assert found == {name: value for name, value in expected.items() if value}
    weights = dict.fromkeys(("false", "erratum", "unreadable", "unproved"), "error") | {"holds-if": "notice"}
    weights |= dict.fromkeys(("undecided", "unrefuted", "ambiguous"), "warning")
    assert {rule: weight for rule, (weight, _) in RULES.items()} == weights


RULE, PLACE = "runs.tool.driver.rules.", "runs.results.locations.physicalLocation."
REQUIRED = {
    "$schema", "version", "runs.tool.driver.name", "runs.tool.driver.version", "runs.properties.decided",
    "runs.properties.unread", "runs.properties.not understood", *(f"{RULE}{member}" for member in (
        "id", "shortDescription.text", "fullDescription.text", "help.text", "defaultConfiguration.level")),
    *(f"runs.results.{member}" for member in ("ruleId", "ruleIndex", "level", "message.text")),
    f"{PLACE}artifactLocation.uri", f"{PLACE}region.startLine",
}  # fmt: skip
"""Members of SARIF 2.1.0 that its schema has, and that it or GitHub requires of every part."""


def members(part: object, name: str = "") -> Iterator[str]:
    """Yield the names of all members without parts; those of a list have its name."""
    if isinstance(part, dict | list):
        rows = part.items() if isinstance(part, dict) else [("", one) for one in part]
        for key, value in rows:
            yield from members(value, ".".join(filter(None, (name, key))))
    else:
        yield name


def test_sarif_has_the_members_of_its_standard(report: Report):
    data = json.loads(FORMATS["sarif"](report))
    assert {name for name in members(data) if name.removeprefix("runs.properties.") not in [*Status]} == REQUIRED
    assert (data["version"], len(data["runs"])) == ("2.1.0", 1)
    rules, results = data["runs"][0]["tool"]["driver"]["rules"], data["runs"][0]["results"]
    for found, remark in zip(results, remarks(report), strict=True):
        assert {*members(found, "runs.results")} == {name for name in REQUIRED if name.startswith("runs.results")}
        place, rule = found["locations"][0]["physicalLocation"], rules[found["ruleIndex"]]
        assert rule["id"] == found["ruleId"] == remark.rule
        level = RULES[remark.rule][0].replace("notice", "note")
        assert rule["defaultConfiguration"]["level"] == found["level"] == level
        uri = place["artifactLocation"]["uri"]
        assert re.fullmatch(r"(file://)?([\w./~-]|%[0-9A-F]{2})+", uri, re.ASCII)
        assert unquote(uri).removeprefix("file://") == remark.file
        assert place["region"]["startLine"] == max(remark.line, 1)


def test_a_claim_stands_where_it_is_printed_if_that_file_is_there(tmp_path: Path):
    for name in ("one", "two"):
        (tmp_path / name).mkdir()
        text = HEAD + "[[equation]]\nnumber = '1'\nat = 'paper.tex:41'\nclaim = 'x == x + 1'\n"
        (tmp_path / name / "claims.toml").write_text(text)
    (tmp_path / "one" / "paper.tex").touch()
    (tmp_path / "bad.toml").write_text("x = \n")
    (tmp_path / "two" / "notes.md").write_text("$$a$$\n\n$$b$$\n<!-- dualcay: claim 1 == 2 -->\n")
    names = ("two/claims.toml", "bad.toml", "one/claims.toml", "one/claims.toml", "two/notes.md")
    done = dualcay("verify", "--format", "github", *names, cwd=tmp_path)
    found = re.findall(r"^::error file=(.*?),line=(\d+)", done.stdout, re.M)
    places = [("two/claims.toml", "7"), ("one/paper.tex", "41"), ("two/notes.md", "3"), ("bad.toml", "1")]
    assert (done.returncode, found) == (2, places)
    assert done.stdout.endswith("\n3 decided, 1 unread, 1 not understood: 3 false\n")
    shutil.rmtree(tmp_path / "one")
    assert "::error file=bad.toml,line=1" in dualcay("verify", "--format", "github", "bad.toml", cwd=tmp_path).stdout
