"""Page of formulas in use: it agrees with the files, a sample with its verdicts, and a stale one is noticed."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest

from derive.claims.result import Result, Status, Verdict
from derive.claims.run import decide_each, undecided
from derive.claims.sheet import Sheet, sheet
from docs.pages import field
from docs.pages.field_facts import WRONG, Document, Place, anchor, as_json, document, facts, sheets

DOCS = Path(__file__).parents[2] / "docs"
PAGE, JSON = ((DOCS / name).read_text(encoding="utf-8") for name in ("field.md", "field.json"))
RECORDED: dict[str, dict[str, Any]] = {row["id"]: row for row in json.loads(JSON)["formulas"]}
NUMBERS = "- Its sides differ at"
"""Start of the lines that no file of facts holds: these need a decision."""

SMALL = """
[paper]
slug = "small"
title = "Two formulas"
[letters]
v = "vector"
[field]
bibtex = "@misc{small}"
conventions = "none"
licence = "none"
[[equation]]
number = "1"
claim = "norm(v) == norm(-v)"
[[equation]]
number = "2"
claim = "skew(v)*v == 0*v"
"""

ENDLESS = "sum(k, 0, 999999999, x**k) == x"
"""Claim that no computer decides in seconds."""


def recorded(read: Sheet) -> Document:
    """Return a file of the library with the recorded verdicts, without a decision."""
    found = []
    for entry in read.entries():
        row = RECORDED[anchor(undecided(read.slug, entry, ""))]
        status = Status(row["status"])
        verdict = Verdict(entry.readings[0].statement, "", status not in WRONG, "")
        further = {"certainty": row.get("certainty", ""), "found": row["condition"] or ""}
        found.append(Result(read.slug, entry, status, row.get("undecided", ""), (verdict,), **further))
    return document(read, found)


@pytest.fixture(scope="module")
def library() -> list[Document]:
    return [recorded(read) for read in sheets()]


def differing(items: Sequence[tuple[Sheet, int]], results: Sequence[Result], rows: dict[str, Any]) -> list[str]:
    """Return the anchors of equations whose decision is not the recorded one."""
    found = [facts(document(read, []), result) for (read, _), result in zip(items, results, strict=True)]
    return [row["id"] for row in found if row != rows[row["id"]]]


def test_page_and_json_agree_with_the_files(library: list[Document]) -> None:
    assert as_json(library) == JSON
    assert field.page(library) == "".join(line for line in PAGE.splitlines(True) if not line.startswith(NUMBERS))
    assert PAGE.count(NUMBERS) == sum(row["status"] in WRONG for row in RECORDED.values())


def test_every_formula_has_an_anchor_of_its_own(library: list[Document]) -> None:
    names = [anchor(result) for of in library for result in of.results]
    assert len(set(names)) == len(names)
    assert all(PAGE.count(f'<a id="{name}"></a>') == 1 for name in names)


def test_formulas_by_name_have_one_to_copy() -> None:
    statuses = {name: [Status(RECORDED[place]["status"]) for place in anchors] for name, anchors in field.NAMES.items()}
    assert [name for name, found in statuses.items() if all(status in WRONG for status in found)] == []
    assert "<b>inverse left Jacobian of SO(3)</b>: 10 right, 2 wrong" in PAGE


def test_a_sample_is_decided_as_recorded_and_a_change_is_noticed() -> None:
    read = {one.slug: one for one in sheets()}
    items = [(one, place) for one in read.values() for place in range(len(one.entries()))][::480]
    wrong, name = read["slambook"], "slambook-liegroup-287"
    place = next(i for i, entry in enumerate(wrong.entries()) if entry.number == "lieGroup:287")
    mended = sheet(wrong.request[0].replace('- theta**5/5"', '- theta**5/factorial(5)"'), "slambook.toml")
    items += [(wrong, place), (mended, place)]
    results = decide_each(items)
    assert differing(items[:-1], results[:-1], RECORDED) == []
    assert differing(items, results, RECORDED) == [name]
    assert differing(items[:-1], results[:-1], RECORDED | {name: RECORDED[name] | {"status": "holds"}}) == [name]


def test_a_stale_page_is_noticed(
    library: list[Document], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(field, "sheets", list)
    monkeypatch.setattr(field, "decided", lambda *_: library[:1])
    command = ["-o", str(tmp_path / "field.md")]
    assert field.main(command) == 0
    assert field.main([*command, "--check"]) == 0
    for name in ("field.md", "field.json"):
        text = (tmp_path / name).read_text(encoding="utf-8")
        (tmp_path / name).write_text(text.replace("holds", "false", 1), encoding="utf-8")
        assert field.main([*command, "--check"]) == 1
        assert f"{name} is stale" in capsys.readouterr().err
        (tmp_path / name).write_text(text, encoding="utf-8")


def test_what_takes_too_long_is_on_the_page_and_the_run_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    slow = SMALL.replace('v = "vector"', 'v = "vector"\nx = "real"').replace("skew(v)*v == 0*v", ENDLESS)
    monkeypatch.setattr(field, "sheets", lambda: [sheet(slow, "small.toml")])
    assert field.main(["-o", str(tmp_path / "field.md"), "--seconds", "1"]) == 0
    text = (tmp_path / "field.md").read_text(encoding="utf-8")
    assert '<a href="#small-2">small 2</a>: not decided within 1 s of processor time' in text
    assert "| [Two formulas](#in-small) | 2 | 1 | 0 | 0 | 0 | 1 |" in text


def test_an_unreadable_formula_is_refused_before_any_is_decided(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(field, "sheets", lambda: [sheet(SMALL.replace("norm(-v)", "norm(-u)"), "small.toml")])
    assert field.main(["-o", str(tmp_path / "field.md")]) == 2
    assert "equation 1" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("at", "source", "expected"),
    [
        (
            "a.tex:4-6, 9",
            "github.com/o/r, commit 0123abc, b.tex, doc/a.tex",
            ("o/r", "0123abc", "doc/a.tex", "4-6"),
        ),
        ("p/q, commit 89abcde, src/c.h:7", "public libraries", ("p/q", "89abcde", "src/c.h", "7")),
        ("c.rst:7", "github.com/o/r, commit 0123abc, docs", ("o/r", "0123abc", None, "7")),
        ("equation 3", "public issue threads", (None, None, None, None)),
    ],
)
def test_place_is_read_from_words(at: str, source: str, expected: tuple[str | None, ...]) -> None:
    place = Place.of(at, source)
    assert (place.repository, place.commit, place.path, place.line) == expected
    assert bool(place.link) == (None not in expected)
