"""Templates: each receives exactly the names used by it and by the templates it includes."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from derive.output import generated, pages, render

pytestmark = pytest.mark.smoke


@pytest.fixture
def write(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[[str, str], object]]:
    """Provide a function that writes templates into a folder used in place of the project's templates."""
    monkeypatch.setattr(pages, "folder", lambda: tmp_path)
    pages.environment.cache_clear()
    pages.holes.cache_clear()

    def written(name: str, text: str) -> None:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")

    yield written
    pages.environment.cache_clear()
    pages.holes.cache_clear()


def test_template_is_rendered(write):
    write("a", "{{ n }} of {% for x in range(n) %}{{ x }}{{ word }}{% endfor %}")
    assert render("a", n=2, word=",") == "2 of 0,1,"


def test_superfluous_and_missing_keys_are_named(write):
    write("a", "{% if n %}{{ word }}{% endif %}")
    with pytest.raises(TypeError, match=r"templates/a: holes left open: none; data without a hole: array, out$"):
        render("a", n=1, word="w", out=0, array=0)
    with pytest.raises(TypeError, match=r"templates/a: holes left open: word; data without a hole: none$"):
        render("a", n=0)  # the branch that uses the name is not taken


def test_included_template_may_use_macros_of_its_includer(write):
    write("a", '{% macro f(x) %}<{{ x }}>{% endmacro %}{% include "b" %}')
    write("b", '{{ f(n) }}{% include "c" %}')
    write("c", "{{ word }}")
    assert render("a", n=1, word="w") == "<1>w"
    with pytest.raises(TypeError, match="left open: word;"):
        render("a", n=1)
    with pytest.raises(TypeError, match=r"without a hole: f$"):
        render("a", n=1, word="w", f=print)


def test_names_in_a_parent_template_are_required(write):
    write("parent", "{{ title }}{% block body %}{% endblock %}")
    write("a", '{% extends "parent" %}{% block body %}{{ n }}{% endblock %}')
    assert render("a", title="t", n=1) == "t1"
    with pytest.raises(TypeError, match="left open: title;"):
        render("a", n=1)


def test_computed_template_name_is_refused(write):
    write("a", "{% include name %}")
    with pytest.raises(TypeError, match="a refers to a template by a computed name"):
        render("a", name="b")


def test_file_without_holes_is_copied_beneath_the_header(write):
    write("c/runtime/plain", "x = 1\n")
    write("c/filled.j2", "{{ header }}\nx = {{ n }}\n")
    assert generated("c/plain", "# made") == "# made\nx = 1\n"
    assert generated("c/filled", "# made", n=2) == "# made\nx = 2\n"
    with pytest.raises(TypeError, match=r"templates/c/runtime/plain has no holes, got data for n$"):
        generated("c/plain", "# made", n=2)


def test_templates_have_holes():
    for path in pages.folder().rglob("*.j2"):
        text = path.read_text(encoding="utf-8").removeprefix("{{ header }}")
        assert "{{" in text or "{%" in text, f"{path} has no holes: remove its ending .j2"
