"""Citations: they contain title and DOI of the decided papers, and the current version."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from derive.about import __version__
from derive.papers import PAPERS

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
