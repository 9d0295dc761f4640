"""Table of the quantities of symbols, with special values.

A statement holds only if it is true at generic values and at every special value of every symbol. Examples of special
values are a real part of zero, a half turn, a full turn and the identity.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from enum import Enum, auto
from typing import TYPE_CHECKING, Any

import mpmath

from ...algebra import Dual, Quaternion, Tensor, Vector
from ...maps.first_principles import tensor_by_sandwich as rotation
from .draw import Draw, Smooth, polynomial
from .fields import Field

if TYPE_CHECKING:
    from .generic import Generic

Make = Callable[[Draw], Any]


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
    draw: Make | None = None  # draws a 60-digit value that is not special; without it, symbols need a definition
    special: Mapping[str, Make] = field(default_factory=dict)  # draw values at which formulas tend to fail
    size: int = 0  # number of independent numbers in a value
    exact: Callable[[Generic, str], Any] | None = None  # returns the generic value of a symbol, given its name
    built: Callable[[Generic, str], Any] | None = None  # the same without a frame along the vectors
    role: Role | None = None
    value: Callable[[Field], Any] | None = None  # returns the value of a constant in a field
    apart: bool = False  # whether it separates real and dual parts; then exact coefficients are dual too
    varies: bool = True  # whether a symbol without a definition is free

    def generic(self, draw: Draw) -> Any:
        """Return a 60-digit value that is not special."""
        if self.draw is None:
            raise ValueError(f"a symbol that is a {self.name} has no value of its own: define it")
        return self.draw(draw)


_ZERO = (0, 0, 0)


def _angle(half_turns: int, du: Any | None = None) -> Make:
    return lambda d: d.number(half_turns * mpmath.pi, du)


def _scalar(half_turns: float) -> Make:
    return lambda d: d.scalar(half_turns * mpmath.pi)


def _half_turn(d: Draw) -> Quaternion:
    return d.quaternion(mpmath.pi / 2)


def _turn(low: float, high: float) -> Callable[[Draw], Quaternion]:
    return lambda d: d.quaternion(d.real(low, high))


_within, _beyond = _turn(0.3, 1.3), _turn(1.7, 3.0)  # a half turn


def _translation(sign: int) -> Make:
    return lambda d: Quaternion(Dual(mpmath.mpf(sign), mpmath.mpf(0)), d.still(_ZERO, d.signed3()))


ORDER = Quantity("order")
"""Order n, at the requested orders or at all orders at once."""
BRANCH = Quantity("branch")
"""Branch k = 0, 1 … n − 1."""
PROPOSITION = Quantity("proposition", apart=True)
"""Claim in words."""
SIGN = Quantity("sign", lambda d: 1, {"−": lambda d: -1})
"""Sign ±, equal on both sides of an equation."""

_REAL = (
    Quantity("real", lambda d: d.scalar(d.signed()), {"0": _scalar(0), "negative": lambda d: d.scalar(-d.real())}, 1,
             lambda g, name: g.real(g.number(name)), apart=True),
    Quantity("real angle", lambda d: d.scalar(d.real(0.3, 1.2)),
             {"0": _scalar(0), "π/2": _scalar(0.5), "π": _scalar(1),
              "beyond π": lambda d: d.scalar(d.real(3.3, 6.1)), "2π": _scalar(2),
              "negative": lambda d: d.scalar(-d.real())}, 1,
             lambda g, name: g.real(g.angle(name)), role=Role.ANGLE, apart=True),
    Quantity("smooth function", lambda d: polynomial([d.signed() for _ in range(5)]),
             {"exponential": lambda d: polynomial([1 / mpmath.factorial(k) for k in range(70)]),
              "reciprocal": lambda d: Smooth(lambda a: 1 / a, lambda a: -1 / (a * a))}, 4,
             lambda g, name: polynomial([g.real(g.number(name, i)) for i in range(4)])),
    Quantity("real vector", lambda d: Vector(*d.signed3()).map(d.scalar),
             {"0": lambda d: Vector(*map(mpmath.mpf, _ZERO)).map(d.scalar)}, 3,
             lambda g, name: g.vector(name).map(g.real), role=Role.VECTOR, apart=True),
    Quantity("rotation", lambda d: rotation(_within(d)).re.map(d.lifted),
             {"identity": lambda d: Tensor.identity(), "half turn": lambda d: rotation(_half_turn(d)).re.map(d.lifted),
              "beyond a half turn": lambda d: rotation(_beyond(d)).re.map(d.lifted)}, 3,
             lambda g, name: rotation(g.turn(name)).map(g.real), role=Role.TURN),
    Quantity("real tensor", apart=True), Quantity("real quaternion", apart=True),
)

_NUMBERS = (
    Quantity("dual number", lambda d: d.number(d.signed()),
             {"real part 0": lambda d: d.number(0), "0": lambda d: d.number(0, 0),
              "negative": lambda d: d.number(-d.real()), "real": lambda d: d.number(d.real(), 0)}, 1,
             lambda g, name: g.number(name)),
    Quantity("argument", lambda d: d.number(d.signed()),
             {"real part 0": lambda d: d.number(0), "negative": lambda d: d.number(-d.real())}, 1,
             lambda g, name: g.number(name, at=g.every and g.every.X)),
    Quantity("scale", lambda d: d.number(d.real(0.5, 2.0)), {"negative": lambda d: d.number(-d.real(0.5, 2.0))}, 1,
             lambda g, name: g.number(name, at=g.every and g.every.scale)),
    Quantity("angle", lambda d: d.number(d.real(0.3, 2.8)),
             {"0": _angle(0, 0), "real part 0": _angle(0), "real part π": _angle(1), "real part 2π": _angle(2),
              "real part 3π": _angle(3), "real part 4π": _angle(4),
              "beyond a half turn": lambda d: d.number(d.real(3.3, 6.1)),
              "negative": lambda d: d.number(-d.real(0.3, 2.8))}, 1,
             lambda g, name: g.angle(name), role=Role.ANGLE),
)

_STRUCTURES = (
    Quantity("dual vector", lambda d: d.vector(),
             {"real part 0": lambda d: d.vector(re=_ZERO), "0": lambda d: d.vector(_ZERO, _ZERO),
              "real": lambda d: d.vector(du=(0, 0, 0))}, 3, lambda g, name: g.vector(name), role=Role.VECTOR),
    Quantity("unit vector", lambda d: d.unit(), size=2, exact=lambda g, name: g.unit(name)),
    Quantity("quaternion", lambda d: Quaternion(d.number(d.signed()), d.vector()),
             {"real part 0": lambda d: Quaternion(d.number(0), d.still(_ZERO, (d.real(), d.real(), d.real())))}, 4,
             lambda g, name: Quaternion(g.number(name, 3), g.vector(name)), role=Role.VECTOR),
    Quantity("unit quaternion", _within,
             {"1": _translation(1), "−1": _translation(-1), "half turn": _half_turn, "beyond a half turn": _beyond}, 3,
             lambda g, name: g.turn(name), role=Role.TURN),
    Quantity("tensor", lambda d: Tensor.from_entries(d.number(d.signed()) for _ in range(9)),
             {"singular": lambda d: Tensor.dyad(d.vector(), d.vector())}, 9,
             lambda g, name: Tensor.from_entries(g.number(name, i) for i in range(9)), role=Role.TENSOR),
    Quantity("orthogonal tensor", lambda d: rotation(_within(d)),
             {"translation": lambda d: rotation(_translation(1)(d)),
              "identity": lambda d: Tensor.identity().map(lambda c: Dual(mpmath.mpf(c), mpmath.mpf(0))),
              "half turn": lambda d: rotation(_half_turn(d)), "beyond a half turn": lambda d: rotation(_beyond(d))}, 3,
             lambda g, name: rotation(g.turn(name)), role=Role.TURN),
    Quantity("line", apart=True), Quantity("pose"),
)

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
