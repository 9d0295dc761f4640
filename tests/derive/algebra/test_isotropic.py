"""Algebra spanned by I, skew(v), v⊗v: every operation on (a, b, c, x) agrees with the expanded tensors."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from derive.algebra import Dual, Isotropic, Vector, ZeroDivisorError

pytestmark = pytest.mark.smoke

fractions = st.fractions(min_value=-5, max_value=5, max_denominator=4)
duals = st.builds(Dual, fractions, fractions)
vectors = st.builds(Vector, duals, duals, duals)
triples = st.tuples(duals, duals, duals)
few = settings(max_examples=15, deadline=None)


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


@few
@given(triples, vectors)
def test_inverse(f, v: Vector) -> None:
    S = Isotropic(*f, v.dot(v))
    assume(S.det().re != 0)
    assert S @ S.inverse() == Isotropic(1, 0, 0, S.x)
    assert S.inverse().tensor(v) == S.tensor(v).inverse()


def test_inverse_over_the_rational_functions() -> None:
    *_, a, b, c, x = sympy.field("a b c x", sympy.QQ)
    S = Isotropic(a, b, c, x)
    assert (S @ S.inverse()).coefficients == (1, 0, 0)
    assert S.inverse().inverse() == S


def test_skew_generates_the_algebra() -> None:
    x = sympy.ring("x", sympy.ZZ)[1]
    skew = Isotropic(0, 1, 0, x)
    assert skew @ skew == Isotropic(-x, 0, 1, x)
    assert skew @ skew @ skew == skew * -x


def test_zero_divisors_and_different_vectors_are_refused() -> None:
    with pytest.raises(ZeroDivisorError, match="zero divisor"):
        Isotropic(Dual(0, 1), Dual(0, 1), Dual(1, 0), Dual(Fraction(1), 2)).inverse()
    with pytest.raises(ZeroDivisionError):
        Isotropic(Fraction(-4), Fraction(1), Fraction(1), Fraction(4)).inverse()
    with pytest.raises(ValueError, match="different vectors"):
        Isotropic(1, 2, 3, 4) @ Isotropic(1, 2, 3, 5)
    with pytest.raises(TypeError):
        Isotropic(1, 2, 3, 4) * Isotropic(1, 2, 3, 4)
