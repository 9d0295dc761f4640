"""Exact numbers: rational functions of named generators over Q, modulo relations between the generators.

Formulas and kernels accept exact numbers like floats. Equality is decided exactly: an identity between exact numbers
holds for all values of the generators. The polynomials come from python-flint.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from numbers import Rational
from typing import Any

import sympy

from .element import Element, NotExactError, Polynomial, Polynomials


class RationalFunctions:
    """Field Q(names), or quotients of Q[names] modulo relations.

    The names are generators in lexicographic order; a relation eliminates its first generator. Signs, also of square
    roots, are taken at a reference `point`, by default at distinct positive numbers. Without `lowest_terms`, every
    divisor stays in the denominators.
    """

    def __init__(
        self, names: Sequence[str], point: Mapping[str, Fraction] | None = None, lowest_terms: bool = True
    ) -> None:
        self.names = tuple(names)
        self.library = Polynomials(len(self.names))
        self.lowest_terms = lowest_terms
        self.relations: list[Polynomial] = []
        primes = {name: Fraction(int(sympy.prime(i + 2)), 3) for i, name in enumerate(self.names)}
        self.point = primes if point is None else dict(point)

    def symbol(self, name: str) -> Element:
        """Return the generator with the given name."""
        return Element(self, self.library.generators[self.index(name)], self.library.one)

    def index(self, name: str) -> int:
        if name not in self.names:
            raise ValueError(f"no symbol {name!r} in a ring of {', '.join(self.names)}")
        return self.names.index(name)

    def constant(self, value: Rational | int) -> Element:
        """Return the element equal to an integer or a fraction."""
        return Element(self, self.library.constant(value), self.library.one)

    def element(self, value: Element | Rational | int) -> Element:
        """Return the value itself if it belongs to this ring, else the constant; refuse floats."""
        if isinstance(value, Element):
            if value.ring is not self:
                raise ValueError("elements of two different rings cannot be combined")
            return value
        if isinstance(value, Rational):
            return self.constant(value)
        raise TypeError(f"the exact ring takes int and Fraction, not {type(value).__name__} {value!r}")

    def lift(self, expression: Any, values: Mapping[Any, Element | Rational | int]) -> Element:
        """Return a SymPy expression (or an exact number) as an element, given the values of its symbols.

        The expression may contain sums, products and integer powers. Half-integer powers use `Element.sqrt`.
        """
        if isinstance(expression, int | Fraction):
            return self.constant(expression)
        if not isinstance(expression, sympy.Basic):
            raise TypeError(f"expected a SymPy expression or an exact number, not {type(expression).__name__}")
        return self._lift(expression, {symbol: self.element(value) for symbol, value in values.items()})

    def _lift(self, node: Any, table: dict[Any, Element]) -> Element:
        if node in table:
            return table[node]
        if node.is_Rational:
            return self.constant(Fraction(int(node.p), int(node.q)))
        if node.is_Pow and node.exp.is_Rational and node.exp.q <= 2:
            base = self._lift(node.base, table)
            power = (base if node.exp.q == 1 else base.sqrt()) ** abs(int(node.exp.p))
            return power if node.exp > 0 else 1 / power
        if not (node.is_Add or node.is_Mul):
            raise ValueError(f"not an algebraic expression in the given symbols: {node}")
        first, *rest = (self._lift(argument, table) for argument in node.args)
        for other in rest:
            first = first + other if node.is_Add else first * other
        return first

    def normal_form(self, a: Polynomial) -> Polynomial:
        """Return a polynomial reduced modulo the relations: 0 if and only if the relations make it 0."""
        if len(self.relations) == 1:
            return a % self.relations[0]
        before = None
        while self.relations and before != a:
            before = a
            for relation in self.relations:
                a = a % relation
        return a

    def reduced(self, a: Polynomial) -> Polynomial:
        """Return the form of a product that is stored: by default its normal form."""
        return self.normal_form(a)

    def fraction(self, above: Polynomial, below: Polynomial, lowest_terms: bool = False) -> Element:
        """Return a quotient of two polynomials, with a monic denominator."""
        one = self.library.one
        if below != one:
            if (lowest_terms or self.lowest_terms) and (common := above.gcd(below)) != one:
                above, below = above / common, below / common
            leading = below.leading_coefficient()
            if leading != 1:
                above, below = above * (1 / leading), below * (1 / leading)
        return Element(self, above, below)

    def cofactors(self, a: Polynomial, b: Polynomial) -> tuple[Polynomial, Polynomial]:
        """Return ``b/g`` and ``a/g``, the factors of a and b in their least common multiple; g is their gcd."""
        one = self.library.one
        if a == b:
            return one, one
        if one in (a, b):
            return b, a
        common = a.gcd(b)
        return b / common, a / common

    def value(self, a: Polynomial) -> Fraction:
        """Return the value of a polynomial at the reference point; raise NotExactError if a generator has no value."""
        total = Fraction(0)
        for exponents, coefficient in self.library.terms(a).items():
            for name, power in zip(self.names, exponents, strict=True):
                if power and name not in self.point:
                    raise NotExactError(f"an element that depends on {name} has no sign: {self.text(a)}")
                coefficient *= self.point[name] ** power if power else 1
            total += coefficient
        return total

    def text(self, a: Polynomial) -> str:
        terms = []
        for exponents, coefficient in self.library.terms(a).items():
            powers = [(name, power) for name, power in zip(self.names, exponents, strict=True) if power]
            factors = [name if power == 1 else f"{name}**{power}" for name, power in powers]
            terms.append("*".join([str(coefficient)] * (coefficient != 1 or not factors) + factors))
        return " + ".join(terms).replace("+ -", "- ") or "0"

    def cleared(self, elements: Sequence[Element]) -> tuple[list[Element], Element]:
        """Return the elements multiplied by their common denominator, and this denominator."""
        one, common = self.library.one, self.library.one
        for element in elements:
            common = common * self.cofactors(common, element.denominator)[0]
        numerators = [self.reduced(e.numerator * (common / e.denominator)) for e in elements]
        return [Element(self, numerator, one) for numerator in numerators], Element(self, common, one)


class AngleField(RationalFunctions):
    """Field Q(names, angles, tangents, π), with independent generators and an integer M for each angle.

    Sines and cosines of integer multiples of angle/M are elements. An angle and its tangent ``tan(angle/2M)`` are
    algebraically independent generators.
    """

    def __init__(self, names: Sequence[str], angles: Mapping[str, int] | None = None) -> None:
        self.angles = dict(angles or {})
        names = (*names, *(g for name in self.angles for g in (name, f"tan_{name}")), "pi")
        super().__init__(names, {name: self._reference(i, name) for i, name in enumerate(names)})

    def _reference(self, index: int, name: str) -> Fraction:
        """Return a positive reference value; the values of an angle and its ``tan(angle/2M)`` nearly agree."""
        if name == "pi":
            return Fraction(355, 113)
        if name in self.angles:
            return 2 * self.angles[name] * Fraction(1, 37 + 3 * (index + 1))
        return Fraction(1, 37 + 3 * index) if name.startswith("tan_") else Fraction(int(sympy.prime(index + 2)), 3)

    def cos(self, a: Element) -> Element:
        """Return the cosine of a rational multiple of an angle of the field."""
        return self._circle(a)[0]

    def sin(self, a: Element) -> Element:
        """Return the sine of a rational multiple of an angle of the field."""
        return self._circle(a)[1]

    def atan2(self, y: Element, x: Element) -> Element:
        """Return the angle of the point (x, y) as k/M times an angle of the field, |k| ≤ 2M, or raise NotExactError."""
        for name, steps in self.angles.items():
            for k in range(-2 * steps, 2 * steps + 1):
                multiple = self.symbol(name) * Fraction(k, steps)
                cosine, sine = self._circle(multiple)
                if y * cosine == x * sine and (y * sine + x * cosine).sign() > 0:
                    return multiple
        raise NotExactError(f"no multiple of an angle: that of ({x!r}, {y!r})")

    def _circle(self, a: Element) -> tuple[Element, Element]:
        """Return cosine and sine of a sum of rational multiples of angles."""
        turns, *multiples = a.combination([self.symbol(name) for name in ("pi", *self.angles)])
        steps = [multiple * count for multiple, count in zip(multiples, self.angles.values(), strict=True)]
        if any(part.denominator != 1 for part in (2 * turns, *steps)):
            raise NotExactError(f"no rational multiple of an angle: {a!r}")
        c, s = self._turned(None, 0, int(2 * turns) % 4)
        for name, count in zip(self.angles, steps, strict=True):
            if not count:
                continue
            cosine, sine = self._turned(name, int(count), 0)
            c, s = c * cosine - s * sine, c * sine + s * cosine
        return c, s

    def _turned(self, name: str | None, steps: int, quarters: int) -> tuple[Element, Element]:
        """Return cosine and sine of ``steps · angle/M`` plus `quarters` quarter turns."""
        c, s = self.constant(1), self.constant(0)
        if steps:
            t = self.symbol(f"tan_{name}")
            cosine, sine = (1 - t * t) / (1 + t * t), (2 if steps > 0 else -2) * t / (1 + t * t)
            for _ in range(abs(steps)):
                c, s = c * cosine - s * sine, c * sine + s * cosine
        for _ in range(quarters):
            c, s = -s, c
        return c, s
