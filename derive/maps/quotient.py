r"""Quotient ``N(α)/α^k`` as a function of SymPy that is analytic at α = 0, where N has a zero of order k or more.

Its derivative is ``(α N′ − k N)/α^(k+1)``; its value at 0 is a Taylor coefficient of N. Numbers near 0 are evaluated
with as many further digits as N loses there.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import mpmath
import sympy

from .families import alpha

BOUND = sympy.Symbol("_t")
"""Bound symbol of N; no name of a user's symbol begins so by accident."""
BESIDE_ORDER = 3
"""Orders beyond k whose digits are kept near 0, for derivatives by dual numbers."""


class Quotient(sympy.Function):  # type: ignore[misc]  # SymPy is untyped
    """Quotient of a function N and a power of the angle: ``Quotient(Lambda(BOUND, N), k, angle)``."""

    nargs = 3
    is_commutative = True

    @classmethod
    def of(cls, above: sympy.Expr, power: int, angle: sympy.Symbol) -> sympy.Expr:
        """Return ``above/angle^power``, for a function of the angle that has a zero of this order at 0."""
        if above.is_polynomial(angle):
            return sympy.expand(above / angle**power)
        return cls(sympy.Lambda(BOUND, above.subs(angle, BOUND)), sympy.Integer(power), angle)

    @classmethod
    def eval(cls, above: sympy.Lambda, power: sympy.Integer, angle: sympy.Expr) -> sympy.Expr | None:
        """Return the value at a number; the quotient at −α is written with that at α."""
        N, k = above.expr, int(power)
        if angle.is_zero:
            return taylor(N, k)
        if angle.is_number:
            floats = angle.atoms(sympy.Float)
            digits = min((mpmath.libmp.prec_to_dps(f._prec) for f in floats), default=0)
            near = angle.evalf(digits + int(lost(mpmath.mpf(angle.evalf()), k) / 3)) if floats else angle
            value = N.subs(BOUND, near) / near**k
            return value.evalf(digits) if floats else value
        if angle.could_extract_minus_sign() and (side := mirror(N)):
            return side * (-1) ** k * cls(above, power, -angle)
        return None

    @property
    def above(self) -> sympy.Expr:
        """Function N of the bound symbol."""
        return self.args[0].expr

    @property
    def power(self) -> int:
        """Power k of the angle."""
        return int(self.args[1])

    @property
    def written(self) -> sympy.Expr:
        """Quotient as an elementary expression, which is 0/0 at 0."""
        return self.above.subs(BOUND, self.args[2]) / self.args[2] ** self.power

    def _eval_derivative(self, symbol: sympy.Symbol) -> sympy.Expr:
        slope = sympy.expand(BOUND * self.above.diff(BOUND) - self.power * self.above)
        return Quotient.of(slope, self.power + 1, BOUND).subs(BOUND, self.args[2]) * self.args[2].diff(symbol)

    def _eval_subs(self, old: Any, new: Any) -> sympy.Expr:
        """Replace in the angle alone; SymPy would replace the bound symbol too."""
        return self.func(*self.args[:2], self.args[2]._subs(old, new))

    def _eval_evalf(self, prec: int) -> Any:
        at = self.args[2].evalf(mpmath.libmp.prec_to_dps(prec))
        return self.func(*self.args[:2], at) if at.is_Float else None

    def _sympystr(self, printer: Any) -> str:
        return f"({printer._print(self.written)})"

    def _latex(self, printer: Any, exp: str | None = None) -> str:
        value = rf"\left({printer._print(self.written)}\right)"
        return f"{value}^{{{exp}}}" if exp else value


@lru_cache(maxsize=1024)
def taylor(above: sympy.Expr, order: int) -> sympy.Expr:
    """Return a Taylor coefficient at 0 of a function of the bound symbol, exactly."""
    return sympy.expand(above.diff(BOUND, order).subs(BOUND, 0) / sympy.factorial(order))


@lru_cache(maxsize=256)
def mirror(above: sympy.Expr) -> int:
    """Return 1 for an even function of the bound symbol, −1 for an odd one, 0 if expansion shows neither."""
    there = above.subs(BOUND, -BOUND)
    return next((side for side in (1, -1) if sympy.expand(there - side * above) == 0), 0)


def lost(size: Any, power: int) -> int:
    """Return the binary digits that a quotient loses at a number."""
    return (power + BESIDE_ORDER) * max(0, -int(mpmath.mag(size)))


@lru_cache(maxsize=256)
def elementary(expression: sympy.Expr) -> sympy.Expr:
    """Return an expression without quotients, equal for α > 0."""
    if not expression.has(Quotient):
        return expression
    angle = sympy.Dummy("angle", positive=True)  # SymPy takes roots of its powers
    plain = expression.replace(lambda e: isinstance(e, Quotient), lambda e: e.written)
    return sympy.powdenest(sympy.expand_power_base(plain.xreplace({alpha: angle}))).xreplace({angle: alpha})
