"""Lower bound of |φ| on a circle about 0, and proof that φ is analytic inside, by interval arithmetic."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import lru_cache, reduce
from operator import add, mul
from typing import Any, TypeAlias

import mpmath
import sympy

from ..families import alpha
from .edges import DIGITS
from .elementary import evaluate

ARCS = 128
NOT_INTERVALS = "interval arithmetic does not know it"


def smallest(phi: sympy.Expr, radius: Any) -> Any:
    """Return a lower bound of |φ| on a quarter of a circle.

    The result is None if ``Re φ/(φ′(0) α) > 0`` is not proved there.
    """
    with mpmath.workdps(DIGITS):
        slope = mpmath.mpf(evaluate(phi.diff(alpha), alpha, mpmath.mpf(0)))
    least = mpmath.inf
    try:
        for box in _arcs(radius):
            value = _on_intervals(phi)(box)
            if not (value / box / slope).real > 0:
                return None
            least = min(least, mpmath.mpf(abs(value).a))
    except (ZeroDivisionError, ValueError, TypeError):
        return None
    return least if least > 0 and mpmath.isfinite(least) else None


def is_analytic(phi: sympy.Expr, radius: Any) -> bool:
    """Return whether φ is proved to be analytic in a quarter of a disc."""
    try:
        for box in _cells(radius):
            _on_intervals(phi)(box)
    except (ZeroDivisionError, ValueError, TypeError):
        return False
    return True


def _arcs(radius: Any) -> Iterator[Any]:
    iv = mpmath.iv
    for k in range(ARCS):
        angle = iv.mpf([k, k + 1]) * iv.pi / (2 * ARCS)
        yield iv.mpc(iv.mpf(radius) * iv.cos(angle), iv.mpf(radius) * iv.sin(angle))


def _cells(radius: Any, parts: int = 12) -> Iterator[Any]:
    """Return squares that cover a quarter of the disc."""
    iv = mpmath.iv
    side = iv.mpf(radius) / parts
    for i in range(parts):
        for j in range(parts):
            if i * i + j * j < parts * parts:
                yield iv.mpc(side * iv.mpf([i, i + 1]), side * iv.mpf([j, j + 1]))


Interval: TypeAlias = Any
"""Complex or real interval of mpmath."""


@lru_cache(maxsize=256)
def _on_intervals(e: sympy.Expr) -> Callable[[Interval], Interval]:
    """Return an expression as a function of complex intervals.

    The function raises ValueError where an interval may contain a pole or a branch cut.
    """
    if e == alpha:
        return lambda z: z
    if not e.free_symbols:
        constant = _constant(e)
        return lambda z: constant
    parts = [_on_intervals(a) for a in e.args if not (e.is_Pow and a == e.exp)]
    first, exponent = parts[0], e.exp if e.is_Pow else None
    if e.is_Add or e.is_Mul:
        combine = add if e.is_Add else mul
        return lambda z: reduce(combine, (part(z) for part in parts))
    if exponent is not None and exponent.is_Integer:
        return lambda z: _power(first(z), int(exponent))
    if exponent is not None and exponent.is_Rational:
        p, q = int(exponent.p), int(exponent.q)
        return lambda z: mpmath.iv.exp(_log(first(z)) * p / q)
    function = _functions()[e.func]
    return lambda z: function(_complex(first(z)))


def _constant(e: sympy.Expr) -> Interval:
    with mpmath.workdps(DIGITS):
        value = mpmath.mpf(e.evalf(DIGITS))
    off = abs(value) * mpmath.mpf(2) ** -45
    return mpmath.iv.mpf([value - off, value + off])


def _power(base: Interval, exponent: int) -> Interval:
    power = reduce(mul, [base] * abs(exponent))
    return power if exponent > 0 else 1 / _nonzero(power)


def _functions() -> dict[Any, Callable[[Any], Any]]:
    iv = mpmath.iv
    i = iv.mpc(0, 1)
    return {
        sympy.sin: iv.sin, sympy.cos: iv.cos, sympy.exp: iv.exp, sympy.log: _log,
        sympy.tan: lambda a: iv.sin(a) / _nonzero(iv.cos(a)),
        sympy.sinh: lambda a: (iv.exp(a) - iv.exp(-a)) / 2,
        sympy.cosh: lambda a: (iv.exp(a) + iv.exp(-a)) / 2,
        sympy.tanh: lambda a: (iv.exp(a) - iv.exp(-a)) / _nonzero(iv.exp(a) + iv.exp(-a)),
        sympy.asin: lambda a: -i * _log(i * a + iv.exp(_log(1 - a * a) / 2)),
        sympy.acos: lambda a: iv.pi / 2 + i * _log(i * a + iv.exp(_log(1 - a * a) / 2)),
        sympy.atan: lambda a: i / 2 * (_log(1 - i * a) - _log(1 + i * a)),
    }  # fmt: skip


def _nonzero(value: Any) -> Any:
    """Return the value; raise if the interval contains 0."""
    if not abs(value).a > 0:
        raise ValueError(NOT_INTERVALS)
    return value


def _log(value: Any) -> Any:
    """Return the principal logarithm; raise unless the real part is positive."""
    if not _complex(value).real.a > 0:
        raise ValueError(NOT_INTERVALS)
    return mpmath.iv.log(_complex(value))


def _complex(value: Any) -> Any:
    return value if hasattr(value, "_mpci_") else mpmath.iv.mpc(value)
