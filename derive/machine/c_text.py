"""Emitted programs of C headers, read from their text on disk."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path, PurePath
from typing import Any

from pycparser import c_ast

from ..codegen.validation.c_interpreter import CError
from ..codegen.validation.c_interpreter.source import parse
from .terms import Program, ReadError, Scalars, number


class CText:
    """Functions of a header and the headers that it includes, with a prefix left out; they are never executed.

    ``number`` writes a constant as a term.
    """

    def __init__(self, path: Path, prefix: str, number: Callable[[Fraction | int], str] = number) -> None:
        try:
            tree = parse(f'#include "{path.name}"\n', path.parent, {}).tree
        except (CError, OSError) as error:
            raise ReadError(str(error)) from error
        self.name, self.prefix, self.number = path.name, prefix, number
        self.functions = {n.decl.name.removeprefix(prefix): n for n in tree.ext if isinstance(n, c_ast.FuncDef)}

    def program(self, name: str, arguments: Sequence[Any], scalars: Scalars) -> Program:
        """Read a function whose last pointers, those not to constants, are its results; arguments as for Python."""
        if name not in self.functions:
            raise ReadError(f"{self.name}: there is no function {self.prefix}{name}")
        function = self.functions[name]
        made = [_Cells([None] * _size(parameter)) for parameter in _parameters(function)[len(arguments) :]]
        parameters = tuple(term for a in arguments for term in (a if isinstance(a, tuple) else (a,)))
        program = Program(parameters, _place(function.decl))
        given = (_Cells(list(a)) if isinstance(a, tuple) else a for a in arguments)
        self._run(program, scalars, function, [*given, *made])
        program.results = tuple(self._real(function, cell) for cells in made for cell in cells.cells)
        return program

    def _run(self, program: Program, scalars: Scalars, function: Any, arguments: Sequence[Any]) -> None:
        known: dict[str, Any] = dict(zip([p.name for p in _parameters(function)], arguments, strict=True))

        def value(node: Any) -> Any:
            match node:
                case c_ast.ID(name=name) if known.get(name) is not None:
                    return known[name]
                case c_ast.Constant(type="int"):
                    return int(node.value)
                case c_ast.Constant(type="double"):
                    return Fraction(node.value)
                case c_ast.Cast(expr=inner):
                    return value(inner)
                case c_ast.UnaryOp(op="-", expr=inner):
                    found = value(inner)
                    return f"(- ({found}))" if isinstance(found, str) else -found
                case c_ast.ArrayRef(name=array, subscript=index):
                    return value(array).at(node, value(index))
                case c_ast.FuncCall(name=c_ast.ID(name="sqrt"), args=c_ast.ExprList(exprs=[of])):
                    return f"(sqrt({real(of)}))"
                case c_ast.BinaryOp(op="+" | "-" | "*" | "/" as symbol):
                    left, right = value(node.left), value(node.right)
                    if isinstance(left, str) or isinstance(right, str):
                        return f"({self._real(node, left)} {symbol} {self._real(node, right)})"
                    if symbol == "*":
                        return left * right
            raise _unread(node)

        def real(node: Any) -> str:
            return self._real(node, value(node))

        def call(node: Any) -> None:
            name, given = node.name.name.removeprefix(self.prefix), node.args.exprs
            if name in scalars:
                count = len(given) - len(scalars[name])
                found = program.call(scalars, name, [real(each) for each in given[:count]])
                for target, term in zip(given[count:], found, strict=True):
                    known[target.expr.name] = term
            elif name in self.functions:
                cells = {id(each): _Cells([None]) for each in given if getattr(each, "op", "") == "&"}
                places = [cells[id(each)] if id(each) in cells else value(each) for each in given]
                self._run(program, scalars, self.functions[name], places)
                known.update({each.expr.name: cells[id(each)].at(each, 0) for each in given if id(each) in cells})
            else:
                raise _unread(node)

        def declare(node: Any) -> None:
            array = isinstance(node.type, c_ast.ArrayDecl)
            if array and node.init:
                known[node.name] = _Cells([real(each) for each in node.init.exprs])
            elif array:
                known[node.name] = _Cells([None] * _size(node))
            elif node.init:
                (known[node.name],) = program.bind([node.name], real(node.init))

        for statement in function.body.block_items or []:
            match statement:
                case c_ast.Decl():
                    declare(statement)
                case c_ast.Assignment(op="=", lvalue=c_ast.UnaryOp(op="*", expr=pointer), rvalue=right):
                    value(pointer).put(statement, 0, real(right))
                case c_ast.Assignment(op="=", lvalue=c_ast.ArrayRef(name=array, subscript=index), rvalue=right):
                    value(array).put(statement, value(index), real(right))
                case c_ast.FuncCall():
                    call(statement)
                case c_ast.Cast(expr=c_ast.ID()):
                    pass
                case _:
                    raise _unread(statement)

    def _real(self, node: Any, found: Any) -> str:
        """Return a value as a term of numbers."""
        if found is None or isinstance(found, _Cells):
            raise _unread(node)
        return found if isinstance(found, str) else self.number(found)


@dataclass(frozen=True, slots=True)
class _Cells:
    """Array of terms; an unset cell is None."""

    cells: list[Any]

    def at(self, node: Any, index: int) -> str:
        if not 0 <= index < len(self.cells) or self.cells[index] is None:
            raise ReadError(f"{_place(node)}: cell {index} of {len(self.cells)} is read before it is set")
        return str(self.cells[index])

    def put(self, node: Any, index: int, term: str) -> None:
        if not 0 <= index < len(self.cells) or self.cells[index] is not None:
            raise ReadError(f"{_place(node)}: cell {index} of {len(self.cells)} is set twice or does not exist")
        self.cells[index] = term


def _parameters(function: c_ast.FuncDef) -> list[Any]:
    return list(function.decl.type.args.params)


def _size(node: Any) -> int:
    """Return the length of an array; a pointer is to one number."""
    return int(node.type.dim.value) if isinstance(node.type, c_ast.ArrayDecl) else 1


def _place(node: Any) -> str:
    return f"{PurePath(str(node.coord.file)).name}:{node.coord.line}" if node.coord else "?"


def _unread(node: Any) -> ReadError:
    return ReadError(f"{_place(node)}: {getattr(node, 'op', type(node).__name__)} is not read here")
