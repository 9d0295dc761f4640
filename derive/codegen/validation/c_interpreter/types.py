"""The types of C that are read here, and their conversions."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from pycparser import c_ast

from .errors import refuse
from .memory import UNSET, Cells, Pointer

Frame = Cells
Run = Callable[[Frame], Any]

_INT_MAX = 2**31 - 1
_SIZE_MAX = 2**64 - 1


@dataclass(frozen=True, slots=True)
class Type:
    """A type: ``kind`` is real, int, size, void, pointer or array; ``of`` is what the last two hold.

    ``size`` is the length of an array; of a pointer that a parameter declares as an array, how many are promised.
    """

    kind: str
    of: Type | None = None
    size: int = 0
    const: bool = False

    @property
    def cells(self) -> int:
        """How many cells a value takes."""
        return self.size * self.element.cells if self.kind == "array" else 1

    @property
    def element(self) -> Type:
        """What a pointer or an array holds."""
        assert self.of is not None
        return self.of

    @property
    def is_integer(self) -> bool:
        return self.kind in ("int", "size")

    @property
    def is_number(self) -> bool:
        return self.kind == "real" or self.is_integer

    def __str__(self) -> str:
        const = "const " if self.const else ""
        if self.kind == "pointer":
            return f"{const}pointer to {self.of}"
        return f"{const}array of {self.size} {self.of}" if self.kind == "array" else const + self.kind


REAL, INT, SIZE, VOID = map(Type, ("real", "int", "size", "void"))

NAMES: Mapping[tuple[str, ...], Type] = {
    ("double",): REAL, ("int",): INT, ("unsigned", "long"): SIZE, ("void",): VOID,
}  # fmt: skip
"""Types by name. There is one real type: a text that names another would round where the rest does not."""


@dataclass(frozen=True, slots=True)
class Value:
    """An expression: its type and how to compute it; ``address`` where it is a place that can be written."""

    type: Type
    run: Run
    address: Callable[[Frame], Pointer] | None = None
    constant: bool = False


def convert(node: c_ast.Node, value: Value, to: Type) -> Value:
    """The value as one of another type, as in an assignment. Nothing that would lose digits is converted."""
    given, run, plain = value.type, value.run, replace(to, const=False)
    if plain.kind == "real" and given.is_integer:
        if value.constant:
            number = Fraction(run([]))
            return Value(plain, lambda frame: number, constant=True)
        return Value(plain, lambda frame: Fraction(run(frame)))
    if plain.is_integer and given.is_integer:
        return value if given.kind == plain.kind else Value(plain, in_range(node, plain, run))
    if plain.kind == "pointer" and given.kind == "pointer":
        mine, theirs = plain.element, given.element
        if replace(mine, const=False) == replace(theirs, const=False) and (mine.const or not theirs.const):
            return value
    elif plain.kind == given.kind and plain.is_number:
        return value
    raise refuse(node, f"{given} where {plain} is expected")


def in_range(node: c_ast.Node, type_: Type, run: Run) -> Run:
    """The integer computed by ``run``; an error where its type cannot hold it, which C would wrap or not define."""
    low, high = (-_INT_MAX - 1, _INT_MAX) if type_.kind == "int" else (0, _SIZE_MAX)

    def checked(frame: Frame) -> int:
        value: int = run(frame)
        if not low <= value <= high:
            raise refuse(node, f"{value} overflows {type_}")
        return value

    return checked


def common(node: c_ast.Node, *values: Value) -> tuple[Type, list[Value]]:
    """Numbers brought to one type, as for the operands of an operator."""
    types = [value.type for value in values]
    if not all(type_.is_number for type_ in types):
        raise refuse(node, f"numbers are expected, not {', '.join(map(str, types))}")
    kinds = {type_.kind for type_ in types}
    type_ = REAL if "real" in kinds else SIZE if "size" in kinds else INT
    return type_, [convert(node, value, type_) for value in values]


def at_address(type_: Type, address: Callable[[Frame], Pointer]) -> Value:
    """What stands at an address: a number or a pointer, or an array, which is a pointer to its first element."""
    if type_.kind != "array":
        return Value(type_, lambda frame: address(frame).load(), address)
    element, size = type_.element, type_.cells
    return Value(Type("pointer", element), lambda frame: address(frame).narrowed(size))


def variable(type_: Type, offset: int, cells: Cells | None) -> Value:
    """A variable in the frame of a call, or in cells of its own if it is static."""
    size = type_.cells

    def address(frame: Frame) -> Pointer:
        return Pointer(frame if cells is None else cells, offset, offset, offset + size)

    if type_.kind == "array":
        return Value(Type("pointer", type_.element), address)

    def load(frame: Frame) -> Any:
        value = frame[offset] if cells is None else cells[offset]
        return address(frame).load() if value is UNSET else value

    return Value(type_, load, address)
