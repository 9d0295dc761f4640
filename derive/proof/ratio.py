"""Rational functions of independent symbols as numbers: what a formula is evaluated on to be decided for all values.

Unlike the ring of :mod:`derive.proof.exact`, anything but zero divides. Two further things are exact here: the square
root of a perfect square, positive at the reference point, and sine and cosine of rational multiples of an angle that
the field was given, through the tangent of a fraction of it.
"""

from __future__ import annotations

import operator
from collections.abc import Mapping, Sequence
from fractions import Fraction
from numbers import Rational
from typing import Any

import sympy

from derive.proof.polynomial_backend import Polynomial, Polynomials, polynomials


class NotExactError(ArithmeticError):
    """The operation leaves the field: the root of a non-square, the sine of what is no multiple of an angle."""


class RationalFunctions:
    """The field Q(names, angles, …).

    Parameters
    ----------
    names : sequence of str
        Independent symbols. At the reference point they are distinct positive numbers.
    angles : mapping of str to int, optional
        Angle symbols, each with the integer M such that sine and cosine of multiples of angle/M are wanted. An angle
        and its tangent ``tan(angle/2M)`` are two algebraically independent generators.
    """

    def __init__(self, names: Sequence[str], angles: Mapping[str, int] | None = None) -> None:
        self.angles = dict(angles or {})
        self.names = (*names, *(g for name in self.angles for g in (name, f"tan_{name}")), "pi")
        self.library: Polynomials = polynomials(tuple(f"g{i}" for i in range(len(self.names))))
        self.point = tuple(self._reference(i, name) for i, name in enumerate(self.names))

    def symbol(self, name: str) -> Ratio:
        """The generator of that name."""
        return Ratio(self, self.library.generators[self.names.index(name)], self.library.one)

    def constant(self, value: Rational | int) -> Ratio:
        """An integer or a fraction."""
        make = self.library.constant
        return Ratio(self, make(int(value.numerator)), make(int(value.denominator)))

    def _reference(self, index: int, name: str) -> Fraction:
        tangent = Fraction(1, 37 + 3 * index)
        if name == "pi":
            return Fraction(355, 113)
        if name in self.angles:  # positive, and close to the angle whose tangent follows
            return 2 * self.angles[name] * Fraction(1, 37 + 3 * (index + 1))
        return tangent if name.startswith("tan_") else Fraction(int(sympy.prime(index + 2)), 3)

    def value_at_reference(self, a: Polynomial) -> Fraction:
        """The polynomial at the reference point."""
        total = Fraction(0)
        for exponents, coefficient in self.library.coefficients(a).items():
            term = Fraction(coefficient)
            for value, power in zip(self.point, exponents, strict=True):
                term *= value**power
            total += term
        return total


