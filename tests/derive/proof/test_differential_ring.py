"""Differential ring: factors of denominators are certified, and derivation obeys the product rule."""

from __future__ import annotations

import pytest
import sympy

from derive.algebra.element import Element
from derive.proof.differential_ring import DifferentialRing
from derive.proof.notation import Shifted, dot, n, p, q, v, x
from derive.proof.setting import Setting, Symbols
from derive.proof.statement import definition


def ring(zeroed: sympy.Expr | None = None) -> DifferentialRing:
    values = (definition(Shifted(p, x, 0), 1), definition(Shifted(q, x, 0), n))
    return Setting(Symbols((p, q, x, n), (v,), (x,)), (*values, definition(dot(v, v), x)), zeroed=zeroed).ring


def over(divisor: sympy.Expr, at: DifferentialRing) -> Element:
    value = at.constant(0)
    for term in sympy.Add.make_args(divisor):
        product = at.constant(1)
        for factor in sympy.Mul.make_args(term):
            base, exponent = factor.as_base_exp()
            number = base.is_Rational
            product = product * (at.constant(int(base)) if number else at.generator(base) ** int(exponent))
        value = value + product
    return at.constant(1) / value


@pytest.mark.parametrize("divisor", [x, 1 + x, q, p, n, p**2 + x * q**2, n + 1, 2 * n * x * q])
def test_certified(divisor: sympy.Expr) -> None:
    at = ring()
    assert all(multiplier.nonzero for multiplier in at.multipliers(over(divisor, at).denominator))


@pytest.mark.parametrize("divisor", [n - 3, p - q, q - n, x * (p - 1), n**2 - 5 * n + 6])
def test_factors_vanishing_at_an_order_are_not_certified(divisor: sympy.Expr) -> None:
    at = ring()
    assert not all(multiplier.nonzero for multiplier in at.multipliers(over(sympy.expand(divisor), at).denominator))


def test_zeroed_factor_is_not_certified() -> None:
    at = ring(zeroed=1 + x)
    assert [multiplier.nonzero for multiplier in at.multipliers(over(1 + x, at).denominator)] == [False]


def test_division_by_zero_is_refused() -> None:
    at = ring()
    squares = sum((at.generator(sympy.Symbol(f"v_{i}")) ** 2 for i in (1, 2, 3)), at.constant(0))
    with pytest.raises(ZeroDivisionError):
        at.constant(1) / (squares - at.generator(x))


def test_quotients_are_numbers() -> None:
    at = ring()
    a, b = at.generator(x), at.generator(p)
    assert (a + b) / (1 + a) * (1 + a) - b == a
    assert 1 / (a / b) == b / a
    assert a**-2 * a**2 == 1
    assert a != b
    assert 2 - a == -(a - 2)


def test_derivation_obeys_the_product_and_quotient_rules() -> None:
    at = ring()
    a, b = at.generator(x), at.generator(p)
    rates = {at.symbols[x]: at.constant(1), at.symbols[p]: at.generator(q)}

    def rate(value: Element) -> Element:
        return value.derivative(rates)

    f, g = b / (1 + a), a * b / (1 + a) ** 2
    assert rate(f * g) == rate(f) * g + f * rate(g)
    assert rate(f / (1 + a)) == rate(f) / (1 + a) - f / (1 + a) ** 2
