"""Integer letters over generators: powers such as ``x**(2*n + 1)``, multiples of π, and halves.

Whether an integer is odd is a sign, for which a proof takes 1 and -1 as for those of roots. Each irreducible factor f
of a base has a positive generator for an integer m in exponents. It is ``f**(m/2)`` if f is positive, else
``abs(f)**((m - 1)/2)`` for odd m and ``abs(f)**(m/2)`` for even m.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from fractions import Fraction
from typing import Any

import sympy

from ...algebra import Dual, Quaternion, Structure, Vector, dual_part, real_part
from ...algebra.element import Element, NotExactError
from .fields import Field
from .intervals import Monomial

SIGNS_MAX = 5
"""Largest number of unknown signs."""


def is_whole(field: Any, monomial: Monomial) -> bool:
    """Return whether a monomial is a product of integers."""
    return all(name in field.integers and power > 0 for name, power in monomial)


class Integers(Field):
    """Field with integer letters, to which a subclass gives generators; `signs` are the first of unknown sign."""

    integers: Collection[str]
    symbol: Callable[[str], Any]
    element: Callable[[Any], Any]
    terms: Callable[[Any], Iterator[tuple[Monomial, Fraction]]]
    product: Callable[[Any], Any]
    multiples: Callable[[Callable[[Any, Any], bool]], Iterator[tuple[Monomial, Fraction]]]
    next_of: Callable[[str], str]
    restrict: Callable[[str, str, Any], None]
    is_positive: Callable[[Any], bool]
    ring: Any

    def __init__(self, signs: Sequence[int]) -> None:
        self.signs = list(signs)
        self.roots: list[Any] = []  # roots of unknown sign, up to this sign; None for the sign of an integer
        self.parities: dict[tuple[str, Monomial], int] = {}
        self.lines: list[tuple[tuple[Any, Any], Any]] = []  # points, each with the angle of its line
        self.powers: dict[tuple[str, Monomial], tuple[Any, str, Any]] = {}  # factors, names, and twice the exponents

    def next_sign(self, root: Any = None) -> int:
        """Return the next of `signs`, for a root or for an integer."""
        if len(self.roots) == SIGNS_MAX:
            raise NotExactError(f"more than {SIGNS_MAX} unknown signs")
        self.roots.append(root)
        self.signs += [1] * (len(self.roots) - len(self.signs))
        return self.signs[len(self.roots) - 1]

    # ---- parity ------------------------------------------------------------------------------------------------------

    def parity(self, monomial: Monomial, of: str = "one") -> int:
        """Return 1 for an even product of integers and -1 for an odd one; or the same `of` its half, rounded down."""
        if not monomial:
            return -1 if of == "one" else 1
        known = of, tuple((name, 1) for name, _ in monomial) if of == "one" else monomial
        if known not in self.parities:
            self.parities[known] = self.next_sign()
        return self.parities[known]

    def quarters(self, monomial: Monomial, count: int) -> tuple[Any, Any]:
        """Return cosine and sine of ``count monomial π/2`` for a product of integers."""
        one, zero = self.element(1), self.element(0)
        if count % 2 == 0:
            return (one if count % 4 == 0 else one * self.parity(monomial)), zero
        half = one * self.parity(monomial, "half")
        if self.parity(monomial) == 1:
            return half, zero
        return zero, half if count % 4 == 1 else -half

    def floor(self, a: Any) -> Any:
        """Return the greatest integer that is not greater than the half of an integer."""
        sign = 1
        for monomial, multiple in self.terms(self.element(a)):
            if multiple.denominator > 2 or not is_whole(self, monomial):
                raise NotExactError("the floor of a number")
            sign *= self.parity(monomial) if multiple.denominator == 2 else 1
        return a if sign == 1 else a - Fraction(1, 2)

    # ---- powers ------------------------------------------------------------------------------------------------------

    def power(self, base: Any, exponent: Any) -> Any:
        """Return a power, also with a polynomial in integers as exponent."""
        if not isinstance(exponent, Element):
            return super().power(base, exponent)
        if isinstance(base, Quaternion | Vector):
            return self._of_quaternion(base if isinstance(base, Quaternion) else Quaternion(0, base), exponent)
        if isinstance(base, Structure):
            raise NotExactError("a power of a matrix with a letter as exponent")
        if isinstance(base, Dual):
            return base.apply(lambda a: self.power(a, exponent), lambda a: exponent * self.power(a, exponent) / a)
        base, found = self.element(base), self.element(1)
        for monomial, multiple in self.terms(exponent) if base != 1 else ():
            if multiple.denominator > 2 or (multiple.denominator == 2 and not self.is_positive(base)):
                raise NotExactError("a root that is none of a positive square")
            found = found * super().power(self._to_the(base, monomial) if monomial else base, multiple)
        return found

    def _to_the(self, base: Any, monomial: Monomial) -> Any:
        """Return a number to the power of an integer."""
        if not base or not is_whole(self, monomial):
            raise NotExactError("an exponent that is no integer")
        found = self.element(1)
        for factor, count in self._factors(base):
            found = found * self._factor_to_the(factor, monomial) ** count
        return found

    def _factors(self, a: Any) -> Iterator[tuple[Any, int]]:
        """Yield the factors of a number with exponents: -1, primes, and polynomials, positive if they have one sign."""
        rest, library = a, self.ring.library
        for part, sign in ((a.numerator, 1), (a.denominator, -1)):
            for factor, count in library.factors(part):
                number = self.ring.fraction(factor, library.one)
                number = -number if _sign(number) < 0 else number
                rest = rest / number ** (sign * count)
                yield number, sign * count
        (constant,) = library.terms(rest.numerator).values()
        if constant < 0:
            yield self.element(-1), 1
        for number, sign in ((constant.numerator, 1), (constant.denominator, -1)):
            for prime, count in sympy.factorint(abs(number)).items():
                yield self.element(int(prime)), sign * count

    def _factor_to_the(self, factor: Any, monomial: Monomial) -> Any:
        if factor == -1:
            return self.element(self.parity(monomial))
        key, is_odd = (str(factor), monomial), not _sign(factor) and self.parity(monomial) < 0
        if key not in self.powers:
            name = self.next_of("power")
            self.powers[key] = factor, name, self.product(monomial) - int(is_odd)
            self.restrict("power", name, factor)
        half = self.symbol(self.powers[key][1])
        return half * half * factor if is_odd else half * half

    def _of_quaternion(self, q: Quaternion, exponent: Any) -> Quaternion:
        """Return a power of ``size (cos a + u sin a)``; that of an integer does not depend on the sign of the size."""
        w = q.vector
        if real_part(w.dot(w)) == 0:
            size = self.power(q.scalar, exponent)
            return Quaternion(size, exponent * size / q.scalar * w)
        length = self.magnitude(w)
        if all(multiple.denominator == 1 and is_whole(self, monomial) for monomial, multiple in self.terms(exponent)):
            angle = self._line(length, q.scalar)
            size = self.power(length / self.sin(angle), exponent)
        else:
            angle = self.atan2(length, q.scalar)
            size = self.power(self.sqrt(q.norm2()), exponent)
        return Quaternion(size * self.cos(exponent * angle), size * self.sin(exponent * angle) / length * w)

    def _line(self, y: Any, x: Any) -> Any:
        """Return the angle of the line through a point (x, y), up to half turns."""
        if isinstance(y, Dual) or isinstance(x, Dual):
            a, b = real_part(y), real_part(x)
            return Dual(self._line(a, b), (b * dual_part(y) - a * dual_part(x)) / (a * a + b * b))
        if not self.element(x):
            return self.pi / 2
        known = next((angle for (b, a), angle in self.lines if y * a == x * b), None)
        if known is None:
            found = next(self.multiples(lambda c, s: y * c == x * s), None)
            known = self.symbol(self.next_of("angle")) if found is None else self.product(found[0]) * found[1]
            self.lines.append(((y, x), known))
        return known

    def pair(self, n: Any, x: Any) -> Any:
        """Return ``p_n`` and ``q_n`` at x, from ``(1 + iX)ⁿ = p_n + i X q_n``."""
        if not isinstance(n, Element):
            return super().pair(n, x)
        X = self.sqrt(x)
        found = self.power(Quaternion(1, Vector(0, 0, X)), n)
        return found.scalar, found.vector.c3 / X


def _sign(a: Any) -> int:
    """Return the sign of a number, 0 if it has no definite one."""
    try:
        return int(a.sign())
    except NotExactError:
        return 0
