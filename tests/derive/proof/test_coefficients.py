"""Coefficients of sums, and the differential ring in which identities are decided."""

from __future__ import annotations

import pytest
import sympy

from derive.algebra.element import Element
from derive.proof.coefficients import BINOMIAL, NotDecidedError, Series, _written_out, _zero, residue
from derive.proof.identity import definition
from derive.proof.notation import Shifted, dot, j, n, p, q, v, x
from derive.proof.rings import DifferentialRing
from derive.proof.setting import Setting, Symbols

B = sympy.binomial


def zero(e: sympy.Expr, first: int = 1) -> bool:
    return bool(residue(_written_out(e, BINOMIAL.equation.right), first) == 0)


@pytest.mark.parametrize(
    "identity",
    [
        B(n + 1, j) - B(n, j) - B(n, j - 1),
        j * B(n, j) - n * B(n - 1, j - 1),
        B(n + 2, 2 * j + 1) - B(n, 2 * j + 1) - 2 * B(n, 2 * j) - B(n, 2 * j - 1),
        (n - j) * B(n, j) - (j + 1) * B(n, j + 1),
        (-1) ** j * B(2 * n + 1, j) + (-1) ** (j + 1) * (B(2 * n, j) + B(2 * n, j - 1)),
    ],
)
def test_identities_of_binomials(identity: sympy.Expr) -> None:
    assert zero(identity)


@pytest.mark.parametrize(
    "wrong",
    [
        B(n + 1, j) - B(n, j) - B(n, j + 1),
        B(n, 2 * j) - B(n, 2 * j + 1),
        (-1) ** j * B(n, j) - B(n, j),
        B(2 * n, j) - B(n, j),
        n * B(n, j),
    ],
)
def test_false_identities_are_refused(wrong: sympy.Expr) -> None:
    assert not zero(wrong)


@pytest.mark.parametrize("tails", [(), ((1, j * 0),), ((2, n - n),)])
@pytest.mark.parametrize("power", [0, 1, 3])
def test_each_head_coefficient_is_decided(power: int, tails: tuple[tuple[int, sympy.Expr], ...]) -> None:
    found = dict(_zero("", Series({power: n}, tails), 1))
    assert [label for label, value in found.items() if value != 0] == [f", coefficient of x^{power}"]


def test_factorials_of_negative_numbers_are_refused() -> None:
    with pytest.raises(NotDecidedError, match="factorial"):
        zero(B(n - 2, j))


def test_series_shift_their_index() -> None:
    series = Series({0: n}, ((1, B(n, j)),))
    shifted = Series({1: sympy.Integer(1)}) * series
    assert [shifted.coefficient(i) for i in range(4)] == [0, n, n, B(n, 2)]
    assert (series + series).coefficient(0) == 2 * n
    with pytest.raises(NotDecidedError, match="product of two sums"):
        series * series


# --- differential ring ------------------------------------------------------------------------------------------------


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
