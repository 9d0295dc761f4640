r"""Form of φ that is analytic at α = 0, where its text may hold 0/0 or a root of 0.

A factor b^e with a zero of order k of b becomes ``α^(k e) (b/α^k)^e``, where ``b/α^k`` is a `Quotient` that is not 0 at
0. The powers of α of a product must add up to a whole number, 0 or more. An odd root of an odd expression is odd: the
root of a negative number is negative.
"""

from __future__ import annotations

import mpmath
import sympy

from ..elementary import Quotient, alpha
from ..grammar import PhiError

ORDER_MAX = 16
"""Largest order of a zero at α = 0."""
DIGITS = 60
ZERO = mpmath.mpf(10) ** -40
"""Size of a constant that is taken for 0 only if expansion shows that it is 0."""


def regular(e: sympy.Expr) -> sympy.Expr:
    """Return an expression equal to e for α > 0 and analytic at 0; `PhiError` if there is none.

    It is e itself, unless a part of e is 0/0 or a root of 0 there.
    """
    if not e.has(alpha) or e == alpha:
        return e
    if e.is_Mul or e.is_Pow:
        return _product(e)
    try:
        parts = tuple(map(regular, e.args))
    except PhiError:
        if not e.is_Add or (quotient := sympy.together(e)).is_Add:
            raise
        return _product(quotient)  # the poles of its terms may cancel
    return e.func(*parts) if parts != e.args else e


def _product(e: sympy.Expr) -> sympy.Expr:
    given = [(f.base, f.exp) if f.is_Pow and f.exp.is_Rational else (f, sympy.S.One) for f in sympy.Mul.make_args(e)]
    factors = [(regular(base) if base != e else base, power) for base, power in given]
    if not any(order_at_zero(base) for base, power in factors if not (power.is_Integer and power > 0)):
        return e if factors == given else sympy.Mul(*(base**power for base, power in factors))
    found, total = sympy.S.One, sympy.S.Zero
    for base, power in factors:
        order = order_at_zero(base)
        if not (order * power).is_Integer or (order and power.q % 2 == 0):
            raise PhiError(f"{base**power} has no derivative at alpha = 0")
        rest = Quotient.of(base, order, alpha) if order else base
        if order and power.q > 1 and rest.subs(alpha, 0) < 0:
            found, rest = found * (-1) ** power.p, Quotient.of(sympy.expand(-base), order, alpha)
        found, total = found * rest**power, total + order * power
    if total < 0:
        raise PhiError(f"{e} divides by zero at alpha = 0")
    return alpha**total * found


def order_at_zero(e: sympy.Expr) -> int:
    """Return the order of the zero of a function at α = 0; `PhiError` if nothing decides it, or if it has no value."""
    for order in range(ORDER_MAX + 1):
        value = sympy.expand(e.subs(alpha, 0))
        if not (value.is_comparable and value.is_finite):
            raise PhiError(f"{e} has no value at alpha = 0")
        if value != 0:
            if abs(value.evalf(DIGITS)) > ZERO:
                return order
            break
        e = e.diff(alpha)
    raise PhiError(f"nothing decides the order of the zero of {e} at alpha = 0")
