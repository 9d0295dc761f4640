"""Notebooks (nbformat 4): cells with the lines of the file on which their text stands."""

from __future__ import annotations

from collections.abc import Iterator
from json import JSONDecoder, scanner
from typing import Any

from .comments import Collector
from .files import Files, SheetError
from .markup import Markdown


class Placed(str):
    """Text of a JSON file with its line."""

    __slots__ = ("line",)
    line: int


def parsed(text: str) -> Any:
    """Return the value of a JSON text, whose texts know their lines."""
    decoder: Any = JSONDecoder()
    plain, line, seen = decoder.parse_string, 1, 0

    def string(source: str, end: int, strict: bool = True) -> tuple[Placed, int]:
        nonlocal line, seen
        line, seen = line + source.count("\n", seen, end), end
        value, end = plain(source, end, strict)
        placed = Placed(value)
        placed.line = line
        return placed, end

    decoder.parse_string = string
    decoder.scan_once = scanner.py_make_scanner(decoder)  # type: ignore[attr-defined]
    return decoder.decode(text)


def _cells(text: str, file: str) -> Iterator[tuple[str, list[tuple[int, str]]]]:
    """Yield the kind of each cell with its numbered lines."""
    try:
        data = parsed(text)
    except (ValueError, RecursionError) as error:
        raise SheetError(f"{file}: not JSON: {str(error) or 'too many brackets in each other'}") from None
    cells = data.get("cells") if isinstance(data, dict) and data.get("nbformat") == 4 else None
    if not (isinstance(cells, list) and all(isinstance(cell, dict) for cell in cells)):
        raise SheetError(f"{file}: expected a notebook with \"nbformat\": 4 and a list of cells")
    for number, cell in enumerate(cells, 1):
        source = cell.get("source", [])
        parts = source if isinstance(source, list) else [source]
        if not all(isinstance(part, Placed) for part in parts):
            raise SheetError(f"{file}: the source of cell {number} is no text")
        lines: list[tuple[int, str]] = []
        for part in parts:
            lines += [(part.line, text) for text in part.removesuffix("\n").split("\n")]
        yield str(cell.get("cell_type")), lines


def read(files: Files, collected: Collector) -> None:
    for number, (kind, lines) in enumerate(_cells(files.text(files.first), files.first), 1):
        reader = Markdown(collected, files.first, f"cell {number}")
        if kind == "markdown":
            reader.lines(lines)
        elif kind == "code":
            for line, text in lines:
                shown = text.lstrip()
                reader.going_on = reader.going_on and shown.startswith("#")
                if shown.startswith("#"):
                    reader.comment(line, len(text) - len(shown) + 2, shown[1:])
            reader.finish()
