"""Evaluation of elementary expressions: correct values, common parts computed once, other functions refused."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy

from derive.algebra import Dual, functions
from derive.maps.elementary import FUNCTIONS, evaluate

pytestmark = pytest.mark.smoke

a = sympy.Symbol("a")
AT = Fraction(5, 16)
EXPRESSIONS = (
    sympy.tan(a / 4) ** 2 - 3 * a + 1,
    sympy.cot(a) / (a * (1 + a**2)),
    sympy.sqrt(1 + a) ** 3 + sympy.cbrt(a) ** -2 + a ** sympy.Rational(-3, 2),
    a / 7 + sympy.Rational(2, 3) + sympy.pi * a,
    sum(getattr(sympy, name)(a / 3) for name in FUNCTIONS),
)


@pytest.mark.parametrize("expression", EXPRESSIONS, ids=str)
def test_values_and_slopes_match_sympy(expression: sympy.Expr) -> None:
    with mpmath.workdps(30):
        at = mpmath.mpf(AT.numerator) / AT.denominator
        found = evaluate(expression, a, Dual(at, mpmath.mpf(3)))
        there = {a: sympy.Rational(AT.numerator, AT.denominator)}
        for got, wanted in ((found.re, expression), (found.du, 3 * expression.diff(a))):
            assert mpmath.almosteq(got, mpmath.mpf(wanted.subs(there).evalf(35)), rel_eps=mpmath.mpf(10) ** -27)
        assert mpmath.almosteq(evaluate(expression, a, at), found.re)


def test_rational_functions_of_fractions_are_fractions() -> None:
    assert evaluate((a**3 - 1) / (a + 2) + sympy.Rational(1, 3), a, AT) == (AT**3 - 1) / (AT + 2) + Fraction(1, 3)


def test_every_part_is_computed_once() -> None:
    asked: list[str] = []

    def told(name: str) -> Callable[[Any], Any]:
        def function(value: Any) -> Any:
            asked.append(name)
            return getattr(functions, name)(value)

        return function

    library = SimpleNamespace(sin=told("sin"), cos=told("cos"))
    expression = sympy.sin(a) * sympy.tan(a) + sympy.cot(a) ** 2 - sympy.cos(a) / sympy.cos(2 * a)
    evaluate(expression, a, mpmath.mpf(1), library)
    assert sorted(asked) == ["cos", "cos", "sin"]


def test_other_functions_and_divisions_by_zero_are_refused() -> None:
    for expression in (1 / a, sympy.cot(a), a**-2):
        for zero in (0.0, mpmath.mpf(0), np.float64(0), Fraction(0)):  # a NumPy quotient would be infinite
            if not (isinstance(zero, Fraction) and expression.has(sympy.cot)):
                with pytest.raises(ZeroDivisionError):
                    evaluate(expression, a, zero)
    other = sympy.Symbol("b")
    for expression in (sympy.gamma(a), 2**a, a**sympy.pi, a**a, other, sympy.sin(a + other), other**2):
        with pytest.raises(ValueError, match="not an elementary expression in a: "):
            evaluate(expression, a, 1.0)
