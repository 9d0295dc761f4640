"""Table of quantities of symbols: those with coordinates (`kinds`), those that a definition gives, and constants."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum, auto
from typing import TYPE_CHECKING, Any

from ...algebra import Dual, Quaternion, Tensor
from ...algebra.first_principles import tensor_by_sandwich as rotation
from .fields import Field
from .kinds import KINDS, Kind, exact, polynomial

if TYPE_CHECKING:
    from .generic import Generic


class Role(Enum):
    """Role of a quantity in the choice of exact coordinates."""

    ANGLE = auto()  # its fractions have exact sine and cosine; on branch k the generic angle is α + 2kπ
    TURN = auto()  # displacement, given by an angle and an axis
    VECTOR = auto()  # a frame may be chosen along it; the first vector's magnitude is the tangent of an angle
    TENSOR = auto()  # has generic entries; no frame is chosen


Value = Callable[["Generic", str], Any]
"""Function that returns the generic value of a symbol, given its name."""


@dataclass(frozen=True, eq=False)
class Quantity:
    """Row of the table."""

    name: str
    size: int = 0  # number of independent numbers in a value
    exact: Value | None = None
    built: Value | None = None  # the same without a frame along the vectors
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

FRAMED: dict[str, tuple[Role | None, Value]] = {
    "real angle": (Role.ANGLE, lambda g, name: g.real(g.angle(name))),
    "angle": (Role.ANGLE, lambda g, name: g.angle(name)),
    "argument": (None, lambda g, name: g.number(name, at=g.every and g.every.X)),
    "scale": (None, lambda g, name: g.number(name, at=g.every and g.every.scale)),
    "smooth function": (None, lambda g, name: polynomial([g.real(g.number(name, i)) for i in range(4)])),
    "real vector": (Role.VECTOR, lambda g, name: g.vector(name).map(g.real)),
    "dual vector": (Role.VECTOR, lambda g, name: g.vector(name)),
    "unit vector": (None, lambda g, name: g.unit(name)),
    "quaternion": (Role.VECTOR, lambda g, name: Quaternion(g.number(name, 3), g.vector(name))),
    "unit quaternion": (Role.TURN, lambda g, name: g.turn(name)),
    "rotation": (Role.TURN, lambda g, name: rotation(g.turn(name)).map(g.real)),
    "orthogonal tensor": (Role.TURN, lambda g, name: rotation(g.turn(name))),
}
"""Roles and generic values in a frame, or with exact sines; values of other kinds are built from generic numbers."""

NOT_APART = ("smooth function", "rotation")
"""Real quantities of statements that hold for dual numbers too."""


def _row(name: str, kind: Kind) -> Quantity:
    """Return the row of a kind; a constant one that is no angle is built without a frame."""
    plain, built = name.removeprefix("constant "), exact(kind)
    role, framed = FRAMED.get(plain, (Role.TENSOR if kind.size > 1 else None, built))
    if kind.constant and role is not Role.ANGLE:
        framed = built
    apart = not kind.dual and name not in NOT_APART
    return Quantity(name, kind.size - kind.projective, framed, built, role, apart=apart)


_DEFINED = (
    Quantity("real tensor", apart=True), Quantity("real quaternion", apart=True), Quantity("line", apart=True),
    Quantity("pose"), Quantity("number"), Quantity("function"), Quantity("function of parts", apart=True),
    Quantity("map"), PROPOSITION,
)  # fmt: skip
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

_WITH_COORDINATES = (_row(name, kind) for name, kind in KINDS.items())
QUANTITIES: dict[str, Quantity] = {
    row.name: row for row in (ORDER, BRANCH, SIGN, *_WITH_COORDINATES, *_DEFINED, *_CONSTANT)
}
