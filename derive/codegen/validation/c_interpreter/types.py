"""Types of C, typed expressions as Python text, and their conversions."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import PurePath
from typing import Any

from .memory import CError

LIBRARY: Mapping[str, tuple[int, Callable[..., Any]]] = {
    "fabs": (1, abs),
    "sqrt": (1, lambda a: a.sqrt()),
    "tan": (1, lambda a: a.tan()),
    "atan2": (2, lambda a, b: a.arctan2(b)),
    "expm1": (1, lambda a: a.expm1()),
    "log1p": (1, lambda a: a.log1p()),
}
"""Functions of the C library: the number of arguments, and the method of the number type."""


@dataclass(frozen=True, slots=True)
class Type:
    """A type of C: ``kind`` is real, int, size, void or pointer; ``of`` is what a pointer points to.

    ``length`` is the number of elements that an array parameter promises.
    """

    kind: str
    of: Type | None = None
    const: bool = False
    length: int = 0

    @property
    def plain(self) -> Type:
        """The type without its qualifier and length."""
        return replace(self, const=False, length=0)

    @property
    def target(self) -> Type:
        """The type that a pointer points to."""
        assert self.of is not None
        return self.of

    @property
    def is_integer(self) -> bool:
        return self.kind in ("int", "size")

    @property
    def is_number(self) -> bool:
        return self.kind == "real" or self.is_integer

    def __str__(self) -> str:
        name = f"pointer to {self.of}" if self.kind == "pointer" else self.kind
        return f"const {name}" if self.const else name


REAL, INT, SIZE, VOID = map(Type, ("real", "int", "size", "void"))

NAMES: Mapping[tuple[str, ...], Type] = {
    ("double",): REAL, ("int",): INT, ("unsigned", "long"): SIZE, ("void",): VOID,
}  # fmt: skip
"""Types by name. There is one real type: another would round where the rest does not."""


@dataclass(frozen=True, slots=True)
class Value:
    """An expression: its type, its Python text, and the text of its address where it can be written."""

    type: Type
    text: str
    address: str | None = None
    constant: bool = False


def refuse(node: Any, message: str) -> CError:
    """Return the error with file and line of a node of the syntax tree."""
    return CError(f"{place(node)}: {message}")


def place(node: Any) -> str:
    """Return file name and line of a node."""
    coordinate = node.coord
    return f"{PurePath(str(coordinate.file)).name}:{coordinate.line}" if coordinate else "?"


def real(value: Value) -> Value:
    """Return a number as a real one."""
    if value.type.kind == "real":
        return value
    return Value(REAL, f"Fraction({value.text})", constant=value.constant)


def converted(node: Any, value: Value, to: Type) -> Value:
    """Return the value as one of another type, as in an assignment; refuse what would lose digits."""
    given, plain = value.type.plain, to.plain
    if plain.kind == "real" and given.is_number:
        return real(value)
    if plain == given and plain.is_number:
        return value
    if (plain.kind, given.kind) == ("size", "int"):
        return Value(plain, value.text if value.constant else f"size({value.text})")
    if plain.kind == given.kind == "pointer":
        mine, theirs = plain.target, given.target
        if mine.plain == theirs.plain and (mine.const or not theirs.const):
            return value
    raise refuse(node, f"{value.type} where {to.plain} is expected")


def common(node: Any, *values: Value) -> Type:
    """Return the type to which the operands of an operator are brought."""
    kinds = {value.type.kind for value in values}
    if not all(value.type.is_number for value in values):
        raise refuse(node, f"numbers are expected, not {', '.join(str(value.type) for value in values)}")
    return REAL if "real" in kinds else SIZE if "size" in kinds else INT
