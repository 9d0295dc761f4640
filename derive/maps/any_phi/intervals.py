"""How small a φ is on a circle about 0, and that it is analytic inside: by interval arithmetic on small arcs."""

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
    """The least |φ| on a quarter of a circle, rounded down, where ``Re φ/(φ′(0) α) > 0``; else, or unproved, None."""
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
    """Whether φ is proved to be analytic in a quarter of a disc."""
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
    """Squares that cover a quarter of the disc: φ is analytic in each, or an error."""
    iv = mpmath.iv
    side = iv.mpf(radius) / parts
    for i in range(parts):
        for j in range(parts):
            if i * i + j * j < parts * parts:
                yield iv.mpc(side * iv.mpf([i, i + 1]), side * iv.mpf([j, j + 1]))


Interval: TypeAlias = Any
"""A complex interval of mpmath, or a real one."""


@lru_cache(maxsize=256)
def _on_intervals(e: sympy.Expr) -> Callable[[Interval], Interval]:
    """An expression as a function of complex intervals; ValueError where a branch cut or a pole may be met."""
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
    return power if exponent > 0 else 1 / _away(power)


def _functions() -> dict[Any, Callable[[Any], Any]]:
    iv = mpmath.iv
    i = iv.mpc(0, 1)
    return {
        sympy.sin: iv.sin, sympy.cos: iv.cos, sympy.exp: iv.exp, sympy.log: _log,
        sympy.tan: lambda a: iv.sin(a) / _away(iv.cos(a)),
        sympy.sinh: lambda a: (iv.exp(a) - iv.exp(-a)) / 2,
        sympy.cosh: lambda a: (iv.exp(a) + iv.exp(-a)) / 2,
        sympy.tanh: lambda a: (iv.exp(a) - iv.exp(-a)) / _away(iv.exp(a) + iv.exp(-a)),
        sympy.asin: lambda a: -i * _log(i * a + iv.exp(_log(1 - a * a) / 2)),
        sympy.acos: lambda a: iv.pi / 2 + i * _log(i * a + iv.exp(_log(1 - a * a) / 2)),
        sympy.atan: lambda a: i / 2 * (_log(1 - i * a) - _log(1 + i * a)),
    }  # fmt: skip


def _away(value: Any) -> Any:
    """The value, which has to be no zero."""
    if not abs(value).a > 0:
        raise ValueError(NOT_INTERVALS)
    return value


def _log(value: Any) -> Any:
    """The principal logarithm, of what has a positive real part."""
    if not _complex(value).real.a > 0:
        raise ValueError(NOT_INTERVALS)
    return mpmath.iv.log(_complex(value))


def _complex(value: Any) -> Any:
    return value if hasattr(value, "_mpci_") else mpmath.iv.mpc(value)
