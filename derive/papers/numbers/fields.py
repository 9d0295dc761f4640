"""Two fields in which printed formulas are evaluated, with their elementary functions.

`Decimal60` consists of 60-digit floating-point numbers, which refute a formula or give evidence for it. `Exact`
consists of rational functions of independent symbols, which decide a formula for all values at once. Functions of dual
numbers, also nested ones, follow from ``f(a) + ε a° f'(a)``.
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
TOLERANCE = mpmath.mpf(10) ** -45  # far above rounding errors, far below relevant differences
_NOTHING = mpmath.mpf(10) ** -55  # bound on the rounding error of the sine at a multiple of π


class UndefinedError(ArithmeticError):
    """Error for a formula without a value at this point."""


class Field(ABC):
    """Numbers with elementary functions; subclasses define each on plain numbers or raise `NotExactError`.

    Attributes
    ----------
    name : str
        Name in descriptions of methods.
    ordered : bool
        Whether every number has a sign, so that numbers can be compared.
    """

    name: str
    ordered: bool = False

    def sin(self, a: Any) -> Any:
        """Return the sine of a plain or dual number."""
        return a.apply(self.sin, self.cos) if isinstance(a, Dual) else self._sin(a)

    def cos(self, a: Any) -> Any:
        """Return the cosine."""
        return a.apply(self.cos, lambda b: -self.sin(b)) if isinstance(a, Dual) else self._cos(a)

    def exp(self, a: Any) -> Any:
        """Return the exponential."""
        return a.apply(self.exp, self.exp) if isinstance(a, Dual) else self._exp(a)

    def log(self, a: Any) -> Any:
        """Return the natural logarithm."""
        return a.apply(self.log, lambda b: 1 / b) if isinstance(a, Dual) else self._log(a)

    def atan(self, a: Any) -> Any:
        """Return the principal arc tangent."""
        return a.apply(self.atan, lambda b: 1 / (1 + b * b)) if isinstance(a, Dual) else self._atan(a)

    def atan2(self, y: Any, x: Any) -> Any:
        """Return the angle of the point (x, y), between −π and π."""
        if not (isinstance(x, Dual) or isinstance(y, Dual)):
            return self._atan2(y, x)
        (a, da), (b, db) = ((c.re, c.du) if isinstance(c, Dual) else (c, 0) for c in (x, y))
        return Dual(self.atan2(b, a), (a * db - b * da) / (a * a + b * b))

    def sqrt(self, a: Any) -> Any:
        """Return the square root; raise for a zero divisor other than 0."""
        if not isinstance(a, Dual):
            return self._sqrt(a)
        if a == 0:
            return a
        if innermost(a.re) == 0:
            raise ZeroDivisorError(f"{a!r} is a zero divisor and has no square root")
        return a.apply(self.sqrt, lambda b: 1 / (2 * self.sqrt(b)))

    def magnitude(self, v: Vector) -> Any:
        """Return the magnitude of a vector; ``ε |a°|`` for a dual one with real part zero."""
        square = v.dot(v)
        if isinstance(square, Dual) and self._vanishes(square.re):
            return Dual(0 * square.re, self.magnitude(v.du))
        return self.sqrt(square)

    def _vanishes(self, a: Any) -> bool:
        return bool(a == 0) if isinstance(a, Dual) else self.vanishes(a)

    def power(self, base: Any, exponent: Any) -> Any:
        """Return a power: integer for any value, rational for a quaternion, half-integer for a number."""
        if isinstance(exponent, Fraction) and exponent.denominator == 1:
            exponent = int(exponent)
        if isinstance(exponent, int):
            base = Quaternion(0, base) if isinstance(base, Vector) else base
            if exponent < 0 and self.vanishes(innermost(_size(base))):
                raise UndefinedError("the inverse of a zero divisor")
            return integer_power(base, exponent)
        if isinstance(exponent, Fraction) and isinstance(base, Quaternion):
            return self._quaternion_power(base, exponent)
        if isinstance(exponent, Fraction) and exponent.denominator == 2 and not isinstance(base, Structure):
            return integer_power(self.sqrt(base), exponent.numerator)
        raise NotExactError(f"{base!r} to the power {exponent!r}")

    def _quaternion_power(self, q: Quaternion, r: Fraction) -> Quaternion:
        """Return the principal value ``|q|^r (cos rθ + u sin rθ)``, ``0 ≤ θ < π``."""
        size = self.power(q.norm2(), r / 2)
        w = q.vector
        if real_part(w.dot(w)) == 0:  # then w · w = 0
            if innermost(q.scalar) < 0:
                raise UndefinedError("a power of a negative number")
            return Quaternion(size, r.numerator * size / (r.denominator * q.scalar) * w)
        length = self.magnitude(w)
        angle = self.atan2(length, q.scalar) * r.numerator / r.denominator
        return Quaternion(size * self.cos(angle), size * self.sin(angle) / length * w)

    def pair(self, n: Any, x: Any) -> tuple[Any, Any]:
        """Return the polynomials ``p_n`` and ``q_n`` at x."""
        return pair(n, x)

    @abstractmethod
    def same(self, a: Any, b: Any) -> bool:
        """Return whether two plain numbers are equal."""

    def vanishes(self, a: Any) -> bool:
        """Return whether a plain number is zero up to rounding."""
        return bool(a == 0)

    def negligible(self, parts: Iterable[Any]) -> bool:
        """Return whether a power series can be truncated after a term with these parts."""
        raise NotExactError("an infinite sum")

    # functions missing in a field raise NotExactError

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
    """Real numbers with 60 digits, for use inside ``mpmath.workdps(DIGITS)``."""

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
    """Rational functions over Q of independent symbols, with roots of squares and half-angle tangents."""

    name = "exact"

    def __init__(self, names: Sequence[str] = (), angles: Mapping[str, int] | None = None) -> None:
        self.functions = AngleField(names, angles)

    def symbol(self, name: str) -> Element:
        """Return the generator of this name."""
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
    """Return the innermost real part of a nested dual number."""
    while isinstance(a, Dual):
        a = a.re
    return a


def _size(a: Any) -> Any:
    """Return a number whose real part is 0 if and only if the value has no inverse."""
    return a.det() if isinstance(a, Tensor) else a.norm2() if isinstance(a, Quaternion) else a


def integer_power(base: Any, exponent: int) -> Any:
    """Return an integer power by the product of the base's type; a negative exponent inverts the base."""
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
    """Return the reciprocal, exact for integers."""
    return Fraction(1) / a if isinstance(a, int | Fraction) else 1 / a


def chopped(a: Any) -> Any:
    """Return a plain number, or 0 if its size is within the rounding error."""
    return mpmath.mpf(0) if abs(a) < _NOTHING else a
