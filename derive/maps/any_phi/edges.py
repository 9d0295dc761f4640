"""Where a φ ends, and the angle of a length before that."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any

import mpmath
import sympy

from ..families import alpha
from .elementary import evaluate
from .grammar import PhiError

DIGITS = 60
FURTHEST = 4
"""Where a chart without an edge is cut, in units of π."""
GRID = 2000


@dataclass(frozen=True)
class Edge:
    """Where φ ends: at φ′ = 0 (a fold), at a pole, or cut at 4π."""

    angle: sympy.Expr
    kind: str


def edge_of(phi: sympy.Expr) -> Edge:
    """The first φ′ = 0 or pole of φ.

    Raises
    ------
    PhiError
        If φ does not increase from 0, or is no real number.
    """
    slope = phi.diff(alpha)
    with mpmath.workdps(DIGITS):
        step = FURTHEST * mpmath.pi / GRID
        try:
            before = real_value(slope, mpmath.mpf(0), phi)
        except ZeroDivisionError:
            raise PhiError(f"phi = {phi} divides by zero at alpha = 0") from None
        if not before > 0:
            raise PhiError(f"phi'(0) = {mpmath.nstr(before, 5)}, and has to be positive")
        for k in range(1, GRID + 1):
            try:
                now, size = real_value(slope, k * step, phi), real_value(phi, k * step, phi)
            except (PhiError, ZeroDivisionError):
                return _pole(phi, (k - 1) * step, k * step)
            if now <= 0 or size <= 0:
                jumped = now > 10 * before or size <= 0
                return _pole(phi, (k - 1) * step, k * step) if jumped else _fold(phi, slope, (k - 1) * step, k * step)
            before = now
    return Edge(FURTHEST * sympy.pi, "cut")


def real_value(expression: sympy.Expr, at: Any, phi: sympy.Expr) -> Any:
    """φ, or a derivative of it, at an angle.

    Raises
    ------
    PhiError
        If it is no real number there.
    """
    value = evaluate(expression, alpha, at)
    if isinstance(value, mpmath.mpc | complex):
        if value.imag != 0:
            raise PhiError(f"phi = {phi} is no real number at alpha = {mpmath.nstr(at, 5)}")
        value = value.real
    return value if isinstance(value, float | mpmath.mpf) else mpmath.mpf(value)


def _fold(phi: sympy.Expr, slope: sympy.Expr, low: Any, high: Any) -> Edge:
    least = mpmath.mpf(10) ** -50
    root = mpmath.findroot(lambda a: real_value(slope, a, phi), (low, high), solver="anderson", tol=least)
    return Edge(_named(root), "fold")


def _pole(phi: sympy.Expr, low: Any, high: Any) -> Edge:
    """Where 1/φ changes sign, or φ stops being real."""

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
    """A multiple of π or the root of a fraction, where it is one to 40 digits; else a decimal."""
    for value, make in ((root / mpmath.pi, lambda q: q * sympy.pi), (root**2, sympy.sqrt)):
        near = Fraction(int(mpmath.nint(value * 5040)), 5040)
        if abs(value - mpmath.mpf(near.numerator) / near.denominator) < mpmath.mpf(10) ** -40:
            return make(sympy.Rational(near.numerator, near.denominator))
    return sympy.Float(mpmath.nstr(root, 50), 50)


def _end(phi: sympy.Expr, edge: sympy.Expr, size: Any) -> Any:
    """The edge, or an angle beyond that of a length."""
    if not edge.is_infinite:
        return mpmath.mpf(edge.evalf(mpmath.mp.dps + 5))
    high = mpmath.mpf(1)
    while real_value(phi, high, phi) <= size:
        high = 2 * high
    return high


def angle_of(phi: sympy.Expr, edge: sympy.Expr, size: Any) -> Any:
    """φ⁻¹ of a length, which is below that of the edge, in the working precision: from what floats make of it."""
    if size == 0:
        return size
    slope, high = _slope(phi), _end(phi, edge, size)
    guess = min(size / real_value(slope, mpmath.mpf(0), phi), high / 2)
    try:
        found = _solved(phi, slope, float(size), float(high), float(guess), sys.float_info.epsilon)
        guess = mpmath.mpf(found) if 0 < found < high else guess
    except (ArithmeticError, ValueError):  # beyond what floats hold, or where φ is real to more digits only
        pass
    return _solved(phi, slope, size, high, guess, mpmath.eps)


@lru_cache(maxsize=64)
def _slope(phi: sympy.Expr) -> sympy.Expr:
    return phi.diff(alpha)


def _solved(phi: sympy.Expr, slope: sympy.Expr, size: Any, high: Any, guess: Any, eps: Any) -> Any:
    """Newton's method between bounds: for φ, or 1/φ, which ends in no pole; where both leave them they are halved."""
    low = 0 * high
    for _ in range(8 * mpmath.mp.prec):
        reached, rise = real_value(phi, guess, phi), real_value(slope, guess, phi)
        low, high = (guess, high) if reached < size else (low, guess)
        steps = (size - reached) / rise, (1 - reached / size) * reached / rise
        inside = (at for at in (guess + step for step in steps) if low <= at <= high)
        better = next(inside, (low + high) / 2)
        guess, step = better, abs(better - guess)
        if step <= 8 * eps * better:
            break
    return guess
