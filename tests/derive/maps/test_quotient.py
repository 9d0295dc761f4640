"""Quotients N(α)/α^k that are analytic at 0: values, derivatives and enclosures, for every elementary function."""

from __future__ import annotations

from typing import Any

import mpmath
import pytest
import sympy

from derive.algebra import Dual
from derive.maps import PhiError
from derive.maps.any_phi import intervals
from derive.maps.any_phi.expressions import parity
from derive.maps.any_phi.regular import order_at_zero, regular
from derive.maps.elementary import FUNCTIONS, Quotient, alpha, elementary, evaluate

VANISHING = [
    *(function(alpha / 3) - function(alpha / 3).series(alpha, 0, 2).removeO() for name in FUNCTIONS
      if name != "log" and (function := getattr(sympy, name))),
    sympy.log(1 + alpha**2), sympy.sqrt(1 + alpha**2 / 4) - 1, sympy.cbrt(8 + alpha) - 2, sympy.tan(alpha / 3) ** 2,
]  # fmt: skip
"""Functions that are 0 at α = 0: elementary ones less their first terms, and others."""
ANGLES = ("1e-20", "0.01", "0.4")
DIGITS = 50


def _quotient(above: sympy.Expr) -> Any:
    return Quotient.of(above, order_at_zero(above), alpha)


def _exact(e: sympy.Expr, angle: str) -> Any:
    with mpmath.workdps(2 * DIGITS - 3 * mpmath.frexp(mpmath.mpf(angle))[1] // 2):
        return evaluate(elementary(e), alpha, mpmath.mpf(angle))


@pytest.mark.parametrize("above", VANISHING, ids=str)
def test_values_and_derivatives_keep_their_digits(above: sympy.Expr) -> None:
    """Allow 10 of 50 digits; a plain quotient loses all of them at 1e-20."""
    quotient = _quotient(above)
    with mpmath.workdps(DIGITS):
        for angle in ANGLES:
            found = evaluate(quotient, alpha, Dual(mpmath.mpf(angle), mpmath.mpf(2)))
            for got, e in ((found.re, quotient), (found.du, 2 * quotient.diff(alpha))):
                exact = _exact(e, angle)
                assert abs(got - exact) <= abs(exact) * mpmath.mpf(10) ** (10 - DIGITS), angle
        at_zero = evaluate(quotient, alpha, Dual(mpmath.mpf(0), mpmath.mpf(2)))
        assert mpmath.almosteq(at_zero.re, mpmath.mpf(quotient.subs(alpha, 0).evalf(DIGITS)))
        assert mpmath.almosteq(at_zero.du, 2 * mpmath.mpf(quotient.diff(alpha).subs(alpha, 0).evalf(DIGITS)))


@pytest.mark.parametrize("terms", [intervals.TERMS, 2])
def test_enclosures_hold_the_values(terms: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Require enclosures about 0, at numbers and on rectangles; within 1/4, unless a remainder stands for the terms."""
    monkeypatch.setattr(intervals, "INTERVALS", intervals.Intervals())
    monkeypatch.setattr(intervals, "TERMS", terms)
    for above in VANISHING:
        quotient = _quotient(above)
        with intervals.precise() as at:
            for angle in ("0", "1e-20", "0.01", "0.4"):
                middle, wide = mpmath.mpf(angle), mpmath.mpf("0.01")
                exact = quotient.subs(alpha, 0).evalf(DIGITS) if middle == 0 else _exact(quotient, angle)
                box = at.interval(middle - wide, middle + wide)
                for place in (at.interval(middle, middle), box, at.rectangle(box, at.interval(-wide, wide))):
                    off = at.size(at.enclosure(quotient, place) - at.interval(mpmath.mpf(exact), mpmath.mpf(exact)))
                    assert off[0] <= mpmath.mpf(10) ** -40, (above, angle)
                    assert terms == 2 or off[1] <= 0.25, (above, angle)


FORMS = {
    "alpha - sin(alpha)": 3, "alpha**3 + alpha**5": 3, "1 - cos(alpha)": 2, "tan(alpha) - alpha": 3, "sin(alpha)**2": 2,
    "alpha*cos(alpha) - sin(alpha)": 3, "2 + alpha": 0,
}  # fmt: skip


@pytest.mark.parametrize("text", FORMS)
def test_orders_are_exact(text: str) -> None:
    assert order_at_zero(sympy.sympify(text, locals={"alpha": alpha})) == FORMS[text]


@pytest.mark.parametrize(
    ("e", "side"),
    [
        (sympy.cbrt(alpha - sympy.sin(alpha)), -1),
        (sympy.cbrt(sympy.sin(alpha) - alpha), -1),
        (alpha * sympy.sqrt((1 - sympy.cos(alpha)) / alpha**2), -1),
        (sympy.sin(alpha) ** 2 / alpha, -1),
        (1 / alpha - sympy.cos(alpha) / sympy.sin(alpha), -1),
        ((alpha**5 + alpha**7) ** sympy.Rational(3, 5), -1),
        ((alpha**5 + alpha**7) ** sympy.Rational(2, 5), 1),
        (sympy.exp(alpha) / (1 + alpha), None),
    ],
    ids=str,
)
def test_regular_forms_are_equal_beyond_zero(e: sympy.Expr, side: int | None) -> None:
    """Odd roots of negative numbers are negative."""
    found = regular(e)
    assert parity(found) == side
    with mpmath.workdps(DIGITS):
        for angle in ("1e-3", "0.3"):
            value, plain = evaluate(found, alpha, mpmath.mpf(angle)), evaluate(e, alpha, mpmath.mpf(angle))
            size = abs(plain) if isinstance(plain, mpmath.mpc) else plain
            assert mpmath.almosteq(abs(value) if size is not plain else value, size, mpmath.mpf(10) ** -30)


@pytest.mark.parametrize("e", [sympy.cbrt(alpha), sympy.sqrt(alpha**2), sympy.sin(alpha) / alpha**2, 1 / alpha])
def test_other_roots_and_poles_are_refused(e: sympy.Expr) -> None:
    with pytest.raises(PhiError, match="at alpha = 0"):
        regular(e)
