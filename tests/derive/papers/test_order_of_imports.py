"""Import order inside derive/papers: numbers, language, entries, decision."""

from __future__ import annotations

import re

import pytest

from derive.papers import PAPERS
from tests.support.imports import ROOT, imported, sources

BASE = ("derive", "papers")
PACKAGES = tuple(paper.package.rpartition(".")[2] for paper in PAPERS)
DECIDING = ("sharp", "explore", "decide", "entry_certificate")
ENTRIES = ("equation", "result")
ROOMS = (
    "numbers", "language", *ENTRIES, *PACKAGES, *DECIDING, "report", "",
)  # fmt: skip
"""Import order: each subpackage or module may import itself and earlier ones; the empty name is derive.papers."""

IN_A_PAPER = ("notation", "definitions", "sections")
"""Import order inside the package of a paper; its ``__init__`` imports only its notation."""


def found() -> list[tuple[tuple[str, ...], tuple[str, ...]]]:
    """Return pairs of importing and imported modules, as tuples of name parts below derive.papers."""
    pairs = ((name, module) for name, file in sources(*BASE) for module in imported(file))
    return [(name, module[2:]) for name, module in pairs if module[:2] == BASE]


def room(name: tuple[str, ...]) -> str:
    return name[0] if name else ""


def allowed(importer: tuple[str, ...], name: tuple[str, ...]) -> bool:
    if room(importer) in PACKAGES and room(name) in PACKAGES:
        return room(importer) == room(name) and allowed_in_a_paper(importer[1:], name[1:])
    return ROOMS.index(room(name)) <= ROOMS.index(room(importer))


def allowed_in_a_paper(importer: tuple[str, ...], name: tuple[str, ...]) -> bool:
    if not importer or not name:
        return bool(name) and part(name) == "notation"
    if importer[0] == name[0] == "sections":
        return name < importer  # alphabetical order is the order of sections
    return IN_A_PAPER.index(part(name)) <= IN_A_PAPER.index(part(importer))


def part(name: tuple[str, ...]) -> str:
    """Return the part of a paper's package to which a module belongs; files begin with the paper's short name."""
    return name[0].rpartition("_")[2]


def test_imports_run_one_way() -> None:
    assert len(found()) > 300
    assert [pair for pair in found() if not allowed(*pair)] == []


def test_every_room_is_in_the_table() -> None:
    assert {room(name) for name, _ in sources(*BASE)} == set(ROOMS)


@pytest.mark.parametrize("paper", PAPERS, ids=lambda paper: paper.short)
def test_sections_are_named_in_printed_order(paper) -> None:
    assert list(paper.sections) == sorted(paper.sections)
    held = ROOT.joinpath(*paper.package.split("."), "sections")
    assert {path.stem for path in held.glob("s*.py")} - set(paper.sections) <= {"s07_general_order"}


@pytest.mark.parametrize(
    ("importer", "name"),
    [(("numbers", "generic"), ("language", "printed")), (("language", "printed"), ("equation",)),
     ((PACKAGES[0], "cp23_notation"), (PACKAGES[1], "k10_notation")),
     ((PACKAGES[0], "definitions", "orders"), (PACKAGES[0], "sections")),
     ((PACKAGES[0], "sections", "s03_rigid_motion"), (PACKAGES[0], "sections", "s04_dual_quaternions")),
     (("equation",), ("decide",)), (("decide",), ())],
)  # fmt: skip
def test_imports_against_the_order_are_refused(importer, name) -> None:
    assert not allowed(importer, name)
    assert allowed(name, importer) or room(importer) in PACKAGES


def test_imports_inside_the_toolkit_are_relative() -> None:
    files = [file for _, file in sources("derive")]
    assert [str(file) for file in files if re.search(r"^(from|import) derive\b", file.read_text("utf-8"), re.M)] == []
