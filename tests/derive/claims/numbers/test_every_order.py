"""Powers with exponent a n + b, for every order n at once: products add exponents."""

from __future__ import annotations

from fractions import Fraction

import pytest

from derive.algebra import Dual, Quaternion, Tensor, Vector
from derive.algebra.element import NotExactError
from derive.claims.numbers.generic import EveryOrder

FIELD = EveryOrder(["x"])
n, X, theta, psi = FIELD.n, FIELD.X, FIELD.theta, FIELD.psi
UNIT = Quaternion(1, Vector(X, 0, 0))
EXPONENTS = [(n, 2 * n + 1), (n + 2, 1 - n)]
BASES = {
    "1 + X²": 1 + X * X, "its root": FIELD.secant, "cos²": 1 / (1 + X * X), "scale": FIELD.scale, "2 n": 2 * n,
    "scale (1 + X²)": FIELD.scale * (1 + X * X), "4 n² / sec": 4 * n * n / FIELD.secant,
}  # fmt: skip


@pytest.mark.parametrize("base", BASES.values(), ids=BASES)
@pytest.mark.parametrize(("first", "second"), EXPONENTS)
def test_exponents_of_numbers_add_up(base, first, second) -> None:
    assert FIELD.power(base, first) * FIELD.power(base, second) == FIELD.power(base, first + second)
    assert FIELD.power(base, first) * FIELD.power(base, -first) == 1
    assert FIELD.power(base, first + 1) == FIELD.power(base, first) * base
    assert FIELD.power(base, n) not in (base, base * base, 1)


@pytest.mark.parametrize(
    "base", [UNIT, FIELD.scale * UNIT, Quaternion(1, Vector(0, X * Fraction(3, 5), X * Fraction(4, 5)))]
)
@pytest.mark.parametrize(("first", "second"), EXPONENTS)
def test_exponents_of_quaternions_add_up(base: Quaternion, first, second) -> None:
    power = FIELD.power(base, first)
    assert power * FIELD.power(base, second) == FIELD.power(base, first + second)
    assert power * base == FIELD.power(base, first + 1)
    assert power.norm2() == FIELD.power(base.norm2(), first)


def test_root_is_the_positive_one() -> None:
    assert FIELD.secant == FIELD.sqrt(1 + X * X) == 1 / FIELD.cos(theta)
    assert FIELD.sin(theta) / FIELD.cos(theta) == X
    assert FIELD.power(FIELD.secant, 2 * n) == FIELD.power(1 + X * X, n)


def test_powers_of_dual_numbers_have_their_derivative() -> None:
    base = Dual(1 + X * X, FIELD.symbol("x"))
    assert FIELD.power(base, n) == Dual(FIELD.power(base.re, n), n * FIELD.power(base.re, n - 1) * base.du)


def test_angles_may_be_written_with_n() -> None:
    assert FIELD.cos(n * theta) == FIELD.cos(psi)
    assert FIELD.sin(n * theta + theta) == FIELD.sin(psi) * FIELD.cos(theta) + FIELD.cos(psi) * FIELD.sin(theta)
    assert FIELD.cos(psi - theta) == FIELD.cos(psi) * FIELD.cos(theta) + FIELD.sin(psi) * FIELD.sin(theta)


@pytest.mark.parametrize("times", [1, 2, -1])
def test_roots_divide_the_angle(times: int) -> None:
    q = Quaternion(FIELD.cos(psi), Vector(FIELD.sin(psi), 0, 0))
    part = Quaternion(FIELD.cos(times * theta), Vector(FIELD.sin(times * theta), 0, 0))
    assert FIELD.power(q, times / n) == part


def test_cosine_and_sine_of_n_times_a_dual_angle() -> None:
    cosine, sine = FIELD.turn(n, Dual(X, FIELD.symbol("x")))
    assert (cosine.re, sine.re) == FIELD.turn(n, X)
    assert cosine * cosine + sine * sine == Dual(1, 0)
    assert sine.du * (1 + X * X) == n * cosine.re * FIELD.symbol("x")


def test_polynomials_of_a_given_order() -> None:
    assert FIELD.pair(2, X * X) == (1 - X * X, 2)
    assert FIELD.pair(3, X * X) == (1 - 3 * X * X, 3 - X * X)
    p, q = FIELD.pair(n, X * X)
    assert FIELD.pair(n + 1, X * X) == (p - X * X * q, p + q)
    assert (p * p + X * X * q * q) == FIELD.power(1 + X * X, n)
    assert FIELD.pair(2 * n, X * X) == (p * p - X * X * q * q, 2 * p * q)


@pytest.mark.parametrize(
    ("base", "exponent"),
    [(Tensor.identity(), n), (UNIT.vector, n), (FIELD.symbol("x"), n), (1 + X, n), (1 + X * X, n * n),
     (Quaternion(1, Vector(2 * X, 0, 0)), n), (1 + X * X, n / 3), (UNIT, 1 / n),
     (Quaternion(FIELD.cos(psi), Vector(2 * FIELD.sin(psi), 0, 0)), 1 / n),
     (Quaternion(FIELD.sin(psi), Vector(FIELD.cos(psi), 0, 0)), 1 / n)],
)  # fmt: skip
def test_other_powers_are_refused(base, exponent) -> None:
    with pytest.raises(NotExactError):
        FIELD.power(base, exponent)
