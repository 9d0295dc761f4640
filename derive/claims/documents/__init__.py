"""Documents with claims in comments beside their displayed equations, read to what a file of claims contains.

========  =====================================
files     files within limits, and those taken in
comments  comments with their places, and the equations to which they belong
scanner   open display and comments between lines
tex       LaTeX
markup    Markdown, reStructuredText
notebook  notebooks
========  =====================================
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from ..language.names import ClaimError
from . import markup, notebook, tex
from .comments import Collector
from .files import Files, SheetError

READERS: dict[str, Callable[[Files, Collector], None]] = {
    ".tex": tex.read, ".md": partial(markup.read, markup.Markdown), ".rst": partial(markup.read, markup.Rest),
    ".ipynb": notebook.read,
}  # fmt: skip
"""Readers of documents by the ending of the file."""


def content(path: str | Path) -> tuple[dict[str, Any], list[tuple[str, ClaimError]]]:
    """Return the tables that a document's comments amount to, and what cannot be read in it."""
    files, collected = Files(path), Collector()
    if (suffix := Path(path).suffix.lower()) not in READERS:
        raise SheetError(f"{path}: expected a document, {', '.join(READERS)}")
    READERS[suffix](files, collected)
    if not collected.equations:
        found = [(":".join(map(str, error.at)), f"; {error.message}") for _, error in collected.problems if error.at]
        place, first = found[0] if found else (path, "")
        raise SheetError(f"{place}: no displayed equation{first}")
    tables = {
        "paper": {"slug": Path(path).with_suffix("").as_posix(), "short": Path(path).stem},
        "letters": collected.letters, "definitions": collected.definitions, "equation": collected.equations,
    }  # fmt: skip
    return tables, collected.problems
