from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

from derive.algebra.element import Element, NotExactError
from derive.proof import Ring

pytestmark = pytest.mark.smoke

POINT = {"v1": Fraction(2, 3), "v2": Fraction(-1, 5), "v3": Fraction(7, 4), "d1": Fraction(3), "d2": Fraction(-5, 2)}
SQUARE = sum((POINT[name] ** 2 for name in ("v1", "v2", "v3")), Fraction(0))

x = sympy.Symbol("x")


def ring(root: int = 0) -> Ring:
    return Ring(extra=("d1", "d2"), root=root)


def value(element: Element) -> Fraction:
    """Return the value of an element at `POINT`, from its stored numerator and denominator."""
    numbers = {**POINT, "x": SQUARE}

    def at(polynomial: Any) -> Fraction:
        total = Fraction(0)
        for exponents, term in element.ring.library.terms(polynomial).items():
            for name, power in zip(element.ring.names, exponents, strict=True):
                term *= numbers[name] ** power
            total += term
        return total

    return at(element.numerator) / at(element.denominator)


def program(steps: list[tuple[str, int, int]], numbers: list[Any], square: Any) -> Any:
    """Run the steps of a straight-line program on any kind of number."""
    values = list(numbers)
    for operation, i, j in steps:
        a, b = values[i % len(values)], values[j % len(values)]
        if operation == "+":
            values.append(a + b)
        elif operation == "-":
            values.append(a - b)
        elif operation == "*":
            values.append(a * b)
        elif operation == "/":
            values.append(a / (1 + square * square * (i + 1)))
        else:
            values.append(Fraction(j + 1, i + 1) - a)
    return values[-1]


STEPS = st.lists(st.tuples(st.sampled_from("+-*/c"), st.integers(0, 9), st.integers(0, 9)), min_size=1, max_size=8)


@given(steps=STEPS)
@settings(max_examples=40)
def test_programs_agree_with_rational_arithmetic(steps: list[tuple[str, int, int]]) -> None:
    names = ("v1", "v2", "v3", "d1", "d2")
    exact = ring()
    v1, v2, v3 = exact.v
    element = program(steps, [exact.symbol(name) for name in names], v1 * v1 + v2 * v2 + v3 * v3)
    number = program(steps, [POINT[name] for name in names], SQUARE)
    assert value(element) == number
    assert element == element + 0
    assert not element - element


@pytest.mark.parametrize("root", [0, 1, -1, -4])
def test_square_becomes_the_generator(root: int) -> None:
    exact = ring(root)
    v = np.array(exact.v, dtype=object)
    assert (v * v).sum() == exact.x
    assert v @ v == exact.x
    assert v[2] ** 3 == v[2] * (exact.x - v[0] ** 2 - v[1] ** 2)
    if root:
        assert exact.generator ** 2 == 1 + (v @ v) / root


def test_numbers_mix() -> None:
    exact = ring()
    v1 = exact.symbol("v1")
    assert 2 * v1 == v1 + v1 == np.int64(2) * v1 == v1 * np.int32(2)
    assert Fraction(1, 2) * v1 + v1 / 2 == v1
    assert 1 - v1 == -(v1 - 1)
    assert +v1 == v1
    assert 1 / (1 + exact.x) * (1 + exact.x) == 1
    assert v1 != exact.symbol("v2")
    assert v1 != "v1"
    assert exact.constant(Fraction(6, 3)) == 2
    assert not exact.constant(0)
    assert repr(v1 * v1) == "v1**2"
    assert repr(v1 / 2) == "1/2*v1"
    assert repr(v1 / (1 - exact.x)) == "(-1*v1)/(x - 1)"
    assert repr(v1 - v1) == "0"


def _raises(action: Callable[[], object], error: type[Exception], text: str) -> None:
    with pytest.raises(error, match=text):
        action()


