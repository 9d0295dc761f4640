"""Equality of values, and their printed components."""

from __future__ import annotations

from derive.algebra import Dual, Tensor, Vector
from derive.maps.pose import Pose
from derive.papers.explore import shown
from derive.papers.language.common_definitions import condition
from derive.papers.language.environment import Env
from derive.papers.language.values import Either, coefficients, equal
from derive.papers.numbers.fields import Decimal60

IDENTITY = Tensor(((1, 0, 0), (0, 1, 0), (0, 0, 1)))
TURNED = Tensor(((0, -1, 0), (1, 0, 0), (0, 0, 1)))


def test_poses_are_equal_by_rotation_and_by_displacement() -> None:
    field, pose = Decimal60(), Pose(IDENTITY, Vector(1, 2, 3))
    assert equal(field, pose, Pose(IDENTITY, Vector(1, 2, 3)))
    assert not equal(field, pose, Pose(IDENTITY, Vector(1, 2, 4)))
    assert not equal(field, pose, Pose(TURNED, Vector(1, 2, 3)))


def test_all_components_of_a_pose_are_shown() -> None:
    assert [float(text) for text in shown(Pose(TURNED, Vector(4, 5, 6)))] == [0, -1, 0, 1, 0, 0, 0, 0, 1, 4, 5, 6]


def test_numbers_of_a_dual_vector_have_the_real_part_first() -> None:
    v = Vector(Dual(1, 4), Dual(2, 5), Dual(3, 6))
    assert list(coefficients(v)) == [1, 2, 3, 4, 5, 6]
    assert list(coefficients(Dual(v.dot(v).re, 7))) == [14, 7]


def test_symbol_defined_by_a_condition_equals_any_value_that_satisfies_it() -> None:
    env = Env(Decimal60(), {})
    root = condition(lambda env, value, square: env.equal(value * value, square))(env, 4)
    assert all(env.equal(root, value) for value in (2, -2, Either(3, 2)))
    assert not any(env.equal(root, value) for value in (3, Either(1, 3)))
