"""The two kinds of numbers formulas are executed on."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest

from derive.algebra import Dual, Quaternion, Tensor, Vector, ZeroDivisorError
from derive.papers.numbers.draw import Draw
from derive.papers.numbers.every_order import EveryOrder
from derive.papers.numbers.fields import DIGITS, Decimal60, Exact, Field, UndefinedError, integer_power
from derive.papers.numbers.residues import Residue, Residues
from derive.proof.ratio import NotExactError

pytestmark = pytest.mark.smoke


@pytest.fixture
def exact() -> Exact:
    return Exact(["x", "y"], {"a": 4})


def test_rational_identities_are_exact(exact) -> None:
    x, y = exact.symbol("x"), exact.symbol("y")
    assert exact.same((x * x - y * y) / (x - y), x + y)
    assert not exact.same(x, y)


def test_roots_of_squares_are_exact_and_others_refused(exact) -> None:
    x, y = exact.symbol("x"), exact.symbol("y")
    assert exact.same(exact.sqrt(x * x + 2 * x * y + y * y), x + y)
    with pytest.raises(NotExactError, match="not a perfect square"):
        exact.sqrt(x * x + y * y)


@pytest.mark.parametrize("multiple", [Fraction(1, 4), Fraction(1, 2), 1, Fraction(3, 2), -1])
def test_angles_are_found_again(exact, multiple) -> None:
    angle = exact.symbol("a") * multiple
    assert exact.same(exact.sin(angle) ** 2 + exact.cos(angle) ** 2, 1)
    assert exact.same(exact.atan2(exact.sin(angle), exact.cos(angle)), angle)
    assert exact.same(exact.atan(exact.sin(angle) / exact.cos(angle)), angle)


def test_what_is_no_angle_is_refused(exact) -> None:
    with pytest.raises(NotExactError, match="no multiple of an angle"):
        exact.atan(exact.symbol("x"))
    with pytest.raises(NotExactError):
        exact.sin(exact.symbol("x"))


def test_quarter_turns_are_exact(exact) -> None:
    a = exact.symbol("a")
    assert exact.same(exact.sin(a + exact.pi), -exact.sin(a))
    assert exact.same(exact.cos(a + exact.pi / 2), -exact.sin(a))


def test_powers_for_every_order() -> None:
    field = EveryOrder()
    p, q = field.pair(field.n, field.X**2)
    p_next, q_next = field.pair(field.n + 1, field.X**2)
    assert field.same(p_next, p - field.X**2 * q)
    assert field.same(q_next, p + q)
    assert field.same(p * p + field.X**2 * q * q, field.power(1 + field.X**2, field.n))


@pytest.mark.parametrize("exponent", range(6))
def test_integer_powers(exponent: int) -> None:
    tensor = Tensor(((1, 2, 0), (0, 1, 3), (4, 0, 1)))
    expected = Tensor.identity()
    for _ in range(exponent):
        expected = expected @ tensor
    assert integer_power(tensor, exponent) == expected


def test_decimal_functions_of_dual_numbers() -> None:
    with mpmath.workdps(DIGITS):
        field, a = Decimal60(), Dual(mpmath.mpf("0.7"), mpmath.mpf("0.3"))
        assert field.same(field.sin(a).du, a.du * mpmath.cos(a.re))
        assert field.same(field.atan2(field.sin(a), field.cos(a)).du, a.du)
        assert field.same(field.atan(a).du, a.du / (1 + a.re**2))


def test_decimal_refuses_what_has_no_value() -> None:
    field = Decimal60()
    with pytest.raises(UndefinedError):
        field.sqrt(mpmath.mpf(-1))
    with pytest.raises(ZeroDivisorError):
        field.sqrt(Dual(mpmath.mpf(0), mpmath.mpf(1)))
    with pytest.raises(UndefinedError):
        field.atan2(mpmath.mpf(0), mpmath.mpf(0))


def test_a_field_says_when_two_numbers_are_equal() -> None:
    with pytest.raises(TypeError, match="abstract"):
        Field()


def test_roots_of_quaternions_are_principal() -> None:
    with mpmath.workdps(DIGITS):
        field = Decimal60()
        q = Draw("root").quaternion(0.9)
        half = field.power(q, Fraction(1, 2))
        assert all(field.same(a.re, b.re) and field.same(a.du, b.du) for a, b in zip(half * half, q, strict=True))
        assert half.scalar.re > 0


def test_roots_for_every_order_are_of_unit_quaternions_of_the_angle() -> None:
    field = EveryOrder()
    cosine, sine, zero = field.cos(field.psi), field.sin(field.psi), field.psi - field.psi
    root = field.power(Quaternion(cosine, Vector(sine, zero, zero)), 1 / field.n)
    assert field.same(root.norm2(), 1)
    for other in (Quaternion(cosine, Vector(2 * sine, zero, zero)), Quaternion(sine, Vector(cosine, zero, zero))):
        with pytest.raises(NotExactError, match="roots of quaternions other than"):
            field.power(other, 1 / field.n)


def test_vectors_beside_numbers_make_quaternions() -> None:
    field = Decimal60()
    assert field.power(Vector(1, 2, 3), 2) == Quaternion(-14, Vector(0, 0, 0))


def test_residues_have_reciprocals_but_for_zero_and_sines_of_angles_alone() -> None:
    field = Residues(["x"], {"a": 2})
    x, a = field.symbol("x"), field.symbol("a")
    assert x**-1 * x == x**-2 * x * x == Residue(1)
    with pytest.raises(ZeroDivisionError):
        Residue(0) ** -1
    assert field.same(field.sin(a) ** 2 + field.cos(a) ** 2, 1)
    assert field.sin(0) == 0
    for other in (x, 5, Fraction(1, 2)):
        with pytest.raises(NotExactError, match="no rational multiple of an angle"):
            field.sin(other)
