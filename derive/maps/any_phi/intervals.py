"""Interval arithmetic: enclosures of an expression in α on real intervals and on complex rectangles, and of its series.

`Undecided` is raised where a value may be undefined, or may touch a pole or a branch cut; a smaller interval may be
decided. A series about a box has coefficients that enclose those at every point of the box.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache, reduce
from operator import mul
from types import SimpleNamespace
from typing import Any, TypeAlias

import flint
import mpmath
import sympy

from ..elementary import BOUND, Quotient, alpha, evaluate

BITS = 224
"""Working precision of enclosures: more than 60 digits."""

Function: TypeAlias = Callable[[Any], Any]
SQUARES = [mpmath.ldexp(1, k) for k in range(-5, 4)]
"""Half sides of squares about 0 in which quotients are series."""
TERMS = 40
"""Number of terms of a quotient's series before the remainder."""
WITHOUT_CUTS = ("sin", "cos", "exp", "sinh", "cosh", "tanh")


class Undecided(Exception):
    """Signal that an interval is too wide for an enclosure."""


class Intervals:
    """Enclosures as ``arb`` and ``acb`` of python-flint, with libraries of functions of these and of series."""

    def __init__(self) -> None:
        entire = {name: _method(name) for name in WITHOUT_CUTS} | {"constant": self._constant, "power": self._power}
        cut = _with_cuts(lambda a: a.log(analytic=True), lambda a: a.sqrt(analytic=True), flint.acb(0, 1))
        self.complex = SimpleNamespace(**entire, **cut)
        circular = {"sin": self._sin, "cos": lambda a: self._sin(a + flint.arb.pi() / 2)}
        self.real = SimpleNamespace(**(entire | circular), **{name: _method(name) for name in cut})
        self.series = SimpleNamespace(**_of_series(self.complex))

    def _sin(self, a: Any) -> Any:
        """Return the sine, by ``sin(m + t) = sin m (1 − 2 sin² t/2) + cos m sin t``; python-flint widens by t."""
        middle = a.mid()
        beside, half = a - middle, ((a - middle) / 2).sin()
        return middle.sin() * (1 - 2 * half * half) + middle.cos() * beside.sin()

    def _power(self, a: Any, count: int) -> Any:
        """Return a power as a product; that of python-flint is undefined for balls that hold 0."""
        return reduce(mul, count * [a])

    def _constant(self, e: sympy.Expr) -> Any:
        value = mpmath.mpf(e.evalf(mpmath.mp.dps + 5))
        off = abs(value) * mpmath.ldexp(1, -BITS)
        return self.interval(value - off, value + off)

    def rectangle(self, re: Any, im: Any) -> Any:
        """Return the complex numbers with real and imaginary part in two intervals."""
        return flint.acb(re, im)

    def interval(self, low: Any, high: Any) -> Any:
        return flint.arb(low).union(flint.arb(high))

    def bounds(self, value: Any) -> tuple[Any, Any]:
        """Return lower and upper bound of a real enclosure."""
        return mpmath.mpf(value.lower()), mpmath.mpf(value.upper())

    def size(self, value: Any) -> tuple[Any, Any]:
        """Return lower and upper bound of the absolute value."""
        return mpmath.mpf(value.abs_lower()), mpmath.mpf(value.abs_upper())

    def enclosure(self, expression: sympy.Expr, at: Any) -> Any:
        """Return an enclosure of an expression in α at a real interval or a complex rectangle."""
        try:
            found = evaluate(expression, alpha, at, self._library(at)) + 0 * at
            if mpmath.isfinite(self.size(found)[1]):
                return found
        except (ZeroDivisionError, ValueError, OverflowError, mpmath.libmp.ComplexResult):
            pass
        raise Undecided

    def _library(self, at: Any) -> SimpleNamespace:
        of = self.complex if hasattr(at, "imag") and not self._is_real(at) else self.real
        return SimpleNamespace(**vars(of), quotient=self.quotient)

    def quotient(self, e: Quotient, at: Any) -> Any:
        """Return an enclosure of ``N(α)/α^k``: as a quotient, or as the series of N from the term k on, if narrower.

        The remainder ``c_M α^(M−k)`` is Taylor's: c_M encloses the coefficient of order M at all points of a square
        about 0, and therefore its mean along the way from 0 to α.
        """
        low, size = self.size(at)
        side = next((side for side in SQUARES if size <= side), None)
        found = list[Any]()
        if side is not None and (series := self._terms(e, side)) is not None:
            terms, rest = series
            first = rest.real if self._is_real(at) else rest
            found.append(reduce(lambda value, term: value * at + term, reversed(terms), first))
        if low > 0 or not found:
            found.append(evaluate(e.above, BOUND, at, self._library(at)) / at**e.power)
        return min(found, key=self._width)

    def _width(self, value: Any) -> Any:
        low, high = self.size(value)
        return high - low if mpmath.isfinite(high) else mpmath.inf

    @cache  # noqa: B019  # one object per library
    def _terms(self, e: Quotient, side: Any) -> tuple[list[Any], Any] | None:
        """Return the terms of a quotient at 0, and c_M for a square about 0; None if N is not analytic there."""
        count, along = e.power + TERMS, self.interval(-side, side)
        before, flint.ctx.cap = flint.ctx.cap, count + 1
        try:
            places = flint.acb(0), self.rectangle(along, along)
            abouts = (flint.acb_series([middle, 1], count + 1) for middle in places)
            first, rest = (evaluate(e.above, BOUND, about, self.series) for about in abouts)
        except (Undecided, ZeroDivisionError, ValueError, OverflowError):
            return None
        finally:
            flint.ctx.cap = before
        known = min(first.prec, rest.prec) > count and mpmath.isfinite(self.size(rest[count])[1])
        return ([first[k].real for k in range(e.power, count)], rest[count]) if known else None

    def _is_real(self, at: Any) -> bool:
        return isinstance(at, flint.arb)


