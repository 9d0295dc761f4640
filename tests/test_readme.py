"""README and citations: figures, titles and the version are current; tests/docs/test_pages.py runs the sessions."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from benchmarks import page as speed
from benchmarks import times
from derive.about import __version__
from derive.codegen.targets import TARGETS
from derive.papers import PAPERS
from docs.pages.field_facts import COLLECTIONS
from tests.support import pages


def read(name: str) -> str:
    return (pages.ROOT / name).read_text(encoding="utf-8")


ROWS = dict(re.findall(r"^\| (speed|accuracy|proofs|papers|formulas in use) \| (.+?) \| ", read("README.md"), re.M))


def numbers(text: str) -> list[str]:
    """Return the numbers of a text, without those of names."""
    return re.findall(r"(?<!\w)\d+(?:\.\d+)?", text)


def measured() -> dict[str, tuple[str, ...]]:
    """Return the figures of the pages, by row of the README."""
    accuracy = re.search(r"`exponential` is off by at most, in eps: Q ([\d.]+), ρ ([\d.]+)", read("docs/accuracy.md"))
    assert accuracy is not None
    theorems = read("docs/theorems.md")
    general = theorems.partition("\n## For every order\n")[2].partition("\n## ")[0]
    controls = sum(map(int, re.findall(r"^- controls: (\d+)$", theorems, re.M)))
    counts = re.findall(r"^\| \w+ \| (\d+) \| \d+ \| \d+ \| \d+ \| (\d+) \|$", read("docs/errata.md"), re.M)
    errata, entries = (sum(map(int, column)) for column in zip(*counts, strict=True))
    in_use = read("docs/field.md")
    documents = set(re.findall(r"^\| \[.+?\]\(#in-(\S+)\) \|", in_use, re.M)) - {*COLLECTIONS}
    field = re.findall(r"^\| all \| (\d+) \| \d+ \| \d+ \| (\d+) \|", in_use, re.M)[0]
    return {
        "speed": (*numbers(speed.figures(times.read())),),
        "accuracy": accuracy.groups(),
        "proofs": (str(general.count("\n<details>")), str(controls)),
        "papers": (str(entries), str(errata)),
        "formulas in use": (field[0], str(len(documents)), field[1]),
    }


@pytest.mark.parametrize("row", ["speed", "accuracy", "proofs", "papers", "formulas in use"])
def test_figures_agree_with_the_pages(row: str) -> None:
    assert numbers(ROWS[row]) == [*measured()[row]]


def test_assurance_page_has_a_row_for_every_target() -> None:
    matrix = read("docs/assurance.md").partition("\n## Targets\n")[2].partition("\n## ")[0]
    assert re.findall(r"^\| `(.+?)` \|", matrix, re.M) == list(TARGETS)


# --- citations --------------------------------------------------------------------------------------------------------

ROOT = Path(__file__).parent.parent


def words(text: str) -> list[str]:
    """Return the words of a text in lower case, without markup of TeX and YAML."""
    return re.findall(r"\w+", re.sub(r"[{}]|>-", "", text).lower())


@pytest.mark.parametrize("name", ["CITATION.cff", "docs/errata.bib"])
def test_papers_and_version_match_the_toolkit(name: str) -> None:
    text = (ROOT / name).read_text(encoding="utf-8")
    assert re.search(rf"version:? {re.escape(__version__)}\b", text, re.IGNORECASE)
    assert re.findall(r"doi[\s:={]+([^\s}]+)", text) == [paper.doi for paper in PAPERS if paper.doi]
    for paper in PAPERS:
        title = words(paper.citation.split(": ", 1)[1].split(". ")[0])
        assert " ".join(title) in " ".join(words(text))


def test_changelog_contains_the_version() -> None:
    assert f"\n## {__version__}" in (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
