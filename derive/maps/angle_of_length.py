"""Angle φ⁻¹ of a length |v| below the edge, to the working precision."""

from __future__ import annotations

import sys
from functools import lru_cache
from typing import Any

import mpmath
import sympy

from .elementary import evaluate
from .families import alpha
from .phi_error import PhiError


def real_value(expression: sympy.Expr, at: Any, phi: sympy.Expr) -> Any:
    """Return φ, or a derivative of φ, at an angle; `PhiError` if the value is not real."""
    value = evaluate(expression, alpha, at)
    if isinstance(value, mpmath.mpc | complex):
        if value.imag != 0:
            raise PhiError(f"phi = {phi} is no real number at alpha = {mpmath.nstr(at, 5)}")
        value = value.real
    return value if isinstance(value, float | mpmath.mpf) else mpmath.mpf(value)


def _end(phi: sympy.Expr, edge: sympy.Expr, size: Any) -> Any:
    """Return the edge as a number; without an edge, an angle where φ exceeds the length."""
    if not edge.is_infinite:
        return mpmath.mpf(edge.evalf(mpmath.mp.dps + 5))
    high = mpmath.mpf(1)
    while real_value(phi, high, phi) <= size:
        high = 2 * high
    return high


def angle_of(phi: sympy.Expr, edge: sympy.Expr, size: Any) -> Any:
    """Return φ⁻¹ of a length below φ at the edge, in the working precision; floats give the first guess."""
    if size == 0:
        return size
    slope, high = _slope(phi), _end(phi, edge, size)
    guess = min(size / real_value(slope, mpmath.mpf(0), phi), high / 2)
    try:
        found = _solved(phi, slope, float(size), float(high), float(guess), sys.float_info.epsilon)
        guess = mpmath.mpf(found) if 0 < found < high else guess
    except (ArithmeticError, ValueError):  # beyond the range of floats, or where rounding to floats makes φ complex
        pass
    return _solved(phi, slope, size, high, guess, mpmath.eps)


@lru_cache(maxsize=64)
def _slope(phi: sympy.Expr) -> sympy.Expr:
    return phi.diff(alpha)


def _solved(phi: sympy.Expr, slope: sympy.Expr, size: Any, high: Any, guess: Any, eps: Any) -> Any:
    """Solve φ = size by Newton's method between bounds, on φ or on 1/φ; bisect where both steps leave the bounds."""
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
