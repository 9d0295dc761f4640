"""Reference pages: each public name has its page, and generated texts are complete."""

from __future__ import annotations

import re
from collections import Counter

import click
import pytest

import derive
import dualcay
from derive.cli.commands import cli
from derive.codegen.signatures import PUBLIC
from docs._ext import reference
from dualcay import cayley2
from dualcay.rotation import cayley2 as rotation
from tests.support.pages import ROOT

CHARTS = {name for name in dir(dualcay) if hasattr(getattr(dualcay, name), "KERNELS")}
EXPECTED = {
    "functions": {*reference.functions(cayley2), *reference.functions(rotation)},
    "charts": CHARTS,
    "tools": {*dualcay.__all__, *dualcay.PARTS} - {"rotation"},
    "toolkit": {*derive.__all__} - {"__version__", "x", "alpha"},
}


def listed(text: str) -> Counter[str]:
    """Return how often a page lists each name in its tables of generated pages."""
    return Counter(re.findall(r"^   (\w+)$", text, re.MULTILINE))


@pytest.mark.parametrize("page", EXPECTED)
def test_pages_list_each_public_name_once(page: str) -> None:
    text = (ROOT / "docs" / "reference" / f"{page}.md").read_text(encoding="utf-8")
    assert listed(text) == dict.fromkeys(EXPECTED[page], 1)


def test_toolkit_page_names_the_symbols_and_parts_of_charts() -> None:
    text = (ROOT / "docs" / "reference" / "toolkit.md").read_text(encoding="utf-8")
    assert "`derive.x`" in text
    assert "`derive.alpha`" in text
    rows = re.findall(r"^\| (`.+?) \|", text, re.MULTILINE)
    names = re.findall(r"`(\w+)(?:\(\))?`", " ".join(rows))
    assert len(names) == 13
    assert [name for name in names if not hasattr(derive.Cayley(2), name)] == []


def test_command_page_has_every_option() -> None:
    text = reference.command_page()
    for name, command in cli.commands.items():
        part = text.split(f"## dualcay {name}\n")[1].split("\n## ")[0]
        for option in command.params:
            assert isinstance(option, click.Option)
            assert f":::{{option}} {', '.join(option.opts)}" in part


def test_c_page_has_every_function_with_a_comment() -> None:
    sections = reference.c_functions(reference.c_header())
    found = {name: comment for _, functions in sections for name, _, comment in functions}
    assert found.keys() == PUBLIC.keys()
    assert all(comment[0].isupper() and comment.rstrip().endswith(".") for comment in found.values())


def test_facts_follow_from_the_chart() -> None:
    found = reference.facts("cayley3")
    assert found["Vectors of a pose"] == "3"
    assert found["Singular angles"] == "2π, 3π"
    assert found["Size of v at half a turn"] == "0.5774"  # tan 30°
    assert found["Further names"] == "``dcay`` of ``tangent``, ``dcay_inv`` of ``tangent_inv``"
    assert found["Written by"] == "``dualcay generate -n 3 --target numpy``"
    assert reference.facts("cayley1")["Size of v at half a turn"] == "infinite"
    assert reference.angle(4.5) == "4.5 rad"
