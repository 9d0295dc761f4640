"""Kinds of letters in claims: each value is built from free real numbers, for points, exact fields and rates alike.

The numbers of a letter are its coordinates. A kind lists special coordinates, at which formulas tend to fail. A
projective kind has one coordinate too many, so that a half turn has finite ones; exact values set the first to 1.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from ...algebra import Dual, Quaternion, Tensor, Vector
from ...algebra.matrix import shaped
from .balls import Balls, precision
from .fields import Field

Numbers = Sequence[Any]
SPECIAL_BITS = 8192
"""Bits of special coordinates such as π, more than any evaluation has."""


@dataclass(frozen=True)
class Kind:
    """Row of the table: the builder of a value from `size` numbers, and how coordinates are chosen."""

    size: int
    build: Callable[[Numbers], Any]
    special: Callable[[Any], Mapping[str, Numbers]] = lambda pi: {}  # coordinates by label
    dual: bool = False
    constant: bool = False  # whether rates are 0
    invertible: bool = False  # whether the value 0 is left out
    still: bool = False  # whether coordinates have neither rates nor dual parts
    projective: bool = False
    spread: str = ""  # "positive" or "integer" coordinates
    free: str = ""  # kind without the constraint
    needs: str = ""  # the constraint, with the letter as {0}
    antipode: Callable[[Numbers], Numbers] = lambda c: tuple(-a for a in c)  # coordinates of the opposite value


def jet(value: Any, rates: Sequence[Any]) -> Any:
    """Return a number with its rates: of first order as one dual number, of second order as nested dual numbers."""
    return Dual(jet(value, rates[:-1]), jet(rates[0], rates[1:])) if rates else value


def sphere(c: Numbers) -> Vector:
    """Return the unit vector with homogeneous stereographic coordinates; (1, s, t) are all but (0, 0, −1)."""
    r, s, t = c
    square, flat = r * r, s * s + t * t
    unit: Vector = Vector(2 * r * s, 2 * r * t, square - flat) / (square + flat)
    return unit


def turned(c: Numbers) -> Tensor:
    """Return the rotation by a quaternion that need not be a unit."""
    s, a = c[0], Vector(*c[1:4])
    square, size = s * s, a.dot(a)
    R = Tensor.identity() * (square - size) + Tensor.dyad(a, a) * 2 + Tensor.skew(a) * (2 * s)
    rotation: Tensor = R / (square + size)
    return rotation


def versor(c: Numbers) -> Quaternion:
    """Return the unit quaternion ``q²/|q|²``."""
    q = Quaternion(c[0], Vector(*c[1:4]))
    unit: Quaternion = q * q / q.norm2()
    return unit


def _pose(c: Numbers) -> Any:
    rows = [(*row, d) for row, d in zip(turned(c).rows, c[4:], strict=True)]
    return shaped([*rows, (0, 0, 0, 1)])


def _numbers(pi: Any) -> dict[str, Numbers]:
    return {str(a): (Fraction(a),) for a in (0, 1, -1, 2)}


def _angles(pi: Any) -> dict[str, Numbers]:
    halves = {f"{k}*pi/2": (pi * Fraction(k, 2),) for k in (1, -1, 3)}
    return {"0": (Fraction(0),), **halves, **{f"{k}*pi": (pi * k,) for k in (1, -1, 2, -2, 3, 4, 5)}}


def _vectors(pi: Any) -> dict[str, Numbers]:
    turns = {f"magnitude {k}*pi": tuple(pi * Fraction(k * c, 3) for c in (1, -2, 2)) for k in (1, 2, 3, 4)}
    return {"0": (Fraction(0),) * 3, "along an axis": tuple(map(Fraction, (0, 0, -2))), **turns,
            "unit": tuple(Fraction(c, 3) for c in (2, 1, -2))}  # fmt: skip


def _rational(**rows: Numbers) -> Callable[[Any], Mapping[str, Numbers]]:
    found = {label.replace("_", " "): tuple(map(Fraction, row)) for label, row in rows.items()}
    return lambda pi: found


_axes = _rational(first_axis=(1, 1, 0), second_axis=(1, 0, 1), third_axis=(1, 0, 0), minus_third_axis=(0, 1, 0),
                  in_plane=(1, 0, -1))  # fmt: skip
_turns = _rational(identity=(1, 0, 0, 0), half_turn=(0, 1, -2, 2), about_an_axis=(0, 0, 0, 1), quarter=(1, 1, 0, 0),
                   beyond_a_half_turn=(-1, 1, 2, 1))  # fmt: skip
_versors = _rational(one=(1, 0, 0, 0), minus_one=(0, 1, 0, 0), half_turn=(3, 1, -2, 2), beyond=(1, 2, 1, -2))
_poses = _rational(identity=(1, 0, 0, 0, 0, 0, 0), translation=(1, 0, 0, 0, 1, 2, -1), half_turn=(0, 1, -2, 2, 1, 0, 3),
                   rotation=(2, 1, 0, -1, 0, 0, 0))  # fmt: skip
_tensors = _rational(zero=(0,) * 9, identity=(1, 0, 0, 0, 1, 0, 0, 0, 1), singular=(1, 2, 3, 2, 4, 6, -1, 0, 1),
                     symmetric=(2, 1, 0, 1, 3, -1, 0, -1, 1), skew=(0, 1, -2, -1, 0, 3, 2, -3, 0))  # fmt: skip
_quaternions = _rational(zero=(0,) * 4, one=(1, 0, 0, 0), minus_one=(-1, 0, 0, 0), vector=(0, 1, 2, -1))
_sixes = _rational(zero=(0,) * 6, second_part=(0, 0, 0, 1, -2, 1), first_part=(1, 2, -1, 0, 0, 0))


def _twists(pi: Any) -> dict[str, Numbers]:
    turns = {label: (*c, Fraction(1), Fraction(2), Fraction(-1)) for label, c in _vectors(pi).items()}
    return {**_sixes(pi), **turns}


def _opposite(c: Numbers) -> Numbers:
    r, s, t = c
    return -(s * s + t * t), r * s, r * t


_scalar = Kind(1, lambda c: c[0], _numbers)
_angle = replace(_scalar, special=_angles)
_vector = Kind(3, lambda c: Vector(*c), _vectors)
_unit = Kind(3, sphere, _axes, projective=True, free="real vector", needs="norm({0}) == 1", antipode=_opposite)
_tensor = Kind(9, Tensor.from_entries, _tensors)
_rotation = Kind(4, turned, _turns, projective=True, free="tensor 3x3", needs="{0}*transpose({0}) == I",
                 antipode=lambda c: (c[0], *(-a for a in c[1:])))  # fmt: skip
_quaternion = Kind(4, lambda c: Quaternion(c[0], Vector(*c[1:])), _quaternions)
_versor = Kind(4, versor, _versors, projective=True, free="real quaternion of a letter", needs="norm({0}) == 1",
               antipode=_rotation.antipode)  # fmt: skip
_six = Kind(6, lambda c: shaped([[a] for a in c]), _twists)

KINDS: dict[str, Kind] = {
    "real": _scalar, "real angle": _angle, "real vector": _vector, "real unit vector": _unit, "tensor 3x3": _tensor,
    "positive": replace(_scalar, spread="positive", special=_rational(one=(1,), two=(2,))),
    "integer": replace(_scalar, spread="integer", special=_rational(zero=(0,), one=(1,), minus_one=(-1,), six=(6,))),
    "rotation": _rotation, "real quaternion of a letter": _quaternion, "unit real quaternion": _versor,
    "pose 4x4": Kind(7, _pose, _poses, projective=True, antipode=lambda c: (c[0], *(-a for a in c[1:]))),
    "twist": _six, "wrench": replace(_six, special=_sixes),
    "dual number": replace(_scalar, dual=True), "angle": replace(_angle, dual=True),
    "dual vector": replace(_vector, dual=True),
    "unit vector": replace(_unit, dual=True, free="dual vector", needs="dot({0}, {0}) == 1"),
    "tensor": replace(_tensor, dual=True), "quaternion": replace(_quaternion, dual=True),
    "orthogonal tensor": replace(_rotation, dual=True, free="tensor"),
    "unit quaternion": replace(_versor, dual=True, free="quaternion", needs="{0}*conjugate({0}) == 1"),
    "scale": replace(_scalar, special=_rational(minus_one=(-1,)), dual=True, invertible=True),
}  # fmt: skip
"""Kinds by the name of a quantity."""
KINDS |= {f"constant {name}": replace(kind, constant=True) for name, kind in KINDS.items() if not kind.still}


def special(kind: Kind) -> dict[str, Numbers]:
    with precision(SPECIAL_BITS):
        return dict(kind.special(Balls().pi))


@dataclass(frozen=True, eq=False)
class Quantity:
    """Row of the table."""

    name: str
    value: Callable[[Field], Any] | None = None  # returns the value of a constant in a field
    apart: bool = False  # whether it separates real and dual parts
    varies: bool = True  # whether a symbol without a definition is free


ORDER = Quantity("order")
"""Order n, at the requested orders or at all orders at once."""
BRANCH = Quantity("branch")
"""Branch k = 0, 1 … n − 1."""
SIGN = Quantity("sign")
"""Sign ±, equal on both sides of an equation."""

_DEFINED = (Quantity("function"), Quantity("function of parts", apart=True))
"""Quantities that need a definition."""

_CONSTANT = (
    Quantity("dual unit", value=lambda field: Dual(0, 1), apart=True, varies=False),
    Quantity("identity", value=lambda field: Tensor.identity(), varies=False),
    Quantity("π", value=lambda field: field.pi, varies=False),
    Quantity("∞", varies=False),
    Quantity("words", value=lambda field: None, varies=False),
    Quantity("index", varies=False),
)
"""Constants; an index is bound by its operator."""

_WITH_COORDINATES = (Quantity(name, apart=not kind.dual and name != "rotation") for name, kind in KINDS.items())
QUANTITIES: dict[str, Quantity] = {
    row.name: row for row in (ORDER, BRANCH, SIGN, *_WITH_COORDINATES, *_DEFINED, *_CONSTANT)
}
