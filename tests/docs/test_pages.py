"""Pages of the site and of the root: sessions run, commands exist, links lead to files, each public name has a page."""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
import sys
import threading
from collections import Counter
from collections.abc import Callable, Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import click
import pytest
import sympy

import derive
import dualcay
from benchmarks import commands, style
from benchmarks import page as speed
from benchmarks.accuracy import report as accuracy
from derive.cli.commands import cli
from derive.codegen.signatures import POSES
from derive.codegen.targets import TARGETS
from derive.proof import theorems
from docs._ext import chart_examples, dark, function_pages, links, printed, publication, reference, reference_figures
from dualcay import cayley2
from dualcay.rotation import cayley2 as rotation
from tests.support import browsers, compilers, examples, node, packages, pages
from tests.support.command import dualcay as dualcay_command
from tests.support.libraries import jax
from tests.support.pages import ROOT

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


def test_document_with_claims_is_decided_as_the_page_says(tmp_path: Path) -> None:
    text = TEXTS["docs/howto/paper_source.md"]
    rows = re.findall(r"^\| `(.+?)` \| `(paper.tex:\d+)` \| `?([\w-]+)", text, re.M)
    (tmp_path / "paper.tex").write_text(pages.blocks(text, "latex")[0], encoding="utf-8")
    done = dualcay_command("verify", "paper.tex", "--format", "json", cwd=tmp_path)
    found = json.loads(done.stdout)
    unread = [(row["number"], row["at"], "unread") for row in found["unread"]]
    assert [(row["equation"], row["at"], row["status"]) for row in found["equations"]] + unread == rows
    assert dualcay_command("draft", "paper.tex", cwd=tmp_path).stdout.count("\nproposed = true") == 1


@pytest.mark.thorough
@pytest.mark.compiler
@pytest.mark.parametrize(
    ("name", "language", "libraries"),
    [("c", "c", "-lm"), ("cpp_autodiff", "cpp", ""), ("ceres", "cpp", "-isystem/usr/include/eigen3 -lceres -lglog")],
)
def test_programs_print_what_the_page_shows(
    name: str, language: str, libraries: str, shared: Callable[[str, Callable[[Path], object]], Path], tmp_path: Path
) -> None:
    if name == "ceres" and not Path("/usr/include/ceres/manifold.h").exists():
        pytest.skip("Ceres is not installed")
    kernels = shared("c_headers", packages.headers)
    (tmp_path / "dualcay").symlink_to(kernels)
    text = TEXTS[f"docs/howto/{name}.md"]
    [program], [output] = pages.blocks(text, language), pages.blocks(text, "text")
    source = tmp_path / f"program.{language}"
    further = [f"void part() {{\n{part}}}\n" for part in pages.blocks(text, r"\{code-block\} cpp")]
    source.write_text(program + "".join(further), encoding="utf-8")
    compiler = [compilers.find()] if language == "c" else shlex.split(os.environ.get("CXX", "c++"))
    subprocess.run([*compiler, "-I", tmp_path, source, "-o", tmp_path / "program", *libraries.split()], check=True)
    assert subprocess.run(tmp_path / "program", capture_output=True, text=True, check=True).stdout == output


JAVASCRIPT = TEXTS["docs/howto/javascript.md"]


@pytest.fixture
def javascript(tmp_path: Path) -> Path:
    """Provide a folder with the modules of the JavaScript page, and its program and page."""
    packages.write([2], "js", tmp_path / "dualcay")
    for name, language in (("program.mjs", "js"), ("page.html", "html")):
        (tmp_path / name).write_text(pages.blocks(JAVASCRIPT, language)[0], encoding="utf-8")
    return tmp_path


@pytest.mark.node
def test_javascript_program_prints_what_the_page_shows(javascript: Path) -> None:
    done = subprocess.run([str(node.find()), "program.mjs"], cwd=javascript, capture_output=True, text=True, check=True)
    assert done.stdout == pages.blocks(JAVASCRIPT, "text")[0]


@pytest.mark.browser
@pytest.mark.thorough
def test_javascript_page_shows_what_it_says(javascript: Path) -> None:
    with ThreadingHTTPServer(("127.0.0.1", 0), partial(SimpleHTTPRequestHandler, directory=str(javascript))) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        flags = ("--headless", "--no-sandbox", "--disable-gpu", "--dump-dom")
        url = f"http://127.0.0.1:{server.server_port}/page.html"
        command = [str(browsers.find()), *flags, f"--user-data-dir={javascript / 'profile'}", url]
        shown = subprocess.run(command, capture_output=True, text=True, check=True).stdout
        server.shutdown()
    assert f'<p id="angle">{pages.blocks(JAVASCRIPT, "text")[1].strip()}</p>' in shown


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


def test_dead_links_of_a_site_are_found(tmp_path: Path) -> None:
    texts = {
        "index": '<a href="page.html#here">1</a> <img alt="" src="picture.png">',
        "page": '<p id="here"></p><a href="#there">2</a><a href="https://a.b">3</a>',
        "left_over": '<a href="gone.html">4</a>',
    }
    for name, text in texts.items():
        (tmp_path / f"{name}.html").write_text(text, encoding="utf-8")
    assert links.dead_links(tmp_path) == ["index.html: picture.png", "page.html: #there"]


def test_times_on_pages_have_commands_that_measure_them() -> None:
    named = {name for page in commands.PAGES for _, name, _ in commands.PLACE.findall(page.read_text(encoding="utf-8"))}
    assert named == commands.COMMANDS.keys()
    for line in commands.COMMANDS.values():
        pages.check_command(f"dualcay {line}")