def _method(name: str) -> Function:
    return lambda a: getattr(a, name)()


def _of_series(of: SimpleNamespace) -> dict[str, Function]:
    """Return functions of power series, from those of their first coefficients, which are boxes about real numbers.

    Such a box that touches a branch cut contains the branch point, and so the slope has no finite enclosure there.
    """
    i = flint.acb(0, 1)

    def arc(name: str, slope: Function) -> Function:
        return lambda u: (u.derivative() * slope(u)).integral() + getattr(of, name)(u[0])

    def sqrt(u: Any, power: int = 1) -> Any:
        return (power * log(u) / 2).exp()  # narrower than python-flint's roots

    log = arc("log", lambda u: 1 / u)
    return {
        **{name: _method(name) for name in ("sin", "cos", "exp")}, "constant": of.constant, "log": log, "sqrt": sqrt,
        "sinh": lambda u: -i * (i * u).sin(), "cosh": lambda u: (i * u).cos(),
        "tanh": lambda u: -i * (i * u).sin() / (i * u).cos(), "atan": arc("atan", lambda u: 1 / (1 + u * u)),
        "asin": arc("asin", lambda u: sqrt(1 - u * u, -1)), "acos": arc("acos", lambda u: -sqrt(1 - u * u, -1)),
        "asinh": arc("asinh", lambda u: sqrt(1 + u * u, -1)), "atanh": arc("atanh", lambda u: 1 / (1 - u * u)),
    }  # fmt: skip


def _with_cuts(log: Function, sqrt: Function, i: Any) -> dict[str, Function]:
    """Return functions that have branch cuts, by analytic logarithms and roots."""
    return {
        "log": log, "sqrt": sqrt,
        "asin": lambda a: -i * log(i * a + sqrt(1 - a * a)),
        "acos": lambda a: -2 * i * log(sqrt((1 + a) / 2) + i * sqrt((1 - a) / 2)),
        "atan": lambda a: i / 2 * (log(1 - i * a) - log(1 + i * a)),
        "asinh": lambda a: log(a + sqrt(1 + a * a)),
        "atanh": lambda a: (log(1 + a) - log(1 - a)) / 2,
    }  # fmt: skip


INTERVALS = Intervals()
"""Enclosures of this process."""


@contextmanager
def precise() -> Iterator[Intervals]:
    before, flint.ctx.prec = flint.ctx.prec, BITS
    try:
        with mpmath.workprec(BITS + 32):
            yield INTERVALS
    finally:
        flint.ctx.prec = before
