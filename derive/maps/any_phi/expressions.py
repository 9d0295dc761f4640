"""φ from text: parsed as Python's grammar, nothing of it run, by a list of what may stand in it.

Numbers, ``alpha``, ``n``, ``pi``, ``+ - * / **`` and some functions; everything else is refused with the part that is
not understood. What is accepted is odd by its structure: sums of odd terms, odd times even, odd functions of odd terms.
"""

from __future__ import annotations

import ast
import re
import warnings
from collections.abc import Callable, Mapping
from typing import Any

import sympy

from ..families import alpha

FUNCTIONS: Mapping[str, Callable[[sympy.Expr], sympy.Expr]] = {
    name: getattr(sympy, name)
    for name in ("sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log", "sqrt")
}
ODD = (sympy.sin, sympy.tan, sympy.asin, sympy.atan, sympy.sinh, sympy.tanh)
EVEN = (sympy.cos, sympy.cosh)
OPERATIONS: Mapping[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: lambda a, b: a + b,
    ast.Sub: lambda a, b: a - b,
    ast.Mult: lambda a, b: a * b,
    ast.Div: lambda a, b: a / b,
}

LENGTH, NODES, DEPTH, DIGITS, EXPONENT, DECIMAL_EXPONENT, BITS = 400, 150, 30, 30, 16, 20, 2000
"""Limits: of characters, parts, brackets in brackets, digits of a number, powers, n in 1e-n, and of a number's bits."""

NUMBER = re.compile(r"(\d+)(?:\.(\d*))?(?:[eE]([+-]?\d+))?|\.(\d+)(?:[eE]([+-]?\d+))?")


class PhiError(ValueError):
    """A φ that is refused, and why."""


def parsed(text: str, order: int | None = None) -> sympy.Expr:
    """Return the expression in `families.alpha` that a text says; `order` is the value of n.

    Raises
    ------
    PhiError
        Naming what is not understood.
    """
    if len(text) > LENGTH:
        raise PhiError(f"phi has {len(text)} characters, and {LENGTH} are the most")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", SyntaxWarning)  # of "1if", say
            tree = ast.parse(text.strip(), mode="eval")
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        raise PhiError(f"phi is no expression: {text!r}") from error
    if (count := sum(1 for _ in ast.walk(tree))) > NODES:
        raise PhiError(f"phi has {count} parts, and {NODES} are the most")
    try:
        found = _Reader(text.strip(), order).read(tree.body, 0)
    except ZeroDivisionError:
        raise PhiError(f"phi divides by zero: {text!r}") from None
    if found.has(sympy.zoo, sympy.nan, sympy.oo, -sympy.oo):
        raise PhiError(f"phi divides by zero: {text!r}")
    return found


class _Reader:
    """Reads one text."""

    def __init__(self, text: str, order: int | None) -> None:
        self.text = text
        self.order = order

    def read(self, node: ast.expr, depth: int) -> sympy.Expr:
        if depth > DEPTH:
            raise PhiError(f"phi has more than {DEPTH} brackets in each other")
        if isinstance(node, ast.Constant):
            return self._number(node)
        if isinstance(node, ast.Name):
            return self._name(node)
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub | ast.UAdd):
            value = self.read(node.operand, depth + 1)
            return -value if isinstance(node.op, ast.USub) else value
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow):
            return self._power(node, depth)
        if isinstance(node, ast.BinOp) and type(node.op) in OPERATIONS:
            left, right = self.read(node.left, depth + 1), self.read(node.right, depth + 1)
            if isinstance(node.op, ast.Div) and right.is_zero:
                raise ZeroDivisionError
            return OPERATIONS[type(node.op)](left, right)
        if isinstance(node, ast.Call):
            return self._call(node, depth)
        raise self._refused(node)

    def _power(self, node: ast.BinOp, depth: int) -> sympy.Expr:
        base, exponent = self.read(node.left, depth + 1), self._exponent(node.right, depth + 1)
        if base.is_Rational and max(abs(base.p), base.q).bit_length() * abs(exponent) > BITS:
            raise PhiError(f"a number in phi is too large: {self._part(node)[:60]}")
        if base == 0 and exponent < 0:
            raise ZeroDivisionError
        return base**exponent

    def _call(self, node: ast.Call, depth: int) -> sympy.Expr:
        named = isinstance(node.func, ast.Name) and node.func.id in FUNCTIONS
        if not named or len(node.args) != 1 or node.keywords:
            raise self._refused(node)
        assert isinstance(node.func, ast.Name)
        return FUNCTIONS[node.func.id](self.read(node.args[0], depth + 1))

    def _name(self, node: ast.Name) -> sympy.Expr:
        if node.id == "n":
            if self.order is None:
                raise PhiError("phi holds n: give its value with -n")
            return sympy.Integer(self.order)
        names = {"alpha": alpha, "pi": sympy.pi}
        if node.id not in names:
            raise self._refused(node)
        return names[node.id]

    def _number(self, node: ast.Constant) -> sympy.Rational:
        """From its digits: 0.1 is a tenth."""
        text = self._part(node)
        found = NUMBER.fullmatch(text)
        if found is None or isinstance(node.value, bool | str | bytes | complex):
            raise self._refused(node)
        whole, rest, exponent = found[1] or "", found[2] or found[4] or "", int(found[3] or found[5] or 0)
        if len(whole + rest) > DIGITS or abs(exponent) > DECIMAL_EXPONENT:
            most = f"at most {DIGITS} digits, up to 1e{DECIMAL_EXPONENT}"
            raise PhiError(f"numbers in phi have {most}, given {text[:60]}")
        return sympy.Rational(int(whole + rest or 0)) * sympy.Integer(10) ** (exponent - len(rest))

    def _exponent(self, node: ast.expr, depth: int) -> sympy.Rational:
        value = self.read(node, depth)
        if not (value.is_Rational and abs(value) <= EXPONENT and value.q <= EXPONENT):
            raise PhiError(f"powers in phi are numbers up to {EXPONENT}, given {self._part(node)}")
        return value

    def _part(self, node: ast.expr) -> str:
        return ast.get_source_segment(self.text, node) or ""

    def _refused(self, node: ast.expr) -> PhiError:
        known = f"numbers, alpha, n, pi, + - * / **, {', '.join(FUNCTIONS)}"
        return PhiError(f"not understood in phi: {self._part(node)[:60]!r} (known are {known})")


def parity(expression: sympy.Expr) -> int | None:
    """−1 of what is odd in α by its structure, 1 of what is even, None of what cannot be said."""
    if expression == alpha:
        return -1
    if alpha not in expression.free_symbols:
        return 1
    parts = [parity(argument) for argument in expression.args]
    if expression.is_Add:
        return parts[0] if len(set(parts)) == 1 else None
    if expression.is_Mul:
        return None if None in parts else int(sympy.prod(parts))
    if expression.is_Pow:
        exponent = expression.exp
        if alpha not in exponent.free_symbols and exponent.is_Integer and parts[0] is not None:
            return int(parts[0] ** (int(exponent) % 2))
    elif expression.func in ODD and parts[0] == -1:
        return -1
    elif expression.func in EVEN and parts[0] is not None:
        return 1
    return 1 if all(part == 1 for part in parts) else None
