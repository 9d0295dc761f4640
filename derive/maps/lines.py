r"""Oriented lines as unit dual vectors: Study's mapping, and the distance between two lines.

The line through the point p with unit direction a is ``a + ε p × a`` (direction, moment about the origin). The
functions take any real coefficients; `library` provides their ``sqrt``.
"""

from __future__ import annotations

from typing import Any

from ..algebra import Coefficient, Vector, functions


def line_through(point: Vector, direction: Vector) -> Vector:
    """Return the line through a point along a unit direction, ``a + ε p × a``."""
    return Vector.dual(direction, point.cross(direction))


def foot(line: Vector) -> Vector:
    """Return the point of the line that is nearest to the origin, ``a × a*``."""
    return line.re.cross(line.du)


def distance(a: Vector, b: Vector, library: Any = functions) -> Coefficient:
    """Return the shortest distance between two lines that are not parallel, ``|(q − p)·(a × b)| / |a × b|``."""
    normal = a.re.cross(b.re)
    return abs((foot(b) - foot(a)).dot(normal)) / library.sqrt(normal.dot(normal))


def distance_of_parallels(a: Vector, b: Vector, library: Any = functions) -> Coefficient:
    """Return the distance between two parallel lines of either orientation, ``|(q − p) × a|``."""
    across = (foot(b) - foot(a)).cross(a.re)
    return library.sqrt(across.dot(across))
