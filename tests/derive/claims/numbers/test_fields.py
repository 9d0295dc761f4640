"""Both fields in which formulas are evaluated: balls and rational numbers."""

from __future__ import annotations

from fractions import Fraction

import pytest

from derive.algebra import Dual, Quaternion, Tensor, Vector, ZeroDivisorError
from derive.algebra.element import NotExactError
from derive.claims.numbers.balls import Ball, Balls, arb, precision
from derive.claims.numbers.fields import Exact, Field, UndefinedError, integer_power
from derive.claims.numbers.kinds import versor

pytestmark = pytest.mark.smoke


def ball(number: str) -> Ball:
    """Return a decimal number or fraction as a ball."""
    return Ball(arb(Fraction(number)))


def unit() -> Quaternion:
    """Return a unit dual quaternion."""
    parts = (("1", "3"), ("1/2", "1"), ("-1/3", "2"), ("1", "1/5"))
    return versor([Dual(ball(re), ball(du)) for re, du in parts])


def test_roots_of_squares_are_exact_and_others_refused() -> None:
    exact = Exact()
    assert exact.same(exact.sqrt(Fraction(9, 4)), Fraction(3, 2))
    with pytest.raises(NotExactError, match="not a perfect square"):
        exact.sqrt(Fraction(9, 2))


@pytest.mark.parametrize("exponent", range(6))
def test_integer_powers(exponent: int) -> None:
    tensor = Tensor(((1, 2, 0), (0, 1, 3), (4, 0, 1)))
    expected = Tensor.identity()
    for _ in range(exponent):
        expected = expected @ tensor
    assert integer_power(tensor, exponent) == expected


def test_balls_refuse_undefined_values() -> None:
    field = Balls()
    with pytest.raises(UndefinedError):
        field.sqrt(ball("-1"))
    with pytest.raises(ZeroDivisorError):
        field.sqrt(Dual(ball("0"), ball("1")))
    with pytest.raises(UndefinedError):
        field.atan2(ball("0"), ball("0"))


def test_roots_of_quaternions_are_principal() -> None:
    with precision(256):
        field = Balls()
        q = unit()
        half = field.power(q, Fraction(1, 2))
        assert all(field.same(a.re, b.re) and field.same(a.du, b.du) for a, b in zip(half * half, q, strict=True))
        assert half.scalar.re > 0


def test_vectors_beside_numbers_make_quaternions() -> None:
    field = Balls()
    assert field.power(Vector(1, 2, 3), 2) == Quaternion(-14, Vector(0, 0, 0))


# ---- functions that fields provide or refuse -------------------------------------------------------------------------

ZEROS = {"0": ball("0"), "ε": Dual(ball("0"), ball("1")), "vector": Vector(0, 0, 0),
         "tensor": Tensor.dyad(Vector(1, 2, 3), Vector(1, 0, 0)),
         "quaternion": Quaternion(0, Vector(0, 0, 0))}  # fmt: skip


class Bare(Field):
    """Field without functions."""


@pytest.mark.parametrize("exponent", [-1, -2, Fraction(-3)])
@pytest.mark.parametrize("base", ZEROS.values(), ids=ZEROS)
def test_zero_divisors_have_no_negative_power(base, exponent) -> None:
    with pytest.raises(UndefinedError, match="the inverse of a zero divisor"):
        Balls().power(base, exponent)
    assert Balls().power(base, 1) is not None


@pytest.mark.parametrize(
    ("call", "what"),
    [(lambda f: f.sin(1), "the function sin"), (lambda f: f.cos(1), "the function cos"),
     (lambda f: f.exp(1), "the function exp"), (lambda f: f.log(1), "the function log"),
     (lambda f: f.atan(1), "the function atan2"), (lambda f: f.atan2(1, 1), "the function atan2"),
     (lambda f: f.sqrt(1), "the function sqrt"), (lambda f: f.pi, "π"),
     (lambda f: f.power(2, Fraction(1, 3)), "the function log"),
     (lambda f: f.power(2, "n"), "a power with this exponent")],
)  # fmt: skip
def test_missing_functions_are_refused(call, what: str) -> None:
    with pytest.raises(NotExactError, match=f"^{what}"):
        call(Bare())


