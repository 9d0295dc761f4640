"""Elements of the exact ring: numbers with exact arithmetic and decided equality."""

from __future__ import annotations

import operator
from numbers import Number
from typing import TYPE_CHECKING

from .polynomial_backend import Polynomial, Polynomials

if TYPE_CHECKING:
    from .exact import Ring

BITS = 32  # of a packed monomial, per symbol: exponents stay far below 2**32


class Element:
    """An element of a :class:`Ring`: a number for formulas and kernels. Made by the ring, not directly.

    It takes ``+ - * /``, integer powers, ``==`` and ``.sqrt()`` (which ``numpy.sqrt`` calls on object arrays), with
    int, Fraction and NumPy integers as partners. A float partner is a TypeError: a rounded constant cannot be part of
    an exact identity. Division by zero is a ZeroDivisionError, division by anything but a function of the squares a
    ValueError.
    """

    __slots__ = ("denominator", "ring", "terms")
    __hash__ = None  # type: ignore[assignment]  # equal elements may be stored with different denominators

    def __init__(self, ring: Ring, terms: dict[int, Polynomial], denominator: Polynomial) -> None:
        self.ring = ring
        self.terms = terms
        self.denominator = denominator

    def _partner(self, other: object) -> Element | None:
        if isinstance(other, Element | Number):
            return self.ring.element(other)  # type: ignore[arg-type]  # refuses what is not exact
        return None

    def __neg__(self) -> Element:
        return Element(self.ring, {key: -c for key, c in self.terms.items()}, self.denominator)

    def __pos__(self) -> Element:
        return self

    def __add__(self, other: object) -> Element:
        partner = self._partner(other)
        if partner is None:
            return NotImplemented
        library, product = self.ring.polynomials, self.ring.polynomials.product
        mine, theirs = cofactors(library, self.denominator, partner.denominator)
        one = library.one
        terms = dict(self.terms) if mine == one else {key: product(c, mine) for key, c in self.terms.items()}
        for key, c in partner.terms.items():
            accumulate(terms, key, c if theirs == one else product(c, theirs))
        terms = {key: c for key, c in terms.items() if c}
        return Element(self.ring, terms, product(self.denominator, mine) if mine != one else self.denominator)

    __radd__ = __add__

    def __sub__(self, other: object) -> Element:
        partner = self._partner(other)
        return NotImplemented if partner is None else self + (-partner)

    def __rsub__(self, other: object) -> Element:
        return (-self) + other

    def __mul__(self, other: object) -> Element:
        partner = self._partner(other)
        if partner is None:
            return NotImplemented
        product = self.ring.polynomials.product
        terms: dict[int, Polynomial] = {}
        for key, c in self.terms.items():
            for key2, c2 in partner.terms.items():
                accumulate(terms, key + key2, product(c, c2))
        return Element(self.ring, self.ring.reduced(terms), product(self.denominator, partner.denominator))

    __rmul__ = __mul__

    def __truediv__(self, other: object) -> Element:
        partner = self._partner(other)
        if partner is None:
            return NotImplemented
        divisor = partner._numerator("a divisor")
        if not divisor:
            raise ZeroDivisionError("division by the zero of the exact ring")
        # a/D : b/E = a E/(D b), the factors common to D and E taken out first
        library, product = self.ring.polynomials, self.ring.polynomials.product
        mine, theirs = cofactors(library, partner.denominator, self.denominator)
        terms = {key: product(c, theirs) for key, c in self.terms.items()}
        return Element(self.ring, terms, product(mine, divisor))._in_lowest_terms()

    def __rtruediv__(self, other: object) -> Element:
        partner = self._partner(other)
        return NotImplemented if partner is None else partner / self

    def __pow__(self, exponent: object) -> Element:
        n = operator.index(exponent)  # type: ignore[arg-type]  # a TypeError for what is no integer
        if n < 0:
            raise ValueError(f"powers in the exact ring have exponents >= 0, given {n}")
        result, square = self.ring.constant(1), self
        while n:
            if n & 1:
                result = result * square
            n >>= 1
            if n:
                square = square * square
        return result

    def __eq__(self, other: object) -> bool:
        partner = self._partner(other)
        if partner is None:
            return NotImplemented
        if self.terms.keys() != partner.terms.keys():
            return False
        if self.denominator == partner.denominator:
            return all(c == partner.terms[key] for key, c in self.terms.items())
        library, product = self.ring.polynomials, self.ring.polynomials.product
        mine, theirs = cofactors(library, self.denominator, partner.denominator)
        return all(product(c, mine) == product(partner.terms[key], theirs) for key, c in self.terms.items())

    def __lt__(self, other: object) -> bool:
        """Order of functions of the squares at small positive squares; a selecting kernel asks for it."""
        partner = self._partner(other)
        if partner is None:
            return NotImplemented
        difference = self - partner
        difference._numerator("a compared element")
        return bool(difference) and difference._sign_near_zero() < 0

    def __gt__(self, other: object) -> bool:
        partner = self._partner(other)
        return NotImplemented if partner is None else partner < self

    def __bool__(self) -> bool:
        return bool(self.terms)

    def __repr__(self) -> str:
        monomials = []
        for key, coefficient in sorted(self.terms.items()):
            powers = ((name, (key >> (BITS * i)) & ((1 << BITS) - 1)) for i, name in enumerate(self.ring.names))
            factors = [name if power == 1 else f"{name}**{power}" for name, power in powers if power]
            monomials.append("*".join([f"({coefficient})", *factors]))
        numerator = " + ".join(monomials) or "0"
        return numerator if self.denominator == self.ring.polynomials.one else f"({numerator})/({self.denominator})"

    def sqrt(self) -> Element:
        """The square root that is positive near v = 0 (at small positive squares).

        Raises
        ------
        ValueError
            If the element is not the square of a rational function of the squares (or of s = sqrt(1 + x/k)).
        """
        ring, library = self.ring, self.ring.polynomials
        numerator = self._numerator("an element under a square root")
        if not numerator:
            return self
        common = library.gcd(numerator, self.denominator)
        top, bottom = library.quotient(numerator, common), library.quotient(self.denominator, common)
        root, below = library.square_root(top * bottom), bottom  # sqrt(a/b) = sqrt(a b)/b, whatever the signs
        if root is None:
            raise ValueError(f"not a perfect square in the exact ring: {self!r}")
        result = Element(ring, {0: root}, below)
        return -result if result._sign_near_zero() < 0 else result

    def derivative(self, name: str) -> Element:
        """Partial derivative with respect to a component or an extra symbol, or of a function of x by x.

        Parameters
        ----------
        name : str
            A symbol of the ring (the squares follow their vector: the derivative of x by ``"v1"`` is 2 v1), or ``"x"``
            (or another square), for an element that depends on the squares alone.
        """
        ring = self.ring
        if name in ring.square_names:
            self._numerator("an element differentiated by a square")
            return self._by_square(ring.square_names.index(name))
        index = ring.position(name)
        shift = BITS * index
        terms: dict[int, Polynomial] = {}
        for key, c in self.terms.items():
            power = (key >> shift) & ((1 << BITS) - 1)
            if power:
                accumulate(terms, key - (1 << shift), c * power)
        explicit = Element(ring, terms, self.denominator)
        if index >= 3 * len(ring.vectors):
            return explicit
        return explicit + self._by_square(index // 3) * (2 * ring.symbol(name))

    def _by_square(self, index: int) -> Element:
        """Derivative by a square, the components held fixed."""
        ring, library = self.ring, self.ring.polynomials
        product, rate, below = library.product, library.derivative, self.denominator
        slope = rate(below, index)
        terms = {key: rate(c, index) for key, c in self.terms.items()}
        if slope:
            # (P/D)' = (P' a - P b)/(D a) with D'/D = b/a in lowest terms
            b, a = cofactors(library, below, slope)
            terms = {key: product(c, a) - product(self.terms[key], b) for key, c in terms.items()}
            below = product(below, a)
        if ring.root and index == 0:  # s² = 1 + x/k, so d/dx = d/ds / (2 k s)
            below = below * library.generators[0] * (2 * ring.root)
        return Element(ring, {key: c for key, c in terms.items() if c}, below)

    def _in_lowest_terms(self) -> Element:
        """The same without a common factor, if it is a function of the squares: what it enters stays small."""
        if self.terms.keys() - {0}:
            return self
        library = self.ring.polynomials
        above, below = cofactors(library, self.denominator, self.terms.get(0, library.zero))
        return Element(self.ring, {0: above} if above else {}, below)

    def _numerator(self, what: str) -> Polynomial:
        """The numerator of an element that depends on the squares alone."""
        if self.terms.keys() - {0}:
            raise ValueError(f"{what} must depend on the squares {', '.join(self.ring.square_names)} only: {self!r}")
        return self.terms.get(0, self.ring.polynomials.zero)

    def _sign_near_zero(self) -> int:
        """Sign of a function of the squares at small positive squares (s slightly above 1, or below)."""
        sign = 1
        for part in (self.terms[0], self.denominator):
            if self.ring.root:
                first = self.ring.polynomials.generators[0]
                part = _shifted(self.ring.polynomials, part, first * self.ring.root)
            coefficients = self.ring.polynomials.coefficients(part)
            sign *= 1 if coefficients[min(coefficients)] > 0 else -1
        return sign


def _shifted(library: Polynomials, a: Polynomial, generator: Polynomial) -> Polynomial:
    """The polynomial with its first generator s replaced by 1 + the given one."""
    result = library.zero
    for (power, *rest), c in library.coefficients(a).items():
        term = library.constant(c) * (generator + library.one) ** power
        for other, exponent in zip(library.generators[1:], rest, strict=True):
            term = term * other**exponent
        result = result + term
    return result


def accumulate(terms: dict[int, Polynomial], key: int, value: Polynomial) -> None:
    if key in terms:
        terms[key] = terms[key] + value
    else:
        terms[key] = value


def cofactors(library: Polynomials, a: Polynomial, b: Polynomial) -> tuple[Polynomial, Polynomial]:
    """``b/g`` and ``a/g`` with g the greatest common divisor: the factors that make a and b equal."""
    if a == b:
        return library.one, library.one
    if a == library.one or b == library.one:
        return b, a
    g = library.gcd(a, b)
    return library.quotient(b, g), library.quotient(a, g)
