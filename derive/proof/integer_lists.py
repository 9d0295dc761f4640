"""Integer lists of exact elements, as certificates show them.

A polynomial is a list of terms ``[coefficient, exponents]`` with one exponent for each variable. A side is a list
``[divisor, powers, polynomial]``: the polynomial over the divisor and over the product of the factors to these powers.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import product
from math import lcm, prod
from typing import Any

from ..algebra.element import Element
from ..algebra.exact import RationalFunctions
from ..algebra.polynomial_backend import Polynomial

Terms = list[list[Any]]
PLACES = (*map(Fraction, (1, 2, 0, -1)), Fraction(3, 5), Fraction(4, 5))
"""Values tried for each variable of a point."""


class IntegerLists:
    """Integer lists of elements of one ring."""

    def __init__(self, ring: RationalFunctions) -> None:
        self.ring = ring
        self.factors: list[Polynomial] = []  # irreducible factors of all denominators so far

    def polynomial(self, a: Polynomial) -> tuple[int, Terms]:
        """Return the least common denominator of the coefficients, and the polynomial times this denominator."""
        terms: dict[tuple[int, ...], Fraction] = self.ring.library.terms(a)
        divisor = lcm(*(c.denominator for c in terms.values()))
        return divisor, [[int(c * divisor), list(exponents)] for exponents, c in terms.items()]

    def side(self, element: Element) -> list[Any]:
        """Return the divisor, the powers of the factors, and the numerator of an element."""
        library, powers = self.ring.library, [0] * len(self.factors)
        rest = element.denominator
        for factor, power in library.factors(element.denominator):
            if factor not in self.factors:
                self.factors.append(factor)
                powers.append(0)
            powers[self.factors.index(factor)] = power
            rest = rest / factor**power
        divisor, terms = self.polynomial(element.numerator * (1 / library.leading_coefficient(rest)))
        return [divisor, powers, terms]

    def point(self, factor: Polynomial) -> dict[str, str]:
        """Return values of variables at which a polynomial is not 0, and the relations on its variables are 0."""

        def value(a: Polynomial, at: tuple[Fraction, ...]) -> Fraction:
            terms = self.ring.library.terms(a).items()
            return sum((c * prod(map(pow, at, exponents)) for exponents, c in terms), Fraction(0))

        degrees = factor.degrees()
        met = [r for r in self.ring.relations if any(map(min, degrees, r.degrees()))]
        used = [any(powers) for powers in zip(degrees, *(r.degrees() for r in met), strict=True)]
        for at in product(*(PLACES if variable else (Fraction(0),) for variable in used)):
            if value(factor, at) and not any(value(r, at) for r in met):
                return {name: str(a) for name, a, u in zip(self.ring.names, at, used, strict=True) if u}
        raise ArithmeticError(f"no point found where {self.ring.text(factor)} is not 0")
