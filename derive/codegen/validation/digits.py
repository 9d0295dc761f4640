"""Numbers of 50 digits which kernels take inside object arrays, and seeded cases for the maps that need them."""

from __future__ import annotations

import random
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import mpmath

from ...algebra import Dual, Vector
from ...maps import Cayley
from ...maps.inverse import vector_from_quaternion, vector_from_screw
from ...maps.pose import Screw, pose_from_tensor, quaternion_from_screw, tensor_from_screw
from .exact import Expectation

DIGITS = 50
SEED = 2011


class Decimal:
    """A real number of 50 digits: + - * / with exact partners, comparison, ``sqrt``, ``tan``, ``arctan2``."""

    __slots__ = ("value",)

    def __init__(self, value: Any) -> None:
        self.value = mpmath.mpf(value.numerator) / value.denominator if isinstance(value, int | Fraction) else value

    @staticmethod
    def _value(other: object) -> Any:
        if isinstance(other, Decimal):
            return other.value
        if isinstance(other, int | Fraction):
            return Decimal(other).value
        raise TypeError(f"a kernel mixed a 50-digit number with {type(other).__name__} {other!r}")

    def __add__(self, other: object) -> Decimal:
        return Decimal(self.value + self._value(other))

    def __sub__(self, other: object) -> Decimal:
        return Decimal(self.value - self._value(other))

    def __rsub__(self, other: object) -> Decimal:
        return Decimal(self._value(other) - self.value)

    def __mul__(self, other: object) -> Decimal:
        return Decimal(self.value * self._value(other))

    def __truediv__(self, other: object) -> Decimal:
        return Decimal(_quotient(self.value, self._value(other)))

    def __rtruediv__(self, other: object) -> Decimal:
        return Decimal(_quotient(self._value(other), self.value))

    __radd__, __rmul__ = __add__, __mul__

    def __neg__(self) -> Decimal:
        return Decimal(-self.value)

    def __lt__(self, other: object) -> bool:
        return bool(self.value < self._value(other))

    def __gt__(self, other: object) -> bool:
        return bool(self.value > self._value(other))

    def __eq__(self, other: object) -> bool:
        return bool(self.value == self._value(other))

    __hash__ = None  # type: ignore[assignment]

    def sqrt(self) -> Decimal:
        return Decimal(mpmath.sqrt(self.value))

    def tan(self) -> Decimal:
        return Decimal(mpmath.tan(self.value))

    def arctan2(self, other: object) -> Decimal:
        return Decimal(mpmath.atan2(self.value, self._value(other)))


def _quotient(a: Any, b: Any) -> Any:
    """The IEEE quotient: a selection computes both sides, and the one not taken may divide by zero."""
    if b:
        return a / b
    return a * mpmath.inf if a else mpmath.nan


def expectations(cayley: Cayley) -> Iterator[tuple[Expectation, ...]]:
    """Inverse maps, screws, shadows (at most eight branches) and composition, a batch of seeded screws each."""
    draw = random.Random(SEED)
    screws = list(_screws(draw))
    others = [*screws[1:], screws[0]]
    n = cayley.order
    yield from zip(*(_principal(n, *pair) for pair in zip(screws, others, strict=True)), strict=True)
    for branch in range(min(n, 8)):
        # the vector of a translation has its pole at half a turn
        finite = [screw for screw in screws if screw.angle.re or 2 * branch != n]
        yield from zip(*(_branch(n, screw, branch) for screw in finite), strict=True)


def _principal(n: int, screw: Screw, other: Screw) -> Iterator[Expectation]:
    principal = vector_from_screw(n, screw)
    dual_angle = (screw.angle.re, screw.angle.du)
    axis = (*screw.axis.re, *screw.axis.du)
    yield Expectation("from_screw", (dual_angle, axis), _flat(principal))
    q = quaternion_from_screw(screw)
    yield Expectation("from_quaternion", (tuple(-c for c in (*q.re, *q.du)),), _flat(principal))
    yield Expectation("to_screw", (_flat(principal),), (*dual_angle, *axis))
    product = quaternion_from_screw(other) * q
    vectors = (_flat(vector_from_screw(n, other)), _flat(principal))
    yield Expectation("compose", vectors, _flat(vector_from_quaternion(n, product)))


def _branch(n: int, screw: Screw, branch: int) -> Iterator[Expectation]:
    principal, v = _flat(vector_from_screw(n, screw)), _flat(vector_from_screw(n, screw, branch))
    q = quaternion_from_screw(screw)
    R = tensor_from_screw(screw)
    pose = pose_from_tensor(R)
    Q, rho = pose.rotation, tuple(pose.displacement)
    rows = [entry for i in range(3) for entry in (Q[i, 0], Q[i, 1], Q[i, 2], rho[i])]
    k = f" {branch}"
    yield Expectation("from_quaternion" + k, ((*q.re, *q.du),), v)
    yield Expectation("from_tensor" + k, ((*R.re, *R.du),), v)
    yield Expectation("from_pose" + k, ((*rows, 0, 0, 0, 1),), v)
    yield Expectation("shadow" + k, (principal,), v)
    yield Expectation("principal", (v,), principal)


def _screws(draw: random.Random) -> Iterator[Screw]:
    """Screws that take every side of every selection: each component of the quaternion largest, and a translation."""

    def number(low: float, high: float) -> Any:
        return mpmath.mpf(draw.uniform(low, high))

    for largest, angle in enumerate((2.6, 2.7, 2.8, 0.5)):
        u = Vector(*(number(1, 2) if i == largest else number(-1, 1) for i in range(3)))
        u = u / u.magnitude()
        point = Vector(*(number(-2, 2) for _ in range(3)))
        yield Screw(Dual(mpmath.mpf(angle), number(-2, 2)), Vector.dual(u, point.cross(u)))
    yield Screw(Dual(mpmath.mpf(0), number(1, 2)), Vector.dual(u, 0 * u))


def _flat(v: Vector) -> tuple[Any, ...]:
    return (*v.re, *v.du)
