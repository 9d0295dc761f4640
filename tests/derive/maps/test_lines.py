"""Lines as unit dual vectors, and the distance between lines."""

from __future__ import annotations

import mpmath

from derive.algebra import Vector
from derive.maps import lines

X, Y = Vector(mpmath.mpf(1), mpmath.mpf(0), mpmath.mpf(0)), Vector(mpmath.mpf(0), mpmath.mpf(1), mpmath.mpf(0))


def test_foot_is_the_nearest_point_of_the_line(gap) -> None:
    line = lines.line_through(Vector(5, 2, -3), X)
    assert gap(lines.foot(line), Vector(0, 2, -3)) == 0
    assert line.re.dot(line.du) == 0


def test_distance_of_skew_lines_is_along_their_common_normal() -> None:
    a, b = lines.line_through(Vector(7, 0, 2), X), lines.line_through(Vector(0, -4, 5), Y)
    assert lines.distance(a, b) == lines.distance(b, a) == 3


def test_distance_of_parallels_of_either_orientation() -> None:
    a, b = lines.line_through(Vector(1, 0, 0), X), lines.line_through(Vector(9, 3, 4), X)
    assert lines.distance_of_parallels(a, b) == 5
    assert lines.distance_of_parallels(a, -b) == 5


def test_distance_does_not_depend_on_the_angle_of_lines() -> None:
    slanted = Vector(mpmath.mpf(3) / 5, mpmath.mpf(4) / 5, mpmath.mpf(0))
    a, b = lines.line_through(Vector(7, 0, 2), X), lines.line_through(Vector(0, -4, 5), slanted)
    assert abs(lines.distance(a, b) - 3) < 1e-40
    assert lines.distance(b, a) == lines.distance(a, b)
