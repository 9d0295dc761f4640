"""Elementary functions of dual numbers, ``f(a + ε a°) = f(a) + ε a° f'(a)``, over coefficients of any library.

Each function takes a plain or a dual number. The real function comes from the library of the coefficient: `sympy` for
its expressions, `mpmath` for its floats, `numpy` for its arrays and scalars, `math` for Python's own numbers.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from typing import Any

from .dual import Coefficient, Dual, ZeroDivisorError, dual_part, real_part


def namespace(*values: Coefficient) -> Any:
    """Return the library of the values: the first of SymPy, mpmath and NumPy that has a value, else `math`."""
    libraries = {type(real_part(value)).__module__.partition(".")[0] for value in values}
    for name in ("sympy", "mpmath", "numpy"):
        if name in libraries:
            return sys.modules[name]  # already imported, since a value belongs to this library
    return math


def _elementary(name: str, slope: Callable[[Any, Any], Any]) -> Callable[[Coefficient], Coefficient]:
    """Return the function of plain and dual numbers with the given name in all libraries.

    The derivative at a is ``slope(library, a)``.
    """

    def function(value: Coefficient) -> Coefficient:
        library = namespace(value)
        f = getattr(library, name)
        return value.apply(f, lambda a: slope(library, a)) if isinstance(value, Dual) else f(value)

    return function


sin = _elementary("sin", lambda library, a: library.cos(a))
cos = _elementary("cos", lambda library, a: -library.sin(a))
atan = _elementary("atan", lambda library, a: 1 / (1 + a * a))
asin = _elementary("asin", lambda library, a: 1 / library.sqrt(1 - a * a))
acos = _elementary("acos", lambda library, a: -1 / library.sqrt(1 - a * a))
exp = _elementary("exp", lambda library, a: library.exp(a))
log = _elementary("log", lambda library, a: 1 / a)
sinh = _elementary("sinh", lambda library, a: library.cosh(a))
cosh = _elementary("cosh", lambda library, a: library.sinh(a))
# full precision near 0; SymPy has neither function
expm1 = _elementary("expm1", lambda library, a: library.exp(a))
log1p = _elementary("log1p", lambda library, a: 1 / (1 + a))


def tan(value: Coefficient) -> Coefficient:
    """Return the tangent, ``sin/cos``; an exact pole raises `ZeroDivisorError`."""
    return _quotient(sin(value), cos(value), "tan", value)


def cot(value: Coefficient) -> Coefficient:
    """Return the cotangent; an exact pole raises `ZeroDivisorError`."""
    return _quotient(cos(value), sin(value), "cot", value)


def tanh(value: Coefficient) -> Coefficient:
    """Return the hyperbolic tangent."""
    return sinh(value) / cosh(value)


def atan2(y: Coefficient, x: Coefficient) -> Coefficient:
    """Return the angle of the point (x, y): real part in (−π, π], dual part ``(x y° − y x°)/(x² + y²)``."""
    a, b = real_part(y), real_part(x)
    angle = namespace(y, x).atan2(a, b)
    if not (isinstance(y, Dual) or isinstance(x, Dual)):
        return angle
    return Dual(angle, (b * dual_part(y) - a * dual_part(x)) / (a * a + b * b))


def sqrt(value: Coefficient) -> Coefficient:
    """Return the square root; a zero divisor raises `ZeroDivisorError`, since the root has no derivative at 0.

    Elements of an exact ring use their own method ``sqrt``.
    """
    if not isinstance(value, Dual):
        return value.sqrt() if hasattr(value, "sqrt") else namespace(value).sqrt(value)
    if value.re == 0:
        raise ZeroDivisorError(f"{value!r} has real part zero: a zero divisor has no square root")
    root = sqrt(value.re)
    return Dual(root, value.du / (2 * root))


def _quotient(numerator: Coefficient, denominator: Coefficient, name: str, at: Coefficient) -> Coefficient:
    if real_part(denominator) == 0:
        raise ZeroDivisorError(f"{name} has a pole at {at!r}")
    return numerator / denominator
