"""Elementary functions of dual numbers, ``f(a + ε a°) = f(a) + ε a° f'(a)``, over coefficients of any library.

Each function takes a plain or a dual number. The real function comes from the library of the coefficient: `sympy` for
its expressions, `mpmath` for its floats, `numpy` for its arrays and scalars, `math` for Python's own numbers.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from functools import lru_cache
from typing import Any

from .dual import Coefficient, Dual, ZeroDivisorError, dual_part, real_part


def namespace(*values: Coefficient) -> Any:
    """Return the library of the values: SymPy, mpmath or NumPy, else a type with its own ``sqrt``, else `math`."""
    return _library(tuple(type(real_part(value)) for value in values))


@lru_cache(maxsize=64)
def _library(plain: tuple[type, ...]) -> Any:
    libraries = {kind.__module__.partition(".")[0] for kind in plain}
    for name in ("sympy", "mpmath", "numpy"):
        if name in libraries:
            return sys.modules[name]  # already imported, since a value belongs to this library
    return next((kind for kind in plain if hasattr(kind, "sqrt")), math)


def _lifted(name: str, slope: Callable[[Any, Any], Any]) -> Callable[[Elementary, Coefficient], Coefficient]:
    """Return the method for plain and dual numbers of a real function, given its derivative ``slope(functions, a)``."""

    def method(self: Elementary, a: Coefficient) -> Coefficient:
        if isinstance(a, Dual):
            return a.apply(lambda re: method(self, re), lambda re: slope(self, re))
        return self.real(name, a)(a)

    return method


class Elementary:
    """Elementary functions of plain numbers and, by their derivatives, of dual numbers, nested ones included."""

    def real(self, name: str, *values: Coefficient) -> Callable[..., Coefficient]:
        return getattr(namespace(*values), name)  # type: ignore[no-any-return]

    sin = _lifted("sin", lambda f, a: f.cos(a))
    cos = _lifted("cos", lambda f, a: -f.sin(a))
    atan = _lifted("atan", lambda f, a: 1 / (1 + a * a))
    asin = _lifted("asin", lambda f, a: 1 / f.sqrt(1 - a * a))
    acos = _lifted("acos", lambda f, a: -1 / f.sqrt(1 - a * a))
    exp = _lifted("exp", lambda f, a: f.exp(a))
    log = _lifted("log", lambda f, a: 1 / a)
    sinh = _lifted("sinh", lambda f, a: f.cosh(a))
    cosh = _lifted("cosh", lambda f, a: f.sinh(a))
    asinh = _lifted("asinh", lambda f, a: 1 / f.sqrt(1 + a * a))
    atanh = _lifted("atanh", lambda f, a: 1 / (1 - a * a))
    # full precision near 0; SymPy has neither function
    expm1 = _lifted("expm1", lambda f, a: f.exp(a))
    log1p = _lifted("log1p", lambda f, a: 1 / (1 + a))

    def tan(self, a: Coefficient) -> Coefficient:
        """Return the tangent, ``sin/cos``; an exact pole raises `ZeroDivisorError`."""
        return _quotient(self.sin(a), self.cos(a), "tan", a)

    def cot(self, a: Coefficient) -> Coefficient:
        """Return the cotangent; an exact pole raises `ZeroDivisorError`."""
        return _quotient(self.cos(a), self.sin(a), "cot", a)

    def tanh(self, a: Coefficient) -> Coefficient:
        return self.sinh(a) / self.cosh(a)

    def atan2(self, y: Coefficient, x: Coefficient) -> Coefficient:
        """Return the angle of the point (x, y): real part in (−π, π], dual part ``(x y° − y x°)/(x² + y²)``."""
        if not (isinstance(y, Dual) or isinstance(x, Dual)):
            return self.real("atan2", y, x)(y, x)
        a, b = real_part(y), real_part(x)
        return Dual(self.atan2(a, b), (b * dual_part(y) - a * dual_part(x)) / (a * a + b * b))

    def sqrt(self, a: Coefficient) -> Coefficient:
        """Return the square root; a zero divisor raises `ZeroDivisorError`, since the root has no derivative at 0."""
        if not isinstance(a, Dual):
            return self.real("sqrt", a)(a)
        if a.re == 0:
            raise ZeroDivisorError(f"{a!r} has real part zero: a zero divisor has no square root")
        root = self.sqrt(a.re)
        return Dual(root, a.du / (2 * root))


def _quotient(numerator: Coefficient, denominator: Coefficient, name: str, at: Coefficient) -> Coefficient:
    if real_part(denominator) == 0:
        raise ZeroDivisorError(f"{name} has a pole at {at!r}")
    return numerator / denominator


_of = Elementary()
sin, cos, tan, cot, sinh, cosh, tanh = _of.sin, _of.cos, _of.tan, _of.cot, _of.sinh, _of.cosh, _of.tanh
asin, acos, atan, atan2, sqrt = _of.asin, _of.acos, _of.atan, _of.atan2, _of.sqrt
asinh, atanh = _of.asinh, _of.atanh
exp, log, expm1, log1p = _of.exp, _of.log, _of.expm1, _of.log1p
