"""What names mean: variables, types and functions; conditions on the way, and the values they took."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from pycparser import c_ast
from pycparser.c_generator import CGenerator

from .errors import CError, place, refuse
from .memory import UNSET, Cells
from .types import NAMES, Frame, Run, Type, Value, variable

LIBRARY: Mapping[str, tuple[int, Callable[..., Any]]] = {
    "fabs": (1, abs),
    "sqrt": (1, lambda a: a.sqrt()),
    "tan": (1, lambda a: a.tan()),
    "atan2": (2, lambda a, b: a.arctan2(b)),
    "expm1": (1, lambda a: a.expm1()),
    "log1p": (1, lambda a: a.log1p()),
}
"""Functions of the C library, with the number of their arguments, by methods of the number type."""


@dataclass(slots=True)
class Function:
    """A function: parameters, and once it is defined its body; ``calls`` counts, ``names`` are those it calls."""

    name: str
    result: Type
    parameters: tuple[Type, ...]
    body: Callable[[Frame], tuple[Any, ...] | None] | None = None
    size: int = 0
    calls: int = 0
    names: set[str] = field(default_factory=set)

    def run(self, arguments: Sequence[Any]) -> Any:
        """Call it in a new frame. A pointer to a promised array may be used for that array only."""
        if self.body is None:
            return LIBRARY[self.name][1](*arguments)
        self.calls += 1
        frame: Frame = [UNSET] * self.size
        for index, (type_, argument) in enumerate(zip(self.parameters, arguments, strict=True)):
            frame[index] = argument.narrowed(type_.size) if type_.size else argument
        found = self.body(frame)
        if found is None and self.result.kind != "void":
            raise CError(f"{self.name} ends without a value")
        return found[0] if found else None


@dataclass(frozen=True, slots=True)
class Condition:
    """A condition of the text and the truth values it took."""

    node: c_ast.Node
    taken: set[bool]

    def __str__(self) -> str:
        return f"{place(self.node)}: {CGenerator().visit(self.node)}"


@dataclass(slots=True)
class Scope:
    """Names of the file, or of a function and the blocks that are open in it."""

    functions: dict[str, Function] = field(default_factory=dict)
    types: dict[str, Type] = field(default_factory=dict)
    statics: Cells = field(default_factory=list)
    conditions: list[Condition] = field(default_factory=list)
    blocks: list[dict[str, Value]] = field(default_factory=lambda: [{}])
    function: Function | None = None

    def inside(self, function: Function) -> Scope:
        """The scope of a function's parameters and body."""
        return Scope(self.functions, self.types, self.statics, self.conditions, [*self.blocks, {}], function)

    def declare(self, node: c_ast.Decl, type_: Type, static: bool = False) -> tuple[Value, int]:
        """A new variable and its first cell: in the frame of the function, or for the whole run."""
        if node.name in self.blocks[-1]:
            raise refuse(node, f"{node.name} is declared twice")
        if static or self.function is None:
            offset, cells = len(self.statics), self.statics
            self.statics.extend([UNSET] * type_.cells)
            value = variable(type_, offset, cells)
        else:
            offset = self.function.size
            self.function.size += type_.cells
            value = variable(type_, offset, None)
        self.blocks[-1][node.name] = value
        return value, offset

    def lookup(self, node: c_ast.ID) -> Value:
        """The variable of a name."""
        for block in reversed(self.blocks):
            if node.name in block:
                return block[node.name]
        raise refuse(node, f"{node.name} is not declared")

    def called(self, node: c_ast.FuncCall) -> Function:
        """The function a call names."""
        name = getattr(node.name, "name", None)
        function = self.functions.get(name) if isinstance(name, str) else None
        if function is None or (function.body is None and function.name not in LIBRARY):
            raise refuse(node, f"{name} is not a function defined before")
        if self.function:
            self.function.names.add(function.name)
        return function

    def decided(self, node: c_ast.Node, run: Run) -> Run:
        """The condition as 0 or 1; which values it took is recorded."""
        taken: set[bool] = set()
        self.conditions.append(Condition(node, taken))

        def decide(frame: Frame) -> int:
            value = bool(run(frame))
            taken.add(value)
            return int(value)

        return decide

    def type_of(self, node: c_ast.Node) -> Type:
        """The type a declaration spells."""
        if isinstance(node, c_ast.Typename | c_ast.Decl):
            return self.type_of(node.type)
        if isinstance(node, c_ast.TypeDecl) and isinstance(node.type, c_ast.IdentifierType):
            names = tuple(node.type.names)
            found = self.types.get(names[0]) if len(names) == 1 else None
            type_ = found or NAMES.get(names)
            if type_ is None:
                raise refuse(node.type, f"the type {' '.join(names)} is not read here: the one real type is double")
            return _qualified(node, type_)
        if isinstance(node, c_ast.PtrDecl):
            return _qualified(node, Type("pointer", self.type_of(node.type)))
        raise refuse(node, f"{type(node).__name__} is not read here")


def _qualified(node: c_ast.TypeDecl | c_ast.PtrDecl, type_: Type) -> Type:
    if set(node.quals or ()) - {"const"}:
        raise refuse(node, f"{' '.join(node.quals)} is not read here")
    return Type(type_.kind, type_.of, type_.size, type_.const or "const" in (node.quals or ()))
