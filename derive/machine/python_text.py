"""Emitted programs of Python kernels, read from their text on disk."""

from __future__ import annotations

import ast
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from .terms import SYMBOLS, Program, ReadError, Scalars, number


class PythonText:
    """Functions of a Python module, never executed."""

    def __init__(self, path: Path) -> None:
        try:
            self.tree, self.name = ast.parse(path.read_text(encoding="utf-8")), path.name
        except (OSError, SyntaxError, UnicodeDecodeError) as error:
            raise ReadError(f"{path.name}: {error}") from error
        self.functions = {node.name: node for node in ast.walk(self.tree) if isinstance(node, ast.FunctionDef)}

    def program(self, name: str, arguments: Sequence[Any], scalars: Scalars) -> Program:
        """Read a function of ``m``, optionally the chart ``c``, and arguments that are names or tuples of terms."""
        function = self.function(name)
        given = [a if isinstance(a, tuple) else (a,) for a in arguments]
        program = Program(tuple(term for a in given for term in a if term.isidentifier()), self._place(function))
        machine = [None] * (len(function.args.args) - len(arguments))
        program.results = tuple(self._inline(program, scalars, function, [*machine, *arguments]))
        return program

    def function(self, name: str) -> ast.FunctionDef:
        """Return the syntax tree of a function."""
        if name not in self.functions:
            raise ReadError(f"{self.name}: there is no function {name}")
        return self.functions[name]

    def _place(self, node: Any) -> str:
        return f"{self.name}:{node.lineno}"

    def _refuse(self, node: ast.AST) -> ReadError:
        return ReadError(f"{self._place(node)}: {ast.unparse(node)} is not read here")

    def _inline(self, program: Program, scalars: Scalars, function: ast.FunctionDef, arguments: Sequence[Any]) -> Any:
        names = [parameter.arg for parameter in function.args.args]
        if len(names) != len(arguments):
            raise ReadError(f"{self._place(function)}: {function.name} takes {len(names)} arguments")
        known = dict(zip(names, arguments, strict=True))

        def value(node: ast.expr | None) -> Any:
            match node:
                case ast.Constant(value=int() as constant):
                    return number(constant)
                case ast.Name(id=name) if name in known:
                    return known[name]
                case ast.UnaryOp(op=ast.USub(), operand=operand):
                    return f"(- ({value(operand)}))"
                case ast.BinOp(left=left, op=operation, right=right) if type(operation) in SYMBOLS:
                    return f"({value(left)} {SYMBOLS[type(operation)]} {value(right)})"
                case ast.Tuple(elts=parts):
                    return tuple(part for each in parts for part in _parts(each, value))
                case ast.Call(func=ast.Attribute(ast.Name(id="c"), name), args=[_, *given]) if name in scalars:
                    return program.call(scalars, name, [value(each) for each in given])
                case ast.Call(func=ast.Attribute(value=ast.Name(id="m"), attr="sqrt"), args=[of]):
                    return f"(sqrt({value(of)}))"
                case ast.Call(func=ast.Name(id=name), args=given) if name in self.functions:
                    return self._inline(program, scalars, self.functions[name], [value(each) for each in given])
            raise self._refuse(node or function)

        for statement in function.body:
            match statement:
                case ast.Expr(value=ast.Constant()):
                    pass
                case ast.Assign(targets=[ast.Name(id=name)], value=right):
                    found = value(right)
                    known[name] = found if isinstance(found, tuple) else program.bind([name], found)[0]
                case ast.Assign(targets=[ast.Tuple(elts=targets)], value=right):
                    found = value(right)
                    if len(found) != len(targets):
                        raise self._refuse(statement)
                    for target, term in zip(targets, found, strict=True):
                        if (name := getattr(target, "id", "_")) != "_":
                            (known[name],) = program.bind([name], term)
                case ast.Return(value=right):
                    return value(right)
                case _:
                    raise self._refuse(statement)
        raise ReadError(f"{self._place(function)}: {function.name} returns nothing")

    def table(self, method: str) -> tuple[str, ...]:
        """Return the decimals that a method of the interface passes as table."""
        for node in ast.walk(self.function(method)):
            if isinstance(node, ast.keyword) and node.arg == "table" and isinstance(node.value, ast.Name):
                return tuple(self._constants()[node.value.id])
        raise ReadError(f"{self._place(self.function(method))}: {method} passes no table")

    def _constants(self) -> dict[str, Any]:
        """Return module constants that are assigned together in one line, by name."""
        found: dict[str, Any] = {}
        for node in self.tree.body:
            match node:
                case ast.Assign(targets=[ast.Tuple(elts=names)], value=ast.Tuple(elts=values)):
                    found |= {ast.unparse(name): value for name, value in zip(names, values)}
        return {name: ast.literal_eval(v) for name, v in found.items() if name.isupper() and isinstance(v, ast.Tuple)}


def _parts(node: ast.expr, value: Any) -> Sequence[str]:
    """Return the terms of an element of a tuple, which may be a starred tuple."""
    return value(node.value) if isinstance(node, ast.Starred) else (value(node),)
