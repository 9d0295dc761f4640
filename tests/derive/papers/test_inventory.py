"""Files of the papers: inventories name the entries that decide each line, every name is used, and all are read."""

from __future__ import annotations

import re
import tomllib
from itertools import pairwise

import pytest

from derive.claims.language.operations import OPERATIONS
from derive.claims.sheet import Sheet
from derive.papers import PAPERS, verify
from tests.support.imports import ROOT, sources

pytestmark = pytest.mark.smoke

NUMBERED = {"condurache-popa-2023": 131, "karakilic-2010": 22}
LAST_LINE = {"condurache-popa-2023": 469, "karakilic-2010": 269}
WITHOUT_NUMBERS = {"7"}  # numbered equations with no formula in the extracted text


@pytest.fixture(params=PAPERS, ids=lambda paper: paper.short)
def paper(request) -> Sheet:
    return request.param


def test_every_numbered_equation_has_an_entry(paper) -> None:
    numbers = [entry.number for entry in paper.entries()]
    assert {str(n) for n in range(1, NUMBERED[paper.slug] + 1)} <= set(numbers)
    assert len(numbers) == len(set(numbers))


def test_every_line_names_entries_or_a_reason(paper) -> None:
    numbers = {entry.number for entry in paper.entries()}
    for line, content in paper.inventory().items():
        if isinstance(content, str):
            assert content, f"line {line} has neither an entry nor a reason"
        else:
            assert content, f"line {line} names no entry"
            assert set(content) <= numbers, f"line {line} names {set(content) - numbers}"


def test_no_entry_stands_at_a_line_that_claims_nothing(paper) -> None:
    inventory = paper.inventory()
    for entry in paper.entries():
        assert entry.number in inventory[entry.line], f"({entry.number}) is not named at line {entry.line}"


def test_text_is_covered_to_its_end(paper) -> None:
    lines = sorted(paper.inventory())
    assert max(line for line in lines if isinstance(paper.inventory()[line], tuple)) >= LAST_LINE[paper.slug]
    gaps = [(a, b) for a, b in pairwise(lines) if b - a > 4 and 28 < b <= LAST_LINE[paper.slug]]
    assert gaps == []


def test_numbered_equations_are_compared_with_the_extracted_text(paper) -> None:
    without = {entry.number for entry in paper.entries() if entry.number.isdecimal() and not entry.extract}
    assert without <= WITHOUT_NUMBERS


def test_source_of_an_entry_is_its_file(paper) -> None:
    assert {entry.source for entry in paper.entries()} == {f"derive/papers/{paper.slug.replace('-', '_')}.toml"}


def test_whole_file_can_be_read_and_every_name_is_used(paper) -> None:
    data = tomllib.loads((ROOT / paper.entries()[0].source).read_text(encoding="utf-8"))
    assert paper.problems == ()
    assert paper.numbers == tuple(entry.number for entry in paper.entries())
    claims = [str(row.get(key, "")) for row in data["equation"] for key in
              ("claim", "reading", "domain", "condition", "corrected", "because")]  # fmt: skip
    used = set(re.findall(r"\w+", " ".join([*claims, *data["definitions"].values()])))
    names = {re.match(r"\w+", head)[0] for head in (*data["letters"], *data["definitions"])}
    assert names <= used
    assert data["latex"].keys() <= names | OPERATIONS.keys()


def test_entries_of_some_numbers_are_those_of_all(paper) -> None:
    some = {"13", "22"}
    assert [(entry.number, entry.readings) for entry in paper.entries(some)] == [
        (entry.number, entry.readings) for entry in paper.entries() if entry.number in some
    ]  # fmt: skip


def test_equations_are_chosen_by_string_or_list():
    for equations, expected in (("22", ["22"]), ("23, 22", ["22", "23"]), (["22"], ["22"])):
        assert [result.equation.number for result in verify("condurache-popa-2023", equations)] == expected
    with pytest.raises(ValueError, match="no equation 999"):
        verify("condurache-popa-2023", "112,999")


def test_imports_inside_the_toolkit_are_relative() -> None:
    files = [file for _, file in sources("derive")]
    assert [str(file) for file in files if re.search(r"^(from|import) derive\b", file.read_text("utf-8"), re.M)] == []
