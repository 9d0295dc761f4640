"""Taylor's series of elementary functions, with intervals or balls as coefficients.

A series about one point has the coefficients there. A series about a box encloses those at every point of the box.
"""

from __future__ import annotations

from collections.abc import Sequence
from types import SimpleNamespace
from typing import Any


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
