"""Tangent operators and exponential maps from first principles; singular compositions."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import mpmath
import pytest

from derive.algebra import Dual, Quaternion, Vector, ZeroDivisorError, first_principles
from derive.algebra.first_principles import quaternion_exponential, tensor_exponential
from derive.maps import cayley_scalars
from derive.proof import evaluation

pytestmark = pytest.mark.usefixtures("fifty_digits")

TINY = mpmath.mpf(10) ** -40
Gap = Callable[[object, object], Any]
Draw = Callable[..., Vector]


@pytest.mark.parametrize("real", [False, True])
@pytest.mark.parametrize("n", [1, 2, 5])
def test_tangent_operators_are_differentials(n: int, real: bool, draw: Draw, gap: Gap) -> None:
    v = draw().re if real else draw()
    found = first_principles.tangent(lambda at: cayley_scalars.tensor(n, at.dot(at)).tensor(at), v)
    assert gap(found, cayley_scalars.tangent(n, v.dot(v)).tensor(v)) < TINY


@pytest.mark.parametrize("size", [0, 1])
def test_exponentials_of_quaternions_turn_by_twice_the_vector(size: int, draw: Draw, gap: Gap) -> None:
    v = draw()
    a = Vector.dual(v.re * size, v.du)
    q = quaternion_exponential(a)
    assert gap(first_principles.tensor_by_sandwich(q), tensor_exponential(a * 2)) < TINY
    assert gap(q * q.conjugate(), Quaternion(Dual(1, 0), a * 0)) < TINY
    assert gap(tensor_exponential(a) @ tensor_exponential(a), tensor_exponential(a * 2)) < TINY
    assert gap(q * q, quaternion_exponential(a * 2)) < TINY


@pytest.mark.parametrize("depth", [1, 2, 3, 4])
def test_exponentials_at_rest_have_dual_parts_and_rates(depth: int) -> None:
    """Expect exp(a) exp(a) = exp(2a) exactly where the number inside each coefficient is 0."""

    def coefficient(place: int, depth: int) -> Any:
        if not depth:
            return Fraction(place)
        return Dual(coefficient(place, depth - 1), coefficient(7 * place + depth, depth - 1))

    a = Vector(*(coefficient(place, depth) - place for place in (1, 2, 3)))
    q, R = quaternion_exponential(a), tensor_exponential(a)
    assert tuple(q * q) == tuple(quaternion_exponential(a * 2))
    assert tuple(R @ R) == tuple(tensor_exponential(a * 2)) == tuple(first_principles.tensor_by_sandwich(q))


def test_singular_compositions_raise() -> None:
    e = Vector.dual([Fraction(1), Fraction(0), Fraction(0)], [Fraction(0)] * 3)
    for closed_form in (evaluation.compose_first_order, evaluation.compose_second_order):
        with pytest.raises(ZeroDivisorError, match="zero divisor"):
            closed_form(e, e)
