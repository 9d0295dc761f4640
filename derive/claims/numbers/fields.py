"""Fields in which formulas are evaluated, with their elementary functions.

`Exact` and `Constants` have rational numbers and π. Numbers of points are those of `derive.claims.numbers.balls`, and
those of all points at once those of `derive.claims.numbers.generators`.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from operator import matmul, mul
from typing import Any

from ...algebra import Dual, Quaternion, Structure, Tensor, Vector, ZeroDivisorError, real_part
from ...algebra.arithmetic import pair
from ...algebra.element import Element, NotExactError
from ...algebra.exact import AngleField
from ...algebra.functions import Elementary


class UndefinedError(ArithmeticError):
    """Error for a formula without a value at this point."""


class Field(Elementary):
    """Numbers with elementary functions; a function that is missing in a subclass raises `NotExactError`.

    Subclasses define ``_sin``, ``_cos``, ``_exp``, ``_log``, ``_sqrt`` and ``_atan2`` on plain numbers.
    """

    ordered = False  # whether every number has a sign, so that numbers can be compared
    pair = staticmethod(pair)  # polynomials ``p_n`` and ``q_n`` at x

    def real(self, name: str, *values: Any) -> Callable[..., Any]:
        if not hasattr(self, f"_{name}"):
            raise NotExactError(f"the function {name}")
        return getattr(self, f"_{name}")  # type: ignore[no-any-return]

    def sqrt(self, a: Any) -> Any:
        """Return the square root; raise for a zero divisor other than 0."""
        if not isinstance(a, Dual):
            return super().sqrt(a)
        if self.is_null(a.re):
            if self.is_null(a.du):
                return a
            raise ZeroDivisorError(f"the square root of {a!r}")
        root = self.sqrt(a.re)
        return Dual(root, a.du / (2 * root))

    def is_null(self, a: Any) -> bool:
        """Return whether a number is certainly 0, with its dual part and rates."""
        return bool(a == 0)

    def crosses(self, a: Any) -> bool:
        """Return whether a number that varies is 0 now; numbers of most fields do not vary."""
        return False

    def atan(self, a: Any) -> Any:
        return self.atan2(a, 1)

    def absolute(self, a: Any) -> Any:
        """Return the magnitude; of a dual number with its slope, ``ε |a°|`` if the real part is 0."""
        if not isinstance(a, Dual):
            return abs(a)
        size = self.absolute(a.du if a.re == 0 else a.re)
        return Dual(a.re, size) if a.re == 0 else Dual(size, size / a.re * a.du)

    def floor(self, a: Any) -> int:
        """Return the greatest integer that is not greater."""
        raise NotExactError("the floor of a number")

    def magnitude(self, v: Vector) -> Any:
        """Return the magnitude of a vector; ``ε |a°|`` for a dual vector ``ε a°``."""
        square = v.dot(v)
        if isinstance(square, Dual) and self.is_null(square.re):
            return Dual(0 * square.re, self.magnitude(v.du))
        return self.sqrt(square)

    def power(self, base: Any, exponent: Any) -> Any:
        """Return a power with an integer exponent, or with a rational exponent for a quaternion or number."""
        if isinstance(exponent, Fraction) and exponent.denominator == 1:
            exponent = int(exponent)
        if isinstance(exponent, int):
            base = Quaternion(0, base) if isinstance(base, Vector) else base
            size = base.det() if isinstance(base, Tensor) else base.norm2() if isinstance(base, Quaternion) else base
            if exponent < 0 and self.vanishes(innermost(size)):
                raise UndefinedError("the inverse of a zero divisor")
            return integer_power(base, exponent)
        if isinstance(exponent, Fraction) and isinstance(base, Quaternion):
            return self._principal_power(base, exponent)
        if isinstance(exponent, Fraction) and exponent.denominator == 2 and not isinstance(base, Structure):
            return integer_power(self.sqrt(base), exponent.numerator)
        if isinstance(exponent, Fraction) and not isinstance(base, Structure):
            return self.exp(self.log(base) * exponent.numerator / exponent.denominator)
        raise NotExactError("a power with this exponent")

    def _principal_power(self, q: Quaternion, r: Fraction) -> Quaternion:
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

    def same(self, a: Any, b: Any) -> bool:
        return bool(a == b)

    def compared(self, test: Callable[[Any, Any], bool], a: Any, b: Any) -> bool:
        """Return whether an order relation of two plain numbers is true."""
        return test(a, b)

    def vanishes(self, a: Any) -> bool:
        """Return whether a plain number is zero up to rounding."""
        return bool(a == 0)

    def negligible(self, a: Any) -> bool:
        """Return whether a term of an infinite sum no longer changes it."""
        return self.vanishes(a)

    @property
    def usual(self) -> Field:
        """The field in which numbers are equal that cannot be told apart."""
        return self

    @property
    def certain(self) -> Field:
        """The field whose relations decide against a claim: there an overlap of balls tells nothing."""
        return self

    @property
    def pi(self) -> Any:
        raise NotExactError("π")


class Exact(Field):
    """Rational numbers and π, with roots of squares."""

    def __init__(self) -> None:
        self.functions = AngleField(())

    def _sin(self, a: Any) -> Any:
        return self.functions.sin(self.functions.element(a))

    def _cos(self, a: Any) -> Any:
        return self.functions.cos(self.functions.element(a))

    def _sqrt(self, a: Any) -> Any:
        return self.functions.element(a).sqrt()

    @property
    def pi(self) -> Element:
        return self.functions.symbol("pi")


class Constants(Exact):
    """Exact numbers that have signs."""

    ordered = True

    def floor(self, a: Any) -> int:
        """Return the greatest integer that is not greater."""
        number = self.functions.element(a)
        return int(self.functions.value(number.numerator) / self.functions.value(number.denominator) // 1)


def innermost(a: Any) -> Any:
    while isinstance(a, Dual):
        a = a.re
    return a


def integer_power(base: Any, exponent: int) -> Any:
    """Return ``base^exponent`` by products of the base's type; a negative exponent inverts the base."""
    if exponent < 0:
        inverse = base.inverse() if isinstance(base, Quaternion | Tensor) else one_over(base)
        return integer_power(inverse, -exponent)
    if exponent == 0:
        return Tensor.identity() if isinstance(base, Tensor) else 1
    times = matmul if isinstance(base, Tensor) else mul
    if exponent < 2:
        return base
    half = integer_power(base, exponent // 2)
    return times(times(half, half), base) if exponent % 2 else times(half, half)


def one_over(a: Any) -> Any:
    """Return the reciprocal, exact for integers."""
    return Fraction(1) / a if isinstance(a, int | Fraction) else 1 / a