def test_errors_say_what_is_wrong() -> None:
    exact = ring()
    v1, one_plus = exact.symbol("v1"), 1 + exact.x
    block = np.array(exact.v, dtype=object)
    for action in (
        lambda: v1 * 0.5,
        lambda: 2.0 * v1,
        lambda: v1 + np.float64(1),
        lambda: v1 - np.float32(1),
        lambda: v1 == 1.0,
        lambda: block * 0.5,
        lambda: block + np.ones(3),
        lambda: v1 * sympy.Float(2),
    ):
        _raises(action, TypeError, "exact ring takes int and Fraction")
    _raises(lambda: 1 / (v1 - v1), ZeroDivisionError, "zero of the exact ring")
    _raises(lambda: v1 / 0, ZeroDivisionError, "zero of the exact ring")
    _raises(lambda: v1.sqrt(), NotExactError, "not a perfect square")
    _raises(lambda: (v1 * v1).sqrt(), NotExactError, "depends on v1 has no sign")
    _raises(lambda: one_plus.sqrt(), NotExactError, "not a perfect square")
    _raises(lambda: (-(one_plus**2)).sqrt(), NotExactError, "not a perfect square")
    _raises(lambda: exact.derivative(v1, "w"), ValueError, "no symbol 'w'")
    _raises(lambda: v1 + Ring().symbol("v1"), ValueError, "two different rings")
    _raises(lambda: exact.lift(sympy.sin(x), {x: one_plus}), ValueError, "not an algebraic expression")
    _raises(lambda: exact.lift("x", {x: one_plus}), TypeError, "expected a SymPy expression")


def test_square_roots_of_odd_powers() -> None:
    for root in (1, -1, 4, -9):
        exact = ring(root)
        one_plus, s = 1 + exact.x / root, exact.generator
        assert (one_plus**5).sqrt() == s**5
        assert (1 / one_plus).sqrt() == 1 / s
        assert ((s - 2) ** 2).sqrt() == 2 - s  # positive near v = 0, where s = 1
        assert ((s - 1) ** 2 / one_plus).sqrt() == (1 if root > 0 else -1) * (s - 1) / s  # s > 1 or < 1 near v = 0
        radicand = 1 + x / root
        lifted = exact.lift(sympy.sqrt(radicand) / radicand**2 - x, {x: exact.x})
        assert lifted == 1 / s**3 - exact.x
        assert 2 * exact.derivative(s, "x") == 1 / (root * s)


@pytest.mark.parametrize("root", [0, 1, -1, 9])
def test_derivatives(root: int) -> None:
    exact = ring(root)
    v1, _, v3 = exact.v
    square = exact.x
    f = v3 * square / (1 + square) + exact.symbol("d1") * v1
    assert exact.derivative(f, "v3") == square / (1 + square) + 2 * v3 * v3 / (1 + square) ** 2
    assert exact.derivative(f, "d1") == v1
    assert exact.derivative(v3 * v3, "v3") == 2 * v3
    assert exact.derivative(v3 * v3, "v1") == 0
    expression = (x**3 - 1) / (x + 2) + 1 / x
    lifted = exact.lift(expression, {x: square})
    assert lifted == ((square**3 - 1) * square + square + 2) / (square * (square + 2))
    assert exact.derivative(lifted, "x") == exact.lift(sympy.diff(expression, x), {x: square})
    slope = exact.derivative(lifted, "x")
    assert exact.derivatives(expression, x, square, 2) == [lifted, slope, exact.derivative(slope, "x")]
    _raises(lambda: exact.derivatives(expression, x, 2 * square, 1), ValueError, "by the square of v")


def test_quotients_are_in_lowest_terms() -> None:
    exact = ring()
    one_plus, one = 1 + exact.x, exact.library.one
    again = exact.constant(1)
    for _ in range(5):
        again = (again / one_plus) * one_plus**2 / one_plus  # without reduction, one more power each time
    assert (again.numerator, again.denominator) == (one, one)
    third = one_plus / (one_plus * one_plus * 3)
    assert (third * 3).numerator == one
    assert third.denominator == one_plus.numerator
    zero = exact.constant(0) / one_plus
    assert (zero.numerator, zero.denominator) == (exact.library.zero, one)


def test_functions_of_the_square_are_ordered_near_zero():
    exact = ring()
    square = exact.x
    assert 0 < square < 1
    assert square > 0
    assert square * 7 < 1
    assert not square > square
    with pytest.raises(NotExactError, match="depends on v1 has no sign"):
        _ = exact.symbol("v1") > 0


@pytest.mark.parametrize("root", [0, 1, -4])
def test_second_vector_has_its_own_square(root: int) -> None:
    exact = Ring(("w4",), root=root, vectors="vw")
    w1, w2, w3 = (exact.symbol(name) for name in ("w1", "w2", "w3"))
    square = w1 * w1 + w2 * w2 + w3 * w3
    assert square in exact.squares
    assert square != exact.x
    expression = sympy.sqrt(1 + x / root) ** 3 if root else x**3 / (1 + x)
    value, slope = exact.derivatives(expression, x, square, 1)
    assert value == exact.lift(expression, {x: square})
    assert slope == exact.lift(sympy.diff(expression, x), {x: square})
    assert exact.derivative(square, "x") == 0
