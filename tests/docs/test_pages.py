"""Pages of the site and of the root: sessions run as printed, commands exist, links lead to files."""

from __future__ import annotations

import os
import shlex
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import jax
import pytest

from benchmarks import page as speed
from benchmarks.accuracy import report as accuracy
from tests.support import compilers, examples, packages, pages

DOCS = pages.ROOT / "docs"
SITE = [page for page in sorted(DOCS.rglob("*.md")) if "examples" not in page.relative_to(DOCS).parts]
PAGES = [pages.ROOT / "README.md", pages.ROOT / "CONTRIBUTING.md", *SITE]
TEXTS = {page.relative_to(pages.ROOT).as_posix(): page.read_text(encoding="utf-8") for page in PAGES}
COMMANDS = sorted({(name, line) for name, text in TEXTS.items() for line in pages.commands(text)})


def marks(text: str) -> list[pytest.MarkDecorator]:
    """Return the markers of a page that needs PyTorch, or that generates kernels."""
    needed = {">>> import torch": pytest.mark.torch, "derive.generate(": pytest.mark.thorough}
    return [mark for words, mark in needed.items() if words in text]


@pytest.fixture
def _settings(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Restore the import path and the precision of JAX after a page that changes them."""
    monkeypatch.setattr(sys, "path", [*sys.path])
    precision = jax.config.jax_enable_x64
    yield
    jax.config.update("jax_enable_x64", precision)


@pytest.mark.usefixtures("_settings")
@pytest.mark.parametrize("name", [pytest.param(n, marks=marks(text)) for n, text in TEXTS.items() if "\n>>> " in text])
def test_sessions_run_as_printed(name: str) -> None:
    assert pages.sessions(TEXTS[name], name) == ""


@pytest.mark.parametrize(("name", "line"), COMMANDS)
def test_commands_exist(name: str, line: str) -> None:
    pages.check_command(line)


@pytest.mark.parametrize("page", PAGES, ids=TEXTS)
def test_links_lead_to_files(page: Path) -> None:
    assert pages.dead_links(page) == []


@pytest.mark.thorough
@pytest.mark.compiler
@pytest.mark.parametrize(("name", "language"), [("docs/howto/c.md", "c"), ("docs/howto/cpp_autodiff.md", "cpp")])
def test_programs_print_what_the_page_shows(
    name: str, language: str, shared: Callable[[str, Callable[[Path], object]], Path], tmp_path: Path
) -> None:
    kernels = shared("pages_c", lambda place: packages.write([2], "c", place))
    (tmp_path / "dualcay").symlink_to(kernels)
    [program], [output] = pages.blocks(TEXTS[name], language), pages.blocks(TEXTS[name], "text")
    source = tmp_path / f"program.{language}"
    source.write_text(program, encoding="utf-8")
    compiler = [compilers.find()] if language == "c" else shlex.split(os.environ.get("CXX", "c++"))
    subprocess.run([*compiler, "-I", tmp_path, source, "-o", tmp_path / "program", "-lm"], check=True)
    assert subprocess.run(tmp_path / "program", capture_output=True, text=True, check=True).stdout == output


@pytest.mark.smoke
def test_false_sessions_commands_and_links_are_reported(tmp_path: Path) -> None:
    assert "Expected" in pages.sessions("```python\n>>> 1 + 1\n3\n```\n", "page")
    assert "has no example" in examples.failures("nothing", "page")
    for line in ("dualcay shew -n 3", "make nothing", "pip install '.[nothing]'"):
        with pytest.raises((AssertionError, KeyError)):
            pages.check_command(line)
    page = tmp_path / "page.md"
    page.write_text("[here](page.md) [there](there.md)", encoding="utf-8")
    assert pages.dead_links(page) == ["there.md"]


@pytest.mark.parametrize(
    ("name", "introduction"), [("accuracy", accuracy.INTRODUCTION), ("benchmarks", speed.INTRODUCTION)]
)
def test_page_begins_with_its_introduction(name: str, introduction: str) -> None:
    assert (pages.ROOT / "docs" / f"{name}.md").read_text(encoding="utf-8").startswith(introduction)
