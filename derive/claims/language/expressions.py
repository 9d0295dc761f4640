"""Texts of claims: their checked syntax trees, and terms of their operators, relations, numbers and names."""

from __future__ import annotations

import ast
import difflib
import re
from abc import ABC, abstractmethod
from collections.abc import Sequence
from itertools import pairwise
from typing import Any

from . import matrices, names, operator_table
from .grammar import Grammar
from .letters import integer
from .names import Abbreviation, ClaimError, Kind, KindError, Scope
from .operations import CONSTANTS
from .printed import Number, Term

POWER_MAX, NUMERAL_POWER_MAX = 64, 1000
"""Largest power that is a written number."""
RELATIONS: dict[type[ast.cmpop], Any] = {
    ast.Eq: operator_table.equal, ast.NotEq: matrices.unlike, ast.Lt: matrices.less, ast.LtE: matrices.at_most,
    ast.Gt: matrices.greater, ast.GtE: matrices.at_least,
}
JOINS: dict[type[ast.boolop], Any] = {ast.And: operator_table.both, ast.Or: matrices.either}
SUMS: dict[type[ast.operator], str] = {ast.Add: "+", ast.Sub: "-"}


def _parts(node: ast.expr) -> Sequence[ast.expr] | None:
    match node:
        case ast.Name() if not node.id.startswith("_"):
            return ()
        case ast.UnaryOp(op=ast.USub() | ast.UAdd() | ast.Not()):
            return (node.operand,)
        case ast.BinOp(op=ast.Add() | ast.Sub() | ast.Mult() | ast.Div() | ast.Pow()):
            return node.left, node.right
        case ast.BoolOp():
            return node.values
        case ast.Compare() if all(type(op) in RELATIONS for op in node.ops):
            return node.left, *node.comparators
        case ast.Call(func=ast.Name(id=name), keywords=[]) if not name.startswith("_"):
            return node.args
        case ast.List():
            return node.elts
        case ast.Subscript(value=ast.Name(id=name)) if not name.startswith("_"):
            return (node.slice,)
    return None


GRAMMAR = Grammar(
    "a claim", "numbers, letters, + - * / **, == != < <= > >=, and, or, not, calls of operations and definitions, w[k]",
    _parts, ClaimError, characters_max=4000, parts_max=1500, depth_max=40,
)  # fmt: skip


def tree(text: str) -> ast.expr:
    """Return the checked syntax tree of a text, which may have several lines."""
    flat = re.sub(r"\s", " ", text)
    if not flat.strip():
        raise ClaimError("a claim is expected, got nothing", 1)
    shift = len(flat) - len(flat.lstrip())
    try:
        return GRAMMAR.tree(flat.strip())
    except ClaimError as error:
        hint = " (a relation is ==)" if re.search(r"(?<![=!<>])=(?!=)", flat) else ""
        raise ClaimError(error.message + hint, error.column + shift) from None


