"""Lists of results, shown as one line per result at a prompt and as a table in a notebook."""

from __future__ import annotations

import html
from collections.abc import Iterable, Mapping
from typing import Protocol, TypeVar


class Shown(Protocol):
    """Result that fills one row of a table."""

    def cells(self) -> Mapping[str, str]:
        """Return texts by heading; a formula is LaTeX between ``$``, which notebooks and sites typeset."""


T = TypeVar("T", bound=Shown)


class Listing(list[T]):
    """List shown with a line for each result, and as a table in notebooks."""

    def __repr__(self) -> str:
        items = ",\n ".join(map(repr, self))
        return f"[{items}]"

    def _repr_html_(self) -> str:
        rows = [item.cells() for item in self]
        lines = [_row("th", rows[0])] if rows else []
        lines += [_row("td", row.values()) for row in rows]
        return "\n".join(['<table class="mathjax_process">', *lines, "</table>"])


def _row(kind: str, texts: Iterable[str]) -> str:
    cells = (f'<{kind} style="text-align: left">{_in_html(text)}</{kind}>' for text in texts)
    return f"<tr>{''.join(cells)}</tr>"


def _in_html(text: str) -> str:
    r"""Return a cell in HTML; a formula stands between ``\(`` and ``\)``, which MathJax finds in sites too."""
    return html.escape(rf"\({text[1:-1]}\)" if text.startswith("$") and text.endswith("$") else text)
