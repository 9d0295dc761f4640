"""The two kinds of numbers a printed formula is executed on, and their elementary functions.

`Decimal60` has 60-digit floating numbers: they refute, and where nothing better is possible they are evidence.
`Exact` has rational functions of independent symbols: they decide for all values at once. Dual numbers over either
(nested ones too) take every function by ``f(a) + ε a° f'(a)``.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from functools import reduce
from typing import Any

import mpmath

from derive.algebra import Dual, Quaternion, Structure, Tensor, Vector, ZeroDivisorError, real_part
from derive.algebra.angles import AngleField
from derive.algebra.element import Element, NotExactError
from derive.maps.polynomials import pair

DIGITS = 60
TOLERANCE = mpmath.mpf(10) ** -45  # far above the rounding of 60 digits, far below any difference that matters
_NOTHING = mpmath.mpf(10) ** -55  # what is left of a sine at a multiple of π


class UndefinedError(ArithmeticError):
    """The formula has no value at this point."""


class Field(ABC):
    """Numbers with elementary functions; subclasses say what those are on plain coefficients, if they have them.

    Attributes
    ----------
    name : str
        How a method names it.
    ordered : bool
        Whether every number has a sign; where not, a symbol is taken on the side at hand.
    """

    name: str
    ordered: bool = False

    def sin(self, a: Any) -> Any:
        """Sine of a plain or dual number."""
        return a.apply(self.sin, self.cos) if isinstance(a, Dual) else self._sin(a)

    def cos(self, a: Any) -> Any:
        """Cosine."""
        return a.apply(self.cos, lambda b: -self.sin(b)) if isinstance(a, Dual) else self._cos(a)

    def exp(self, a: Any) -> Any:
        """Exponential."""
        return a.apply(self.exp, self.exp) if isinstance(a, Dual) else self._exp(a)

    def log(self, a: Any) -> Any:
        """Natural logarithm."""
        return a.apply(self.log, lambda b: 1 / b) if isinstance(a, Dual) else self._log(a)

    def atan(self, a: Any) -> Any:
        """Principal arc tangent."""
        return a.apply(self.atan, lambda b: 1 / (1 + b * b)) if isinstance(a, Dual) else self._atan(a)

    def atan2(self, y: Any, x: Any) -> Any:
        """The angle, between −π and π, whose sine and cosine are in the ratio of y and x."""
        if not (isinstance(x, Dual) or isinstance(y, Dual)):
            return self._atan2(y, x)
        (a, da), (b, db) = ((c.re, c.du) if isinstance(c, Dual) else (c, 0) for c in (x, y))
        return Dual(self.atan2(b, a), (a * db - b * da) / (a * a + b * b))

    def sqrt(self, a: Any) -> Any:
        """Square root; that of a zero divisor other than 0 is undefined."""
        if not isinstance(a, Dual):
            return self._sqrt(a)
        if a == 0:
            return a
        if innermost(a.re) == 0:
            raise ZeroDivisorError(f"{a!r} is a zero divisor and has no square root")
        return a.apply(self.sqrt, lambda b: 1 / (2 * self.sqrt(b)))

    def magnitude(self, v: Vector) -> Any:
        """Magnitude of a vector; ``ε |a°|`` for a dual one whose real part is zero."""
        square = v.dot(v)
        if isinstance(square, Dual) and self._vanishes(square.re):
            return Dual(0 * square.re, self.magnitude(v.du))
        return self.sqrt(square)

    def _vanishes(self, a: Any) -> bool:
        return bool(a == 0) if isinstance(a, Dual) else self.vanishes(a)

    def power(self, base: Any, exponent: Any) -> Any:
        """Integer powers of anything with a product; roots of numbers; other powers in the subclasses."""
        if isinstance(exponent, Fraction) and exponent.denominator == 1:
            exponent = int(exponent)
        if isinstance(exponent, int):
            base = Quaternion(0, base) if isinstance(base, Vector) else base
            if exponent < 0 and self.vanishes(innermost(_size(base))):
                raise UndefinedError("the inverse of what has none")
            return integer_power(base, exponent)
        if isinstance(exponent, Fraction) and isinstance(base, Quaternion):
            return self._quaternion_power(base, exponent)
        if isinstance(exponent, Fraction) and exponent.denominator == 2 and not isinstance(base, Structure):
            return integer_power(self.sqrt(base), exponent.numerator)
        raise NotExactError(f"{base!r} to the power {exponent!r}")

    def _quaternion_power(self, q: Quaternion, r: Fraction) -> Quaternion:
        """``|q|^r (cos rθ + u sin rθ)`` with ``0 ≤ θ < π``: the principal value."""
        size = self.power(q.norm2(), r / 2)
        w = q.vector
        if real_part(w.dot(w)) == 0:  # then w² = 0
            if innermost(q.scalar) < 0:
                raise UndefinedError("a power of a negative number")
            return Quaternion(size, r.numerator * size / (r.denominator * q.scalar) * w)
        length = self.magnitude(w)
        angle = self.atan2(length, q.scalar) * r.numerator / r.denominator
        return Quaternion(size * self.cos(angle), size * self.sin(angle) / length * w)

    def pair(self, n: Any, x: Any) -> tuple[Any, Any]:
        """The polynomials ``p_n`` and ``q_n`` at x."""
        return pair(n, x)

    @abstractmethod
    def same(self, a: Any, b: Any) -> bool:
        """Return whether two plain numbers are equal."""

    def vanishes(self, a: Any) -> bool:
        """Return whether a plain number is zero, or what rounding makes of it."""
        return bool(a == 0)

    def negligible(self, parts: Iterable[Any]) -> bool:
        """Return whether the rest of a power series can be left off after a term with these parts."""
        raise NotExactError("an infinite sum")

    # what a field does not have it refuses

    def _sin(self, a: Any) -> Any:
        raise NotExactError("sine")

    def _cos(self, a: Any) -> Any:
        raise NotExactError("cosine")

    def _exp(self, a: Any) -> Any:
        raise NotExactError("exponential")

    def _log(self, a: Any) -> Any:
        raise NotExactError("logarithm")

    def _atan(self, a: Any) -> Any:
        return self._atan2(a, 1)

    def _atan2(self, y: Any, x: Any) -> Any:
        raise NotExactError("arc tangent")

    def _sqrt(self, a: Any) -> Any:
        raise NotExactError("square root")

    @property
    def pi(self) -> Any:
        """The number π."""
        raise NotExactError("π")


class Decimal60(Field):
    """60-digit real numbers; to be used inside ``mpmath.workdps(DIGITS)``."""

    name = "60 digits"
    ordered = True

    def same(self, a: Any, b: Any) -> bool:
        return bool(abs(a - b) <= TOLERANCE * (1 + abs(a) + abs(b)))

    def vanishes(self, a: Any) -> bool:
        return bool(abs(a) < _NOTHING)

    def negligible(self, parts: Iterable[Any]) -> bool:
        return all(self.vanishes(part) for part in parts)

    def power(self, base: Any, exponent: Any) -> Any:
        if isinstance(exponent, Fraction) and exponent.denominator > 2 and not isinstance(base, Quaternion):
            return self.exp(self.log(base) * exponent.numerator / exponent.denominator)
        return super().power(base, exponent)

    def _sin(self, a: Any) -> Any:
        return chopped(mpmath.sin(a))

    def _cos(self, a: Any) -> Any:
        return chopped(mpmath.cos(a))

    def _exp(self, a: Any) -> Any:
        return mpmath.exp(a)

    def _log(self, a: Any) -> Any:
        if a <= 0:
            raise UndefinedError("logarithm of a number that is not positive")
        return mpmath.log(a)

    def _atan2(self, y: Any, x: Any) -> Any:
        if x == 0 and y == 0:
            raise UndefinedError("the angle of 0")
        return mpmath.atan2(y, x)

    def _sqrt(self, a: Any) -> Any:
        a = chopped(a)
        if a < 0:
            raise UndefinedError("square root of a negative number")
        return mpmath.sqrt(a)

    @property
    def pi(self) -> Any:
        return mpmath.mpf(mpmath.pi)


class Exact(Field):
    """Rational functions over Q in independent symbols, roots of squares and half-angle tangents included."""

    name = "exact"

    def __init__(self, names: Sequence[str] = (), angles: Mapping[str, int] | None = None) -> None:
        self.functions = AngleField(names, angles)

    def symbol(self, name: str) -> Element:
        """A generator."""
        return self.functions.symbol(name)

    def same(self, a: Any, b: Any) -> bool:
        return bool(a == b)

    def _sin(self, a: Any) -> Any:
        return self.functions.sin(self._element(a))

    def _cos(self, a: Any) -> Any:
        return self.functions.cos(self._element(a))

    def _sqrt(self, a: Any) -> Any:
        return self._element(a).sqrt()

    def _atan2(self, y: Any, x: Any) -> Any:
        return self.functions.atan2(self._element(y), self._element(x))

    @property
    def pi(self) -> Any:
        return self.symbol("pi")

    def _element(self, a: Any) -> Element:
        return a if isinstance(a, Element) else self.functions.constant(Fraction(a))


def innermost(a: Any) -> Any:
    """The real part of a number however deeply it is nested."""
    while isinstance(a, Dual):
        a = a.re
    return a


def _size(a: Any) -> Any:
    """What is 0 of something that has no inverse, up to its dual part."""
    return a.det() if isinstance(a, Tensor) else a.norm2() if isinstance(a, Quaternion) else a


def integer_power(base: Any, exponent: int) -> Any:
    """``base`` multiplied by itself, with the product of its type; negative exponents invert."""
    if exponent < 0:
        inverse = base.inverse() if isinstance(base, Quaternion | Tensor) else one_over(base)
        return integer_power(inverse, -exponent)
    if exponent == 0:
        return Tensor.identity() if isinstance(base, Tensor) else 1
    if exponent == 1:
        return base
    half = integer_power(base, exponent // 2)
    return reduce(_product, (half, half, base) if exponent % 2 else (half, half))


def _product(a: Any, b: Any) -> Any:
    return a @ b if hasattr(a, "__matmul__") else a * b


def one_over(a: Any) -> Any:
    """Reciprocal that keeps integers exact."""
    return Fraction(1) / a if isinstance(a, int | Fraction) else 1 / a


def chopped(a: Any) -> Any:
    """A plain number of 60 digits, or 0 for what rounding makes of it."""
    return mpmath.mpf(0) if abs(a) < _NOTHING else a
