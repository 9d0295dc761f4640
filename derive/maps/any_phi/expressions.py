"""SymPy expression of φ, built from a text with checked grammar, and its parity, decided by structure."""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping
from typing import Any

import sympy

from ..families import alpha
from . import grammar
from .grammar import PhiError

ODD = (sympy.sin, sympy.tan, sympy.asin, sympy.atan, sympy.sinh, sympy.tanh)
EVEN = (sympy.cos, sympy.cosh)
OPERATIONS: Mapping[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: lambda a, b: a + b,
    ast.Sub: lambda a, b: a - b,
    ast.Mult: lambda a, b: a * b,
    ast.Div: lambda a, b: a / b,
}

EXPONENT_MAX = 16
NUMBER_BITS_MAX = 2000


def parsed(text: str, order: int | None = None) -> sympy.Expr:
    """Return a text as an expression in `families.alpha`; `order` is the value of n.

    A part that is refused raises `PhiError` with its name.
    """
    text = text.strip()
    tree = grammar.syntax_tree(text)
    try:
        found = _Builder(text, order).build(tree)
    except ZeroDivisionError:
        raise PhiError(f"phi divides by zero: {text!r}") from None
    if found.has(sympy.zoo, sympy.nan, sympy.oo, -sympy.oo):
        raise PhiError(f"phi divides by zero: {text!r}")
    return found


class _Builder:
    """Builder of the SymPy expression for one text."""

    def __init__(self, text: str, order: int | None) -> None:
        self.text = text
        self.order = order

    def build(self, node: ast.expr) -> sympy.Expr:
        """Return the expression of a node that `grammar` allows."""
        match node:
            case ast.Constant():
                digits, exponent = grammar.decimal(node, self.text)
                return sympy.Integer(digits) * sympy.Integer(10) ** exponent
            case ast.Name():
                return self._name(node.id)
            case ast.UnaryOp():
                value = self.build(node.operand)
                return -value if isinstance(node.op, ast.USub) else value
            case ast.BinOp(op=ast.Pow()):
                return self._power(node)
            case ast.BinOp():
                left, right = self.build(node.left), self.build(node.right)
                if isinstance(node.op, ast.Div) and right.is_zero:
                    raise ZeroDivisionError
                return OPERATIONS[type(node.op)](left, right)
            case ast.Call(func=ast.Name(id=name)):
                return getattr(sympy, name)(self.build(node.args[0]))
        raise TypeError(f"the grammar of phi does not allow {node!r}")

    def _name(self, name: str) -> sympy.Expr:
        if name == "n" and self.order is None:
            raise PhiError("phi holds n: give its value with -n")
        return {"alpha": alpha, "pi": sympy.pi, "n": sympy.Integer(self.order or 0)}[name]

    def _power(self, node: ast.BinOp) -> sympy.Expr:
        base, exponent = self.build(node.left), self._exponent(node.right)
        if base.is_Rational and max(abs(base.p), base.q).bit_length() * abs(exponent) > NUMBER_BITS_MAX:
            raise PhiError(f"a number in phi is too large: {grammar.source(node, self.text)[:60]}")
        if base == 0 and exponent < 0:
            raise ZeroDivisionError
        return base**exponent

    def _exponent(self, node: ast.expr) -> sympy.Rational:
        value = self.build(node)
        if not (value.is_Rational and abs(value) <= EXPONENT_MAX and value.q <= EXPONENT_MAX):
            raise PhiError(f"powers in phi are numbers up to {EXPONENT_MAX}, given {grammar.source(node, self.text)}")
        return value


def parity(expression: sympy.Expr) -> int | None:
    """Return −1 if the structure of an expression is odd in α, 1 if it is even, None if undecided."""
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
