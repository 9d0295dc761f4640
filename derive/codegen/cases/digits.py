"""Numbers of 50 digits which kernels take inside object arrays, and seeded cases for the maps that need them."""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import Any

import mpmath

from ...algebra import Dual, Tensor, Vector
from ...algebra.functions import atan
from ...maps import Cayley
from ...maps.inverse import axis, vector_from_quaternion, vector_from_screw
from ...maps.polynomials import pair_by_squaring
from ...maps.pose import (
    Pose,
    Screw,
    pose_from_tensor,
    quaternion_from_screw,
    tensor_from_pose,
    tensor_from_screw,
)
from ...maps.sign_tests import orientation
from .exact import Expectation
from .maps_at import MAPS, MAX_BRANCHES, Flat
from .screws import covering, finite, half_turns, steep, translation

DIGITS = 50
SEED = 2011

SMALL = 1e-22
"""Small components of a quaternion: a row of the rotation's matrix that belongs to one is good to 28 digits only."""

NEAR_POLE = 1e-6
"""Cosine of half the angle of v below which its condition takes digits that are compared."""

NEAR_TIE = mpmath.mpf(10) ** -30
"""Angle between a vector and the limit of its branch."""

TOLERANCE = mpmath.mpf(10) ** -32
"""Of 50-digit results: 40-digit constants lose at most six digits to the conditioning of the seeded cases."""


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

    def __repr__(self) -> str:
        return str(mpmath.nstr(self.value, DIGITS))

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
    """Inverse maps, screws, shadows (at most eight branches) and composition: a batch for each function and branch."""
    batches: dict[str, list[Expectation]] = {}
    for case in _cases(cayley.order, random.Random(SEED)):
        batches.setdefault(case.function, []).append(case)
    yield from map(tuple, batches.values())


def _cases(n: int, draw: random.Random) -> Iterator[Expectation]:
    """The principal branch takes all screws and exact half turns, every other one some of them."""
    screws, halves = list(covering(draw, SMALL)), list(half_turns(draw))
    still, other_still = translation(draw), translation(draw)
    given = [screw for screw in (*screws, still, other_still) if finite(n, screw, 0, NEAR_POLE)]
    for screw, other in zip(given, [*given[1:], given[0]], strict=True):
        yield from _principal(n, screw, other)
    for branch in range(min(n, MAX_BRANCHES)):
        some = [screws[3 * branch % 8]] if branch else [*screws, still]
        # a translation on another branch has q = 0 but for rounding: there nothing decides about its axis
        for screw in (*some, still) if branch else some:
            if finite(n, screw, branch, NEAR_POLE):
                yield from _branch(n, screw, branch)
                yield from _back(n, screw, branch) if screw in some else ()
        yield from at_half_turns(n, halves, branch)
    for screw in steep(draw, SMALL, 1 / 3):
        if finite(n, screw, 0, NEAR_POLE):
            yield from _from_rotation(tensor_from_screw(screw), 0, _flat(vector_from_screw(n, screw)))
    yield from undecided(n)
    yield from _near_ties(n, screws[0])


def _principal(n: int, screw: Screw, other: Screw) -> Iterator[Expectation]:
    principal = vector_from_screw(n, screw)
    yield Expectation("from_screw", ((screw.angle.re, screw.angle.du), _flat(screw.axis)), _flat(principal))
    q = quaternion_from_screw(screw)
    yield Expectation("from_quaternion", (tuple(-c for c in (*q.re, *q.du)),), _flat(principal))
    product = quaternion_from_screw(other) * q
    vectors = (_flat(vector_from_screw(n, other)), _flat(principal))
    yield Expectation("compose", vectors, _flat(vector_from_quaternion(n, product)))


def _back(n: int, screw: Screw, branch: int) -> Iterator[Expectation]:
    """From other branches, where the axis may be the opposite of v, to the screw and the principal v."""
    v = _flat(vector_from_screw(n, screw, branch))
    yield Expectation("to_screw", (v,), (screw.angle.re, screw.angle.du, *_flat(screw.axis)))
    yield Expectation(f"shadow {n - branch}", (v,), _flat(vector_from_screw(n, screw)))


def _branch(n: int, screw: Screw, branch: int) -> Iterator[Expectation]:
    v = _flat(vector_from_screw(n, screw, branch))
    q = quaternion_from_screw(screw)
    yield Expectation(f"from_quaternion {branch}", ((*q.re, *q.du),), v)
    yield from _from_rotation(tensor_from_screw(screw), branch, v)
    principal = _flat(vector_from_screw(n, screw))
    yield Expectation(f"shadow {branch}", (principal,), v)
    yield Expectation("principal", (v,), principal)


