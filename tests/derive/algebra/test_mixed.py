from __future__ import annotations

import pytest

from derive.algebra import Quaternion, Tensor, Vector
from derive.algebra.functions import sqrt
from derive.algebra.mixed import MeaninglessError, add, multiply, quaternion
from derive.proof import Ring

A, B = Vector(1, 2, 3), Vector(-1, 0, 4)


def test_a_number_and_a_vector_make_a_quaternion() -> None:
    assert add(2, A) == add(A, 2) == Quaternion(2, A)
    assert add(A, B) == A + B
    assert add(2, 3) == 5
    assert quaternion(A) == Quaternion(0, A)


def test_products() -> None:
    assert multiply(A, B) == Quaternion(-A.dot(B), A.cross(B))
    assert multiply(2, A) == multiply(A, 2) == A * 2
    assert multiply(Tensor.skew(A), B) == A.cross(B)
    assert multiply(Tensor.skew(A), Tensor.identity()) == Tensor.skew(A)


def test_a_tensor_is_no_quaternion() -> None:
    with pytest.raises(MeaninglessError, match="tensor"):
        add(2, Tensor.identity())


def test_exact_numbers_take_their_own_root() -> None:
    ring = Ring()
    assert sqrt((1 + ring.x) ** 2) == 1 + ring.x
