"""What a text says once its comments, docstrings, layout and the names of its local variables are taken away."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import PurePath

SCOPES = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Lambda, ast.ListComp, ast.SetComp, ast.DictComp,
          ast.GeneratorExp)  # fmt: skip
"""What has names of its own, or might read those of a function around it."""

DECLARED = re.compile(r"\b(?:dualcay_real|int|size_t) (\w+) ?[=;,]")
"""A variable of C, the first of those that one statement declares."""


def code(file: str, text: str) -> str:
    """The same for two texts only if they do the same; of other languages the text itself."""
    suffix = PurePath(file).suffix
    if suffix == ".py":
        return _python(text)
    if suffix in (".h", ".c"):
        plain = re.sub(r"//.*|/\*[\s\S]*?\*/", "", text)
        return "}".join(map(_renamed, plain.split("\n}")))
    return text


def _python(text: str) -> str:
    tree = ast.parse(text)
    for node in ast.walk(tree):
        body = getattr(node, "body", None)
        if isinstance(body, list):
            node.body = [s for s in body if not _is_text(s)] or [ast.Pass()]  # type: ignore[attr-defined]
        if isinstance(node, ast.FunctionDef):
            _rename(node)
    return ast.dump(tree)


def _is_text(statement: ast.stmt) -> bool:
    return isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant)


def _rename(function: ast.FunctionDef) -> None:
    """Call the variables of a function by numbers; its arguments, which a caller may name, stay."""
    inside = [node for statement in function.body for node in ast.walk(statement)]
    if any(isinstance(node, (*SCOPES, ast.Global, ast.Nonlocal)) for node in inside):
        return
    found = [node for node in inside if isinstance(node, ast.Name)]
    places: dict[str, int] = {}
    for node in sorted(found, key=lambda node: (node.lineno, node.col_offset)):
        if isinstance(node.ctx, ast.Store):
            places.setdefault(node.id, len(places))
    kept = {argument.arg for argument in ast.walk(function.args) if isinstance(argument, ast.arg)}
    for node in found:
        if node.id in places and node.id not in kept:
            node.id = f"{places[node.id]}"


def _renamed(function: str) -> str:
    """The same for a function of C, in one line."""
    places = {name: f"{place}" for place, name in enumerate(dict.fromkeys(DECLARED.findall(function)))}
    return " ".join("".join(places.get(word, word) for word in _words(function)).split())


def _words(text: str) -> Iterator[str]:
    """Identifiers, and what stands between them."""
    return (match[0] for match in re.finditer(r"[A-Za-z_]\w*|[^A-Za-z_]+", text))
