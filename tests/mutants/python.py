"""Mutants of Python source: one node of the tree changed, the rest of the text as it is.

Annotations, aliases of types, decorators, imports, docstrings, messages and ``__all__`` are left alone: nothing
computes with them. So are keywords that say when to give up (``timeout``, the ``strict`` of a zip), and arguments are
not swapped where their order says nothing.
"""

from __future__ import annotations

import ast
import builtins
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from .mutant import Mutant

Change = tuple[ast.AST, ast.AST]
"""A node that has a place in the text, and what stands there instead."""

ARITHMETIC: Mapping[type, type] = {
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.Pow: ast.Mult, ast.Mod: ast.FloorDiv,
    ast.FloorDiv: ast.Mod, ast.LShift: ast.RShift, ast.RShift: ast.LShift, ast.BitOr: ast.BitAnd, ast.BitAnd: ast.BitOr,
}  # fmt: skip
BOUNDARY: Mapping[type, type] = {ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt}
NEGATED: Mapping[type, type] = {
    ast.Eq: ast.NotEq, ast.NotEq: ast.Eq, ast.Lt: ast.GtE, ast.GtE: ast.Lt, ast.Gt: ast.LtE, ast.LtE: ast.Gt,
    ast.In: ast.NotIn, ast.NotIn: ast.In, ast.Is: ast.IsNot, ast.IsNot: ast.Is,
}  # fmt: skip
SIBLINGS = {
    "min": "max", "max": "min", "any": "all", "all": "any", "sin": "cos", "cos": "sin", "sinpi": "cospi",
    "cospi": "sinpi", "re": "du", "du": "re", "floor": "ceil", "ceil": "floor", "union": "intersection",
}  # fmt: skip

GUARDS = ("strict", "timeout")
"""Keywords that say when to give up."""

SYMMETRIC = ("min", "max", "gcd")
"""Functions of arguments in any order."""


def _arithmetic(node: ast.AST) -> Iterator[Change]:
    if isinstance(node, ast.BinOp) and type(node.op) in ARITHMETIC:
        yield node, ast.BinOp(node.left, ARITHMETIC[type(node.op)](), node.right)
    if isinstance(node, ast.AugAssign) and type(node.op) in ARITHMETIC:
        yield node, ast.AugAssign(node.target, ARITHMETIC[type(node.op)](), node.value)


def _comparison(node: ast.AST) -> Iterator[Change]:
    if isinstance(node, ast.Compare):
        for i, op in enumerate(node.ops):
            for table in (BOUNDARY, NEGATED):
                if type(op) in table:
                    ops = [*node.ops[:i], table[type(op)](), *node.ops[i + 1 :]]
                    yield node, ast.Compare(node.left, ops, node.comparators)


def _boolean(node: ast.AST) -> Iterator[Change]:
    if isinstance(node, ast.BoolOp):
        yield node, ast.BoolOp(ast.Or() if isinstance(node.op, ast.And) else ast.And(), node.values)
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
        yield node, node.operand
    elif isinstance(node, ast.Constant) and isinstance(node.value, bool):
        yield node, ast.Constant(not node.value)


def _constant(node: ast.AST) -> Iterator[Change]:
    if isinstance(node, ast.Constant) and type(node.value) in (int, float):
        yield node, ast.Constant(node.value + 1)  # type: ignore[operator]
        yield node, ast.Constant(node.value - 1)  # type: ignore[operator]


def _sign(node: ast.AST) -> Iterator[Change]:
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        yield node, node.operand
    elif isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult | ast.Div):
        yield node, ast.BinOp(ast.UnaryOp(ast.USub(), node.left), node.op, node.right)


def _arguments(node: ast.AST) -> Iterator[Change]:
    if isinstance(node, ast.Call) and not any(isinstance(argument, ast.Starred) for argument in node.args):
        if ast.unparse(node.func).rpartition(".")[2] in SYMMETRIC:
            return
        for arguments in _swapped(node.args):
            yield node, ast.Call(node.func, arguments, node.keywords)


