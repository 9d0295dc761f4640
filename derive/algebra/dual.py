"""Dual numbers ``a + ε a°`` with ``ε² = 0``, and the base class of vectors, tensors and quaternions.

A coefficient is any value of a commutative ring with ``+ - *`` (and ``/`` where a method divides): ``int``, ``float``,
``Fraction``, mpmath ``mpf``, SymPy expressions, elements of exact rings, traced values, and `Dual` numbers over any of
these.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any, ClassVar, Self, TypeAlias

from .latex import Typeset, bracketed, latex, matrix

Coefficient: TypeAlias = Any


class ZeroDivisorError(ZeroDivisionError):
    """Error for inverting, dividing by or taking the root of a zero divisor, a dual number with real part zero."""


class Structure(Typeset):
    """Base class of vectors, tensors and quaternions: sums and multiples, component by component.

    A structure is never a coefficient. ``__array_ufunc__ = None`` makes NumPy leave products to the structure.
    """

    __slots__ = ()
    __array_ufunc__: ClassVar[None] = None
    columns: ClassVar[int] = 1
    """Number of columns in which notebooks show the components."""

    def __iter__(self) -> Iterator[Coefficient]:
        raise NotImplementedError

    @classmethod
    def from_components(cls, components: Iterable[Coefficient], /) -> Self:
        """Return the structure with these components, in the order of iteration."""
        raise NotImplementedError

    @classmethod
    def dual(cls, re: Iterable[Coefficient], du: Iterable[Coefficient]) -> Self:
        """Return the dual structure ``re + ε du`` from the components of both parts."""
        return cls.from_components(Dual(a, b) for a, b in zip(re, du, strict=True))

    def _with(self, components: Iterable[Coefficient]) -> Self:
        return self.from_components(components)

    def _matches(self, other: object) -> bool:
        return type(other) is type(self)

    def map(self, f: Callable[[Any], Any]) -> Self:
        """Apply `f` to every component."""
        return self._with(map(f, self))

    @property
    def re(self) -> Self:
        """Real part."""
        return self.map(real_part)

    @property
    def du(self) -> Self:
        """Dual part."""
        return self.map(dual_part)

    def __add__(self, other: Self) -> Self:
        return self._with(map(operator.add, self, other)) if self._matches(other) else NotImplemented

    def __sub__(self, other: Self) -> Self:
        return self._with(map(operator.sub, self, other)) if self._matches(other) else NotImplemented

    def __neg__(self) -> Self:
        return self.map(operator.neg)

    def __mul__(self, scalar: Any) -> Self:
        return NotImplemented if isinstance(scalar, Structure) else self._with(a * scalar for a in self)

    def __rmul__(self, scalar: Coefficient) -> Self:
        return NotImplemented if isinstance(scalar, Structure) else self._with(a * scalar for a in self)

    def __truediv__(self, scalar: Coefficient) -> Self:
        return NotImplemented if isinstance(scalar, Structure) else self._with(a / scalar for a in self)

    def _typeset(self) -> str:
        if any(isinstance(c, Dual) for c in self):
            return rf"{self.re._typeset()} + \varepsilon {self.du._typeset()}"
        return matrix(self, self.columns)


@dataclass(slots=True, eq=False)  # frozen ones take three times longer to make
class Dual(Typeset):
    """Dual number ``re + ε du``.

    Plain numbers count as ``a + ε 0``. A dual number is invertible if and only if its real part is invertible. Division
    by a zero divisor raises `ZeroDivisorError`. Quotients use the ``/`` of the coefficients. Since ``int / int`` is a
    ``float`` in Python, exact results need ``Fraction`` or SymPy coefficients.

    Nested dual numbers (second derivatives) work as long as all operands have the same depth.
    """

    re: Coefficient
    du: Coefficient = 0

    __array_ufunc__: ClassVar[None] = None

    def apply(self, f: Callable[[Any], Any], df: Callable[[Any], Any]) -> Dual:
        """Return ``f(a) + ε a° f'(a)`` for a function of the coefficients and its derivative."""
        return Dual(f(self.re), self.du * df(self.re))

    def inverse(self) -> Dual:
        """Return ``1/a − ε a°/a²``; a zero divisor raises `ZeroDivisorError`."""
        return 1 / self

    def __add__(self, other: Any) -> Dual:
        if isinstance(other, Structure):
            return NotImplemented
        return Dual(self.re + real_part(other), self.du + dual_part(other))

    __radd__ = __add__

    def __neg__(self) -> Dual:
        return Dual(-self.re, -self.du)

    def __sub__(self, other: Any) -> Dual:
        if isinstance(other, Structure):
            return NotImplemented
        return Dual(self.re - real_part(other), self.du - dual_part(other))

    def __rsub__(self, other: Any) -> Dual:
        return Dual(other - self.re, -self.du)

    def __mul__(self, other: Any) -> Dual:
        if isinstance(other, Structure):
            return NotImplemented
        if isinstance(other, Dual):
            return Dual(self.re * other.re, self.re * other.du + self.du * other.re)
        return Dual(self.re * other, self.du * other)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Dual:
        if isinstance(other, Structure):
            return NotImplemented
        if not isinstance(other, Dual):
            return Dual(self.re / other, self.du / other)
        other._require_invertible()
        quotient = self.re / other.re
        return Dual(quotient, (self.du - quotient * other.du) / other.re)

    def __rtruediv__(self, other: Any) -> Dual:
        self._require_invertible()
        quotient = other / self.re
        return Dual(quotient, -quotient * self.du / self.re)

    def __pow__(self, exponent: int) -> Dual:
        """Return the power ``aⁿ + ε n aⁿ⁻¹ a°``; a negative power of a zero divisor raises `ZeroDivisorError`."""
        if isinstance(exponent, bool) or not isinstance(exponent, int):
            return NotImplemented
        if exponent < 0:
            return self.inverse() ** -exponent
        if exponent == 0:
            return Dual(self.re**0, 0 * self.du)
        return Dual(self.re**exponent, exponent * self.re ** (exponent - 1) * self.du)

    def __abs__(self) -> Dual:
        """Return the magnitude ``|a| + ε sgn(a) a°``, or ``ε |a°|`` at a = 0; its square equals the number's."""
        if self.re == 0:
            return Dual(self.re, abs(self.du))
        magnitude = abs(self.re)
        return Dual(magnitude, magnitude / self.re * self.du)

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Structure):
            return NotImplemented
        return bool(self.re == real_part(other)) and bool(self.du == dual_part(other))

    def __hash__(self) -> int:
        # Dual(a, 0) equals the plain number a, so both have the same hash.
        return hash(self.re) if self.du == 0 else hash((self.re, self.du))

    def _typeset(self) -> str:
        return rf"{latex(self.re)} + \varepsilon {bracketed(self.du)}"

    def _require_invertible(self) -> None:
        if self.re == 0:
            raise ZeroDivisorError(f"{self!r} has real part zero: it is a zero divisor and has no inverse")


def real_part(value: Coefficient) -> Coefficient:
    """Return the real part of a dual number, or a plain number itself."""
    return value.re if isinstance(value, Dual) else value


def dual_part(value: Coefficient) -> Coefficient:
    """Return the dual part of a dual number, or 0 for a plain number."""
    return value.du if isinstance(value, Dual) else 0
