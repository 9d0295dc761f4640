"""Vectors, tensors, quaternions, and I, skew(v), v⊗v: dual parts, inverses, zero divisors, and mixed kinds."""

from __future__ import annotations

import operator
from fractions import Fraction

import pytest
import sympy
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from derive.algebra import Dual, Isotropic, Quaternion, Tensor, Vector, ZeroDivisorError
from derive.algebra.functions import sqrt
from derive.algebra.structures import MeaninglessError, add
from derive.proof import Ring

fractions = st.fractions(min_value=-5, max_value=5, max_denominator=4)
duals = st.builds(Dual, fractions, fractions)
vectors = st.builds(Vector, duals, duals, duals)
tensors = st.lists(duals, min_size=9, max_size=9).map(Tensor.from_entries)
few = settings(max_examples=8)


def test_dual_parts_of_a_vector() -> None:
    v = Vector.dual((1, 2, 3), (4, 5, 6))
    assert v.re == Vector(1, 2, 3)
    assert v.du == Vector(4, 5, 6)
    assert Vector(1, 2, 3).re == Vector(1, 2, 3)
    assert Vector(1, 2, 3).du == Vector(0, 0, 0)
    assert v.dot(v) == Dual(14, 64)
    with pytest.raises(ValueError, match="argument 2"):
        Vector.dual((1, 2), (3, 4, 5))


def test_magnitude_of_a_dual_vector_in_both_cases() -> None:
    assert Vector.dual((3, 0, 4), (1, 7, 2)).magnitude() == Dual(5.0, 2.2)
    assert Vector.dual((0, 0, 0), (3, 0, 4)).magnitude() == Dual(0, 5)
    assert Vector(3, 0, 4).magnitude() == 5
    root = Vector.dual(sympy.Matrix([1, 1, 0]), sympy.Matrix([1, 2, 5])).magnitude()
    assert root == Dual(sympy.sqrt(2), 3 / sympy.sqrt(2))


@few
@given(tensors.filter(lambda T: T.re.det() != 0))
def test_tensor_inverse(T: Tensor) -> None:
    assert T @ T.inverse() == T.inverse() @ T == Tensor.identity()


def test_singular_tensors_have_no_inverse() -> None:
    singular = Tensor.dual(Tensor.skew(Vector(1, 2, 3)), Tensor.identity())
    with pytest.raises(ZeroDivisorError, match="zero divisor"):
        singular.inverse()
    with pytest.raises(ZeroDivisionError):
        Tensor.skew(Vector(Fraction(1), Fraction(2), Fraction(3))).inverse()
    with pytest.raises(ValueError, match="9 entries, got 8"):
        Tensor.from_entries(range(8))


def test_dual_parts_of_a_tensor() -> None:
    S, T = Tensor.from_entries(range(9)), Tensor.identity()
    assert Tensor.dual(S, T).re == S
    assert Tensor.dual(S, T).du == T
    assert S[1, 2] == 5


def test_hamilton_and_zero_divisors() -> None:
    i, j, k = (Quaternion(0, Vector(*e)) for e in ((1, 0, 0), (0, 1, 0), (0, 0, 1)))
    assert i * j == k
    assert j * i == -k
    assert i * i == Quaternion(-1, Vector(0, 0, 0))
    unit = i + 2 * j + Quaternion(Fraction(2), Vector(0, 0, 0))
    assert unit * unit.inverse() == Quaternion(1, Vector(0, 0, 0))
    q = Quaternion.dual((0, 0, 0, 0), (1, 2, 3, 4))
    assert q.re == Quaternion(0, Vector(0, 0, 0))
    assert q.du == Quaternion(1, Vector(2, 3, 4))
    assert 2 * q == q * 2
    with pytest.raises(ZeroDivisorError, match="zero divisor"):
        q.inverse()


@pytest.mark.parametrize("operation", [operator.add, operator.sub, operator.mul, operator.truediv])
@pytest.mark.parametrize("left", [Vector(1, 2, 3), Tensor.identity(), Quaternion(1, Vector(1, 2, 3)), Dual(1, 2)])
@pytest.mark.parametrize("right", [Vector(1, 2, 3), Tensor.identity()])
def test_mixed_structures_are_type_errors(operation, left, right) -> None:
    if type(left) is type(right) and operation in (operator.add, operator.sub):
        return
    if isinstance(left, Dual) and operation is operator.mul:
        assert isinstance(left * right, type(right))
        return
    with pytest.raises(TypeError):
        operation(left, right)


# --- products and sums of mixed kinds ---------------------------------------------------------------------------------


def test_a_tensor_is_no_quaternion() -> None:
    with pytest.raises(MeaninglessError, match="tensor"):
        add(2, Tensor.identity())


def test_exact_numbers_take_their_own_root() -> None:
    ring = Ring()
    assert sqrt((1 + ring.x) ** 2) == 1 + ring.x


# --- algebra spanned by I, skew(v), v⊗v -------------------------------------------------------------------------------

triples = st.tuples(duals, duals, duals)


@pytest.mark.smoke
@few
@given(triples, triples, vectors, vectors)
def test_operations_match_tensors(f, g, v: Vector, w: Vector) -> None:
    x = v.dot(v)
    S, T = Isotropic(*f, x), Isotropic(*g, x)
    assert (S @ T).tensor(v) == S.tensor(v) @ T.tensor(v)
    assert S @ T == T @ S
    assert (S + T).tensor(v) == S.tensor(v) + T.tensor(v)
    assert (S - T).tensor(v) == S.tensor(v) - T.tensor(v)
    assert S.transpose.tensor(v) == S.tensor(v).transpose
    assert S.det() == S.tensor(v).det()
    assert S.apply(v, w) == S.tensor(v) @ w
    assert S.tensor(v) @ v == v * S.axial
    assert (3 * S).tensor(v) == S.tensor(v) * 3
    assert (S / 3) * 3 == S


@pytest.mark.smoke
@few
@given(triples, vectors)
def test_inverse(f, v: Vector) -> None:
    S = Isotropic(*f, v.dot(v))
    assume(S.det().re != 0)
    assert S @ S.inverse() == Isotropic(1, 0, 0, S.x)
    assert S.inverse().tensor(v) == S.tensor(v).inverse()


@pytest.mark.smoke
def test_zero_divisors_and_different_vectors_are_refused() -> None:
    with pytest.raises(ZeroDivisorError, match="zero divisor"):
        Isotropic(Dual(0, 1), Dual(0, 1), Dual(1, 0), Dual(Fraction(1), 2)).inverse()
    with pytest.raises(ZeroDivisionError):
        Isotropic(Fraction(-4), Fraction(1), Fraction(1), Fraction(4)).inverse()
    with pytest.raises(ValueError, match="different vectors"):
        Isotropic(1, 2, 3, 4) @ Isotropic(1, 2, 3, 5)
    with pytest.raises(TypeError):
        Isotropic(1, 2, 3, 4) * Isotropic(1, 2, 3, 4)