def _term(node: ast.AST) -> Iterator[Change]:
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub | ast.Mult | ast.Div):
        yield node, node.left
        if not isinstance(node.op, ast.Div):
            yield node, ast.UnaryOp(ast.USub(), node.right) if isinstance(node.op, ast.Sub) else node.right
    elif isinstance(node, ast.BoolOp):
        for i in range(len(node.values)):
            rest = [*node.values[:i], *node.values[i + 1 :]]
            yield node, rest[0] if len(rest) == 1 else ast.BoolOp(node.op, rest)


def _element(node: ast.AST) -> Iterator[Change]:
    if isinstance(node, ast.Tuple | ast.List) and isinstance(node.ctx, ast.Load) and len(node.elts) > 1:
        for i in range(len(node.elts)):
            yield node, type(node)([*node.elts[:i], *node.elts[i + 1 :]], node.ctx)
    elif isinstance(node, ast.Set) and len(node.elts) > 1:
        for i in range(len(node.elts)):
            yield node, ast.Set([*node.elts[:i], *node.elts[i + 1 :]])
    elif isinstance(node, ast.Dict) and len(node.keys) > 1:
        for i in range(len(node.keys)):
            keys, values = ([*part[:i], *part[i + 1 :]] for part in (node.keys, node.values))
            yield node, ast.Dict(keys, values)


def _statement(node: ast.AST) -> Iterator[Change]:
    if isinstance(node, ast.Expr | ast.AugAssign | ast.Raise | ast.Continue | ast.Break | ast.For):
        yield node, ast.Pass()


def _index(node: ast.AST) -> Iterator[Change]:
    if isinstance(node, ast.Subscript) and isinstance(node.ctx, ast.Load):
        index = node.slice
        if isinstance(index, ast.Name) and not hasattr(builtins, index.id):
            yield index, ast.BinOp(index, ast.Add(), ast.Constant(1))


def _condition(node: ast.AST) -> Iterator[Change]:
    if isinstance(node, ast.If | ast.While | ast.IfExp):
        yield node.test, ast.UnaryOp(ast.Not(), node.test)
    elif isinstance(node, ast.comprehension):
        for test in node.ifs:
            yield test, ast.UnaryOp(ast.Not(), test)


def _results(node: ast.AST) -> Iterator[Change]:
    if isinstance(node, ast.Return | ast.Yield) and isinstance(node.value, ast.Tuple):
        for elements in _swapped(node.value.elts):
            yield node.value, ast.Tuple(elements, ast.Load())


def _sibling(node: ast.AST) -> Iterator[Change]:
    if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load) and node.id in SIBLINGS:
        yield node, ast.Name(SIBLINGS[node.id], node.ctx)
    elif isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Load) and node.attr in SIBLINGS:
        yield node, ast.Attribute(node.value, SIBLINGS[node.attr], node.ctx)


def _swapped(nodes: list[ast.expr]) -> Iterator[list[ast.expr]]:
    """Lists with two neighbours swapped that differ."""
    for i, (first, second) in enumerate(pairwise(nodes)):
        if ast.unparse(first) != ast.unparse(second):
            yield [*nodes[:i], second, first, *nodes[i + 2 :]]


OPERATORS: Mapping[str, Callable[[ast.AST], Iterator[Change]]] = {
    "arithmetic operation": _arithmetic,
    "comparison": _comparison,
    "and, or, not, truth": _boolean,
    "constant ± 1": _constant,
    "sign": _sign,
    "arguments swapped": _arguments,
    "term or factor dropped": _term,
    "element dropped": _element,
    "statement dropped": _statement,
    "index shifted": _index,
    "condition negated": _condition,
    "results swapped": _results,
    "sibling function": _sibling,
}


