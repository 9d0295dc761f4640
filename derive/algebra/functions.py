"""Elementary functions of dual numbers, ``f(a + ε a°) = f(a) + ε a° f'(a)``, over coefficients of any library.

Each function takes a plain or a dual number. The real function comes from the library of the coefficient: `sympy` for
its expressions, `mpmath` for its floats, `numpy` for its arrays and scalars, `math` for Python's own numbers.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from typing import Any

from .coefficients import Coefficient, ZeroDivisorError
from .dual import Dual, dual_part, real_part


def namespace(*values: Coefficient) -> Any:
    """Return the module whose functions fit the values: SymPy before mpmath before NumPy before `math`.

    The function imports nothing, since the library of a value is already loaded.
    """
    libraries = {type(real_part(value)).__module__.partition(".")[0] for value in values}
    for name in ("sympy", "mpmath", "numpy"):
        if name in libraries:
            return sys.modules[name]
    return math


def lift(value: Coefficient, f: Callable[[Any], Any], df: Callable[[Any], Any]) -> Coefficient:
    """Apply `f`, with derivative `df`, to a plain or a dual number."""
    return value.apply(f, df) if isinstance(value, Dual) else f(value)


def sin(value: Coefficient) -> Coefficient:
    """Return the sine."""
    library = namespace(value)
    return lift(value, library.sin, library.cos)


def cos(value: Coefficient) -> Coefficient:
    """Return the cosine."""
    library = namespace(value)
    return lift(value, library.cos, lambda a: -library.sin(a))


def tan(value: Coefficient) -> Coefficient:
    """Return the tangent as a quotient, so that an exact pole is a `ZeroDivisionError`."""
    return _quotient(sin(value), cos(value), "tan", value)


def cot(value: Coefficient) -> Coefficient:
    """Return the cotangent; an exact pole is a `ZeroDivisionError`."""
    return _quotient(cos(value), sin(value), "cot", value)


def atan(value: Coefficient) -> Coefficient:
    """Return the principal arc tangent."""
    return lift(value, namespace(value).atan, lambda a: 1 / (1 + a * a))


def asin(value: Coefficient) -> Coefficient:
    """Return the principal arc sine."""
    library = namespace(value)
    return lift(value, library.asin, lambda a: 1 / library.sqrt(1 - a * a))


def acos(value: Coefficient) -> Coefficient:
    """Return the principal arc cosine."""
    library = namespace(value)
    return lift(value, library.acos, lambda a: -1 / library.sqrt(1 - a * a))


def exp(value: Coefficient) -> Coefficient:
    """Return the exponential."""
    library = namespace(value)
    return lift(value, library.exp, library.exp)


def log(value: Coefficient) -> Coefficient:
    """Return the natural logarithm."""
    return lift(value, namespace(value).log, lambda a: 1 / a)


def expm1(value: Coefficient) -> Coefficient:
    """Return exp − 1, accurate near 0 to the last digit; for numbers only, since SymPy has no such function."""
    library = namespace(value)
    return lift(value, library.expm1, library.exp)


def log1p(value: Coefficient) -> Coefficient:
    """Return the logarithm of 1 plus the value, accurate near 0 to the last digit; for numbers only, like `expm1`."""
    return lift(value, namespace(value).log1p, lambda a: 1 / (1 + a))


def sinh(value: Coefficient) -> Coefficient:
    """Return the hyperbolic sine."""
    library = namespace(value)
    return lift(value, library.sinh, library.cosh)


def cosh(value: Coefficient) -> Coefficient:
    """Return the hyperbolic cosine."""
    library = namespace(value)
    return lift(value, library.cosh, library.sinh)


def tanh(value: Coefficient) -> Coefficient:
    """Return the hyperbolic tangent."""
    return sinh(value) / cosh(value)


def atan2(y: Coefficient, x: Coefficient) -> Coefficient:
    """Return the angle of the point (x, y), real part in (−π, π]; dual part ``(x y° − y x°)/(x² + y²)``."""
    a, b = real_part(y), real_part(x)
    angle = namespace(y, x).atan2(a, b)
    if not (isinstance(y, Dual) or isinstance(x, Dual)):
        return angle
    return Dual(angle, (b * dual_part(y) - a * dual_part(x)) / (a * a + b * b))


def sqrt(value: Coefficient) -> Coefficient:
    """Return the square root; elements of an exact ring use their own method ``sqrt``.

    Raises
    ------
    ZeroDivisorError
        For a dual number with real part zero: the root is not differentiable there.
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
