"""Crate in Rust: no warning, with and without the standard library, and the program of its guide."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.support import languages, pages, rust

pytestmark = [pytest.mark.rust, pytest.mark.thorough]


@pytest.fixture(scope="module")
def crate(tmp_path_factory: pytest.TempPathFactory) -> Path:
    names = ("cayley2", "exponential", "sine3")
    return languages.write("rust", names, tmp_path_factory.mktemp("crate"))


@pytest.mark.parametrize(
    "command",
    [
        ("clippy", "--quiet", "--", "-D", "warnings"),
        ("clippy", "--quiet", "--no-default-features", "--", "-D", "warnings"),
        ("doc", "--quiet"),
        ("test", "--quiet"),
    ],
    ids=" ".join,
)
def test_crate_is_without_a_warning(crate: Path, command: tuple[str, ...], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RUSTDOCFLAGS", "-D warnings")
    said = rust.cargo(crate, *command)
    assert "warning" not in said
    assert command[0] != "test" or re.search(r"test result: ok\. [1-9]", said)


def test_every_function_stands_in_both_modules(crate: Path) -> None:
    for folder, table in (("", languages.TABLES[""]), ("rotation", languages.TABLES["rotation"])):
        text = (crate / folder / "geometry.rs").read_text(encoding="utf-8")
        table.require_complete(folder, re.findall(r"^ *pub fn (\w+?)<", text, re.MULTILINE)[::2], table.composed)
        assert all(f"pub fn {name}_rows<" in text for name in table.public)


def test_program_of_the_guide_prints_what_the_page_shows(crate: Path, tmp_path: Path) -> None:
    text = (pages.ROOT / "docs" / "howto" / "rust.md").read_text(encoding="utf-8")
    [program], [output] = pages.blocks(text, "rust"), pages.blocks(text, "text")
    rust.write(tmp_path, crate, program)
    assert rust.cargo(tmp_path, "run", "--quiet", "--offline") == output
