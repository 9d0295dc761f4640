"""Errata report: terminal tables, JSON, Markdown, HTML and LaTeX by templates/report, and annotations of lines."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from .annotated import as_github, as_sarif
from .content import Report
from .forms import as_json, as_text, data, page

FORMATS: dict[str, Callable[[Report], str]] = {
    "text": as_text,
    "json": as_json,
    "markdown": partial(page, "md"),
    "html": partial(page, "html"),
    "latex": partial(page, "tex"),
    "github": as_github,
    "sarif": as_sarif,
}

LINEWISE = ("github", "sarif")
"""Formats that name the line of each remark."""

__all__ = ["FORMATS", "LINEWISE", "Report", "as_text", "data"]
