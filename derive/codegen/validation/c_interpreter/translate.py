"""Translate the syntax tree of a header to Python functions, statement by statement.

Types are ``real``, ``int`` (of any size) and ``void``, each with a ``*`` for every level of pointers. Types serve to
detect integer divisions and lossy conversions; compilers check the other rules. Real constants become fractions.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import PurePath
from typing import Any, NamedTuple

from pycparser import c_ast

from .memory import CError
from .source import LIBRARY

NAMES: Mapping[tuple[str, ...], str] = {
    ("double",): "real", ("int",): "int", ("unsigned", "long"): "int", ("void",): "void",
}  # fmt: skip
"""Types by C name. There is one real type: conversions to another type would round."""


class Value(NamedTuple):
    """Type and Python text of an expression; ``address`` is the text of its address if it can be assigned."""

    type: str
    text: str
    address: str = ""


class Function(NamedTuple):
    """Signature of a function; ``defined`` is false for a prototype."""

    result: str
    parameters: tuple[str, ...]
    defined: bool


def place(node: Any) -> str:
    return f"{PurePath(str(node.coord.file)).name}:{node.coord.line}" if node.coord else "?"


def refuse(node: Any, message: str) -> CError:
    return CError(f"{place(node)}: {message}")


def converted(node: Any, value: Value, to: str) -> str:
    """Return the text of a value converted to a type; conversions that may lose digits raise `CError`."""
    if to == "real" and value.type == "int":
        return f"Fraction({value.text})"
    if value.type != to:
        raise refuse(node, f"{value.type} where {to} is expected")
    return value.text


@dataclass(slots=True)
class Translator:
    """Python text of a translation unit."""

    lines: list[str] = field(default_factory=list)
    places: list[str] = field(default_factory=list)  # C file and line of every Python line
    functions: dict[str, Function] = field(default_factory=dict)
    types: dict[tuple[str, ...], str] = field(default_factory=lambda: dict(NAMES))
    referred: set[str] = field(default_factory=set)  # functions called in the text
    blocks: list[dict[str, Value]] = field(default_factory=list)  # visible variables, innermost block last
    result: str = ""

    def external(self, node: c_ast.Node) -> None:
        """Translate a definition or declaration of the file."""
        if isinstance(node, c_ast.Typedef):
            self.types[node.name,] = self._type(node.type)
        elif isinstance(node, c_ast.FuncDef):
            self._define(node)
        elif isinstance(node, c_ast.Decl) and isinstance(node.type, c_ast.FuncDecl):
            self._declare(node, defined=False)
        elif not isinstance(node, c_ast.Pragma):
            raise refuse(node, f"the interpreter of C reads no {type(node).__name__}")

    def _write(self, node: c_ast.Node, text: str) -> None:
        self.lines.append("    " * len(self.blocks) + text)
        self.places.append(place(node))

    # --- functions, types, variables ----------------------------------------------------------------------------------

    def _define(self, node: c_ast.FuncDef) -> None:
        name, parameters = node.decl.name, _parameters(node.decl.type)
        if name in self.functions:
            raise refuse(node.decl, f"{name} is defined twice")
        self._write(node, f"def f_{name}({', '.join(f'c_{each.name}' for each in parameters)}):")
        visible = {each.name: Value(self._type(each.type), f"c_{each.name}") for each in parameters}
        lengths = ((p.name, _length(p.type)) for p in parameters if isinstance(p.type, c_ast.ArrayDecl))
        first = [f"called.add({name!r})", *(f"c_{each} = c_{each}.narrowed({length})" for each, length in lengths)]
        for each in visible.keys() & _addressed(node.body):
            visible[each] = Value(visible[each].type, f"c_{each}[0]", f"c_{each}")
            first.append(f"c_{each} = Pointer.to([c_{each}])")
        self.result = self._type(node.decl.type.type)
        self._block(node, node.body, visible, first)
        if self.result != "void":
            self._write(node, f"    raise CError('{name} ends without a value')")
        self._declare(node.decl, defined=True)

    def _declare(self, node: c_ast.Decl, defined: bool) -> None:
        parameters = tuple(self._type(parameter.type) for parameter in _parameters(node.type))
        self.functions[node.name] = Function(self._type(node.type.type), parameters, defined)

    def _type(self, node: c_ast.Node) -> str:
        """Return the type of a declaration; an array is a pointer to its first element."""
        if isinstance(node, c_ast.Typename | c_ast.PtrDecl | c_ast.ArrayDecl):
            return self._type(node.type) + "*" * (not isinstance(node, c_ast.Typename))
        names = tuple(getattr(node.type, "names", (type(node).__name__,)))
        if names not in self.types:
            raise refuse(node, f"the interpreter of C reads no type {' '.join(names)}: the one real type is double")
        return self.types[names]

    def _variable(self, node: c_ast.Decl) -> None:
        """Translate a variable: a constant becomes a Python variable, any other variable a list of cells."""
        name, type_ = f"c_{node.name}", self._type(node.type)
        if any(node.name in block for block in self.blocks):
            raise refuse(node, f"{node.name} is declared twice")
        if isinstance(node.type, c_ast.ArrayDecl):
            cells = self._table(node.type, node.init) if node.init else f"Pointer.to([UNSET] * {_length(node.type)})"
            value = Value(type_, name)
        else:
            cells = converted(node, self._value(node.init), type_) if node.init else "UNSET"
            value = Value(type_, name)
            if "const" not in node.quals:
                cells, value = f"Pointer.to([{cells}])", Value(type_, f"{name}[0]", name)
        self._write(node, f"{name} = {cells}")
        self.blocks[-1][node.name] = value

    def _table(self, node: c_ast.ArrayDecl, first: c_ast.Node) -> str:
        if not isinstance(first, c_ast.InitList) or len(first.exprs) != _length(node):
            raise refuse(node, f"a list of {_length(node)} values is expected")
        if isinstance(node.type, c_ast.ArrayDecl):
            return f"Pointer.to([{', '.join(self._table(node.type, row) for row in first.exprs)}])"
        texts = (converted(each, self._value(each), self._type(node.type)) for each in first.exprs)
        return f"Pointer.to([{', '.join(texts)}])"

    # --- statements ---------------------------------------------------------------------------------------------------

    def _block(self, node: c_ast.Node, body: Any, visible: dict[str, Value], first: Iterable[str] = ("pass",)) -> None:
        """Translate a statement, or several in braces, to an indented block with the variables ``visible``."""
        self.blocks.append(visible)
        for text in first:
            self._write(node, text)
        for each in (body.block_items or []) if isinstance(body, c_ast.Compound) else [body]:
            self._statement(each)
        self.blocks.pop()

    def _statement(self, node: Any) -> None:
        match node:
            case c_ast.Decl():
                self._variable(node)
            case c_ast.Assignment(op="="):
                target, value = self._value(node.lvalue), self._value(node.rvalue)
                if not target.address:
                    raise refuse(node, f"{target.text.removeprefix('c_')} cannot be assigned")
                self._write(node, f"{target.text} = {converted(node, value, target.type)}")
            case c_ast.FuncCall():
                self._write(node, self._value(node).text)
            case c_ast.Return():
                self._write(node, f"return {converted(node, self._value(node.expr), self.result)}")
            case c_ast.If():
                self._write(node, f"if {self._integer(node.cond)}:")
                self._block(node, node.iftrue, {})
                if node.iffalse:
                    self._write(node, "else:")
                    self._block(node, node.iffalse, {})
            case c_ast.For():
                self._loop(node)
            case c_ast.Cast(expr=c_ast.ID()) if self._type(node.to_type) == "void":
                self._value(node.expr)  # (void)parameter; marks an unused parameter
            case c_ast.EmptyStatement() | c_ast.Pragma():
                pass
            case _:
                raise refuse(node, f"the interpreter of C reads no {type(node).__name__}")

    def _loop(self, node: c_ast.For) -> None:
        match node:
            case c_ast.For(
                init=c_ast.DeclList(decls=[c_ast.Decl(name=name, init=first)]),
                cond=c_ast.BinaryOp(op="<", left=c_ast.ID(name=compared), right=last),
                next=c_ast.UnaryOp(op="++", expr=c_ast.ID(name=stepped)),
            ) if name == compared == stepped and first:
                self._write(node, f"for c_{name} in range({self._integer(first)}, {self._integer(last)}):")
                self._block(node, node.stmt, {name: Value("int", f"c_{name}")})
            case _:
                raise refuse(node, "the one loop that the interpreter of C reads is for (size_t j = a; j < b; ++j)")

    # --- expressions --------------------------------------------------------------------------------------------------

    def _integer(self, node: c_ast.Node) -> str:
        return converted(node, self._value(node), "int")

    def _value(self, node: Any) -> Value:
        match node:
            case c_ast.ID():
                for block in self.blocks:
                    if node.name in block:
                        return block[node.name]
                raise refuse(node, f"{node.name} is not declared")
            case c_ast.Constant(type="int"):
                return Value("int", str(int(node.value)))
            case c_ast.Constant(type="double"):
                return Value("real", f"Fraction({node.value!r})")
            case c_ast.ArrayRef():
                return self._at(node, self._value(node.name), self._integer(node.subscript))
            case c_ast.UnaryOp(op="*"):
                return self._at(node, self._value(node.expr), "0")
            case c_ast.UnaryOp(op="&" | "-"):
                return self._unary(node, self._value(node.expr))
            case c_ast.BinaryOp():
                return self._binary(node, node.op, self._value(node.left), self._value(node.right))
            case c_ast.TernaryOp():
                sides = self._value(node.iftrue), self._value(node.iffalse)
                type_ = max(side.type for side in sides)  # "real" if either side is real
                first, second = (converted(node, side, type_) for side in sides)
                return Value(type_, f"choose({self._integer(node.cond)}, lambda: {first}, lambda: {second})")
            case c_ast.Cast():
                type_ = self._type(node.to_type)
                return Value(type_, converted(node, self._value(node.expr), type_))
            case c_ast.FuncCall():
                return self._call(node)
        raise refuse(node, f"the interpreter of C reads no {getattr(node, 'op', type(node).__name__)}")

    def _at(self, node: c_ast.Node, pointer: Value, index: str) -> Value:
        if not pointer.type.endswith("*"):
            raise refuse(node, f"a pointer is expected, not {pointer.type}")
        return Value(pointer.type[:-1], f"{pointer.text}[{index}]", f"{pointer.text}.moved({index})")

    def _unary(self, node: c_ast.UnaryOp, value: Value) -> Value:
        if node.op == "&" and value.address:
            return Value(f"{value.type}*", value.address)
        if node.op == "-" and not value.type.endswith("*"):
            return Value(value.type, f"(-{value.text})")
        raise refuse(node, f"the interpreter of C reads no {node.op} of {value.type}")

    def _binary(self, node: c_ast.BinaryOp, symbol: str, left: Value, right: Value) -> Value:
        types, text = {left.type, right.type}, f"({left.text} {symbol} {right.text})"
        if left.type.endswith("*") and symbol == "+" and right.type == "int":
            return Value(left.type, f"{left.text}.moved({right.text})")
        if symbol in ("<", "==") and types <= {"real", "int"}:
            return Value("int", text)
        if symbol == "/" and types == {"int"}:
            raise refuse(node, "an integer division: one of the operands must be a real number")
        if symbol in ("+", "-", "*", "/") and types <= {"real", "int"}:
            return Value("real" if "real" in types else "int", text)
        if symbol in ("&", "|", "%") and types == {"int"}:
            return Value("int", f"remainder({left.text}, {right.text})" if symbol == "%" else text)
        raise refuse(node, f"the interpreter of C reads no {left.type} {symbol} {right.type}")

    def _call(self, node: c_ast.FuncCall) -> Value:
        name = getattr(node.name, "name", "")
        function = self.functions.get(name)
        if function is None or not (function.defined or name in LIBRARY):
            raise refuse(node, f"{name} is not a function defined before")
        given = node.args.exprs if node.args else []
        if len(given) != len(function.parameters):
            raise refuse(node, f"{name} takes {len(function.parameters)} arguments, not {len(given)}")
        self.referred.add(name)
        texts = (converted(each, self._value(each), to) for each, to in zip(given, function.parameters))
        return Value(function.result, f"f_{name}({', '.join(texts)})")


def _parameters(node: c_ast.FuncDecl) -> list[Any]:
    found = node.args.params if node.args else []
    return [] if any(getattr(getattr(p.type, "type", None), "names", None) == ["void"] for p in found) else found


def _addressed(node: c_ast.Node) -> set[str]:
    """Return the names of variables whose address is taken."""
    own = isinstance(node, c_ast.UnaryOp) and node.op == "&" and isinstance(node.expr, c_ast.ID)
    return {node.expr.name} if own else {name for _, child in node.children() for name in _addressed(child)}


def _length(node: c_ast.ArrayDecl) -> int:
    if not isinstance(node.dim, c_ast.Constant):
        raise refuse(node, "the size of an array must be a constant")
    return int(node.dim.value)
