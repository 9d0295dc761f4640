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
CASES = 3


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
        return Decimal(self.value / self._value(other))

    def __rtruediv__(self, other: object) -> Decimal:
        return Decimal(self._value(other) / self.value)

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


def expectations(cayley: Cayley) -> Iterator[tuple[Expectation, ...]]:
    """Inverse maps, screws, shadows (at most eight branches) and composition, a batch of seeded screws each."""
    draw = random.Random(SEED)
    cases = (_expectations(cayley.order, _screw(draw), _screw(draw)) for _ in range(CASES))
    return zip(*cases, strict=True)


def _expectations(n: int, screw: Screw, other: Screw) -> Iterator[Expectation]:
    principal = vector_from_screw(n, screw)
    dual_angle = (screw.angle.re, screw.angle.du)
    axis = (*screw.axis.re, *screw.axis.du)
    yield Expectation("from_screw", (dual_angle, axis), _flat(principal))
    yield Expectation("to_screw", (_flat(principal),), (*dual_angle, *axis))
    product = quaternion_from_screw(other) * quaternion_from_screw(screw)
    vectors = (_flat(vector_from_screw(n, other)), _flat(principal))
    yield Expectation("compose", vectors, _flat(vector_from_quaternion(n, product)))
    for branch in range(min(n, 8)):
        yield from _branch(n, screw, branch)


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


def _screw(draw: random.Random) -> Screw:
    """A screw of angle in (0, pi), away from both ends."""

    def number(low: float, high: float) -> Any:
        return mpmath.mpf(draw.uniform(low, high))

    u = Vector(*(number(-1, 1) for _ in range(3)))
    u = u / u.magnitude()
    point = Vector(*(number(-2, 2) for _ in range(3)))
    return Screw(Dual(number(0.2, 2.9), number(-2, 2)), Vector.dual(u, point.cross(u)))


def _flat(v: Vector) -> tuple[Any, ...]:
    return (*v.re, *v.du)
