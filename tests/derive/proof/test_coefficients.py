from __future__ import annotations

from math import comb

import pytest
import sympy

from derive.proof.coefficients import BINOMIAL, NotDecidedError, Series, _written_out, _zero, residue
from derive.proof.notation import j, n

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
    for order in range(1, 5):
        for k in range(-2, 8):
            assert _value(identity, order, k) == 0


def _value(e: sympy.Expr, order: int, k: int) -> int:
    at = {n: sympy.Integer(order), j: sympy.Integer(k)}

    def choose(a: sympy.Expr, b: sympy.Expr) -> int:
        return comb(int(a), int(b)) if b >= 0 else 0

    return int(e.replace(B, lambda a, b: choose(*(c.xreplace(at) for c in (a, b)))).xreplace(at))


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
