"""Translate the syntax tree of a header to Python functions, statement by statement."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from pycparser import c_ast

from .types import INT, LIBRARY, NAMES, REAL, SIZE, VOID, Type, Value, common, converted, place, real, refuse

ARITHMETIC, COMPARISON, INTEGER = ("+", "-", "*", "/"), ("<", "=="), ("&", "|", "%")


@dataclass(frozen=True, slots=True)
class Function:
    """The signature of a function; ``defined`` is False for a prototype."""

    name: str
    result: Type
    parameters: tuple[Type, ...]
    defined: bool


@dataclass(slots=True)
class Translator:
    """The Python text of a translation unit, with the place in C of every line.

    ``blocks`` are the variables that are visible, innermost block last; ``referred`` are the functions that are called.
    """

    lines: list[str] = field(default_factory=list)
    places: list[str] = field(default_factory=list)
    functions: dict[str, Function] = field(default_factory=dict)
    types: dict[tuple[str, ...], Type] = field(default_factory=lambda: dict(NAMES))
    referred: set[str] = field(default_factory=set)
    blocks: list[dict[str, Value]] = field(default_factory=lambda: [{}])
    function: Function | None = None
    tables: int = 0

    def external(self, node: c_ast.Node) -> None:
        """Translate a definition or declaration of the file."""
        if isinstance(node, c_ast.Typedef):
            self.types[node.name,] = self.type_of(node.type)
        elif isinstance(node, c_ast.FuncDef):
            self._define(node)
        elif isinstance(node, c_ast.Decl) and isinstance(node.type, c_ast.FuncDecl):
            self._declare_function(node, defined=False)
        elif not isinstance(node, c_ast.Pragma):
            raise refuse(node, f"{type(node).__name__} is not read here")

    def _write(self, node: c_ast.Node, text: str) -> None:
        indent = len(self.blocks) - 1
        self.lines.append("    " * indent + text)
        self.places.append(place(node))

    # --- functions and types ----------------------------------------------------------------------------------------

    def _define(self, node: c_ast.FuncDef) -> None:
        name = node.decl.name
        if name in self.functions and self.functions[name].defined:
            raise refuse(node.decl, f"{name} is defined twice")
        self.function = function = self._declare_function(node.decl, defined=True)
        names = [parameter.name for parameter in _parameters(node.decl.type)]
        self._write(node, f"def f_{name}({', '.join(f'c_{each}' for each in names)}):")
        self.blocks.append({})
        self._write(node, f"called.add({name!r})")
        for each, type_ in zip(names, function.parameters, strict=True):
            self._visible(node, each, Value(type_, f"c_{each}"))
            if type_.length:
                self._write(node, f"c_{each} = c_{each}.narrowed({type_.length})")
        self._statements(node.body.block_items or [])
        if function.result != VOID:
            self._write(node, f"raise CError('{name} ends without a value')")
        self.blocks.pop()

    def _declare_function(self, node: c_ast.Decl, defined: bool) -> Function:
        parameters = tuple(self._parameter(parameter.type) for parameter in _parameters(node.type))
        function = Function(node.name, self.type_of(node.type.type), parameters, defined)
        self.functions[node.name] = function
        return function

    def _parameter(self, node: c_ast.Node) -> Type:
        if isinstance(node, c_ast.ArrayDecl):
            return Type("pointer", self.type_of(node.type), length=_length(node))
        return self.type_of(node)

    def type_of(self, node: c_ast.Node) -> Type:
        """Return the type that a declaration spells."""
        if isinstance(node, c_ast.Typename):
            return self.type_of(node.type)
        if isinstance(node, c_ast.PtrDecl):
            found = Type("pointer", self.type_of(node.type))
        elif isinstance(node, c_ast.TypeDecl) and isinstance(node.type, c_ast.IdentifierType):
            names = tuple(node.type.names)
            if names not in self.types:
                raise refuse(node.type, f"the type {' '.join(names)} is not read here: the one real type is double")
            found = self.types[names]
        else:
            raise refuse(node, f"{type(node).__name__} is not read here")
        if set(node.quals) - {"const"}:
            raise refuse(node, f"{' '.join(node.quals)} is not read here")
        return replace(found, const="const" in node.quals)

    # --- statements ---------------------------------------------------------------------------------------------------

    def _statements(self, nodes: Sequence[c_ast.Node]) -> None:
        for node in nodes:
            self._statement(node)

    def _block(self, node: c_ast.Node) -> None:
        """Translate a statement in braces as an indented block of its own."""
        self.blocks.append({})
        self._write(node, "pass")
        self._statements((node.block_items or []) if isinstance(node, c_ast.Compound) else [node])
        self.blocks.pop()

    def _statement(self, node: c_ast.Node) -> None:
        name = type(node).__name__
        if name not in _STATEMENTS:
            raise refuse(node, f"{name} is not read here")
        _STATEMENTS[name](self, node)

    def _declaration(self, node: c_ast.Decl) -> None:
        """Translate a variable: a constant as a Python variable, any other as cells of its own."""
        if set(node.storage) - {"static"} or (node.storage and not isinstance(node.type, c_ast.ArrayDecl)):
            raise refuse(node, f"{' '.join(node.storage)} is not read here")
        name, variable = node.name, f"c_{node.name}"
        if isinstance(node.type, c_ast.ArrayDecl):
            self._array(node, variable)
            return
        type_ = self.type_of(node.type)
        first = "UNSET" if node.init is None else converted(node, self.value(node.init), type_).text
        if type_.const:
            self._write(node, f"{variable} = {first}")
            self._visible(node, name, Value(type_, variable))
        else:
            self._write(node, f"{variable} = Pointer.to([{first}])")
            self._visible(node, name, Value(type_, f"{variable}[0]", variable))

    def _array(self, node: c_ast.Decl, variable: str) -> None:
        """Translate an array, with first values or without, or a static table of constants."""
        if node.storage or node.init is not None:
            element, text = self._table(node.type, node.init, bool(node.storage))
            self._write(node, f"{variable} = {text}")
        else:
            element = self.type_of(node.type.type)
            self._write(node, f"{variable} = Pointer.to([UNSET] * {_length(node.type)})")
        self._visible(node, node.name, Value(Type("pointer", element), variable))

    def _table(self, node: c_ast.ArrayDecl, first: c_ast.Node, static: bool) -> tuple[Type, str]:
        if not isinstance(first, c_ast.InitList) or len(first.exprs) != _length(node):
            raise refuse(node, f"a list of {_length(node)} values is expected")
        if isinstance(node.type, c_ast.ArrayDecl):
            rows = [self._table(node.type, row, static) for row in first.exprs]
            return Type("pointer", rows[0][0]), f"Pointer.to([{', '.join(text for _, text in rows)}])"
        element = self.type_of(node.type)
        values = [converted(each, self.value(each), element) for each in first.exprs]
        if static and not all(value.constant for value in values):
            raise refuse(node, "a static array takes constants")
        return element, f"Pointer.to([{', '.join(value.text for value in values)}])"

    def _visible(self, node: c_ast.Node, name: str, value: Value) -> None:
        if any(name in block for block in self.blocks):
            raise refuse(node, f"{name} is declared twice")
        self.blocks[-1][name] = value

    def _assignment(self, node: c_ast.Assignment) -> None:
        target, value = self.value(node.lvalue), self.value(node.rvalue)
        if node.op != "=":
            raise refuse(node, f"{node.op} is not read here")
        if target.address is None or target.type.const:
            raise refuse(node, f"{target.type} cannot be assigned")
        self._write(node, f"{target.text} = {converted(node, value, target.type).text}")

    def _if(self, node: c_ast.If) -> None:
        self._write(node, f"if {self._condition(node.cond)}:")
        self._block(node.iftrue)
        if node.iffalse:
            self._write(node, "else:")
            self._block(node.iffalse)

    def _for(self, node: c_ast.For) -> None:
        """Translate ``for (size_t j = a; j < b; ++j)``, the one form of a loop."""
        first = node.init.decls[0] if isinstance(node.init, c_ast.DeclList) and len(node.init.decls) == 1 else None
        name = first.name if first else ""
        test = isinstance(node.cond, c_ast.BinaryOp) and node.cond.op == "<" and _names(node.cond.left, name)
        step = isinstance(node.next, c_ast.UnaryOp) and node.next.op == "++" and _names(node.next.expr, name)
        if first is None or first.init is None or not (test and step):
            raise refuse(node, "the one loop that is read here is for (size_t j = a; j < b; ++j)")
        type_ = self.type_of(first.type)
        bounds = [converted(node, self.value(each), type_).text for each in (first.init, node.cond.right)]
        if not type_.is_integer:
            raise refuse(node, f"a loop over {type_} is not read here")
        self._write(node, f"for c_{name} in range({', '.join(bounds)}):")
        self.blocks.append({})
        self._visible(node, name, Value(replace(type_, const=True), f"c_{name}"))
        self._statements((node.stmt.block_items or []) if isinstance(node.stmt, c_ast.Compound) else [node.stmt])
        self.blocks.pop()

    def _return(self, node: c_ast.Return) -> None:
        assert self.function is not None
        if node.expr is None:
            self._write(node, "return")
        else:
            self._write(node, f"return {converted(node, self.value(node.expr), self.function.result).text}")

    def _call_statement(self, node: c_ast.FuncCall) -> None:
        self._write(node, self._call(node).text)

    def _ignored(self, node: c_ast.Node) -> None:
        """Translate ``(void)name``, which says that a parameter is not read, to nothing."""
        if isinstance(node, c_ast.Cast) and (self.type_of(node.to_type) != VOID or not isinstance(node.expr, c_ast.ID)):
            raise refuse(node, "a value that nothing takes is not read here")
        if isinstance(node, c_ast.Cast):
            self._name(node.expr)

    # --- expressions --------------------------------------------------------------------------------------------------

    def value(self, node: c_ast.Node) -> Value:
        """Return an expression as Python text, its types checked."""
        name = type(node).__name__
        if name not in _EXPRESSIONS:
            raise refuse(node, f"{name} is not read here")
        return _EXPRESSIONS[name](self, node)

    def _condition(self, node: c_ast.Node) -> str:
        value = self.value(node)
        if not value.type.is_integer:
            raise refuse(node, f"an integer is expected as condition, not {value.type}")
        return value.text

    def _constant(self, node: c_ast.Constant) -> Value:
        if node.type not in ("int", "double") or "x" in node.value.lower():
            raise refuse(node, f"a constant of type {node.type}, {node.value}, is not read here")
        if node.type == "int":
            return Value(INT, str(int(node.value)), constant=True)
        return Value(REAL, f"Fraction({node.value!r})", constant=True)

    def _name(self, node: c_ast.ID) -> Value:
        for block in reversed(self.blocks):
            if node.name in block:
                return block[node.name]
        raise refuse(node, f"{node.name} is not declared")

    def _element(self, node: c_ast.ArrayRef) -> Value:
        return self._at(node, self.value(node.name), self.value(node.subscript))

    def _at(self, node: c_ast.Node, pointer: Value, index: Value) -> Value:
        moved = self._moved(node, pointer, index)
        return Value(moved.type.target, f"{pointer.text}[{index.text}]", moved.text)

    def _moved(self, node: c_ast.Node, pointer: Value, by: Value) -> Value:
        if pointer.type.kind != "pointer" or not by.type.is_integer:
            raise refuse(node, f"{pointer.type} + {by.type} is not read here: a pointer and an integer are expected")
        return Value(pointer.type.plain, f"{pointer.text}.moved({by.text})")

    def _unary(self, node: c_ast.UnaryOp) -> Value:
        value = self.value(node.expr)
        if node.op == "*":
            return self._at(node, value, Value(INT, "0"))
        if node.op == "&" and value.address is not None:
            return Value(Type("pointer", value.type), value.address)
        if node.op == "-" and value.type.kind in ("real", "int"):
            return Value(value.type.plain, f"(-{value.text})", constant=value.constant)
        raise refuse(node, f"{node.op} of {value.type} is not read here")

    def _binary(self, node: c_ast.BinaryOp) -> Value:
        symbol, left, right = node.op, self.value(node.left), self.value(node.right)
        if left.type.kind == "pointer" and symbol == "+":
            return self._moved(node, left, right)
        type_, text = common(node, left, right), f"({left.text} {symbol} {right.text})"
        if symbol in COMPARISON:
            return Value(INT, text)
        if symbol in INTEGER and type_ == INT:
            return Value(INT, f"remainder({left.text}, {right.text})" if symbol == "%" else text)
        if symbol not in ARITHMETIC:
            raise refuse(node, f"{left.type} {symbol} {right.type} is not read here")
        if symbol == "/" and type_ != REAL:
            raise refuse(node, "an integer division: one of the operands must be a real number")
        return Value(type_, f"size{text}" if type_ == SIZE and symbol == "-" else text)

    def _choice(self, node: c_ast.TernaryOp) -> Value:
        test, first, second = self._condition(node.cond), self.value(node.iftrue), self.value(node.iffalse)
        type_ = common(node, first, second)
        if type_ == REAL:
            first, second = real(first), real(second)
        return Value(type_, f"({first.text} if {test} else {second.text})")

    def _cast(self, node: c_ast.Cast) -> Value:
        return converted(node, self.value(node.expr), self.type_of(node.to_type))

    def _call(self, node: c_ast.FuncCall) -> Value:
        name = getattr(node.name, "name", None)
        function = self.functions.get(str(name))
        if function is None or not (function.defined or name in LIBRARY) or function is self.function:
            raise refuse(node, f"{name} is not a function defined before")
        given = node.args.exprs if node.args else []
        if len(given) != len(function.parameters):
            raise refuse(node, f"{name} takes {len(function.parameters)} arguments, not {len(given)}")
        self.referred.add(function.name)
        texts = [converted(a, self.value(a), to).text for a, to in zip(given, function.parameters, strict=True)]
        return Value(function.result, f"f_{name}({', '.join(texts)})")


def _parameters(node: c_ast.FuncDecl) -> list[Any]:
    found = node.args.params if node.args else []
    names = [getattr(getattr(p.type, "type", None), "names", None) for p in found]
    return [] if names == [["void"]] else found


def _length(node: c_ast.ArrayDecl) -> int:
    if not isinstance(node.dim, c_ast.Constant) or node.dim.type != "int":
        raise refuse(node, "the size of an array must be a constant")
    return int(node.dim.value)


def _names(node: c_ast.Node, name: str) -> bool:
    return isinstance(node, c_ast.ID) and node.name == name


_STATEMENTS: Mapping[str, Callable[[Translator, Any], None]] = {
    "Assignment": Translator._assignment,
    "Cast": Translator._ignored,
    "Decl": Translator._declaration,
    "EmptyStatement": Translator._ignored,
    "For": Translator._for,
    "FuncCall": Translator._call_statement,
    "If": Translator._if,
    "Pragma": Translator._ignored,
    "Return": Translator._return,
}

_EXPRESSIONS: Mapping[str, Callable[[Translator, Any], Value]] = {
    "ArrayRef": Translator._element,
    "BinaryOp": Translator._binary,
    "Cast": Translator._cast,
    "Constant": Translator._constant,
    "FuncCall": Translator._call,
    "ID": Translator._name,
    "TernaryOp": Translator._choice,
    "UnaryOp": Translator._unary,
}
"""What translates a node, by its kind; other kinds are refused."""