def test_pages_that_moved_lead_to_a_heading() -> None:
    for old, new in publication.MOVED.items():
        page, _, place = new.partition("#")
        text = (DOCS / page).with_suffix(".md").read_text(encoding="utf-8")
        titles = re.findall(r"^#+ (.+)$", text, re.M)
        names = {re.sub(r"[^\w -]", "", title.lower()).replace(" ", "-") for title in titles}
        assert (old, place in {*names, ""}) == (old, True)


def test_repository_has_one_setting() -> None:
    assert publication.theme_options("") == publication.html_context("") == {}
    [link] = publication.theme_options("https://a.b/c")["icon_links"]
    assert link["url"] == "https://a.b/c"
    assert publication.html_context("https://a.b/c")["edit_page_url_template"].startswith("https://a.b/c/edit/main/docs/")


def test_citation_is_bibtex() -> None:
    assert examples.failures(publication.bibtex.__doc__ or "", "bibtex", vars(publication)) == ""
    text = publication.bibtex((ROOT / "CITATION.cff").read_text(encoding="utf-8"), "")
    assert f"version = {{{derive.__version__}}}" in text


@pytest.mark.parametrize(
    ("name", "introduction"), [("accuracy", accuracy.INTRODUCTION), ("benchmarks", speed.INTRODUCTION)]
)
def test_page_begins_with_its_introduction(name: str, introduction: str) -> None:
    assert (pages.ROOT / "docs" / f"{name}.md").read_text(encoding="utf-8").startswith(introduction)


CHARTS = {name for name in dir(dualcay) if hasattr(getattr(dualcay, name), "KERNELS")}
EXPECTED = {
    "functions": {*reference.functions(cayley2), *reference.functions(rotation)},
    "charts": {name for name in CHARTS if not name.startswith("scaled")},  # multiples of Cayley maps
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


def test_lists_tell_what_each_function_takes_gives_and_where_it_is() -> None:
    assert examples.failures(function_pages.arrays.__doc__ or "", "arrays", vars(function_pages)) == ""
    assert all(all(function_pages.takes_and_gives(name)) for name in POSES.public)
    assert function_pages.takes_and_gives("to_screw") == ("v (6)", "angle (2), line (6)")
    assert function_pages.targets("rate") == [*TARGETS, "Dask"]
    assert function_pages.targets("switch") == [name for name in TARGETS if name != "native"]
    assert function_pages.targets("random") == ["numpy", "numba"]
    assert examples.failures(function_pages.related.__doc__ or "", "related", vars(function_pages)) == ""
    assert all(function_pages.related(name) for name in function_pages.COVERAGE if name in POSES.public)
    assert {"twist_jacobian", "body_rate_dot", "compose_jacobians"} <= function_pages.formulas().keys()


def test_pictures_and_results_of_examples() -> None:
    for home, name in (
        (printed, "with_result"), (reference_figures, "first_panel"), (dark, "darkened"), (chart_examples, "session"),
    ):  # fmt: skip
        assert examples.failures(getattr(home, name).__doc__ or "", name, vars(home)) == ""


def test_examples_in_other_charts_are_theirs() -> None:
    found = chart_examples.examples("pose", ["exponential", "scaled1"])
    assert "0.878" in found["exponential"]  # cos(0.5)
    assert chart_examples.examples("twist", ["lambert"]) == {"lambert": ""}
    # the switch of a sine keeps another side of its claim, and order 8 has eight branches
    assert "lambert" not in chart_examples.examples("switch", ["lambert", "exponential"])


DRAWN = [path for path in sorted(DOCS.rglob("*.svg")) if {"examples", "generated", "_static"}.isdisjoint(path.parts)]


@pytest.mark.parametrize("path", DRAWN, ids=lambda path: path.stem)
def test_pictures_fit_the_article_with_text_of_nine_points(path: Path) -> None:
    """Text of Matplotlib has its size in points, divided by 100, as scale."""
    text = path.read_text(encoding="utf-8")
    sizes = [100 * float(scale) for scale in re.findall(r" scale\((\S+) -", text)]
    assert float(re.findall(r'<svg [^>]*?width="([\d.]+)pt"', text)[0]) <= 72 * style.WIDTH + 0.1
    assert min(sizes, default=9) >= 9


def test_toolkit_page_names_the_symbols_and_parts_of_charts() -> None:
    text = (ROOT / "docs" / "reference" / "toolkit.md").read_text(encoding="utf-8")
    assert "`derive.x`" in text
    assert "`derive.alpha`" in text
    rows = re.findall(r"^\| (`.+?) \|", text, re.MULTILINE)
    names = re.findall(r"`(\w+)(?:\([^)]*\))?`", " ".join(rows))
    owners = (derive.Cayley(2), derive.Cayley(sympy.Symbol("n")), derive.Cayley(2).tensor, theorems()[0])
    assert len(names) == 32
    assert [name for name in names if not any(hasattr(owner, name) for owner in owners)] == []


def test_command_page_has_every_option() -> None:
    text = reference.command_page()
    for name, command in cli.commands.items():
        part = text.split(f"## dualcay {name}\n")[1].split("\n## ")[0]
        for option in (found for found in command.params if isinstance(found, click.Option)):
            assert f":::{{option}} {', '.join(option.opts)}" in part


def test_c_page_has_every_function_with_a_comment() -> None:
    sections = reference.c_functions(reference.c_header())
    found = {name: comment for _, functions in sections for name, _, comment in functions}
    assert found.keys() == {**POSES.public, **POSES.composed}.keys()
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
