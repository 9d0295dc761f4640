"""Pages of the site and of the root: sessions run as printed, commands exist, links lead to files."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.support import examples, pages

DOCS = pages.ROOT / "docs"
SITE = [page for page in sorted(DOCS.rglob("*.md")) if "examples" not in page.relative_to(DOCS).parts]
PAGES = [pages.ROOT / "README.md", pages.ROOT / "CONTRIBUTING.md", *SITE]
TEXTS = {page.relative_to(pages.ROOT).as_posix(): page.read_text(encoding="utf-8") for page in PAGES}
COMMANDS = sorted({(name, line) for name, text in TEXTS.items() for line in pages.commands(text)})


@pytest.mark.parametrize("name", [name for name, text in TEXTS.items() if "\n>>> " in text])
def test_sessions_run_as_printed(name: str) -> None:
    assert pages.sessions(TEXTS[name], name) == ""


@pytest.mark.parametrize(("name", "line"), COMMANDS)
def test_commands_exist(name: str, line: str) -> None:
    pages.check_command(line)


@pytest.mark.parametrize("page", PAGES, ids=TEXTS)
def test_links_lead_to_files(page: Path) -> None:
    assert pages.dead_links(page) == []


def test_false_sessions_commands_and_links_are_reported(tmp_path: Path) -> None:
    assert "Expected" in pages.sessions("```python\n>>> 1 + 1\n3\n```\n", "page")
    assert "has no example" in examples.failures("nothing", "page")
    for line in ("dualcay shew -n 3", "make nothing", "pip install '.[nothing]'"):
        with pytest.raises((AssertionError, KeyError)):
            pages.check_command(line)
    page = tmp_path / "page.md"
    page.write_text("[here](page.md) [there](there.md)", encoding="utf-8")
    assert pages.dead_links(page) == ["there.md"]
