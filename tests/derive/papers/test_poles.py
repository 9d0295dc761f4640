"""Poles of formulas: denominators, and multiples of their symbols at which they vanish."""

from __future__ import annotations

import mpmath
import pytest

from derive.algebra import Dual, Vector
from derive.papers.explore import denominators, poles
from derive.papers.language.environment import Env, let
from derive.papers.language.operator_table import equal, norm, over
from derive.papers.language.printed import Number, Symbol, text
from derive.papers.numbers.fields import FIELD_DIGITS, Decimal60, innermost

a, b, x = Symbol("a", "dual number"), Symbol("b", "dual number"), Symbol("x", "argument")
v, r, y = Symbol("v", "dual vector"), Symbol("r", "real"), Symbol("y", "number")
START = mpmath.mpf(9) / 20
VALUES = {a: Dual(START, START), b: Dual(START * 9 / 5, START), x: Dual(START, START), r: START,
          v: Vector(Dual(START, START), Dual(0 * START, START), Dual(0 * START, START))}  # fmt: skip


def environment() -> Env:
    return Env(Decimal60(), dict(VALUES), {y: let(y, lambda env, a: 1 - a, a)})


@pytest.mark.parametrize(
    ("below", "found"),
    [(1 - a, {a: 1}), (a * a - 4, {a: 2}), (1 - x, {x: 1}), (1 - norm(v), {v: 1}), (1 + a, {}),
     (a - b, {a: START * 9 / 5, b: START}), (a**4 - a, {a: 1}), (r - 1, {}), (a - 10, {}),
     (a * (a - 1) * (a - 2), {a: 1})],
)  # fmt: skip
def test_denominator_vanishes_at_a_multiple_of_a_symbol(below, found) -> None:
    with mpmath.workdps(FIELD_DIGITS):
        result = list(poles(equal(1 / below, b), environment()))
        assert [(label, *moved) for label, moved in result] == [
            (f"{text(below)} has the real part 0", x) for x in found
        ]
        for (_, moved), at in zip(result, found.values(), strict=True):
            ((symbol, value),) = moved.items()
            assert abs(innermost(value.c1 if symbol is v else value) - at) < mpmath.mpf(10) ** -50
            below_there = Env(Decimal60(), {**VALUES, **moved}).value(below)
            assert abs(innermost(below_there)) < mpmath.mpf(10) ** -50


@pytest.mark.parametrize(("multiple", "found"), [("0.1", []), ("0.13", [a]), ("4.95", [a]), ("5.05", [])])
def test_range_of_searched_multiples(multiple: str, found) -> None:
    with mpmath.workdps(FIELD_DIGITS):
        far = {a: Dual(START, START), r: START * mpmath.mpf(multiple)}
        assert [symbol for _, moved in poles(equal(1 / (a - r), b), Env(Decimal60(), far)) for symbol in moved] == found


def test_symbols_with_a_definition_are_not_moved() -> None:
    with mpmath.workdps(FIELD_DIGITS):
        assert [list(moved) for _, moved in poles(equal(1 / y, b), environment())] == []


def test_denominator_without_a_value_has_no_pole() -> None:
    with mpmath.workdps(FIELD_DIGITS):
        assert list(poles(equal(1 / (1 / (a - a)), b), environment())) == []


def test_denominators_contain_symbols() -> None:
    found = denominators(equal(a / 2, over(1, 1 - a / (b + 1)) + over(a, Number(3))))
    assert [text(below) for below in found] == ["1-a/b+1", "b+1"]
    assert list(denominators(equal(a * b, 2))) == []
    assert len(list(poles(equal(1 / (1 - a), 2 / (1 - a)), environment()))) == 1
