"""Polynomials over Q by python-flint, and elements of exact rings, with exact arithmetic and tests of equality."""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from numbers import Number, Rational
from typing import Any, TypeVar

import flint
from flint.utils.flint_exceptions import DomainError

Polynomial = Any  # fmpq_mpoly; it has + - * ** % == degrees() gcd() and an exact quotient /


class Polynomials:
    """Polynomials in some generators, in lexicographic order with the greatest generator first."""

    def __init__(self, count: int) -> None:
        self._context = flint.fmpq_mpoly_ctx.get([f"g{i}" for i in range(count)], flint.Ordering.lex)
        self.generators = tuple(self._context.gens())
        self.one, self.zero = self.constant(1), self.constant(0)

    def constant(self, value: Rational | int) -> Polynomial:
        return self._context.constant(flint.fmpq(int(value.numerator), int(value.denominator)))

    def square_root(self, a: Polynomial) -> Polynomial | None:
        """Return a polynomial whose square is ``a``, or None."""
        try:
            return a.sqrt()
        except DomainError:
            return None

    def factors(self, a: Polynomial) -> list[tuple[Polynomial, int]]:
        """Return the irreducible factors with their exponents, constants left out."""
        return [(factor, int(power)) for factor, power in a.factor()[1]]

    def terms(self, a: Polynomial) -> dict[tuple[int, ...], Fraction]:
        return {tuple(map(int, e)): Fraction(int(c.p), int(c.q)) for e, c in a.to_dict().items()}


Result = TypeVar("Result")


class NotExactError(ArithmeticError):
    """Error for a result outside the field, such as the square root of a non-square."""


def _of_ring(operation: Callable[[Element, Element], Result]) -> Callable[[Element, object], Result]:
    """Return an operator that converts a number to an element of the ring first; other types are NotImplemented."""

    def found(self: Element, other: object) -> Result:
        if not isinstance(other, Element | Number):
            return NotImplemented  # type: ignore[no-any-return]
        return operation(self, self.ring.element(other))

    return found


