"""Powers with integer letters in the exponent, over independent generators: products add exponents, for all signs."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest
import sympy

from derive.algebra import Dual, Quaternion, Tensor, Vector
from derive.algebra.element import NotExactError
from derive.claims.numbers.generators import Generators

INTEGERS = {"n": (sympy.Integer(1), sympy.oo), "X": (sympy.Integer(0), sympy.oo)}
BASES: dict[str, Callable[[Any], Any]] = {
    "positive": lambda f: 1 + f.symbol("x") ** 2, "of either sign": lambda f: f.symbol("x"), "-1": lambda f: -1,
    "number": lambda f: Fraction(-12, 5), "quotient": lambda f: 3 * f.symbol("x") / (1 - f.symbol("X")),
    "cosine": lambda f: f.cos(f.symbol("a")), "order": lambda f: 4 * f.symbol("n") ** 2,
    "dual number": lambda f: Dual(1 - f.symbol("x"), f.symbol("a")),
    "quaternion": lambda f: Quaternion(1, Vector(0, 3, 4) * (f.tan(f.symbol("a")) / 5)),
    "multiple of one": lambda f: Quaternion(1, Vector(0, 0, f.tan(f.symbol("a")))) * f.symbol("x"),
    "vector": lambda f: Quaternion(0, Vector(f.symbol("x"), 0, 0)),
}  # fmt: skip
EXPONENTS: tuple[Callable[[Any, Any], tuple[Any, Any]], ...] = (
    lambda n, k: (n, 2 * n + 1), lambda n, k: (n + 2, 1 - n), lambda n, k: (k, 3 * k), lambda n, k: (2 * n * k, n),
)  # fmt: skip


def fields() -> list[Generators]:
    """Return fields for two signs of each of two integers, as of other roots."""
    signs = [(1, 1), (1, -1), (-1, 1), (-1, -1)]
    return [Generators(["x", "a", "X", "n", "k"], INTEGERS, ["n", "k"], 2, (*first, 1, 1, 1)) for first in signs]


@pytest.mark.parametrize("base", BASES.values(), ids=BASES)
@pytest.mark.parametrize("exponents", EXPONENTS)
def test_exponents_add_up(base, exponents) -> None:
    for field in fields():
        b = base(field)
        first, second = exponents(field.symbol("n"), field.symbol("k"))
        power = field.power(b, first)
        assert power * field.power(b, second) == field.power(b, first + second)
        assert power * b == field.power(b, first + 1)
        assert b == -1 or power not in (b, b * b, 1)


def test_powers_of_negative_numbers_follow_the_parity() -> None:
    found = set()
    for field in fields():
        k, x = field.symbol("k"), field.symbol("x")
        sign = field.power(-1, k)
        found.add(int(sign.sign()))
        assert (field.power(x, k) / (x if sign == -1 else 1)).sign() > 0
        assert field.power(-x, k) == sign * field.power(x, k)
    assert found == {1, -1}


def test_half_powers_are_roots_of_positive_numbers() -> None:
    field = fields()[0]
    n, X = field.symbol("n"), field.symbol("X")
    assert field.power(1 + X, n / 2) ** 2 == field.power(1 + X, n)
    assert field.sqrt(field.power(1 + X, 2 * n)) == field.power(1 + X, n)


def test_multiples_of_pi_by_integers() -> None:
    for field in fields():
        k = field.symbol("k")
        assert field.cos(2 * k * field.pi) == 1
        assert field.cos(k * field.pi) == field.power(-1, k)
        assert field.sin(k * field.pi) == 0
        assert field.cos(field.symbol("a") / field.symbol("n") + k * field.pi) == (
            field.power(-1, k) * field.cos(field.symbol("a") / field.symbol("n")))  # fmt: skip


def test_polynomials_of_a_cayley_map() -> None:
    for field in fields():
        n, x = field.symbol("n"), field.tan(field.symbol("a")) ** 2
        assert field.pair(3, x) == (1 - 3 * x, 3 - x)
        p, q = field.pair(n, x)
        assert field.pair(n + 1, x) == (p - x * q, p + q)
        assert p * p + x * q * q == field.power(1 + x, n)


REFUSED: tuple[Callable[[Any, Any, Any], tuple[Any, Any]], ...] = (
    lambda f, x, n: (Tensor.identity(), n), lambda f, x, n: (x, n / 2), lambda f, x, n: (1 + x * x, n / 4),
    lambda f, x, n: (1 + x * x, 1 / n), lambda f, x, n: (x, x * n), lambda f, x, n: (x - x, n),
)  # fmt: skip


@pytest.mark.parametrize("given", REFUSED)
def test_other_powers_are_refused(given) -> None:
    field = fields()[0]
    with pytest.raises(NotExactError):
        field.power(*given(field, field.symbol("x"), field.symbol("n")))
