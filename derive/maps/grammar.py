"""Grammar of φ: numbers, ``alpha``, ``n``, ``pi``, ``+ - * / **`` and some functions; all else is refused by name.

This module works without SymPy.
"""

from __future__ import annotations

import ast
from collections.abc import Sequence

from ..claims.language.grammar import Grammar

SYMBOLIC_ONLY = "its chart is symbolic only; derive.Parameterization has its formulas, dualcay compare its figures"


class PhiError(ValueError):
    """Error for a refused φ, with the reason."""


FUNCTIONS = (
    "sin", "cos", "tan", "sec", "csc", "cot", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "atanh",
    "exp", "log", "sqrt", "cbrt",
)  # fmt: skip
NAMES = ("alpha", "n", "pi")
OPERATORS = (ast.Add, ast.Sub, ast.Mult, ast.Div, ast.Pow)
KNOWN = f"numbers, {', '.join(NAMES)}, + - * / **, {', '.join(FUNCTIONS)}"


def spelled(phi: str) -> str:
    """Return a text of φ without outer spaces, with ``alpha`` for the letter α."""
    return phi.strip(" ").replace("α", "alpha")



def _parts(node: ast.expr) -> Sequence[ast.expr] | None:
    match node:
        case ast.Name() if node.id in NAMES:
            return ()
        case ast.UnaryOp(op=ast.USub() | ast.UAdd()):
            return (node.operand,)
        case ast.BinOp() if isinstance(node.op, OPERATORS):
            return node.left, node.right
        case ast.Call(func=ast.Name(id=name), args=[_], keywords=[]) if name in FUNCTIONS:
            return node.args
    return None


PHI = Grammar("phi", KNOWN, _parts, lambda message, column: PhiError(message), characters_max=400, parts_max=150,
              depth_max=30)
"""Grammar of φ; its errors are `PhiError`."""
