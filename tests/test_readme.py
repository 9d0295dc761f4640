"""README and citations: figures, titles and the version are current; tests/docs/test_pages.py runs the sessions."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections import Counter
from pathlib import Path

import pytest

from benchmarks import page as speed
from benchmarks import times
from derive.about import __version__
from derive.codegen.targets import TARGETS
from derive.papers import PAPERS
from derive.proof.identity import ALL_ORDERS
from derive.proof.phi_premises import SCOPE
from docs.pages.field_facts import COLLECTIONS
from tests.support import pages


def read(name: str) -> str:
    return (pages.ROOT / name).read_text(encoding="utf-8")


NAMES = "speed|accuracy|proofs|bytes|papers|formulas in use"
ROWS = dict(re.findall(rf"^\| ({NAMES}) \| (.+?) \| ", read("README.md"), re.M))


def numbers(text: str) -> list[str]:
    """Return the numbers of a text, without those of names."""
    return re.findall(r"(?<!\w)\d+(?:\.\d+)?", text)


def measured() -> dict[str, tuple[str, ...]]:
    """Return the figures of the pages, by row of the README."""
    accuracy = re.search(r"`exponential` is off by at most, in eps: Q ([\d.]+), ρ ([\d.]+)", read("docs/accuracy.md"))
    assert accuracy is not None
    theorems = json.loads(read("docs/theorems.json"))["theorems"]
    scopes = Counter(theorem["scope"] for theorem in theorems)
    of_scope = (scopes.pop(ALL_ORDERS), scopes.pop(SCOPE), scopes.total())
    controls = sum(theorem["controls"] for theorem in theorems)
    counts = re.findall(r"^\| \w+ \| (\d+)(?: \| \d+)+ \| (\d+) \|$", read("docs/errata.md"), re.M)
    errata, entries = (sum(map(int, column)) for column in zip(*counts, strict=True))
    in_use = read("docs/field.md")
    documents = set(re.findall(r"^\| \[.+?\]\(#in-(\S+)\) \|", in_use, re.M)) - {*COLLECTIONS}
    field = re.findall(r"^\| all \| (\d+) \| \d+ \| \d+ \| \d+ \| (\d+) \|", in_use, re.M)[0]
    machine = re.findall(r"^\| all \|  \|  \| (\d+) \| (\d+) \| 0 \| (\d+) \|$", read("docs/assurance.md"), re.M)
    return {
        "bytes": (machine[0][1], machine[0][0], machine[0][2]),
        "speed": (*numbers(speed.figures(times.read())),),
        "accuracy": accuracy.groups(),
        "proofs": (*map(str, of_scope), str(controls)),
        "papers": (str(entries), str(errata)),
        "formulas in use": (field[0], str(len(documents)), field[1]),
    }


@pytest.mark.parametrize("row", NAMES.split("|"))
def test_figures_agree_with_the_pages(row: str) -> None:
    assert numbers(ROWS[row]) == [*measured()[row]]


NUMPY_ALONE = """
import doctest, sys
class Refuse:
    def find_spec(self, name, *where):
        if name.partition(".")[0] not in {"numpy", "dualcay", *sys.stdlib_module_names}:
            raise ImportError("not installed: " + name)
sys.meta_path.insert(0, Refuse())
session = sys.stdin.read().partition("```python\\n")[2].partition("```")[0]
sys.exit(doctest.DocTestRunner().run(doctest.DocTestParser().get_doctest(session, {}, "session", None, 0)).failed)
"""


def test_session_needs_what_the_line_before_installs() -> None:
    done = subprocess.run(
        [sys.executable, "-c", NUMPY_ALONE], env={**os.environ, "PYTHONPATH": str(ROOT / "generated")},
        input=read("README.md"), capture_output=True, encoding="utf-8", check=False,
    )  # fmt: skip
    assert (done.returncode, done.stdout + done.stderr) == (0, "")


FROM_INDEX = re.compile(r"pip install [^\n#`]*?(?<![\w/-])dualcay(?![\w-])")


def test_nothing_is_told_to_install_that_no_index_has() -> None:
    for told in ('"dualcay[derive]"', "'dualcay'", "numpy dualcay", "-U dualcay>=0.1"):
        assert FROM_INDEX.search(f"pip install {told}")
    for room in ("README.md", "CONTRIBUTING.md", "derive", "docs", "examples", "generated", "templates"):
        for file in [ROOT / room, *sorted((ROOT / room).rglob("*"))]:
            if file.suffix in (".md", ".py", ".j2", ".rst"):
                assert (file, FROM_INDEX.findall(file.read_text(encoding="utf-8"))) == (file, [])


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
