"""Angles over generators: sines of multiples of known angles, and angles of points.

Each monomial of letters in a sine has the tangent of a fraction of it as generator. The angle of a point (x, y) is a
multiple of such a monomial, or a generator, whose own cosine and sine are those of the point.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator
from fractions import Fraction
from math import prod
from typing import Any

import sympy

from ...algebra.element import NotExactError
from .integers import Integers, is_whole
from .intervals import Monomial, interval
from .signed import turns_to_principal


class Angles(Integers):
    """Field with sines and angles, to which a subclass gives generators; ``m/steps`` has an exact sine."""

    steps: int
    radicals: bool
    closed: Collection[str]
    meanings: dict[tuple[str, Monomial], str]
    angles: list[tuple[tuple[Any, Any], Any]]
    meaning_of: Callable[[str, Monomial], str]
    _sqrt: Callable[[Any], Any]

    def _sin(self, a: Any) -> Any:
        return self._circle(self.element(a))[1]

    def _cos(self, a: Any) -> Any:
        return self._circle(self.element(a))[0]

    def _circle(self, a: Any) -> tuple[Any, Any]:
        """Return cosine and sine of a polynomial in the names."""
        c, s = self.element(1), self.element(0)
        for monomial, multiple in self.terms(a):
            cosine, sine = self._of_monomial(monomial, multiple)
            c, s = c * cosine - s * sine, c * sine + s * cosine
        return c, s

    def _of_monomial(self, monomial: Monomial, multiple: Fraction) -> tuple[Any, Any]:
        whole = tuple(row for row in monomial if row != ("pi", 1))
        if len(whole) < len(monomial) and is_whole(self, whole) and (2 * multiple).denominator == 1:
            return self.quarters(whole, int(2 * multiple))
        if self.radicals and monomial == (("pi", 1),):
            angle = sympy.pi * sympy.Rational(multiple.numerator, multiple.denominator)
            return self._by_roots(sympy.cos(angle)), self._by_roots(sympy.sin(angle))
        count = multiple * self.steps
        if count.denominator != 1 or not monomial:
            raise NotExactError("a number or a fraction of an angle in a sine")
        point = next((point for point, angle in self.angles if angle == self.product(monomial)), None)
        if point is not None and multiple.denominator == 1:
            return self._turned(*self._on_circle(*point), int(multiple))
        t = self.symbol(self.meaning_of("tangent", monomial))
        return self._turned((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t), int(count))

    def _by_roots(self, a: sympy.Expr) -> Any:
        """Return a number of SymPy that is rational, or is written by square roots."""
        found = a.rewrite(sympy.sqrt)
        parts = [self._by_roots(part) for part in found.args] if found.is_Add or found.is_Mul else []
        if parts:
            return sum(parts) if found.is_Add else prod(parts)
        if found.is_Pow and (2 * found.exp).is_Integer:
            return self.power(self._by_roots(found.base), Fraction(int(found.exp.p), int(found.exp.q)))
        if not found.is_Rational:
            raise NotExactError(f"{found} is not written by square roots")
        return self.element(Fraction(int(found.p), int(found.q)))

    def _on_circle(self, y: Any, x: Any) -> tuple[Any, Any]:
        """Return cosine and sine of the angle of a point."""
        radius = self._sqrt(x * x + y * y)
        return x / radius, y / radius

    def _turned(self, cosine: Any, sine: Any, count: int) -> tuple[Any, Any]:
        """Return cosine and sine of a multiple of an angle."""
        c, s = self.element(1), self.element(0)
        for _ in range(abs(count)):
            c, s = c * cosine - s * sine, c * sine + s * cosine
        return c, s if count > 0 else -s

    # ---- inverse functions -------------------------------------------------------------------------------------------

    def _atan2(self, y: Any, x: Any) -> Any:
        """Return the angle of a point as a multiple of a known one, up to turns if its range is unknown."""
        y, x = self.element(y), self.element(x)
        if not y and (self.is_positive(x) or self.is_positive(-x)):
            return y if self.is_positive(x) else self.pi
        for (b, a), angle in self.angles:
            if self._along(y, x, b, a):
                return angle
        angle = self._known_angle(y, x)
        if angle is None:
            name = self.next_of("angle")
            angle = self.symbol(name)
            self.restrict("angle", name, y)
        self.angles.append(((y, x), angle))
        return angle

    def _along(self, y: Any, x: Any, b: Any, a: Any) -> bool:
        """Return whether two points (x, y) and (a, b) are proved to lie in one direction."""
        return bool(y * a == x * b) and self.is_positive(y * b + x * a)

    def _known_angle(self, y: Any, x: Any) -> Any:
        """Return the angle of a point as k/steps of a monomial, plus turns if its range does not tell; else None."""
        for sign, half in ((1, 0), (-1, 1)):
            for monomial, part in self.multiples(lambda c, s: self._along(y * sign, x * sign, s, c)):  # noqa: B023
                closed = any(name in self.closed for name, _ in monomial)
                turns = turns_to_principal(part, *interval(self, monomial), closed, half)
                whole = self.symbol(self.next_of("turn")) if turns is None else turns
                return self.product(monomial) * part + self.pi * (2 * whole + half)
        return None

    def multiples(self, test: Callable[[Any, Any], bool]) -> Iterator[tuple[Monomial, Fraction]]:
        """Yield the multiples of the monomials of known tangents whose cosine and sine pass a test."""
        for monomial in [monomial for what, monomial in self.meanings if what == "tangent"]:
            for part in (Fraction(k, self.steps) for k in range(-2 * self.steps, 2 * self.steps + 1) if k):
                if test(*self._of_monomial(monomial, part)):
                    yield monomial, part

    def _asin(self, a: Any) -> Any:
        return self._atan2(a, self._sqrt(1 - self.element(a) ** 2))

    def _acos(self, a: Any) -> Any:
        return self._atan2(self._sqrt(1 - self.element(a) ** 2), a)
