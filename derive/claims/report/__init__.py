"""Errata report in five formats: terminal tables, JSON, Markdown, HTML and LaTeX, with layouts in templates/report."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from .content import Report
from .forms import as_json, as_text, data, page

FORMATS: dict[str, Callable[[Report], str]] = {
    "text": as_text,
    "json": as_json,
    "markdown": partial(page, "md"),
    "html": partial(page, "html"),
    "latex": partial(page, "tex"),
}

__all__ = ["FORMATS", "Report", "as_text", "data"]