class Element:
    """Rational function that behaves like a number. Methods of its ring create it.

    An element supports ``+ - * /``, integer powers, ``==``, ``abs``, ``<`` and ``.sqrt()``, which ``numpy.sqrt`` calls
    on object arrays. The other operand may be an int, a Fraction or a NumPy integer. A float raises TypeError, since
    exact identities contain no rounded constants.
    """

    __slots__ = ("denominator", "numerator", "ring")
    __hash__ = None  # type: ignore[assignment]  # equal elements may be stored with different denominators

    def __init__(self, ring: Any, numerator: Polynomial, denominator: Polynomial) -> None:
        self.ring = ring
        self.numerator = numerator
        self.denominator = denominator

    def __neg__(self) -> Element:
        return Element(self.ring, -self.numerator, self.denominator)

    def __pos__(self) -> Element:
        return self

    @_of_ring
    def __add__(self, other: Element) -> Element:
        if self.denominator == other.denominator:
            return Element(self.ring, self.numerator + other.numerator, self.denominator)
        mine, theirs = self.ring.cofactors(self.denominator, other.denominator)
        numerator = self.ring.reduced(self.numerator * mine + other.numerator * theirs)
        return Element(self.ring, numerator, self.denominator * mine)

    __radd__ = __add__

    @_of_ring
    def __sub__(self, other: Element) -> Element:
        return self + (-other)

    def __rsub__(self, other: object) -> Element:
        return (-self) + other

    @_of_ring
    def __mul__(self, other: Element) -> Element:
        numerator = self.ring.reduced(self.numerator * other.numerator)
        denominator = self.denominator * other.denominator
        if self.ring.relations:
            return Element(self.ring, numerator, denominator)
        return self.ring.fraction(numerator, denominator)  # type: ignore[no-any-return]

    __rmul__ = __mul__

    @_of_ring
    def __truediv__(self, other: Element) -> Element:
        divisor = self.ring.normal_form(other.numerator)
        if not divisor:
            raise ZeroDivisionError("division by the zero of the exact ring")
        # a/D : b/E = a E/(D b), without the factors that D and E share
        mine, theirs = self.ring.cofactors(other.denominator, self.denominator)
        numerator = self.ring.reduced(self.numerator * theirs)
        return self.ring.fraction(numerator, divisor * mine)  # type: ignore[no-any-return]

    @_of_ring
    def __rtruediv__(self, other: Element) -> Element:
        return other / self

    def __pow__(self, exponent: object) -> Element:
        n = operator.index(exponent)  # type: ignore[arg-type]  # a TypeError unless it is an integer
        if n < 0:
            return 1 / self**-n
        if n < 2:
            return self if n else self.ring.constant(1)
        if not self.ring.relations:
            return Element(self.ring, self.numerator**n, self.denominator**n)
        half = self ** (n // 2)
        return half * half * self if n % 2 else half * half

    @_of_ring
    def __eq__(self, other: Element) -> bool:
        return not self - other

    @_of_ring
    def __lt__(self, other: Element) -> bool:
        """Compare the values at the reference point; kernels select by such comparisons."""
        return (self - other).sign() < 0

    @_of_ring
    def __gt__(self, other: Element) -> bool:
        return other < self

    def __bool__(self) -> bool:
        return bool(self.ring.normal_form(self.numerator))

    def __abs__(self) -> Element:
        return -self if self.sign() < 0 else self

    def __repr__(self) -> str:
        above, below = map(self.ring.text, (self.numerator, self.denominator))
        return f"({above})/({below})" if below != "1" else above

    def sign(self) -> int:
        """Return the sign at the reference point."""
        value = self.ring.value(self.numerator) * self.ring.value(self.denominator)
        return int(value > 0) - int(value < 0)

    def sqrt(self) -> Element:
        """Return the square root that is positive at the reference point; a non-square raises NotExactError."""
        root = self.ring.library.square_root(self.numerator * self.denominator)
        if root is None:
            raise NotExactError(f"not a perfect square in the exact ring: {self!r}")
        return abs(self.ring.fraction(root, self.denominator)) if root else self

    def derivative(self, rates: Mapping[int, Element]) -> Element:
        """Return the derivative, from the `rates` of generators by index; other generators are constant."""
        rate = self._derived(self.numerator, rates)
        if self.denominator == self.ring.library.one:
            return rate
        growth = self._derived(self.denominator, rates)  # (P/D)' = (P' − P D'/D)/D
        above, below = self.ring.cofactors(self.denominator, growth.numerator)
        growth = Element(self.ring, above, growth.denominator * below)
        over = Element(self.ring, self.ring.library.one, self.denominator)
        return (rate - Element(self.ring, self.numerator, self.ring.library.one) * growth) * over

    def _derived(self, a: Polynomial, rates: Mapping[int, Element]) -> Element:
        library, total = self.ring.library, self.ring.constant(0)
        for generator, rate in rates.items():
            slope = a.derivative(generator)
            if slope:
                total = total + Element(self.ring, slope, library.one) * rate
        return total  # type: ignore[no-any-return]

    def combination(self, monomials: Sequence[Element]) -> tuple[Fraction, ...]:
        """Return the rational numbers c with ``self = Σ c · monomial``; raise NotExactError if there are none."""
        terms = self.ring.library.terms
        reduced = self.ring.fraction(self.numerator, self.denominator, lowest_terms=True)
        left = terms(reduced.numerator)
        known = [next(iter(terms(monomial.numerator).items())) for monomial in monomials]
        result = tuple(left.pop(exponents, Fraction(0)) / scale for exponents, scale in known)
        if left or reduced.denominator != self.ring.library.one:
            raise NotExactError(f"no combination of {monomials!r}: {self!r}")
        return result
