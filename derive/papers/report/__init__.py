"""Errata report in five formats: terminal tables, JSON, Markdown, HTML and LaTeX, with layouts in templates/report."""

from __future__ import annotations

from collections.abc import Callable

from .content import Report
from .pages import as_html, as_json, as_latex, as_markdown
from .text import as_text

FORMATS: dict[str, Callable[[Report], str]] = {
    "text": as_text,
    "json": as_json,
    "markdown": as_markdown,
    "html": as_html,
    "latex": as_latex,
}

__all__ = ["FORMATS", "Report", "as_text"]
