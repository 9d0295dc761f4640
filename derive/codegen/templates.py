"""Find and render the templates: layout only, every hole filled by the caller or an error."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path
from typing import Any

import jinja2

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


def render(name: str, **data: Any) -> str:
    """Render a template, e.g. ``numpy/cayley.py.j2``."""
    return environment().get_template(name).render(**data)
