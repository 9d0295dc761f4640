"""Brackets c_n, d_n and chains of Cayley maps; refused orders; bounds of φ on circles."""

from __future__ import annotations

import random
from fractions import Fraction
from functools import partial

import mpmath
import numpy as np
import pytest
import sympy

from derive.algebra import arithmetic
from derive.algebra.arithmetic import PLAIN
from derive.maps import Cayley, polynomials
from derive.maps.any_phi import intervals, near_zero
from derive.maps.any_phi.expressions import parsed
from derive.maps.cayley_scalars import HORNER_LIMIT, chain
from derive.maps.elementary import alpha
from derive.maps.polynomials import FIELD, RING_X, horner, rational, x


def test_brackets_keep_all_digits_on_shadows() -> None:
    n, at = 64, mpmath.tan(mpmath.mpf("1.2")) ** 2
    exact = [Cayley(n).c.subs(x, sympy.Float(at, 60)), Cayley(n).d.subs(x, sympy.Float(at, 60))]
    floats = polynomials.brackets(n, float(at))
    c, d = polynomials.brackets(n, at)
    assert abs(floats[0] / float(c) - 1) < 1e-12
    assert abs(floats[1] / float(d) - 1) < 1e-12
    assert abs(sympy.Float(c, 30) / exact[0] - 1) < 1e-20
    assert abs(sympy.Float(d, 30) / exact[1] - 1) < 1e-20


def test_rational_keeps_powers_of_one_plus_x_and_positive_denominators() -> None:
    at = FIELD.gens[0]
    assert rational(3) == 3
    assert rational((1 - at) / (1 + at) ** 3) == (1 - x) / (1 + x) ** 3
    assert rational(at / ((at - 2) * (1 + at))) == -x / ((2 - x) * (1 + x))
    assert rational((1 - at**2) / (1 + at)) == 1 - x


@pytest.mark.parametrize("n", [0, -1, -7])
def test_orders_below_one_are_refused(n: int) -> None:
    with pytest.raises(ValueError, match=rf"the order n must be an integer >= 1, got {n}"):
        arithmetic.pair(n, 1)


@pytest.mark.parametrize("n", [True, 2.0, "3", None, 1.5, Fraction(3)])
def test_other_types_are_refused(n) -> None:
    with pytest.raises(TypeError, match=r"the order n must be an integer >= 1, got .* of type"):
        arithmetic.pair(n, 1)


def test_integer_types_are_accepted() -> None:
    assert arithmetic.require_order(np.int64(3)) == arithmetic.require_order(sympy.Integer(3)) == 3


@pytest.mark.parametrize("n", [HORNER_LIMIT + 1, 10, 12, 14, 16, 23, 64])
def test_the_chain_divides_by_a_power_of_one_plus_x(n: int) -> None:
    """Compare the chain with polynomials and derivatives, all divided by the same power."""
    at = Fraction(3, 7)
    for order, pair in chain(n, at, 1 / (1 + at), PLAIN).items():
        for jet, polynomial in zip(pair, polynomials.ring_pair(order), strict=True):
            derivative = polynomial
            for found in (jet.value, jet.first, 2 * jet.half_second, 6 * jet.sixth_third):
                assert found == horner(derivative, at) / (1 + at) ** (order // 2)
                derivative = derivative.diff(RING_X)


# --- bounds of φ on circles, for polynomials near v = 0 ---------------------------------------------------------------

PHI = [
    "sin(alpha/2)", "tan(alpha/5)", "asin(alpha/4)", "alpha*acos(alpha**2/20)", "atan(alpha/3)", "sinh(alpha/2)",
    "alpha*cosh(alpha/4)", "tanh(alpha/6)", "alpha*cos(alpha/3)", "alpha*sqrt(1 + alpha**2/9)", "alpha*exp(alpha**2/9)",
    "alpha*log(3 + alpha**2/9)", "alpha/(1 + alpha**2/40)", "alpha/(1 + alpha**2/9)**(3/2)", "alpha + alpha**3/50",
]  # fmt: skip
RADIUS = mpmath.mpf("1.5")


def points(seed: int, count: int = 100) -> list[mpmath.mpc]:
    """Return points on a quarter of the circle, with both ends."""
    draw = random.Random(seed)
    return [RADIUS * mpmath.expjpi(share / 2) for share in (0, 1, *(draw.random() for _ in range(count)))]


@pytest.mark.parametrize("text", PHI)
def test_bound_on_a_circle_is_close_and_below_all_points(text: str):
    """Allow 20 %; arcs of length 1/80 and |φ′/φ| ≤ 4 make bounds about 10 % too low."""
    phi = parsed(text)
    least = near_zero.smallest(phi, RADIUS)
    assert near_zero.is_analytic(phi, RADIUS)
    found = min(map(abs, map(sympy.lambdify(alpha, phi, "mpmath"), points(1, 60))))
    assert 0.8 * found < least <= found * (1 + mpmath.mpf(2) ** -40)


@pytest.mark.parametrize(
    "text",
    ["tan(2*alpha)", "asin(alpha)", "alpha*acos(alpha**2)", "atan(alpha)", "tanh(2*alpha)", "alpha*sqrt(1 + alpha**2)",
     "alpha/(1 + alpha**2)", "alpha*log(1 + alpha**2)", "alpha/(1 - 3*alpha**2/2 + 9*alpha**4/10)", "sin(3*alpha)",
     "alpha + alpha/(100*(4*alpha**2 - 1)**2)"],
)  # fmt: skip
def test_phi_not_analytic_or_not_increasing_has_no_bound(text: str):
    phi = parsed(text)
    assert near_zero.smallest(phi, RADIUS) is None or not near_zero.is_analytic(phi, RADIUS)


def test_squares_cover_a_quarter_of_the_disc_and_arcs_the_circle():
    with intervals.precise() as at:
        arcs, squares = (
            [(*at.bounds(box.real), *at.bounds(box.imag)) for box in boxes(at, RADIUS)]
            for boxes in (near_zero._arcs, partial(near_zero._squares, parts=12))
        )
    for z in points(2):
        assert any(a <= z.real <= b and c <= z.imag <= d for a, b, c, d in arcs)
        for share in (0, "0.01", "0.5", "0.9", "0.999", 1):
            inside = z * mpmath.mpf(share)
            assert any(a <= inside.real <= b and c <= inside.imag <= d for a, b, c, d in squares), inside
    far = max(abs(mpmath.mpc(b, d)) for _, b, _, d in squares)
    assert far < RADIUS * (1 + mpmath.sqrt(2) / 12 + mpmath.mpf("0.001"))
