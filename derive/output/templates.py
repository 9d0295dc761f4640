"""Find and render the templates: layout only, each given exactly what fills its holes."""

from __future__ import annotations

from functools import cache, lru_cache
from pathlib import Path
from typing import Any

import jinja2
from jinja2 import meta, nodes

PACKAGED = Path(__file__).parent.parent / "_templates"
CHECKOUT = Path(__file__).parent.parent.parent / "templates"


def folder() -> Path:
    """Where the templates lie: inside the installed package, or beside it in a checkout."""
    return PACKAGED if PACKAGED.is_dir() else CHECKOUT


@lru_cache(maxsize=1)
def environment() -> jinja2.Environment:
    """The environment all templates are rendered in."""
    return jinja2.Environment(
        loader=jinja2.FileSystemLoader(folder(), encoding="utf-8"),
        undefined=jinja2.StrictUndefined,
        autoescape=jinja2.select_autoescape(("html.j2",), default=False),
        keep_trailing_newline=True,
        trim_blocks=True,
        lstrip_blocks=True,
    )


def render(name: str, /, **data: Any) -> str:
    """Render a template, e.g. ``numpy/cayley.py.j2``.

    Raises
    ------
    TypeError
        If the data are not exactly what the template and those it includes ask for, as with a call's arguments.
    """
    asked = holes(name)
    if asked != data.keys():
        missing, unused = (", ".join(sorted(names)) or "none" for names in (asked - data.keys(), data.keys() - asked))
        raise TypeError(f"templates/{name}: holes left open: {missing}; data without a hole: {unused}")
    return environment().get_template(name).render(data)


@cache
def holes(name: str) -> frozenset[str]:
    """Names a template asks for, with those of the templates it refers to and does not define for them."""
    loader = environment().loader
    assert loader is not None
    tree = environment().parse(loader.get_source(environment(), name)[0], name)
    names = set(meta.find_undeclared_variables(tree))
    defined = {node.name for node in tree.body if isinstance(node, nodes.Macro)}
    for reference in meta.find_referenced_templates(tree):
        if reference is None:
            raise TypeError(f"templates/{name} refers to a template by a computed name")
        names |= holes(reference) - defined
    return frozenset(names)
