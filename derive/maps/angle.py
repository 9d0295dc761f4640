"""Angle φ⁻¹ of a length as a function of SymPy, for charts whose φ has no inverse in closed form."""

from __future__ import annotations

from typing import Any

import mpmath
import sympy

from .angle_of_length import angle_of, real_value
from .families import alpha
from .polynomials import x

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
        """Return the angle as a function of x, for φ as a function of `families.alpha`."""
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