class Ratio:
    """An element of `RationalFunctions`; made by the field, not directly."""

    __slots__ = ("denominator", "field", "numerator")
    __hash__ = None  # type: ignore[assignment]  # equal elements are stored with different denominators

    def __init__(self, field: RationalFunctions, numerator: Polynomial, denominator: Polynomial) -> None:
        self.field = field
        self.numerator = numerator
        self.denominator = denominator

    def _partner(self, other: object) -> Ratio | None:
        if isinstance(other, Ratio):
            return other
        return self.field.constant(other) if isinstance(other, Rational) else None

    def __neg__(self) -> Ratio:
        return Ratio(self.field, -self.numerator, self.denominator)

    def __pos__(self) -> Ratio:
        return self

    def __add__(self, other: object) -> Ratio:
        partner = self._partner(other)
        if partner is None:
            return NotImplemented
        library = self.field.library
        if self.denominator == partner.denominator:
            return Ratio(self.field, self.numerator + partner.numerator, self.denominator)
        common = library.gcd(self.denominator, partner.denominator)
        mine = library.quotient(self.denominator, common)
        theirs = library.quotient(partner.denominator, common)
        return Ratio(self.field, self.numerator * theirs + partner.numerator * mine, self.denominator * theirs)

    __radd__ = __add__

    def __sub__(self, other: object) -> Ratio:
        partner = self._partner(other)
        return NotImplemented if partner is None else self + (-partner)

    def __rsub__(self, other: object) -> Ratio:
        return (-self) + other

    def __mul__(self, other: object) -> Ratio:
        partner = self._partner(other)
        if partner is None:
            return NotImplemented
        return self._reduced(self.numerator * partner.numerator, self.denominator * partner.denominator)

    __rmul__ = __mul__

    def __truediv__(self, other: object) -> Ratio:
        partner = self._partner(other)
        if partner is None:
            return NotImplemented
        if not partner:
            raise ZeroDivisionError("division by the zero function")
        return self._reduced(self.numerator * partner.denominator, self.denominator * partner.numerator)

    def __rtruediv__(self, other: object) -> Ratio:
        partner = self._partner(other)
        return NotImplemented if partner is None else partner / self

    def __pow__(self, exponent: object) -> Ratio:
        n = operator.index(exponent)  # type: ignore[arg-type]  # a TypeError for what is no integer
        if n < 0:
            return 1 / self ** (-n)
        if n == 0:
            return self.field.constant(1)  # also of zero, which not every library of polynomials says
        return Ratio(self.field, self.numerator**n, self.denominator**n)

    def __eq__(self, other: object) -> bool:
        partner = self._partner(other)
        if partner is None:
            return NotImplemented
        return bool(self.numerator * partner.denominator == partner.numerator * self.denominator)

    def __bool__(self) -> bool:
        return bool(self.numerator)

    def __abs__(self) -> Ratio:
        return -self if self._sign() < 0 else self

    def __repr__(self) -> str:
        return f"({self.numerator})/({self.denominator})"

    def sqrt(self) -> Ratio:
        """The square root that is positive at the reference point.

        Raises
        ------
        NotExactError
            If the element is not a square.
        """
        root = self.field.library.square_root(self.numerator * self.denominator)
        if root is None:
            raise NotExactError(f"not a perfect square: {self!r}")
        return abs(Ratio(self.field, root, self.denominator))

    def cos(self) -> Ratio:
        """Cosine of a rational multiple of an angle of the field."""
        return self._unit_power()[0]

    def sin(self) -> Ratio:
        """Sine of a rational multiple of an angle of the field."""
        return self._unit_power()[1]

    def angle(self, beside: Ratio) -> Ratio:
        """The angle of the point (beside, self), where it is a multiple, below a turn, of an angle of the field.

        Raises
        ------
        NotExactError
            If it is none.
        """
        for name, steps in self.field.angles.items():
            for k in range(-2 * steps, 2 * steps + 1):
                multiple = self.field.symbol(name) * Fraction(k, steps)
                cosine, sine = multiple.cos(), multiple.sin()
                if self * cosine == beside * sine and (self * sine + beside * cosine)._sign() > 0:
                    return multiple
        raise NotExactError(f"no multiple of an angle: that of ({beside!r}, {self!r})")

    def _unit_power(self) -> tuple[Ratio, Ratio]:
        """(cos, sin) of this element, as the power of ``(1 + i t)²/(1 + t²)``."""
        for name, steps in (*self.field.angles.items(), ("pi", 0)):
            symbols = [self.field.symbol("pi")] if name == "pi" else [self.field.symbol("pi"), self.field.symbol(name)]
            try:
                turns, multiple = (*self.combination(symbols), Fraction(0))[:2]
            except NotExactError:
                continue
            if (multiple * steps).denominator != 1 or (2 * turns).denominator != 1:
                continue
            return self._turned(name, int(multiple * steps), int(2 * turns) % 4)
        raise NotExactError(f"no rational multiple of an angle: {self!r}")

    def _turned(self, name: str, steps: int, quarters: int) -> tuple[Ratio, Ratio]:
        """(cos, sin) of that many steps of an angle and quarter turns."""
        c, s = self.field.constant(1), self.field.constant(0)
        if steps:
            t = self.field.symbol(f"tan_{name}")
            cosine, sine = (1 - t * t) / (1 + t * t), (2 if steps > 0 else -2) * t / (1 + t * t)
            for _ in range(abs(steps)):
                c, s = c * cosine - s * sine, c * sine + s * cosine
        for _ in range(quarters):
            c, s = -s, c
        return c, s

    def combination(self, monomials: Sequence[Ratio]) -> tuple[Fraction, ...]:
        """The rational numbers c with ``self = Σ c · monomial``.

        Raises
        ------
        NotExactError
            If there are none.
        """
        coefficients = self.field.library.coefficients
        left = dict(coefficients(self.numerator))
        below = coefficients(self.denominator)
        result = []
        for monomial in monomials:
            ((exponents, scale),) = coefficients(monomial.numerator).items()
            result.append(Fraction(left.pop(exponents, 0), scale * next(iter(below.values()), 1)))
        if left or any(any(exponents) for exponents in below):
            raise NotExactError(f"no combination of {monomials!r}: {self!r}")
        return tuple(result)

    def _sign(self) -> int:
        at = self.field.value_at_reference
        value = at(self.numerator) * at(self.denominator)
        return (value > 0) - (value < 0)

    def _reduced(self, numerator: Polynomial, denominator: Polynomial) -> Ratio:
        library = self.field.library
        if denominator == library.one:
            return Ratio(self.field, numerator, denominator)
        common: Any = library.gcd(numerator, denominator)
        return Ratio(self.field, library.quotient(numerator, common), library.quotient(denominator, common))
