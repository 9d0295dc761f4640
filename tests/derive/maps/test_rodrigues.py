"""Cayley formula and Rodrigues vector of K10 against each other and against the screw."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest

from derive.algebra import Dual, Tensor, Vector
from derive.maps import closed_forms, rodrigues
from derive.maps.pose import Screw, tensor_from_screw


def screw(angle: float, distance: float) -> Screw:
    u = Vector(mpmath.mpf(2), mpmath.mpf(-3), mpmath.mpf(6)) / 7
    return Screw(Dual(mpmath.mpf(angle), mpmath.mpf(distance)), Vector.dual(u, Vector(1, 4, -2).cross(u)))


def test_closed_forms_are_exact_on_fractions(draw_exact) -> None:
    b = draw_exact()
    A = rodrigues.cayley_formula(b)
    assert list(A @ A.transpose) == list(Tensor.identity())
    assert list(rodrigues.cayley_matrix(A)) == list(Tensor.skew(b))
    assert list(rodrigues.rodrigues_vector(A)) == list(b)
    assert list(A) == list(closed_forms.tensor(1, b.dot(b)).tensor(b))


@pytest.mark.parametrize("angle", [0.7, 2.9, -1.1, 4.5])
def test_vector_is_the_tangent_of_half_the_angle_along_the_axis(angle: float, gap) -> None:
    motion = screw(angle, 0.4)
    b = rodrigues.rodrigues_vector(tensor_from_screw(motion))
    half = motion.angle / 2
    tangent = half.apply(mpmath.tan, lambda a: 1 + mpmath.tan(a) ** 2)
    assert gap(b, motion.axis * tangent) < 1e-45


def test_direction_is_the_axis_up_to_a_half_turn_and_opposite_beyond(gap) -> None:
    for angle, sign in ((2.0, 1), (4.0, -1)):
        motion = screw(angle, -1.5)
        s = rodrigues.direction(rodrigues.rodrigues_vector(tensor_from_screw(motion)))
        assert gap(s, motion.axis * sign) < 1e-45


def test_half_turns_have_no_matrix() -> None:
    half_turn = Tensor(((1, 0, 0), (0, -1, 0), (0, 0, -1))).map(Fraction)
    with pytest.raises(ZeroDivisionError):
        rodrigues.cayley_matrix(half_turn)
    with pytest.raises(ZeroDivisionError):
        rodrigues.rodrigues_vector(half_turn)
