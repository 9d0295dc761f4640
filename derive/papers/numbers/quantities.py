"""Table of the quantities of symbols, with their generic values in an exact field.

Values at points are built by `derive.papers.numbers.kinds`, which extends this table.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum, auto
from typing import TYPE_CHECKING, Any

from ...algebra import Dual, Quaternion, Tensor
from ...maps.first_principles import tensor_by_sandwich as rotation
from .build import polynomial
from .fields import Field

if TYPE_CHECKING:
    from .generic import Generic


class Role(Enum):
    """Role of a quantity in the choice of exact coordinates."""

    ANGLE = auto()  # its fractions have exact sine and cosine; on branch k the generic angle is α + 2kπ
    TURN = auto()  # displacement, given by an angle and an axis
    VECTOR = auto()  # a frame may be chosen along it; the first vector's magnitude is the tangent of an angle
    TENSOR = auto()  # has generic entries; no frame is chosen


@dataclass(frozen=True, eq=False)
class Quantity:
    """Row of the table."""

    name: str
    size: int = 0  # number of independent numbers in a value
    exact: Callable[[Generic, str], Any] | None = None  # returns the generic value of a symbol, given its name
    built: Callable[[Generic, str], Any] | None = None  # the same without a frame along the vectors
    role: Role | None = None
    value: Callable[[Field], Any] | None = None  # returns the value of a constant in a field
    apart: bool = False  # whether it separates real and dual parts; then exact coefficients are dual too
    varies: bool = True  # whether a symbol without a definition is free


ORDER = Quantity("order")
"""Order n, at the requested orders or at all orders at once."""
BRANCH = Quantity("branch")
"""Branch k = 0, 1 … n − 1."""
PROPOSITION = Quantity("proposition", apart=True)
"""Claim in words."""
SIGN = Quantity("sign")
"""Sign ±, equal on both sides of an equation."""

_REAL = (
    Quantity("real", 1, lambda g, name: g.real(g.number(name)), apart=True),
    Quantity("real angle", 1, lambda g, name: g.real(g.angle(name)), role=Role.ANGLE, apart=True),
    Quantity("smooth function", 4, lambda g, name: polynomial([g.real(g.number(name, i)) for i in range(4)])),
    Quantity("real vector", 3, lambda g, name: g.vector(name).map(g.real), role=Role.VECTOR, apart=True),
    Quantity("rotation", 3, lambda g, name: rotation(g.turn(name)).map(g.real), role=Role.TURN),
    Quantity("real tensor", apart=True), Quantity("real quaternion", apart=True),
)  # fmt: skip

_NUMBERS = (
    Quantity("dual number", 1, lambda g, name: g.number(name)),
    Quantity("argument", 1, lambda g, name: g.number(name, at=g.every and g.every.X)),
    Quantity("scale", 1, lambda g, name: g.number(name, at=g.every and g.every.scale)),
    Quantity("angle", 1, lambda g, name: g.angle(name), role=Role.ANGLE),
)

_STRUCTURES = (
    Quantity("dual vector", 3, lambda g, name: g.vector(name), role=Role.VECTOR),
    Quantity("unit vector", 2, lambda g, name: g.unit(name)),
    Quantity("quaternion", 4, lambda g, name: Quaternion(g.number(name, 3), g.vector(name)), role=Role.VECTOR),
    Quantity("unit quaternion", 3, lambda g, name: g.turn(name), role=Role.TURN),
    Quantity("tensor", 9, lambda g, name: Tensor.from_entries(g.number(name, i) for i in range(9)), role=Role.TENSOR),
    Quantity("orthogonal tensor", 3, lambda g, name: rotation(g.turn(name)), role=Role.TURN),
    Quantity("line", apart=True), Quantity("pose"),
)  # fmt: skip

_DEFINED = (
    Quantity("number"), Quantity("function"), Quantity("function of parts", apart=True), Quantity("map"), PROPOSITION,
)
"""Quantities that need a definition; a number may be real or dual."""

_CONSTANT = (
    Quantity("dual unit", value=lambda field: Dual(0, 1), apart=True, varies=False),
    Quantity("identity", value=lambda field: Tensor.identity(), varies=False),
    Quantity("π", value=lambda field: field.pi, varies=False),
    Quantity("∞", varies=False),
    Quantity("words", value=lambda field: None, varies=False),
    Quantity("index", varies=False),
)
"""Constants; an index is bound by its operator."""

QUANTITIES: dict[str, Quantity] = {
    row.name: row for row in (ORDER, BRANCH, SIGN, *_REAL, *_NUMBERS, *_STRUCTURES, *_DEFINED, *_CONSTANT)
}
