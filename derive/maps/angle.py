"""Angle φ⁻¹ of a length |v| below the edge: to the working precision, and as a function of SymPy."""

from __future__ import annotations

import sys
from functools import lru_cache
from typing import Any

import mpmath
import sympy

from .elementary import alpha, evaluate
from .grammar import PhiError
from .polynomials import x


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


TURN = sympy.Symbol("_alpha", real=True)
"""Bound symbol of φ in an `Angle`; the name cannot be one of a user's own symbols by accident."""

GUARD = 20
"""Further bits of the inversion, for the rounding errors of Newton's last step."""


class Angle(sympy.Function):  # type: ignore[misc]  # SymPy is untyped
    """Angle α below the edge with φ(α) = r: ``Angle(Lambda(TURN, φ), edge, r)``; NaN if there is none.

    SymPy differentiates it by r, with the slope 1/φ′(α), and evaluates it to any precision.
    """

    nargs = 3
    is_commutative = True

    @classmethod
    def at_square(cls, phi: sympy.Expr, edge: sympy.Expr) -> sympy.Expr:
        """Return the angle as a function of x, for φ as a function of `elementary.alpha`."""
        return cls(sympy.Lambda(TURN, phi.xreplace({alpha: TURN})), edge, sympy.sqrt(x))

    @classmethod
    def eval(cls, phi: sympy.Lambda, edge: sympy.Expr, length: sympy.Expr) -> sympy.Expr | None:
        """Return the angle of 0 or of a float; other angles stay unevaluated."""
        if length.is_Float and length > 0:
            return cls(phi, edge, length, evaluate=False)._eval_evalf(length._prec)
        return sympy.Integer(0) if length.is_zero else None

    def fdiff(self, argindex: int = 3) -> sympy.Expr:
        """Return the derivative by the length, 1/φ′(α)."""
        phi = self.args[0]
        return 1 / phi.expr.diff(TURN).xreplace({TURN: self})

    def _eval_derivative(self, symbol: sympy.Symbol) -> sympy.Expr:
        return self.fdiff() * self.args[2].diff(symbol)

    def _eval_subs(self, old: Any, new: Any) -> sympy.Expr:
        """Replace in the length alone; SymPy would replace the bound symbol too."""
        return self.func(*self.args[:2], self.args[2]._subs(old, new))

    def _eval_evalf(self, prec: int) -> Any:
        phi, edge = self.args[0].expr.xreplace({TURN: alpha}), self.args[1]
        with mpmath.workprec(prec + GUARD):
            size = self.args[2].evalf(mpmath.mp.dps)
            if not size.is_Float:
                return None
            size = mpmath.mpf(size)
            found = angle_of(phi, edge, size)
            # the angle's rounding error is eps; near a pole it grows in φ by α φ′/φ
            beyond = abs(real_value(phi, found, phi) / size - 1) > mpmath.mpf(2) ** (-prec // 4)
        return sympy.nan if beyond else sympy.Float._new(found._mpf_, prec)

    def _sympystr(self, printer: Any) -> str:
        return f"angle({printer._print(self.args[2])})"

    def _latex(self, printer: Any, exp: str | None = None) -> str:
        value = rf"\varphi^{{-1}}\left({printer._print(self.args[2])}\right)"
        return f"{{{value}}}^{{{exp}}}" if exp else value
