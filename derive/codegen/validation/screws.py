"""Seeded screws on which kernels take every side of every selection.

Kernels compute 4 q qᵀ from a rotation matrix, and take the row of the largest component as a multiple of q. One screw
for each row makes the row's component largest, with axes of both signs and angles below and beyond a quarter turn.
Another screw makes all other components small: the other rows lose their digits, which reveals a wrong selection.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from typing import Any

from ...algebra import Dual, Vector
from ...algebra.functions import atan2
from ...algebra.pose import Screw
from .reals import Real

ANGLES = (0.5, 1.9, 2.6, 3.0)  # rotation angles by row: only the first makes the scalar part the largest
SIGNS = (1, 1, -1, 1)  # signs of the dominant component, by row
HALF_TURN_AXES = ((-3, 6, 2), (4, 3, 0), (3, -2, 6), (0, -3, 4), (0, 0, -1))
"""Axes whose first non-zero component is the first, second or third, with different signs."""


def covering(draw: random.Random, small: float) -> Iterator[Screw]:
    """Yield eight screws, two for each row; ``small`` is the size of the small components."""
    for row in range(4):
        u = [_number(draw, -0.5, 0.5) for _ in range(3)]
        if row:
            u[row - 1] = SIGNS[row] * _number(draw, 1, 2)
        yield _screw(draw, Real(ANGLES[row]), Vector(*u))
    yield from steep(draw, small)


def steep(draw: random.Random, small: float, ratio: float = 3) -> Iterator[Screw]:
    """Yield a screw for each row: quaternion ±1 in that component, ``small · ratioⁱ`` in others, up to scale."""
    for row in range(4):
        e = [Real(small) * Real(ratio) ** i for i in range(4)]
        e[row] = Real(SIGNS[row])
        vector = Vector(*e[1:])
        # the first angle is tiny: a translation along its axis would swamp the digits of the axis
        yield _screw(draw, 2 * atan2(vector.magnitude(), e[0]), vector, pitch=2 if row else 0)


def translation(draw: random.Random) -> Screw:
    """Return a screw without rotation, whose axis passes through the origin."""
    u = Vector(*(_number(draw, -1, 1) for _ in range(3)))
    return Screw(Dual(Real(0), _number(draw, 1, 2)), Vector.dual(u / u.magnitude(), 0 * u))


def half_turns(draw: random.Random) -> Iterator[Screw]:
    for axis in HALF_TURN_AXES:
        yield _screw(draw, +Real.pi(), Vector(*map(Real, axis)))


def _screw(draw: random.Random, angle: Any, direction: Vector, pitch: float = 2) -> Screw:
    u = direction / direction.magnitude()
    point = Vector(*(_number(draw, -2, 2) for _ in range(3)))
    return Screw(Dual(angle, _number(draw, -pitch, pitch)), Vector.dual(u, point.cross(u)))


def _number(draw: random.Random, low: float, high: float) -> Any:
    return Real(draw.uniform(low, high))
