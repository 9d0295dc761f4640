r"""Edge of φ, and the inverse φ⁻¹ below the edge in closed form.

A closed form exists for compositions of invertible functions, and where φ² is a quotient of quadratics in α²:

.. math:: \varphi^2 = \frac{\alpha^2 (n_1 + n_2 \alpha^2)}{d_0 + d_1 \alpha^2 + d_2 \alpha^4} \qquad
    \alpha = r \sqrt{\frac{2 d_0}{b + \sqrt{b^2 + 4 a d_0 r^2}}} \qquad
    a = n_2 - d_2 r^2 \quad b = n_1 - d_1 r^2

This α is 0 at r = 0 and loses no digits there.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import mpmath
import sympy

from ..angle_of_length import real_value
from ..families import alpha
from ..phi_error import PhiError

PHI_DIGITS = 60
"""Working digits of numerical decisions."""
EDGE_MAX = 4
"""Largest edge in units of π; charts without an edge are cut there."""
GRID_POINTS = 2000


@dataclass(frozen=True)
class Edge:
    """Edge of φ: a fold (φ′ = 0), a pole, or the cut at 4π."""

    angle: sympy.Expr
    kind: str


def edge_of(phi: sympy.Expr) -> Edge:
    """Return the edge: the first zero of φ′ or pole of φ, else the cut at 4π; `PhiError` unless φ increases from 0."""
    slope = phi.diff(alpha)
    with mpmath.workdps(PHI_DIGITS):
        step = EDGE_MAX * mpmath.pi / GRID_POINTS
        try:
            before = real_value(slope, mpmath.mpf(0), phi)
        except ZeroDivisionError:
            raise PhiError(f"phi = {phi} divides by zero at alpha = 0") from None
        if not before > 0:
            raise PhiError(f"phi'(0) = {mpmath.nstr(before, 5)}, and has to be positive")
        for k in range(1, GRID_POINTS + 1):
            try:
                now, size = real_value(slope, k * step, phi), real_value(phi, k * step, phi)
            except (PhiError, ZeroDivisionError):
                return _pole(phi, (k - 1) * step, k * step)
            if now <= 0 or size <= 0:
                jumped = now > 10 * before or size <= 0
                return _pole(phi, (k - 1) * step, k * step) if jumped else _fold(phi, slope, (k - 1) * step, k * step)
            before = now
    return Edge(EDGE_MAX * sympy.pi, "cut")


def _fold(phi: sympy.Expr, slope: sympy.Expr, low: Any, high: Any) -> Edge:
    least = mpmath.mpf(10) ** -50
    root = mpmath.findroot(lambda a: real_value(slope, a, phi), (low, high), solver="anderson", tol=least)
    return Edge(_named(root), "fold")


def _pole(phi: sympy.Expr, low: Any, high: Any) -> Edge:
    """Return the pole by bisection: φ is positive below the pole, and negative or not real beyond."""

    def inside(at: Any) -> bool:
        try:
            return bool(real_value(phi, at, phi) > 0)
        except (PhiError, ZeroDivisionError):
            return False

    for _ in range(220):
        middle = (low + high) / 2
        low, high = (middle, high) if inside(middle) else (low, middle)
    if not real_value(phi, low, phi) > 10**6:
        where = f"beyond alpha = {mpmath.nstr(low, 6)}, where it neither turns nor goes to infinity"
        raise PhiError(f"phi = {phi} is no real number {where}")
    return Edge(_named(low), "pole")


def _named(root: Any) -> sympy.Expr:
    """Return the multiple of π or root of a fraction that agrees with a number to 40 digits; else a decimal."""
    for value, make in ((root / mpmath.pi, lambda q: q * sympy.pi), (root**2, sympy.sqrt)):
        near = Fraction(int(mpmath.nint(value * 5040)), 5040)
        if abs(value - mpmath.mpf(near.numerator) / near.denominator) < mpmath.mpf(10) ** -40:
            return make(sympy.Rational(near.numerator, near.denominator))
    return sympy.Float(mpmath.nstr(root, 50), 50)


def closed_inverse(phi: sympy.Expr) -> sympy.Expr | None:
    """Return φ⁻¹ with `families.alpha` in place of the length; None if no form is found.

    The form holds from 0 to the edge of φ, where the root and every function of a composition increase.
    """
    return _unwound(phi) or _root(phi)


def _unwound(phi: sympy.Expr) -> sympy.Expr | None:
    """Return the inverse of a composition of functions and constant factors."""
    rest, found = phi, alpha
    while rest != alpha:
        factor, rest = rest.as_independent(alpha, as_Add=False)
        found = found / factor
        if rest != alpha:
            if rest.func != sympy.sin and not hasattr(rest, "inverse"):  # SymPy's sine has no inverse
                return None
            inverse = sympy.asin if rest.func == sympy.sin else rest.inverse()
            rest, found = rest.args[0], inverse(found)
    return found


def _root(phi: sympy.Expr) -> sympy.Expr | None:
    """Return the inverse if φ² is a quotient of quadratics in α², else None."""
    y = sympy.Dummy("y", positive=True)
    above, below = sympy.fraction(sympy.together((phi**2).subs(alpha, sympy.sqrt(y))))
    if not (above.is_polynomial(y) and below.is_polynomial(y)):
        return None
    N, D = sympy.Poly(above, y), sympy.Poly(below, y)
    if max(N.degree(), D.degree()) > 2:
        return None
    (_, n1, n2), (d0, d1, d2) = ([of.coeff_monomial(y**k) for k in range(3)] for of in (N, D))
    a, b = n2 - d2 * alpha**2, n1 - d1 * alpha**2
    inside = sympy.factor(sympy.expand(b**2 + 4 * a * d0 * alpha**2))
    return alpha * sympy.sqrt(2 * d0 / (b + sympy.sqrt(inside)))
