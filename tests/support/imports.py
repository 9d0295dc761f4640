"""Modules of this project that a file imports, found in its text, also inside functions."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parents[2]


@cache
def imported(path: Path) -> frozenset[tuple[str, ...]]:
    """Return every imported module as parts of its absolute name; ``from package import module`` names the module."""
    return frozenset(_imported(path))


def _imported(path: Path) -> Iterator[tuple[str, ...]]:
    package = path.relative_to(ROOT).parts[:-1]
    for node in _statements(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (tuple(alias.name.split(".")) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else ()
            module = (*base, *node.module.split(".")) if node.module else base
            for alias in node.names:
                yield (*module, alias.name) if _is_module((*module, alias.name)) else module


def _statements(node: ast.AST) -> Iterator[ast.AST]:
    """Yield the statements of a file without their expressions, which are most of its nodes."""
    for field in ("body", "orelse", "finalbody", "handlers", "cases"):
        for statement in getattr(node, field, ()):
            yield statement
            yield from _statements(statement)


def _is_module(name: tuple[str, ...]) -> bool:
    place = ROOT.joinpath(*name)
    return place.with_suffix(".py").is_file() or place.is_dir()


def sources(*package: str) -> Iterator[tuple[tuple[str, ...], Path]]:
    """Yield (parts of the module's name below the package, path) for the files of a package."""
    base = ROOT.joinpath(*package)
    for file in sorted(base.rglob("*.py")):
        parts = file.relative_to(base).with_suffix("").parts
        yield tuple(part for part in parts if part != "__init__"), file
