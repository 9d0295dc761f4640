"""What is wrong with C text."""

from __future__ import annotations

from pathlib import PurePath
from typing import Any


class CError(Exception):
    """C text that does not parse, that breaks a rule of C, or that the interpreter does not read."""


def refuse(node: Any, message: str) -> CError:
    """The error, with file and line of a node of the syntax tree."""
    return CError(f"{place(node)}: {message}")


def place(node: Any) -> str:
    """File name and line of a node."""
    coordinate = node.coord
    return f"{PurePath(str(coordinate.file)).name}:{coordinate.line}" if coordinate else "?"
