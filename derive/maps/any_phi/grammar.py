"""Grammar of φ: a list of allowed syntax, checked on Python's syntax tree. No part of a text is evaluated.

Numbers, ``alpha``, ``n``, ``pi``, ``+ - * / **`` and some functions are allowed. Everything else is refused by name.
This module uses the standard library alone, so that a wrong text is refused before SymPy is loaded.
"""

from __future__ import annotations

import ast
import re
import warnings

from ..phi_error import PhiError

FUNCTIONS = (
    "sin", "cos", "tan", "sec", "csc", "cot", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "atanh",
    "exp", "log", "sqrt", "cbrt",
)  # fmt: skip
NAMES = ("alpha", "n", "pi")
OPERATORS = (ast.Add, ast.Sub, ast.Mult, ast.Div, ast.Pow)
KNOWN = f"numbers, {', '.join(NAMES)}, + - * / **, {', '.join(FUNCTIONS)}"

CHARACTERS_MAX = 400
PARTS_MAX = 150
DEPTH_MAX = 30
DIGITS_MAX = 30
DECIMAL_EXPONENT_MAX = 20

NUMBER = re.compile(r"(\d+)(?:\.(\d*))?(?:[eE]([+-]?\d+))?|\.(\d+)(?:[eE]([+-]?\d+))?")


def syntax_tree(text: str) -> ast.expr:
    """Return the syntax tree of a φ, with every node checked; a forbidden part raises `PhiError` with its text."""
    if strange := re.search(r"[^ -~]|[#\\]", text):  # comments and line breaks, which Python would pass over
        raise PhiError(f"not understood in phi: {strange[0]!r} (known are {KNOWN})")
    if len(text) > CHARACTERS_MAX:
        raise PhiError(f"phi has {len(text)} characters, and {CHARACTERS_MAX} are the most")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", SyntaxWarning)  # Python warns about "1if"
            tree = ast.parse(text, mode="eval")
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        raise PhiError(f"phi is no expression: {text!r}") from error
    if (count := sum(1 for _ in ast.walk(tree))) > PARTS_MAX:
        raise PhiError(f"phi has {count} parts, and {PARTS_MAX} are the most")
    _require_allowed(tree.body, text, 0)
    return tree.body


def _require_allowed(node: ast.expr, text: str, depth: int) -> None:
    if depth > DEPTH_MAX:
        raise PhiError(f"phi has more than {DEPTH_MAX} brackets in each other")
    parts: list[ast.expr] = []
    match node:
        case ast.Constant() if not isinstance(node.value, bool | str | bytes | complex):
            decimal(node, text)
        case ast.Name() if node.id in NAMES:
            pass
        case ast.UnaryOp(op=ast.USub() | ast.UAdd()):
            parts = [node.operand]
        case ast.BinOp() if isinstance(node.op, OPERATORS):
            parts = [node.left, node.right]
        case ast.Call(func=ast.Name(id=name), args=[_], keywords=[]) if name in FUNCTIONS:
            parts = node.args
        case _:
            raise _refused(node, text)
    for part in parts:
        _require_allowed(part, text, depth + 1)


def decimal(node: ast.Constant, text: str) -> tuple[int, int]:
    """Return the digits of a number and its power of ten: 0.1 is (1, −1), exactly a tenth."""
    digits = source(node, text)
    found = NUMBER.fullmatch(digits)
    if found is None:
        raise _refused(node, text)
    whole, rest, exponent = found[1] or "", found[2] or found[4] or "", int(found[3] or found[5] or 0)
    if len(whole + rest) > DIGITS_MAX or abs(exponent) > DECIMAL_EXPONENT_MAX:
        most = f"at most {DIGITS_MAX} digits, up to 1e{DECIMAL_EXPONENT_MAX}"
        raise PhiError(f"numbers in phi have {most}, given {digits[:60]}")
    return int(whole + rest or 0), exponent - len(rest)


def source(node: ast.expr, text: str) -> str:
    """Return the part of the text that a node stands for."""
    return ast.get_source_segment(text, node) or ""


def _refused(node: ast.expr, text: str) -> PhiError:
    return PhiError(f"not understood in phi: {source(node, text)[:60]!r} (known are {KNOWN})")
