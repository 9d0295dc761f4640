"""Seeded screws on which kernels take every side of every selection.

The quaternion of a rotation matrix is read from one of four rows, that of its largest component. For each row there is
a screw whose quaternion has this component largest, axes of both signs among them, angles below and beyond a quarter
turn; and one where all other components are small. There every other row has lost its digits, and a wrong comparison
takes one of them.
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
    """Eight screws, two for each row; ``small`` is the size of the small components."""
    draw = Draw(source)
    for row in range(4):
        yield _screw(draw, mpmath.mpf(ANGLES[row]), _direction(draw, row))
    yield from steep(source, small)


def steep(source: random.Random, small: float, ratio: float = 3) -> Iterator[Screw]:
    """One screw for each row, whose other components are small: from one to the next they grow by ``ratio``.

    That of the first row, which hardly turns, does not move along its axis either: else its axis would be lost in it.
    """
    draw = Draw(source)
    for row in range(4):
        e = [mpmath.mpf(small) * mpmath.mpf(ratio) ** i for i in range(4)]
        e[row] = mpmath.mpf(SIGNS[row] if row else 1)
        vector = Vector(*e[1:])
        yield _screw(draw, 2 * mpmath.atan2(vector.magnitude(), e[0]), vector, pitch=2 if row else 0)


def translation(source: random.Random) -> Screw:
    """A screw without rotation; its axis passes through the origin."""
    draw = Draw(source)
    u = draw.vector(-1, 1)
    return Screw(Dual(mpmath.mpf(0), draw.number(1, 2)), Vector.dual(u / u.magnitude(), 0 * u))


def half_turns(source: random.Random) -> Iterator[Screw]:
    """Screws at half a turn: the first component of the axis which is not 0 is each of the three, of both signs."""
    draw = Draw(source)
    for axis in ((-3, 6, 2), (4, 3, 0), (3, -2, 6), (0, -3, 4), (0, 0, -1)):
        u = Vector(*map(mpmath.mpf, axis))
        yield _screw(draw, +mpmath.pi, u)


def _direction(draw: Draw, row: int) -> Vector:
    """A direction in which one component is largest, by so much that it makes its row the largest; any for row 0."""
    u = list(draw.vector(-0.5, 0.5))
    if row:
        u[row - 1] = SIGNS[row] * draw.number(1, 2)
    return Vector(*u)


def _screw(draw: Draw, angle: Any, direction: Vector, pitch: float = 2) -> Screw:
    u = direction / direction.magnitude()
    point = draw.vector(-2, 2)
    return Screw(Dual(angle, draw.number(-pitch, pitch)), Vector.dual(u, point.cross(u)))
