"""Composition in closed form at n = 1 and 2, and the homomorphism from quaternions to tensors."""

from __future__ import annotations

from fractions import Fraction

import pytest

from derive.algebra import Quaternion, Tensor, Vector, ZeroDivisorError
from derive.maps import closed_forms
from derive.maps.composition import compose_first_order, compose_second_order, tensor_from_quaternion

ORDERS = [1, 2, 3, 4, 5, 8]


def tensor(n: int, v: Vector) -> Tensor:
    return closed_forms.tensor(n, v.dot(v)).tensor(v)


def test_homomorphism_from_quaternions(draw, gap) -> None:
    q, r = (closed_forms.quaternion_from_vector(3, draw()) for _ in range(2))
    R = tensor_from_quaternion
    assert gap(R(q * r), R(q) @ R(r)) < 1e-44
    assert R(-q) == R(q)
    assert gap(R(q).transpose, R(q.conjugate())) < 1e-48
    assert gap(R(q) @ R(q).transpose, Tensor.identity()) < 1e-44
    v = draw()
    assert gap(R(q) @ v, q.sandwich(v)) < 1e-44


@pytest.mark.parametrize("n", ORDERS)
def test_homomorphism_agrees_with_the_closed_tensor(n: int, draw, gap) -> None:
    v = draw(1.5)
    assert gap(tensor_from_quaternion(closed_forms.quaternion_from_vector(n, v)), tensor(n, v)) < 1e-42


def test_closed_forms_are_exact_on_fractions(draw_exact) -> None:
    for _ in range(5):
        v2, v1 = draw_exact(), draw_exact()
        assert tensor(1, compose_first_order(v2, v1)) == tensor(1, v2) @ tensor(1, v1)
        assert tensor(2, compose_second_order(v2, v1)) == tensor(2, v2) @ tensor(2, v1)
        s = compose_second_order(v2, v1)
        q = closed_forms.quaternion_from_vector
        assert q(2, s) == q(2, v2) * q(2, v1)


def test_singular_compositions_raise() -> None:
    e = Vector.dual([Fraction(1), Fraction(0), Fraction(0)], [Fraction(0)] * 3)
    for closed_form in (compose_first_order, compose_second_order):
        with pytest.raises(ZeroDivisorError, match="zero divisor"):
            closed_form(e, e)


def test_opposite_quaternions_are_one_displacement() -> None:
    q = Quaternion(Fraction(3, 5), Vector(Fraction(0), Fraction(4, 5), Fraction(0)))
    assert tensor_from_quaternion(q) == tensor_from_quaternion(-q)
    assert tensor_from_quaternion(q).rows[0] == (Fraction(-7, 25), 0, Fraction(24, 25))
