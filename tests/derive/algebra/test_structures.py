"""Vectors, tensors, quaternions, and I, skew(v), v⊗v: laws of products, exact and dual, and sums of mixed kinds."""

from __future__ import annotations

import operator
from fractions import Fraction

import mpmath
import pytest
import sympy
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from derive.algebra import Dual, Isotropic, Quaternion, Tensor, Vector, ZeroDivisorError
from derive.algebra.functions import sqrt
from derive.algebra.structures import MeaninglessError, add, multiply, quaternion
from derive.proof import Ring

fractions = st.fractions(min_value=-5, max_value=5, max_denominator=4)
duals = st.builds(Dual, fractions, fractions)
vectors = st.builds(Vector, duals, duals, duals)
tensors = st.lists(duals, min_size=9, max_size=9).map(Tensor.from_entries)
quaternions = st.builds(Quaternion, duals, vectors)
few = settings(max_examples=8)


@few
@given(vectors, vectors, vectors, duals)
def test_vector_products(a: Vector, b: Vector, c: Vector, s: Dual) -> None:
    assert a.cross(b) == -b.cross(a)
    assert a.dot(b) == b.dot(a)
    assert a.dot(a.cross(b)) == 0
    assert a.cross(b.cross(c)) == b * a.dot(c) - c * a.dot(b)
    assert (s * a).dot(b) == s * a.dot(b)
    assert s * a == a * s
    assert a - b == a + -b


def test_right_handed_basis() -> None:
    e1, e2, e3 = Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)
    assert (e1.cross(e2), e2.cross(e3), e3.cross(e1)) == (e3, e1, e2)


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
@given(st.lists(fractions, min_size=6, max_size=6).filter(any))
def test_magnitude_squares_to_the_square(c: list[Fraction]) -> None:
    v = Vector.dual(map(mpmath.mpmathify, c[:3]), map(mpmath.mpmathify, c[3:]))
    residue = v.magnitude() ** 2 - v.dot(v)
    assert abs(residue.re) + abs(residue.du) < 1e-11


@few
@given(tensors, tensors, vectors, vectors)
def test_tensor_products(S: Tensor, T: Tensor, a: Vector, b: Vector) -> None:
    assert (S @ T) @ a == S @ (T @ a)
    assert (S @ T).transpose == T.transpose @ S.transpose
    assert (S @ T).trace() == (T @ S).trace()
    assert (S @ T).det() == S.det() * T.det()
    assert a.dot(T.transpose @ b) == b.dot(T @ a)
    assert S - T == S + -T
    assert (S + T) @ a == S @ a + T @ a


@few
@given(vectors, vectors, vectors, vectors)
def test_skew_dyad_vect(a: Vector, b: Vector, c: Vector, d: Vector) -> None:
    assert Tensor.skew(a) @ b == a.cross(b)
    assert Tensor.skew(a).vect() == a
    assert Tensor.dyad(a, b) @ c == a * b.dot(c)
    assert Tensor.dyad(a, b) @ Tensor.dyad(c, d) == Tensor.dyad(a, d) * b.dot(c)
    assert Tensor.dyad(a, b).trace() == a.dot(b)
    assert (Tensor.dyad(a, b) + Tensor.skew(c)).vect() == c - a.cross(b) / 2


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


@few
@given(quaternions, quaternions, quaternions, vectors)
def test_quaternion_algebra(q: Quaternion, r: Quaternion, s: Quaternion, v: Vector) -> None:
    assert (q * r) * s == q * (r * s)
    assert q * (r + s) == q * r + q * s
    assert q - r == q + -r
    assert (q * r).conjugate() == r.conjugate() * q.conjugate()
    assert q * q.conjugate() == Quaternion(q.norm2(), Vector(0, 0, 0))
    assert (q * r).norm2() == q.norm2() * r.norm2()
    assert (q * r).sandwich(v) == q.sandwich(r.sandwich(v))
    assert q.sandwich(v).dot(q.sandwich(v)) == q.norm2() ** 2 * v.dot(v)


@few
@given(quaternions.filter(lambda q: q.norm2().re != 0))
def test_quaternion_inverse(q: Quaternion) -> None:
    assert q * q.inverse() == Quaternion(1, Vector(0, 0, 0))


def test_hamilton_and_zero_divisors() -> None:
    i, j, k = (Quaternion(0, Vector(*e)) for e in ((1, 0, 0), (0, 1, 0), (0, 0, 1)))
    assert i * j == k
    assert j * i == -k
    assert i * i == Quaternion(-1, Vector(0, 0, 0))
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
def test_inverse_over_the_rational_functions() -> None:
    *_, a, b, c, x = sympy.field("a b c x", sympy.QQ)
    S = Isotropic(a, b, c, x)
    assert (S @ S.inverse()).coefficients == (1, 0, 0)
    assert S.inverse().inverse() == S


@pytest.mark.smoke
def test_skew_generates_the_algebra() -> None:
    x = sympy.ring("x", sympy.ZZ)[1]
    skew = Isotropic(0, 1, 0, x)
    assert skew @ skew == Isotropic(-x, 0, 1, x)
    assert skew @ skew @ skew == skew * -x


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