@pytest.mark.parametrize("exponent", [Fraction(1, 3), Fraction(2, 3), Fraction(3, 2), Fraction(-1, 2), Fraction(5, 4)])
def test_rational_powers_of_quaternions(exponent: Fraction) -> None:
    with precision(256):
        field, q = Balls(), unit() * ball("2")
        power = field.power(q, exponent)
        whole, other = integer_power(power, exponent.denominator), integer_power(q, exponent.numerator)
        assert all(field.same(a.re, b.re) and field.same(a.du, b.du) for a, b in zip(whole, other, strict=True))


def test_powers_of_quaternions_with_purely_dual_vector_part() -> None:
    with precision(256):
        field, zero = Balls(), ball("0")
        q = Quaternion(Dual(ball("4"), zero), Vector(*(Dual(zero, ball(str(c))) for c in (1, 2, 3))))
        half = field.power(q, Fraction(3, 2))
        assert all(field.same(a.re, b.re) and field.same(a.du, b.du)
                   for a, b in zip(half * half, q * q * q, strict=True))  # fmt: skip
        with pytest.raises(UndefinedError, match="a power of a negative number"):
            field.power(-q, Fraction(1, 2))


@pytest.mark.parametrize(
    ("call", "inverse", "slope"),
    [(Field.exp, Field.log, lambda a: Balls().exp(a)), (Field.log, Field.exp, lambda a: 1 / a),
     (Field.sqrt, lambda field, a: field.power(a, 2), lambda a: 1 / (2 * Balls().sqrt(a))),
     (lambda field, a: field.power(a, Fraction(1, 3)), lambda field, a: field.power(a, 3),
      lambda a: 1 / (3 * Balls().power(a, Fraction(2, 3))))],
)  # fmt: skip
def test_functions_of_dual_numbers_have_their_derivatives(call, inverse, slope) -> None:
    with precision(256):
        field, a = Balls(), Dual(ball("0.7"), ball("0.3"))
        value = call(field, a)
        assert field.same(value.du, a.du * slope(a.re))
        back = inverse(field, value)
        assert field.same(back.re, a.re)
        assert field.same(back.du, a.du)


def test_magnitudes_of_vectors_without_real_part_are_dual() -> None:
    with precision(256):
        field, zero = Balls(), ball("0")
        v = Vector(*(Dual(zero, ball(str(c))) for c in (1, 2, 2)))
        assert field.magnitude(v) == Dual(0, 3)
        w = Vector(*(Dual(ball(str(c)), ball(str(c))) for c in (1, 2, 2)))
        assert field.magnitude(w) == Dual(3, 3)
        assert field.sqrt(Dual(zero, zero)) == 0
        assert field.magnitude(Vector(3, 0, 4)) == 5
        with pytest.raises(UndefinedError, match="has no rate"):
            Balls(moving=True).magnitude(v)


def test_zeros_are_certain_and_logarithms_refused() -> None:
    with precision(256):
        field = Balls()
        assert field.sin(field.pi) == 0 == field.cos(field.pi / 2)
        assert not field.same(ball("1"), 1 + ball("1e-40"))
        with pytest.raises(UndefinedError, match="logarithm of a number that is not positive"):
            field.log(ball("0"))


def test_the_angle_of_a_point_may_have_one_dual_coordinate() -> None:
    with precision(256):
        field, one = Balls(), ball("1")
        for y, x, slope in ((Dual(one, one), 2 * one, "0.4"), (one, Dual(2 * one, one), "-0.2")):
            angle = field.atan2(y, x)
            assert field.same(angle.re, field.atan2(ball("1"), ball("2")))
            assert field.same(angle.du, ball(slope))