class Expressions(ABC):
    """Reader of the operators, relations, numbers and names of one text in a scope."""

    def __init__(self, text: str, scope: Scope) -> None:
        self.text, self.scope = re.sub(r"\s", " ", text), scope
        self.shift = len(self.text) - len(self.text.lstrip())
        self.text = self.text.strip()

    def error(self, message: str, node: ast.expr) -> ClaimError:
        return ClaimError(message, node.col_offset + 1 + self.shift)

    def read(self, node: ast.expr) -> tuple[Term, Kind]:
        """Return the term of a node that the grammar allows, and its kind."""
        try:
            return self._read(node)
        except KindError as error:
            place = error.place
            at = node.args[place] if isinstance(node, ast.Call) and place is not None else node
            raise self.error(str(error), at) from None

    def _read(self, node: ast.expr) -> tuple[Term, Kind]:
        match node:
            case ast.Constant():
                return self._number(node)
            case ast.Name():
                return self._name(node)
            case ast.UnaryOp():
                return self._signed(node)
            case ast.BinOp(op=ast.Pow()):
                return self._power(node)
            case ast.BinOp():
                return self._combined(node)
            case ast.Compare():
                return self._compared(node)
            case ast.BoolOp():
                parts = [self._relation(part) for part in node.values]
                return JOINS[type(node.op)](*parts), "truth"
            case ast.Call(func=ast.Name(id=name)):
                return self._called(name, node)
            case ast.Subscript(value=ast.Name(id=name)):
                return self._member(name, node)
        raise self.error("a list stands in matrix([[…]]) or block([[…]]) only", node)

    def _number(self, node: ast.Constant) -> tuple[Term, Kind]:
        digits, exponent = GRAMMAR.decimal(node, self.text)
        if exponent >= 0:
            return Number(digits * 10**exponent), "integer"
        return Number(digits) / Number(10**-exponent), "number"

    def _name(self, node: ast.Name) -> tuple[Term, Kind]:
        name = node.id
        if name in self.scope.known:
            return self.scope.known[name]
        if name in CONSTANTS:
            return CONSTANTS[name]
        if name in self.scope.abbreviations:
            return self._abbreviated(self.scope.abbreviations[name], node, [])
        raise self.error(f"unknown letter {name!r}{self._near(name, (*self.scope.known, *CONSTANTS))}", node)

    def _near(self, name: str, known: Sequence[str]) -> str:
        near = difflib.get_close_matches(name, (*known, *self.scope.abbreviations), n=3, cutoff=0.5)
        return f" (nearest: {', '.join(near)})" if near else " (letters stand in [letters] or --let)"

    def _relation(self, node: ast.expr) -> Term:
        term, kind = self.read(node)
        if kind != "truth":
            raise self.error(f"a relation is expected, got {names.name(kind)}", node)
        return term

    def _signed(self, node: ast.UnaryOp) -> tuple[Term, Kind]:
        if isinstance(node.op, ast.Not):
            return operator_table.negated(self._relation(node.operand)), "truth"
        term, kind = self.read(node.operand)
        if kind == "truth":
            raise self.error("a relation has no sign", node)
        return (-term if isinstance(node.op, ast.USub) else term), kind

    def _power(self, node: ast.BinOp) -> tuple[Term, Kind]:
        (base, kind), (exponent, of) = self.read(node.left), self.read(node.right)
        result = names.power_kind(kind, of)
        written = integer(node.right)
        if kind == of == "integer" and (written or 0) >= 0 and written is not None:
            result = "integer"
        if written is not None:
            most = POWER_MAX if integer(node.left) is None else NUMERAL_POWER_MAX
            if abs(written) > most:
                raise self.error(f"powers are numbers up to {most}, got {written}", node.right)
            exponent = Number(written)
        elif isinstance(node.right, ast.BinOp) and isinstance(node.right.op, ast.Pow) and _constant(node.right):
            raise self.error("a power of a power of numbers is too large", node.right)
        return base**exponent, result

    def _combined(self, node: ast.BinOp) -> tuple[Term, Kind]:
        (a, left), (b, right) = self.read(node.left), self.read(node.right)
        if "truth" in (left, right):
            raise self.error("a relation is no number", node)
        if isinstance(node.op, ast.Div):
            kind = names.quotient_kind(left, right)
            if isinstance(b, Number) and b.value == 0:
                raise self.error("division by zero", node.right)
            return a / b, kind
        if isinstance(node.op, ast.Mult):
            return a * b, names.product_kind(left, right)
        kind = names.sum_kind(left, right, SUMS[type(node.op)])
        return (a + b if isinstance(node.op, ast.Add) else a - b), kind

    def _compared(self, node: ast.Compare) -> tuple[Term, Kind]:
        nodes = (node.left, *node.comparators)
        sides = [self.read(side) for side in nodes]
        for op, (a, left), (b, right), at in zip(node.ops, sides, sides[1:], nodes[1:], strict=False):
            ordered = not isinstance(op, ast.Eq | ast.NotEq)
            try:
                names.require_comparable(left, right, names.ZERO in (a, b), ordered)
            except KindError as error:
                raise self.error(str(error), at) from None
        terms = [term for term, _ in sides]
        if all(isinstance(op, ast.Eq) for op in node.ops):
            return operator_table.equal(*terms), "truth"
        found = [RELATIONS[type(op)](a, b) for op, (a, b) in zip(node.ops, pairwise(terms), strict=True)]
        return (found[0] if len(found) == 1 else operator_table.both(*found)), "truth"

    @abstractmethod
    def _called(self, name: str, node: ast.Call) -> tuple[Term, Kind]:
        """Return the term of a call."""

    @abstractmethod
    def _member(self, name: str, node: ast.Subscript) -> tuple[Term, Kind]:
        """Return the term of a member of a family of letters."""

    @abstractmethod
    def _abbreviated(self, called: Abbreviation, node: ast.expr, given: Sequence[ast.expr]) -> tuple[Term, Kind]:
        """Return the term of a definition with these arguments."""


def _constant(node: ast.expr) -> bool:
    return not any(isinstance(part, ast.Name) for part in ast.walk(node))
