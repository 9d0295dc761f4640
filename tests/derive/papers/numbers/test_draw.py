"""Seeded draws: numbers away from 0, unit vectors, unit quaternions, functions with derivatives."""

from __future__ import annotations

from itertools import product

import mpmath
import pytest

from derive.algebra import Dual
from derive.papers.numbers.draw import Draw, polynomial, sphere
from derive.papers.numbers.fields import FIELD_DIGITS, Decimal60
from derive.papers.numbers.quantities import QUANTITIES

FIELD = Decimal60()


SEEDED = ["-0.8848645", "0.8416006", "0.53936883", "0.6785535"]
"""First numbers of a seed; published counterexamples depend on them."""


@pytest.fixture(autouse=True)
def _digits():
    with mpmath.workdps(FIELD_DIGITS):
        yield


def test_seed_determines_the_numbers() -> None:
    draw = Draw("a")
    assert [mpmath.nstr(draw.signed(), 8) for _ in range(4)] == SEEDED


def test_numbers_are_away_from_zero() -> None:
    draw = Draw("range")
    assert all(0.2 <= draw.real() <= 0.9 for _ in range(100))
    assert all(3 <= draw.real(3, 4) <= 4 for _ in range(100))
    signed = [draw.signed() for _ in range(100)]
    assert {mpmath.sign(a) for a in signed} == {-1, 1}
    assert all(0.2 <= abs(a) <= 0.9 for a in signed)


def test_numbers_have_as_many_decimals_as_asked_for() -> None:
    draw = Draw("digits", digits=2)
    for a in (draw.real(), draw.real(), draw.signed()):
        assert a * 100 == round(float(a * 100))
    assert Draw("digits").real() * 10**30 % 1 == 0
    assert Draw("digits").real() * 10**20 % 1 != 0


@pytest.mark.parametrize("moving", [False, True])
def test_layout_of_parts(moving: bool) -> None:
    draw = Draw("parts", moving)
    vector = draw.still((1, 2, 3), (4, 5, 6))
    other = draw.vector((1, 2, 3), (4, 5, 6))
    number = draw.number(7, 8)
    if moving:
        assert all(part.du == 0 for c in vector for part in (c.re, c.du))
        assert all(part.du != 0 for c in (*other, number) for part in (c.re, c.du))
        now = [Dual(c.re.re, c.du.re) for c in (*vector, *other, number)]
    else:
        now = [*vector, *other, number]
    expected = [Dual(1, 4), Dual(2, 5), Dual(3, 6)]
    assert now == [*expected, *expected, Dual(7, 8)]


def test_parts_not_given_are_drawn() -> None:
    draw = Draw("rest")
    assert all(c.re != 0 != c.du for c in draw.vector())
    assert [c.re for c in draw.vector(re=(1, 2, 3))] == [1, 2, 3]
    assert [c.du for c in draw.vector(du=(1, 2, 3))] == [1, 2, 3]
    assert draw.number(0).du != 0
    assert draw.number(1, 0).du == 0


def test_projected_points_lie_on_the_sphere() -> None:
    numbers = [Dual(mpmath.mpf(re), mpmath.mpf(du)) for re, du in (("2", "5"), ("0.3", "-1"), ("0", "1"))]
    for s, t in product(numbers, repeat=2):
        u = sphere(s, t)
        square = u.dot(u)
        assert FIELD.same(square.re, 1)
        assert FIELD.same(square.du, 0)
        for side, c in ((s, u.c1), (t, u.c2)):  # stereographic projection from (0, 0, −1)
            assert FIELD.same((side * (1 + u.c3) - c).re, 0)
            assert FIELD.same((side * (1 + u.c3) - c).du, 0)


@pytest.mark.parametrize("half", ["0.3", "1.3", "2.9"])
def test_quaternions_have_the_half_angle_asked_for(half: str) -> None:
    q = Draw(half).quaternion(mpmath.mpf(half))
    assert FIELD.same(q.scalar.re, mpmath.cos(mpmath.mpf(half)))
    assert FIELD.same(q.vector.re.dot(q.vector.re), mpmath.sin(mpmath.mpf(half)) ** 2)
    assert all(FIELD.same(a, b) for a, b in ((q.norm2().re, 1), (q.norm2().du, 0)))


# ---- functions -------------------------------------------------------------------------------------------------------


def test_polynomials_have_these_values() -> None:
    f = polynomial([1, 2, 3])
    assert [f(a) for a in (0, 1, 2, -1)] == [1, 6, 17, 2]
    assert [f.derivative(a) for a in (0, 1, 2, -1)] == [2, 8, 14, -4]


@pytest.mark.parametrize("a", ["-1.5", "0", "0.7", "1.9"])
def test_series_is_the_exponential(a: str) -> None:
    f, at = QUANTITIES["smooth function"].special["exponential"](Draw("f")), mpmath.mpf(a)
    assert FIELD.same(f(at), mpmath.exp(at))
    assert FIELD.same(f.derivative(at), mpmath.exp(at))


@pytest.mark.parametrize("name", ["generic", *QUANTITIES["smooth function"].special])
def test_derivatives_match_the_function(name: str) -> None:
    quantity = QUANTITIES["smooth function"]
    f = {"generic": quantity.generic, **quantity.special}[name](Draw("f"))
    for a in (mpmath.mpf("0.7"), mpmath.mpf("-1.2")):
        assert FIELD.same(f(Dual(a, mpmath.mpf(2))).du, 2 * f.derivative(a))
        assert FIELD.same(f(Dual(a, mpmath.mpf(2))).re, f(a))
