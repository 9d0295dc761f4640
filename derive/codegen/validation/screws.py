"""Seeded screws on which kernels take every side of every selection.

The quaternion of a rotation matrix is read from one of four rows, that of its largest component. For each row one screw
has this component largest, with axes of both signs and angles below and beyond a quarter turn. For each row another
screw has all other components small: every other row has lost its digits there, which shows a wrong comparison.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import mpmath

from ...algebra import Dual, Vector
from ...maps.pose import Screw

ANGLES = (0.5, 1.9, 2.6, 3.0)
"""Rotation angles of the screws, by row: the scalar part is the largest component of the first quaternion only."""

SIGNS = (-1, 1, -1, 1)
"""Signs of the dominant component of the axis, by row."""


@dataclass(frozen=True, slots=True)
class Draw:
    """A seeded source of numbers."""

    source: random.Random

    def number(self, low: float, high: float) -> Any:
        return mpmath.mpf(self.source.uniform(low, high))

    def vector(self, low: float, high: float) -> Vector:
        return Vector(*(self.number(low, high) for _ in range(3)))


def covering(source: random.Random, small: float) -> Iterator[Screw]:
    """Yield eight screws, two for each row; ``small`` is the size of the small components."""
    draw = Draw(source)
    for row in range(4):
        yield _screw(draw, mpmath.mpf(ANGLES[row]), _direction(draw, row))
    yield from steep(source, small)


def steep(source: random.Random, small: float, ratio: float = 3) -> Iterator[Screw]:
    """Yield one screw for each row, whose other components are small: from one to the next they grow by ``ratio``.

    The first one hardly turns. It does not move along its axis either, or its axis would be lost in the translation.
    """
    draw = Draw(source)
    for row in range(4):
        e = [mpmath.mpf(small) * mpmath.mpf(ratio) ** i for i in range(4)]
        e[row] = mpmath.mpf(SIGNS[row] if row else 1)
        vector = Vector(*e[1:])
        yield _screw(draw, 2 * mpmath.atan2(vector.magnitude(), e[0]), vector, pitch=2 if row else 0)


def translation(source: random.Random) -> Screw:
    """Return a screw without rotation, whose axis passes through the origin."""
    draw = Draw(source)
    u = draw.vector(-1, 1)
    return Screw(Dual(mpmath.mpf(0), draw.number(1, 2)), Vector.dual(u / u.magnitude(), 0 * u))


def half_turns(source: random.Random) -> Iterator[Screw]:
    """Yield screws at half a turn; the first non-zero component of the axis is each of the three, of both signs."""
    draw = Draw(source)
    for axis in ((-3, 6, 2), (4, 3, 0), (3, -2, 6), (0, -3, 4), (0, 0, -1)):
        u = Vector(*map(mpmath.mpf, axis))
        yield _screw(draw, +mpmath.pi, u)


def _direction(draw: Draw, row: int) -> Vector:
    """Return a direction with one component so large that its row is the largest; any direction for row 0."""
    u = list(draw.vector(-0.5, 0.5))
    if row:
        u[row - 1] = SIGNS[row] * draw.number(1, 2)
    return Vector(*u)


def _screw(draw: Draw, angle: Any, direction: Vector, pitch: float = 2) -> Screw:
    u = direction / direction.magnitude()
    point = draw.vector(-2, 2)
    return Screw(Dual(angle, draw.number(-pitch, pitch)), Vector.dual(u, point.cross(u)))
