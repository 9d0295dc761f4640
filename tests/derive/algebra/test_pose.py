"""Poses, dual tensors, screws and lines: the isomorphism, and natural invariants for every case of the trace."""

from __future__ import annotations

import math

import mpmath
import pytest
import sympy

from derive.algebra import Dual, Tensor, Vector
from derive.algebra.first_principles import tensor_by_sandwich
from derive.algebra.pose import (
    Pose,
    Screw,
    distance,
    distance_of_parallels,
    foot,
    natural_invariants,
    pose_from_tensor,
    quaternion_from_screw,
    tensor_from_pose,
    tensor_from_screw,
)  # fmt: skip
from derive.maps import cayley_scalars

pytestmark = pytest.mark.usefixtures("fifty_digits")

S = sympy.Rational
X, Y = Vector(mpmath.mpf(1), mpmath.mpf(0), mpmath.mpf(0)), Vector(mpmath.mpf(0), mpmath.mpf(1), mpmath.mpf(0))


@pytest.fixture
def draw_pose(draw):
    def pose() -> Pose:
        v = draw()
        return Pose(cayley_scalars.tensor(1, v.re.dot(v.re)).tensor(v.re), v.du)

    return pose


def line_through(point: Vector, direction: Vector) -> Vector:
    return Vector.dual(direction, point.cross(direction))


def screw(angle, distance, direction, point) -> Screw:
    return Screw(Dual(angle, distance), line_through(Vector(*point), Vector(*direction)))


def test_isomorphism(draw_pose, gap) -> None:
    for _ in range(4):
        g, h = draw_pose(), draw_pose()
        assert gap(tensor_from_pose(g @ h), tensor_from_pose(g) @ tensor_from_pose(h)) < 1e-45
        assert gap(tensor_from_pose(g.inverse()), tensor_from_pose(g).transpose) < 1e-45
        back = pose_from_tensor(tensor_from_pose(g))
        assert gap(back.rotation, g.rotation) < 1e-45
        assert gap(back.displacement, g.displacement) < 1e-45
        point = h.displacement
        assert gap((g @ h).apply(point), g.apply(h.apply(point))) < 1e-45


def test_orthogonal_dual_tensor_moves_lines_as_the_pose_moves_points(draw_pose, gap) -> None:
    g = draw_pose()
    a, b = Vector(1, 2, 3), Vector(-2, 5, 1)
    line = Vector.dual(b - a, a.cross(b))
    moved = Vector.dual(g.apply(b) - g.apply(a), g.apply(a).cross(g.apply(b)))
    assert gap(tensor_from_pose(g) @ line, moved) < 1e-44


def test_natural_invariants_of_any_pose(draw_pose, gap) -> None:
    for _ in range(6):
        R = tensor_from_pose(draw_pose())
        found = natural_invariants(R)
        assert 0 < found.angle.re < mpmath.pi
        assert gap(found.axis.dot(found.axis), Dual(1)) < 1e-45
        assert gap(tensor_from_screw(found), R) < 1e-45
        assert gap(tensor_by_sandwich(quaternion_from_screw(found)), R) < 1e-45


def test_a_known_screw_is_found_exactly() -> None:
    given = screw(sympy.pi / 3, S(5), (S(2, 3), S(-2, 3), S(1, 3)), (S(1), S(2), S(3)))
    found = natural_invariants(tensor_from_screw(given))
    for a, b in zip((*found.axis, found.angle), (*given.axis, given.angle), strict=True):
        assert sympy.radsimp(sympy.expand(a.re - b.re)) == 0 == sympy.radsimp(sympy.expand(a.du - b.du))


@pytest.mark.parametrize("sign", [1, -1])
def test_trace_minus_one_exactly(sign: int) -> None:
    direction = [sign * S(k, 3) for k in (1, -2, 2)]
    given = screw(sympy.pi, S(4), direction, (S(1), S(1), S(0)))
    R = tensor_from_screw(given)
    assert R.re.trace() == -1
    found = natural_invariants(R)
    # both axes give R; the returned one has a positive first non-zero component
    assert found.angle == Dual(sympy.pi, sign * 4)
    assert found.axis == given.axis * sign
    assert natural_invariants(tensor_from_screw(screw(sympy.pi, 0, (0, -1, 0), (0, 0, 0)))).axis.re == Vector(0, 1, 0)


@pytest.mark.parametrize("below", [0.0, 1e-15, 1e-9, 1e-4, 0.1, 1.0, 1.5, 1.6])
def test_floats_keep_their_digits_up_to_pi(below: float) -> None:
    given = screw(math.pi - below, 2.0, (0.6, 0.0, 0.8), (1.0, 2.0, 3.0))
    found = natural_invariants(tensor_from_screw(given))
    for a, b in zip((*found.axis, found.angle), (*given.axis, given.angle), strict=True):
        assert abs(a.re - b.re) < 4e-15
        assert abs(a.du - b.du) < 2e-14


def test_trace_three() -> None:
    rho = Vector(S(2), S(-1), S(2))
    identity = Tensor.identity().map(S)
    found = natural_invariants(tensor_from_pose(Pose(identity, rho)))
    assert found == Screw(Dual(0, 3), Vector.dual((S(2, 3), S(-1, 3), S(2, 3)), (0, 0, 0)))
    with pytest.raises(ValueError, match="the identity has no axis"):
        natural_invariants(tensor_from_pose(Pose(identity, rho * 0)))


def test_foot_is_the_nearest_point_of_the_line(gap) -> None:
    line = line_through(Vector(5, 2, -3), X)
    assert gap(foot(line), Vector(0, 2, -3)) == 0
    assert line.re.dot(line.du) == 0


def test_distance_of_skew_lines_is_along_their_common_normal() -> None:
    a, b = line_through(Vector(7, 0, 2), X), line_through(Vector(0, -4, 5), Y)
    assert distance(a, b) == distance(b, a) == 3


def test_distance_of_parallels_of_either_orientation() -> None:
    a, b = line_through(Vector(1, 0, 0), X), line_through(Vector(9, 3, 4), X)
    assert distance_of_parallels(a, b) == 5
    assert distance_of_parallels(a, -b) == 5


def test_distance_does_not_depend_on_the_angle_of_lines() -> None:
    slanted = Vector(mpmath.mpf(3) / 5, mpmath.mpf(4) / 5, mpmath.mpf(0))
    a, b = line_through(Vector(7, 0, 2), X), line_through(Vector(0, -4, 5), slanted)
    assert abs(distance(a, b) - 3) < 1e-40
    assert distance(b, a) == distance(a, b)