@dataclass(frozen=True, slots=True)
class Edit:
    """A stretch of a file, in bytes, and what stands there instead; the lines of the statement it belongs to."""

    path: str
    start: int
    end: int
    text: str
    lines: tuple[int, int]

    def apply(self, source: bytes) -> bytes:
        return source[: self.start] + self.text.encode() + source[self.end :]


def python_mutants(path: str, source: str) -> Iterator[Mutant]:
    """All mutants of a module, in the order of its text."""
    starts = [0]
    for line in source.encode().splitlines(keepends=True):
        starts.append(starts[-1] + len(line))
    seen = set()
    for node, lines in _sites(ast.parse(source)):
        for operator, changes in OPERATORS.items():
            for old, new in changes(node):
                after = ast.unparse(ast.fix_missing_locations(new))
                shown = f"{short(ast.unparse(old))} → {short(after)}"
                text = f"({after})" if isinstance(old, ast.expr) else after
                start, end = _span(old, starts)
                if (start, end, text) not in seen:
                    seen.add((start, end, text))
                    yield Mutant(path, old.lineno, operator, shown, Edit(path, start, end, text, lines))  # type: ignore[attr-defined]


def short(text: str) -> str:
    """One line, its middle left out where it is long."""
    text = " ".join(text.split())
    return text if len(text) <= 90 else f"{text[:60]} … {text[-25:]}"


def _span(node: Any, starts: list[int]) -> tuple[int, int]:
    return starts[node.lineno - 1] + node.col_offset, starts[node.end_lineno - 1] + node.end_col_offset


def _sites(node: ast.AST, lines: tuple[int, int] = (1, 1)) -> Iterator[tuple[ast.AST, tuple[int, int]]]:
    """Nodes that compute, with the first and last line of their statement (of a compound one, of its head)."""
    if isinstance(node, ast.stmt):
        body = getattr(node, "body", None)
        last = max(node.lineno, body[0].lineno - 1) if body else node.end_lineno or node.lineno
        lines = node.lineno, last
        if _is_text(node) or _is_declaration(node):
            return
        yield node, lines
    elif isinstance(node, ast.expr | ast.comprehension):
        yield node, lines
    if isinstance(node, ast.JoinedStr) or (isinstance(node, ast.keyword) and node.arg in GUARDS):
        return
    for name, value in ast.iter_fields(node):
        if name not in ("annotation", "returns", "decorator_list", "bases", "exc", "type"):
            for child in value if isinstance(value, list) else [value]:
                if isinstance(child, ast.AST):
                    yield from _sites(child, lines)


def _is_text(node: ast.stmt) -> bool:
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)


def _is_declaration(node: ast.stmt) -> bool:
    """Imports, ``__all__``, what only a type checker reads, and aliases of types."""
    if isinstance(node, ast.Import | ast.ImportFrom):
        return True
    if isinstance(node, ast.If):
        return ast.unparse(node.test) == "TYPE_CHECKING"
    if not isinstance(node, ast.Assign) or not isinstance(node.targets[0], ast.Name):
        return False
    name = node.targets[0].id
    return name == "__all__" or (name[:1].isupper() and not name.isupper() and _is_type(node.value))


def _is_type(node: ast.expr) -> bool:
    allowed = (ast.Name, ast.Attribute, ast.Subscript, ast.Tuple, ast.List, ast.BinOp, ast.BitOr, ast.Load)
    return all(
        isinstance(part, allowed) or (isinstance(part, ast.Constant) and not isinstance(part.value, int | float))
        for part in ast.walk(node)
    )


def same_code(before: str, after: str) -> bool:
    """Whether two sources compile to the same code, wherever it stands in the text."""
    return bool(_shape(compile(before, "", "exec")) == _shape(compile(after, "", "exec")))


def _shape(code: Any) -> Any:
    constants = tuple(_shape(c) if hasattr(c, "co_code") else (type(c), c) for c in code.co_consts)
    return code.co_code, constants, code.co_names, code.co_varnames, code.co_name
