"""Residues are what fractions are modulo one prime, and angles keep their sines and cosines."""

from __future__ import annotations

import operator
from fractions import Fraction
from itertools import product

import pytest

from derive.algebra.exact import NotExactError
from derive.papers.numbers.residues import PRIME, Residue, Residues, is_square, residue, square_root

NUMBERS = [Fraction(0), Fraction(1), Fraction(-3), Fraction(2, 7), Fraction(-5, 4), Fraction(PRIME + 2, 3)]
OPERATIONS = (operator.add, operator.sub, operator.mul, operator.truediv)


def of(a: Fraction) -> Residue:
    value = residue(a)
    assert value is not None
    return Residue(value)


@pytest.mark.parametrize("operation", OPERATIONS, ids=lambda f: f.__name__)
@pytest.mark.parametrize(("first", "second"), list(product(NUMBERS, NUMBERS)), ids=str)
def test_arithmetic_is_that_of_fractions(operation, first: Fraction, second: Fraction) -> None:
    forms = [(of(first), of(second)), (of(first), second), (first, of(second))]
    forms += [(of(first), int(second))] if second.denominator == 1 else []
    forms += [(int(first), of(second))] if first.denominator == 1 else []
    for a, b in forms:
        if operation is operator.truediv and second == 0:
            with pytest.raises(ZeroDivisionError):
                operation(a, b)
        else:
            result = operation(a, b)
            assert isinstance(result, Residue)
            assert 0 <= result.value < PRIME
            assert result == of(operation(first, second))


@pytest.mark.parametrize("exponent", [-3, -1, 0, 1, 2, 5])
def test_powers_are_those_of_fractions(exponent: int) -> None:
    for a in NUMBERS:
        if a == 0 and exponent < 0:
            with pytest.raises(ZeroDivisionError):
                of(a) ** exponent
        else:
            assert of(a) ** exponent == of(a**exponent)


def test_equal_residues_are_equal_numbers() -> None:
    assert Residue(3) == 3 == Residue(3)
    assert Residue(3) != 4 != Residue(3)
    assert Residue(3) != "3"
    assert hash(Residue(3)) == hash(Residue(3))
    assert bool(Residue(1))
    assert not Residue(0)
    assert repr(Residue(3)) == f"3 mod {PRIME}"
    assert residue(True) == 1
    assert residue("3") is residue(0.5) is None
    for operation in OPERATIONS:
        for pair in ((Residue(3), "3"), ("3", Residue(3))):
            with pytest.raises(TypeError):
                operation(*pair)


def test_roots_are_squares_and_minus_one_has_none() -> None:
    assert not is_square(-1)
    for a in range(2, 40):
        root = square_root(a)
        assert is_square(a) is (root is not None) is not is_square(-a)
        if root is not None:
            assert root * root % PRIME == a
            assert is_square(root)
        assert is_square(abs(Residue(a)).value)
        assert abs(Residue(a)) in (Residue(a), -Residue(a))


# ---- the field -------------------------------------------------------------------------------------------------------


@pytest.fixture
def field() -> Residues:
    return Residues((), {"a": 4, "b": 2})


def test_symbols_are_squares(field: Residues) -> None:
    for name in ("x", "y", "a", "pi"):
        root = field.sqrt(field.symbol(name))
        assert root * root == field.symbol(name)
        assert field.symbol(name) == field.symbol(name) != field.symbol(name + "'")


@pytest.mark.parametrize(
    ("i", "j", "k"), [(1, 0, 0), (0, 1, 0), (1, 1, 0), (-3, 1, 1), (2, -1, 3), (5, 0, -2), (0, 0, 4)]
)
def test_sines_and_cosines_add_up(field: Residues, i: int, j: int, k: int) -> None:
    one = field.symbol("a") * Fraction(i, 4) + field.symbol("b") * Fraction(j, 2)
    other = field.symbol("b") / 2 - k * field.pi / 2
    sin, cos = field.sin, field.cos
    assert sin(one) ** 2 + cos(one) ** 2 == 1
    assert sin(one + other) == sin(one) * cos(other) + cos(one) * sin(other)
    assert cos(one - other) == cos(one) * cos(other) + sin(one) * sin(other)
    assert sin(-one) == -sin(one)
    assert cos(-one) == cos(one) == cos(0 + one) == cos(one + 0) == cos(+one)


def test_tangents_of_half_a_part_are_positive(field: Residues) -> None:
    """And so are the cosine of the whole and what the tangent of an angle needs a root of."""
    for part in (field.symbol("a") / 4, field.symbol("b") / 2, Residues((), {"c": 1}).symbol("c")):
        inside = Residues((), {"a": 4, "b": 2, "c": 1})
        half = inside.sin(part) / (1 + inside.cos(part))
        assert is_square(half.value)
        assert is_square((1 - half * half).value)
        assert is_square((1 + half * half).value)
        assert is_square(inside.cos(part).value)


def test_quarter_turns_are_where_they_are(field: Residues) -> None:
    turns = [(field.cos(k * field.pi / 2), field.sin(k * field.pi / 2)) for k in range(-1, 6)]
    assert turns == [(0, -1), (1, 0), (0, 1), (-1, 0), (0, -1), (1, 0), (0, 1)]
    assert (field.cos(0), field.sin(0)) == (1, 0)
    assert field.sin(field.symbol("a")) not in (0, 1)


def test_sines_of_parts_that_are_too_small_are_refused(field: Residues) -> None:
    for angle in (field.symbol("a") / 3, field.symbol("b") / 4, field.pi / 3, field.symbol("a") * field.symbol("b")):
        with pytest.raises(NotExactError, match="of an angle"):
            field.sin(angle)


@pytest.mark.parametrize("k", range(1, 9))
def test_roots_of_squares_of_angles_are_angles(field: Residues, k: int) -> None:
    part = field.symbol("a") * Fraction(k, 4)
    root = field.sqrt(part * part)
    assert root == part
    assert field.sin(root) == field.sin(part)


def test_what_is_no_square_has_no_root(field: Residues) -> None:
    x = field.symbol("x")
    assert field.sqrt(0) == 0
    assert field.sqrt(Fraction(1, 4)) in (Fraction(1, 2), Fraction(-1, 2))
    with pytest.raises(NotExactError, match="not a square"):
        field.sqrt(-x)
    with pytest.raises(NotExactError, match="a root of higher order"):
        field.power(x, Fraction(1, 3))
    with pytest.raises(NotExactError, match="arc tangent"):
        field.atan2(x, 1)
    assert field.power(x, Fraction(3, 2)) ** 2 == x**3
    assert field.power(x, Fraction(4, 2)) == x * x
