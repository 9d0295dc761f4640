"""Interval arithmetic: enclosures of an expression in α on real intervals and on complex rectangles, and of its series.

`Undecided` is raised where a value may be undefined, or may touch a pole or a branch cut; a smaller interval may be
decided. A series about a box has coefficients that enclose those at every point of the box.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import cache, reduce
from operator import mul
from types import SimpleNamespace
from typing import Any, TypeAlias

import flint
import mpmath
import sympy

from ..elementary import BOUND, Quotient, alpha, evaluate


class Series:
    """Series ``c_0 + c_1 t + …``, cut after its given coefficients."""

    def __init__(self, terms: Sequence[Any]) -> None:
        self.terms = list(terms)

    def _terms_of(self, other: Any) -> Sequence[Any]:
        return other.terms if isinstance(other, Series) else [other, *[0 * c for c in self.terms[1:]]]

    def __add__(self, other: Any) -> Series:
        return Series([a + b for a, b in zip(self.terms, self._terms_of(other), strict=True)])

    def __neg__(self) -> Series:
        return Series([-c for c in self.terms])

    def __sub__(self, other: Any) -> Series:
        return self.__add__(-1 * other)

    def __rsub__(self, other: Any) -> Series:
        return self.__neg__().__add__(other)

    def __mul__(self, other: Any) -> Series:
        if not isinstance(other, Series):
            return Series([c * other for c in self.terms])
        return Series([_product(self.terms, other.terms, k) for k in range(len(self.terms))])

    def __truediv__(self, other: Any) -> Series:
        if not isinstance(other, Series):
            return Series([c / other for c in self.terms])
        found = list[Any]()
        for k, c in enumerate(self.terms):
            found.append((c - _product(found, other.terms, k)) / other.terms[0])
        return Series(found)

    def __rtruediv__(self, other: Any) -> Series:
        return Series(self._terms_of(other)) / self

    def __pow__(self, count: int) -> Series:
        value = 0 * self + 1
        for _ in range(count):
            value = value * self
        return value

    __radd__, __rmul__ = __add__, __mul__

    @property
    def slope(self) -> Series:
        """Derivative, with a last coefficient of 0 that `with_slope` does not read."""
        return Series([*(k * c for k, c in enumerate(self.terms) if k), 0 * self.terms[0]])

    def with_slope(self, first: Any) -> Series:
        """Return the series that begins with a value and has this series as derivative."""
        return Series([first, *(c / k for k, c in enumerate(self.terms[:-1], 1))])


def _product(a: Sequence[Any], b: Sequence[Any], order: int) -> Any:
    """Return the coefficient of an order in a product of series; coefficients beyond the lists are left out."""
    return sum(a[i] * b[order - i] for i in range(max(0, order - len(b) + 1), min(order + 1, len(a))))


def library(base: Any) -> SimpleNamespace:
    """Return elementary functions of series, from those of their coefficients."""

    def paired(u: Series, first: Sequence[Any], sides: Sequence[int]) -> Sequence[Series]:
        """Return y and z with ``y′ = a z u′`` and ``z′ = b y u′`` for two signs."""
        rates, y, z = u.slope.terms, [first[0]], [first[1]]
        for k in range(1, len(rates)):
            rise, fall = (_product(rates, of, k - 1) / k for of in (z, y))
            y, z = [*y, sides[0] * rise], [*z, sides[1] * fall]
        return Series(y), Series(z)

    def circular(u: Series) -> Sequence[Series]:
        return paired(u, (base.sin(u.terms[0]), base.cos(u.terms[0])), (1, -1))

    def hyperbolic(u: Series) -> Sequence[Series]:
        return paired(u, (base.sinh(u.terms[0]), base.cosh(u.terms[0])), (1, 1))

    def exp(u: Series) -> Series:
        return paired(u, 2 * (base.exp(u.terms[0]),), (1, 1))[0]

    def sqrt(u: Series) -> Series:
        found = [base.sqrt(u.terms[0])]
        for k in range(1, len(u.terms)):
            found.append((u.terms[k] - _product(found[1:], found[1:], k - 2)) / (2 * found[0]))
        return Series(found)

    def arc(name: str, slope: Any) -> Any:
        return lambda u: (u.slope * slope(u)).with_slope(getattr(base, name)(u.terms[0]))

    def tanh(u: Series) -> Series:
        sine, cosine = hyperbolic(u)
        return sine / cosine

    return SimpleNamespace(
        sin=lambda u: circular(u)[0], cos=lambda u: circular(u)[1], exp=exp, sqrt=sqrt, tanh=tanh,
        sinh=lambda u: hyperbolic(u)[0], cosh=lambda u: hyperbolic(u)[1], log=arc("log", lambda u: 1 / u),
        asin=arc("asin", lambda u: 1 / sqrt(1 - u * u)), acos=arc("acos", lambda u: -1 / sqrt(1 - u * u)),
        atan=arc("atan", lambda u: 1 / (1 + u * u)), asinh=arc("asinh", lambda u: 1 / sqrt(1 + u * u)),
        atanh=arc("atanh", lambda u: 1 / (1 - u * u)), constant=base.constant,
    )  # fmt: skip


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
    """Enclosures as ``arb`` and ``acb`` of python-flint, with libraries of their real and complex functions."""

    def __init__(self) -> None:
        entire = {name: _method(name) for name in WITHOUT_CUTS} | {"constant": self._constant, "power": self._power}
        cut = _with_cuts(lambda a: a.log(analytic=True), lambda a: a.sqrt(analytic=True), flint.acb(0, 1))
        self.complex = SimpleNamespace(**entire, **cut)
        circular = {"sin": self._sin, "cos": lambda a: self._sin(a + flint.arb.pi() / 2)}
        self.real = SimpleNamespace(**(entire | circular), **{name: _method(name) for name in cut})

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
        point, square = (
            Series([middle, 1 + 0 * middle, *[0 * middle] * (count - 1)])
            for middle in (self.interval(mpmath.mpf(0), mpmath.mpf(0)), self.rectangle(along, along))
        )
        try:
            first, rest = (evaluate(e.above, BOUND, at, library(self._library(at.terms[0]))) for at in (point, square))
        except (Undecided, ZeroDivisionError, ValueError, OverflowError, mpmath.libmp.ComplexResult):
            return None
        bound = rest.terms[-1]
        return (first.terms[e.power : -1], bound) if mpmath.isfinite(self.size(bound)[1]) else None

    def _is_real(self, at: Any) -> bool:
        return isinstance(at, flint.arb)


def _method(name: str) -> Function:
    return lambda a: getattr(a, name)()


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
