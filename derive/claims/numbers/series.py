r"""Truncated Laurent series in one small parameter, over the numbers of another field.

One evaluation of a formula at :math:`a + s` gives its derivatives and its limit at a. A quotient of two series drops
their common powers of s, so removable singularities are filled. Roots and signs are those for small s > 0; where they
differ for s < 0, `SeriesField.one_sided` records it.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

from ...algebra import Dual, Structure
from ...algebra.element import Element, NotExactError
from .fields import Field, UndefinedError


class Series:
    """Series ``s^order (c₀ + c₁ s + …)`` with the coefficients known; numbers of other fields are constant."""

    __slots__ = ("coefficients", "field", "order")
    __hash__ = None  # type: ignore[assignment]  # equality compares the known coefficients

    def __init__(self, field: SeriesField, order: int, coefficients: Sequence[Any]) -> None:
        zeros = 0
        while zeros < len(coefficients) and field.is_zero(coefficients[zeros]):
            zeros += 1
        self.field, self.order, self.coefficients = field, order + zeros, tuple(coefficients[zeros:])

    @property
    def end(self) -> int:
        """Order of the first unknown term."""
        return self.order + len(self.coefficients)

    def __getitem__(self, power: int) -> Any:
        """Return the coefficient of a power of s; raise UndefinedError if it is not known."""
        if power >= self.end:
            raise UndefinedError("too few terms of a series are known")
        return self.coefficients[power - self.order] if power >= self.order else 0

    def upto(self, end: int) -> list[Any]:
        """Return the coefficients of s⁰ … before s^end; a negative power of s raises UndefinedError."""
        if self.coefficients and self.order < 0:
            raise UndefinedError("a pole")
        return [self[power] for power in range(end)]

    def _both(self, other: Any, f: Callable[[Series, Series], Any]) -> Any:
        """Return f of two series of the higher field; structures and dual numbers take the operation over."""
        if isinstance(other, Dual | Structure):
            return NotImplemented
        field = other.field if isinstance(other, Series) and other.field.level > self.field.level else self.field
        return f(field.series(self), field.series(other))

    def _is_constant(self, other: Any) -> bool:
        """Return whether the other operand is a number of a lower field."""
        if isinstance(other, Series):
            return other.field.level < self.field.level
        return not isinstance(other, Dual | Structure)

    def __add__(self, other: Any) -> Any:
        return self._both(other, lambda a, b: a._sum(b, operator.add))

    __radd__ = __add__

    def __sub__(self, other: Any) -> Any:
        return self._both(other, lambda a, b: a._sum(b, operator.sub))

    def __rsub__(self, other: Any) -> Any:
        return -self + other

    def _sum(self, other: Series, f: Callable[[Any, Any], Any]) -> Series:
        low, high = min(self.order, other.order), min(self.end, other.end)
        return Series(self.field, low, [f(self[k], other[k]) for k in range(low, high)])

    def __mul__(self, other: Any) -> Any:
        if isinstance(other, int) and other == 0:
            return 0
        if self._is_constant(other):
            return Series(self.field, self.order, [c * other for c in self.coefficients])
        return self._both(other, lambda a, b: a._product(b))

    __rmul__ = __mul__

    def _product(self, other: Series) -> Series:
        a, b = self.coefficients, other.coefficients
        size = min(len(a), len(b))
        convolved = getattr(self.field.base, "convolved", _convolved)
        return Series(self.field, self.order + other.order, convolved(a[:size], b[:size]))

    def __truediv__(self, other: Any) -> Any:
        if self._is_constant(other) and not self.field.is_zero(other):
            return Series(self.field, self.order, [c / self.field.number(other) for c in self.coefficients])
        return self._both(other, lambda a, b: a._quotient(b))

    def __rtruediv__(self, other: Any) -> Any:
        return self._both(other, lambda a, b: b._quotient(a))

    def _quotient(self, other: Series) -> Series:
        if not other.coefficients:
            raise UndefinedError("division by a series without a known term")
        size = min(len(self.coefficients), len(other.coefficients))
        if not size:  # no term is known to differ from 0
            return Series(self.field, self.order - other.order, ())
        divided = getattr(self.field.base, "divided", _divided)
        found = divided(self.coefficients[:size], other.coefficients[:size])
        return Series(self.field, self.order - other.order, found)

    def __neg__(self) -> Series:
        return Series(self.field, self.order, [-c for c in self.coefficients])

    def __abs__(self) -> Series:
        return -self if self < 0 else self

    def __pow__(self, exponent: int) -> Any:
        result: Any = self.field.series(1)
        for _ in range(abs(exponent)):
            result = result * self
        return 1 / result if exponent < 0 else result

    def __eq__(self, other: object) -> bool:
        difference = self - other
        return not (difference.coefficients if isinstance(difference, Series) else difference)

    def __lt__(self, other: Any) -> bool:
        return bool(self._sign(other) < 0)

    def __gt__(self, other: Any) -> bool:
        return bool(self._sign(other) > 0)

    def _sign(self, other: Any) -> Any:
        """Return a number with the sign of the difference for small s > 0; an odd power has the other one for s < 0."""
        difference = self - other
        if not difference.coefficients:
            return 0
        self.field.one_sided |= difference.order % 2 != 0
        return difference.coefficients[0]

    def derivative(self) -> Series:
        found = [k * c for k, c in enumerate(self.coefficients, self.order)]
        return Series(self.field, self.order - 1, found)

    def integral(self, constant: Any) -> Series:
        if self.order < 0 and self.coefficients:
            raise UndefinedError("the integral of a pole")
        found = [self[k] / self.field.number(k + 1) for k in range(self.end)]
        return Series(self.field, 0, [constant, *found])


def _convolved(a: Sequence[Any], b: Sequence[Any]) -> list[Any]:
    """Return the sums ``Σ aᵢ b₍ₖ₋ᵢ₎``."""
    return [sum((a[i] * b[k - i] for i in range(1, k + 1)), a[0] * b[k]) for k in range(len(a))]


def _divided(a: Sequence[Any], b: Sequence[Any]) -> list[Any]:
    found: list[Any] = []
    for k in range(len(a)):
        rest = a[k]
        for i in range(k):
            rest = rest - found[i] * b[k - i]
        found.append(rest / b[0])
    return found


class SeriesField(Field):
    """Field of series with `terms` coefficients over another field."""

    def __init__(self, base: Field, terms: int) -> None:
        self.base, self.terms = base, terms
        self.level: int = getattr(base, "level", 0) + 1
        self.ordered = base.ordered
        self.one_sided = False

    def series(self, a: Any) -> Series:
        if isinstance(a, Series) and a.field is self:
            return a
        return self.at(a, 0)

    def at(self, a: Any, slope: Any) -> Series:
        """Return ``a + slope s``."""
        return Series(self, 0, [self.number(a), self.number(slope), *[Fraction(0)] * (self.terms - 2)])

    @staticmethod
    def number(a: Any) -> Any:
        """Return a number, an integer as a fraction, whose quotients are exact."""
        return Fraction(a) if isinstance(a, int) else a

    def is_zero(self, a: Any) -> bool:
        return not a if isinstance(a, int | Fraction) else self.base.vanishes(a)

    def real(self, name: str, *values: Any) -> Callable[..., Any]:
        def of_series(*arguments: Any) -> Any:
            if not any(isinstance(a, Series) and a.field is self for a in arguments):
                return getattr(self.base, name)(*arguments)
            if not hasattr(self, f"_{name}"):
                raise NotExactError(f"the series of {name}")
            return getattr(self, f"_{name}")(*map(self.series, arguments))

        return of_series

    def pair(self, n: Any, x: Any) -> tuple[Any, Any]:
        if not isinstance(n, int):
            raise NotExactError("derivatives of p_n and q_n for a symbolic n")
        return Field.pair(n, x)

    def power(self, base: Any, exponent: Any) -> Any:
        """Return a power; that with a letter as exponent by ``f g' = exponent f' g``."""
        if not isinstance(exponent, Element) or isinstance(base, Dual | Structure):
            return super().power(base, exponent)
        u = self.series(base).upto(self.series(base).end)
        found = [self.base.power(u[0], exponent)]
        for k in range(1, len(u)):
            terms = ((exponent * j - (k - j)) * u[j] * found[k - j] for j in range(1, k + 1))
            found.append(sum(terms) / (u[0] * self.number(k)))
        return Series(self, 0, found)

    def same(self, a: Any, b: Any) -> bool:
        return self.vanishes(a - b)

    def crosses(self, a: Any) -> bool:
        return a.order > 0 and bool(a.coefficients) if isinstance(a, Series) else self.base.vanishes(a)

    def vanishes(self, a: Any) -> bool:
        return not a.coefficients if isinstance(a, Series) and a.field is self else self.base.vanishes(a)

    @property
    def pi(self) -> Any:
        return self.base.pi

    # ---- functions of series, by their differential equations ---------------------------------------------------

    def _circle(self, a: Series, start: tuple[Any, Any], sign: int) -> tuple[Series, Series]:
        """Return (S, C) with ``S' = C a'``, ``C' = sign S a'``: sine and cosine, or the hyperbolic ones."""
        u = a.upto(a.end)
        S, C = [start[0]], [start[1]]
        for k in range(1, len(u)):
            S.append(sum(j * u[j] * C[k - j] for j in range(1, k + 1)) / self.number(k))
            C.append(sign * sum(j * u[j] * S[k - j] for j in range(1, k + 1)) / self.number(k))
        return Series(self, 0, S), Series(self, 0, C)

    def _start(self, a: Series) -> Any:
        return a.upto(1)[0]

    def _sin(self, a: Series) -> Series:
        c = self._start(a)
        return self._circle(a, (self.base.sin(c), self.base.cos(c)), -1)[0]

    def _cos(self, a: Series) -> Series:
        c = self._start(a)
        return self._circle(a, (self.base.sin(c), self.base.cos(c)), -1)[1]

    def _exp(self, a: Series) -> Series:
        start = self.base.exp(self._start(a))
        return self._circle(a, (start, start), 1)[0]

    def _log(self, a: Series) -> Any:
        return (a.derivative() / a).integral(self.base.log(self._start(a)))

    def _sqrt(self, a: Series) -> Any:
        if not a.coefficients:
            return Series(self, -(-a.order // 2), ())
        if a.order % 2:
            raise UndefinedError("the root of an odd power")
        self.one_sided |= a.order % 4 != 0
        c = a.coefficients
        found = [self.base.sqrt(c[0])]
        for k in range(1, len(c)):
            inner = sum(found[i] * found[k - i] for i in range(1, k))
            found.append((c[k] - inner) / (2 * found[0]))
        return Series(self, a.order // 2, found)

    def _atan2(self, y: Series, x: Series) -> Any:
        low = min(y.order, x.order)
        self.one_sided |= bool(y.order % 2 or x.order % 2)
        start = self.base.atan2(y[low], x[low])
        if self.ordered and y.order > low and x[low] < 0 and y < 0:
            start = -start  # just below the branch cut
        return ((x * y.derivative() - y * x.derivative()) / (x * x + y * y)).integral(start)

    def _asin(self, a: Series) -> Any:
        slope = a.derivative() / self.sqrt(1 - a * a)
        return slope.integral(self.base.asin(self._start(a)))

    def _acos(self, a: Series) -> Any:
        return (-a.derivative() / self.sqrt(1 - a * a)).integral(self.base.acos(self._start(a)))
