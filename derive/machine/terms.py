"""Emitted programs, read back from Python or C text on disk as straight-line terms of Coq.

Assignments become nested ``let``. Calls of other geometry programs are inlined; calls of scalar programs named as
opaque stay calls of a function that Coq knows nothing about. Text outside this subset raises `ReadError`.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path, PurePath
from typing import Any

from pycparser import c_ast

from ..codegen.validation.c_interpreter import CError
from ..codegen.validation.c_interpreter.source import parse

Scalars = Mapping[str, Sequence[str]]
"""Names of the results of opaque scalar programs, by program."""

SYMBOLS: Mapping[type[ast.operator], str] = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/"}
_WORDS = "as at cofix else end exists fix for forall fun if in let match mod return then using where with Prop Set Type"
RESERVED = frozenset([*_WORDS.split(), "sqrt"])
"""Words of Coq that are no names, and the one function that terms may call."""


class ReadError(ValueError):
    """Error in emitted text that is missing or is not a straight-line program; the message names file and line."""


def number(value: Fraction | int) -> str:
    """Return a rational number as a term of ones.

    Examples
    --------
    >>> number(6), number(Fraction(-1, 2))
    ('(2 * (1 + 2 * 1))', '(- ((1 / 2)))')
    """
    value = Fraction(value)
    if value < 0:
        return f"(- ({number(-value)}))"
    if value.denominator != 1:
        return f"({number(value.numerator)} / {number(value.denominator)})"
    half, odd = divmod(int(value), 2)
    if half == 0 or (half, odd) == (1, 0):
        return str(value)
    return f"(1 + 2 * {number(half)})" if odd else f"(2 * {number(half)})"


@dataclass(slots=True)
class Program:
    """Straight-line program: its parameters, its steps of names and a term, its results, and its file and line."""

    parameters: tuple[str, ...]
    place: str = ""
    steps: list[tuple[Sequence[str], str]] = field(default_factory=list)
    results: tuple[str, ...] = ()
    used: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        self.used |= {*self.parameters, *RESERVED}

    def bind(self, names: Sequence[str], term: str) -> tuple[str, ...]:
        """Add the step that gives names to a term, or to its parts; return the names, changed where they are taken."""
        if len(names) == 1 and term.isidentifier():
            return (term,)
        made = tuple(map(self._free, names))
        self.steps.append((made, term))
        return made

    def _free(self, name: str) -> str:
        free = next(each for each in _numbered(name) if each not in self.used)
        self.used.add(free)
        return free

    def call(self, scalars: Scalars, name: str, arguments: Sequence[str]) -> tuple[str, ...]:
        """Add the call of an opaque scalar program and return the names of its results."""
        return self.bind(scalars[name], f"{name} {' '.join(arguments)}")

    def definition(self, name: str) -> str:
        """Return the program as a definition of Coq, a function to tuples of numbers of K."""
        lines = [f"Definition {name} ({' '.join(self.parameters)} : K) : {product(len(self.results))} :="]
        for names, term in self.steps:
            lines.append(f"  let {names[0] if len(names) == 1 else _tuple(names, mark=chr(39))} := {term} in")
        return "\n".join([*lines, f"  {_tuple(self.results)}."])


def product(count: int) -> str:
    """Return the type of tuples of numbers."""
    return f"({' * '.join(['K'] * count)})%type"


def _tuple(terms: Sequence[str], mark: str = "") -> str:
    return f"{mark}({', '.join(terms)})"


def _numbered(name: str) -> Iterator[str]:
    yield name
    count = 2
    while True:
        yield f"{name}_{count}"
        count += 1


# --- Python -----------------------------------------------------------------------------------------------------------


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


# --- C ----------------------------------------------------------------------------------------------------------------


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