def _from_rotation(R: Tensor, branch: int, v: Flat) -> Iterator[Expectation]:
    pose = pose_from_tensor(R)
    Q, rho = pose.rotation, tuple(pose.displacement)
    rows = [entry for i in range(3) for entry in (Q[i, 0], Q[i, 1], Q[i, 2], rho[i])]
    yield Expectation(f"from_tensor {branch}", ((*R.re, *R.du),), v)
    yield Expectation(f"from_pose {branch}", ((*rows, 0, 0, 0, 1),), v)


def at_half_turns(n: int, screws: Sequence[Screw], branch: int) -> Iterator[Expectation]:
    """At all of these half turns on the principal branch, at one of them on others."""
    for screw in [screws[branch % len(screws)]] if branch else screws:
        if finite(n, screw, branch, NEAR_POLE):
            yield from _half_turn(n, screw, branch)


def _half_turn(n: int, screw: Screw, branch: int) -> Iterator[Expectation]:
    """At exactly half a turn u and -u are one rotation: the vector part stands, or its first component is positive.

    The scalar part is exactly 0, the rotation exactly symmetric.
    """
    u, moment, d = screw.axis.re, screw.axis.du, screw.angle.du
    opposite = Screw(Dual(screw.angle.re, -d), -screw.axis)
    for sign, same in ((1, screw), (-1, opposite)):
        q = tuple(sign * c for c in (0, *u, -d / 2, *moment))
        yield Expectation(f"from_quaternion {branch}", (q,), _flat(vector_from_screw(n, same, branch)))
    R = tensor_from_pose(Pose(Tensor.dyad(u, u) * 2 - Tensor.identity(), d * u + 2 * u.cross(moment)))
    positive = screw if orientation(*u) > 0 else opposite
    yield from _from_rotation(R, branch, _flat(vector_from_screw(n, positive, branch)))


def _near_ties(n: int, screw: Screw) -> Iterator[Expectation]:
    """Vectors just before and behind the angles (2k − 1)π between branches, to the digits of the printed limits."""
    for k in range(1, n // 2 + 1):
        for behind, step in enumerate((-NEAR_TIE, NEAR_TIE)):
            alpha = (2 * k - 1) * mpmath.pi + step
            angles = (alpha, alpha - 2 * (k - 1 + behind) * mpmath.pi)
            ends = (Screw(Dual(angle, screw.angle.du), screw.axis) for angle in angles)
            v, principal = (_flat(vector_from_screw(n, end)) for end in ends)
            yield Expectation("principal", (v,), principal)


def undecided(n: int) -> Iterator[Expectation]:
    """Vectors with p = 0 or q = 0 exactly, half a turn or none: v itself or its dual part decides about the axis."""
    for square, direction in ((1, (1, 0, 0)), (1, (0, -1, 0)), (3, (1, 1, 1)), (3, (-1, 1, -1))):
        p, q = pair_by_squaring(n, square)
        re = Vector(*map(mpmath.mpf, direction))
        for along in (1, -1) if p * q == 0 else ():
            v = Vector.dual(re, along * re + re.cross(Vector(1, 2, 3)))
            u, r = axis(n, v)
            angle = (mpmath.pi if p == 0 else 0, (2 * n * atan(r)).du)
            yield Expectation("to_screw", (_flat(v),), (*angle, *_flat(u)))
            # at odd multiples of half a turn beyond the first either side is a principal v
            if q == 0 or abs(2 * n * atan(r).re) < mpmath.pi + NEAR_TIE:
                yield Expectation("principal", (_flat(v),), MAPS["principal"](n, 0, _flat(v)))
            for branch in range(1, min(n, MAX_BRANCHES)):
                turn = branch * mpmath.pi / n
                if abs(mpmath.cos(turn) - r.re * mpmath.sin(turn)) > NEAR_POLE:
                    yield Expectation(f"shadow {branch}", (_flat(v),), MAPS["shadow"](n, branch, _flat(v)))


def close(got: Any, expected: Any) -> bool:
    """Whether a result of 50-digit numbers is the expected one."""
    value = got.value if isinstance(got, Decimal) else Decimal(got).value
    return bool(abs(value - expected) <= TOLERANCE * (1 + abs(expected)))


def _flat(v: Vector) -> tuple[Any, ...]:
    return (*v.re, *v.du)
