"""Links "open in the browser" beside the claims of reports, files and sessions: each fills the form of the page `try`.

The page reads claims of reports by their anchors from a file of the site; a link to another claim holds it.
"""

from __future__ import annotations

import ast
import json
import re
import tomllib
from collections.abc import Iterator
from html import escape
from pathlib import Path
from typing import Any
from urllib.parse import urlencode

from docutils import nodes

from derive.output.files import put

ROOT = Path(__file__).parents[2]
CLAIMS = ROOT / "build" / "docs" / "assets" / "claims.json"
REPORTS = ("errata", "field")
NAME = re.compile(r"[A-Za-z]\w*")
SHEET = re.compile(r"^\[(?:paper|letters)\]$.*?(?=^'''|\Z)", re.MULTILINE | re.DOTALL)
CALL = re.compile(r"\bderive\.check\([\"'].*\)$", re.MULTILINE)
PLACE = re.compile(r'<a id="([^"]+)">')
Form = dict[str, str]


def forms(text: str) -> dict[str, Form]:
    """Return the claims of a file by their numbers, each with what it needs; none for an excerpt that is no file."""
    try:
        data = tomllib.loads(text)
    except tomllib.TOMLDecodeError:
        return {}
    letters, definitions = ({NAME.search(key)[0]: (key, value) for key, value in data.get(table, {}).items()}  # type: ignore[index]
                            for table in ("letters", "definitions"))  # fmt: skip
    found = {}
    for row in data.get("equation", ()):
        texts = {"claim": (row.get("reading") or [row])[0].get("claim", ""), "domain": row.get("domain", "")}
        used, waiting = set[str](), [*texts.values()]
        while waiting:
            new = set(NAME.findall(waiting.pop())) - used
            used |= new
            waiting += [definitions[name][1] for name in new & definitions.keys()]
        given, defined = ([f"{key} = {_line(text)}" for name, (key, text) in table.items() if name in used]
                          for table in (letters, definitions))  # fmt: skip
        form = {"letters": "; ".join(given), "definitions": "\n".join(defined)}
        form |= {key: _line(text) for key, text in texts.items()}
        if form["claim"]:
            found[str(row["number"])] = {key: text for key, text in form.items() if text}
    return found


def _line(text: str) -> str:
    return " ".join(text.split())


def _of_call(text: str) -> Form:
    """Return the claim of a call of `derive.check` whose arguments are texts."""
    call: Any = ast.parse(text, mode="eval").body
    named = {word.arg: word.value.value for word in call.keywords if word.arg != "seconds"}
    domain = {"domain": named.pop("domain")} if "domain" in named else {}
    return {"letters": "; ".join(f"{a} = {kind}" for a, kind in named.items()), "claim": call.args[0].value, **domain}


def claims() -> dict[str, Form]:
    """Return the claims of papers and of formulas in use by their anchors."""
    found = {}
    for file in sorted((ROOT / "derive" / "papers").rglob("*.toml")):
        text = file.read_text(encoding="utf-8")
        slug = tomllib.loads(text)["paper"]["slug"]
        found |= {nodes.make_id(f"{slug}-{number}"): form for number, form in forms(text).items()}
    return found


def add_links(app: Any, page: nodes.document) -> None:
    """Add a link to each entry of a report, and links below each file of claims and each session with some."""
    name = app.env.current_document.docname
    link, known = "../" * name.count("/") + "try.html?", claims() if name in REPORTS else {}
    for node, place in list(_entries(page)):
        if place in known:
            node += _raw(f' <a class="in-browser" href="{link}entry={place}">open in the browser</a>')
    for block in list(page.findall(nodes.literal_block)):
        found = {n: form for sheet in SHEET.findall(block.astext()) for n, form in forms(sheet).items()}
        found |= {form["claim"]: form for form in map(_of_call, CALL.findall(block.astext()))}
        if found:
            links = (f'<a href="{link}{escape(urlencode(form))}">{escape(n)}</a>' for n, form in found.items())
            while isinstance(block.parent, nodes.container):
                block = block.parent
            below = nodes.paragraph("", "", _raw(f"Open in the browser: {', '.join(links)}"), classes=["in-browser"])
            block.parent.insert(block.parent.index(block) + 1, below)


def _entries(page: nodes.document) -> Iterator[tuple[nodes.Element, str]]:
    """Yield cells and paragraphs with the anchors of entries that they are about."""
    for node in page.findall(nodes.Element):
        if isinstance(node, nodes.raw) and (found := PLACE.search(node.astext())):
            yield node.parent, nodes.make_id(found[1])
        elif isinstance(node, nodes.paragraph | nodes.section):  # the first paragraph of a section, or itself
            yield from ((next(iter(node.findall(nodes.paragraph)), node), place) for place in node["ids"])


def _raw(html: str) -> nodes.raw:
    return nodes.raw("", html, format="html")


def setup(app: Any) -> dict[str, bool]:
    """Connect the links to Sphinx."""
    app.connect("builder-inited", lambda app: put(CLAIMS, json.dumps(claims(), ensure_ascii=False)))
    app.connect("doctree-read", add_links)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
