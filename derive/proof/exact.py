r"""The exact ring: rational functions of vector components, modulo :math:`v \cdot v = x`.

An element is

.. math:: \frac{1}{D(x)} \sum_m P_m(x)\, m, \qquad m = v_1^i v_2^j v_3^k d_1^l \cdots, \quad k \in \{0, 1\}

with integer polynomials :math:`P_m`, :math:`D` in the square(s) of the vector(s). Wherever :math:`v_3^2` arises it is
replaced by :math:`x - v_1^2 - v_2^2`, so :math:`v_1 v_1 + v_2 v_2 + v_3 v_3` becomes the generator :math:`x` by itself.
This form is unique up to a common factor of the :math:`P_m` and :math:`D`, therefore equality is decided exactly.

The ring is a type of number: a formula or an emitted kernel runs on its elements as it runs on floats.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from numbers import Rational
from typing import Any

import sympy

from .element import BITS, Element, accumulate, cofactors
from .polynomial_backend import Polynomial, Polynomials, polynomials

Operand = Element | Rational | int


class Ring:
    """Rational functions of the components of some vectors, and polynomials in further symbols.

    Parameters
    ----------
    vectors : sequence of str
        Each name ``v`` stands for three components ``v1``, ``v2``, ``v3`` and the square v·v. Division is by functions
        of the squares only.
    extra : sequence of str
        Further independent symbols (dual parts, rates, points).
    root : int
        Not 0: the square x of the first vector is expressed through s = sqrt(1 + x/root), so that odd powers of
        1 + x/root have a square root. 0: it is not.
    backend : {"flint", "sympy"}, optional
        Library for the polynomials; by default python-flint where it is installed.
    """

    def __init__(
        self,
        vectors: Iterable[str] = ("v",),
        extra: Iterable[str] = (),
        root: int = 0,
        backend: str | None = None,
    ) -> None:
        if not isinstance(root, int):
            raise TypeError(f"the root of a ring is that of 1 + x/k for an integer k, or none (0), given {root!r}")
        self.vectors = tuple(vectors)
        self.root = root
        squares = ["s" if root else "x"] + [f"{name}_square" for name in self.vectors[1:]]
        self.polynomials: Polynomials = polynomials(tuple(squares), backend)
        self.names = tuple(f"{name}{i}" for name in self.vectors for i in (1, 2, 3)) + tuple(extra)
        if not self.vectors or len({*self.names, *squares}) < len(self.names) + len(squares):
            raise ValueError(f"a ring needs a vector and distinct names, given {(*self.names, *squares)}")
        self.square_names = ("x", *squares[1:])
        generators = self.polynomials.generators
        first = (generators[0] ** 2 - self.polynomials.one) * root if root else generators[0]
        self.squares = (first, *generators[1:])  # v.v of each vector as a polynomial in the generators

    def constant(self, value: Rational | int) -> Element:
        """The element equal to an integer or a fraction."""
        make = self.polynomials.constant
        numerator, denominator = int(value.numerator), int(value.denominator)
        return Element(self, {0: make(numerator)} if numerator else {}, make(denominator))

    def symbol(self, name: str) -> Element:
        """The element named in ``names`` (such as ``"v1"`` or an extra symbol)."""
        return Element(self, {1 << (BITS * self.position(name)): self.polynomials.one}, self.polynomials.one)

    def position(self, name: str) -> int:
        """Index of a symbol in ``names``."""
        if name not in self.names:
            raise ValueError(f"no symbol {name!r} in a ring of {', '.join(self.names)}")
        return self.names.index(name)

    def vector(self, name: str) -> tuple[Element, Element, Element]:
        """The three components of a vector."""
        self._index(name)
        return self.symbol(f"{name}1"), self.symbol(f"{name}2"), self.symbol(f"{name}3")

    def square(self, name: str) -> Element:
        """The square v·v of a vector."""
        return Element(self, {0: self.squares[self._index(name)]}, self.polynomials.one)

    def square_root(self) -> Element:
        """The element s = sqrt(1 + x/root) of a ring made with a root."""
        if not self.root:
            raise ValueError("sqrt(1 + x/root) is an element of rings made with a root only")
        return Element(self, {0: self.polynomials.generators[0]}, self.polynomials.one)

    def lift(self, expression: Any, values: Mapping[Any, Operand]) -> Element:
        """A SymPy expression as an element, its symbols replaced by the given values.

        Parameters
        ----------
        expression : sympy.Expr or number
            Sums, products and powers of symbols and rational numbers; half a power is that of `Element.sqrt`.
        values : mapping
            Element (or exact number) for each SymPy symbol.
        """
        if isinstance(expression, int | Fraction):
            return self.constant(expression)
        if not isinstance(expression, sympy.Basic):
            raise TypeError(f"expected a SymPy expression or an exact number, not {type(expression).__name__}")
        return self._lift(expression, {symbol: self.element(value) for symbol, value in values.items()})

    def derivatives(self, expression: Any, symbol: Any, square: Element, order: int) -> list[Element]:
        """An expression in one symbol as an element where this is the first square, and its derivatives by it."""
        if square != self.square(self.vectors[0]):
            raise ValueError(f"derivatives are by the square of {self.vectors[0]}, not by {square!r}")
        found = [self.lift(expression, {symbol: square})]
        while len(found) <= order:
            found.append(found[-1].derivative(self.square_names[0]))
        return found

    def element(self, value: Operand) -> Element:
        """The value itself if it is of this ring, else the constant; floats are refused."""
        if isinstance(value, Element):
            if value.ring is not self:
                raise ValueError("elements of two different rings cannot be combined")
            return value
        if isinstance(value, Rational):
            return self.constant(value)
        raise TypeError(f"the exact ring takes int and Fraction, not {type(value).__name__} {value!r}")

    def cleared(self, elements: Sequence[Element]) -> tuple[list[Element], Element]:
        """The elements multiplied by their least common denominator, and that denominator."""
        library = self.polynomials
        common = library.one
        for element in elements:
            common = library.product(common, cofactors(library, common, element.denominator)[0])
        numerators = []
        for element in elements:
            factor = library.quotient(common, element.denominator)
            terms = {key: library.product(c, factor) for key, c in element.terms.items()}
            numerators.append(Element(self, terms, library.one))
        return numerators, Element(self, {0: common}, library.one)

    def _index(self, vector: str) -> int:
        if vector not in self.vectors:
            raise ValueError(f"no vector {vector!r} in a ring of {', '.join(self.vectors)}")
        return self.vectors.index(vector)

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

    def reduced(self, terms: dict[int, Polynomial]) -> dict[int, Polynomial]:
        """The same polynomial without zero terms and without the square of any third component."""
        for i, square in enumerate(self.squares):
            shift = BITS * (3 * i + 2)
            high = [key for key in terms if (key >> shift) & 2]  # exponent 2 or 3: products of reduced elements
            for key in high:
                coefficient = terms.pop(key)
                low = key - (2 << shift)
                accumulate(terms, low, self.polynomials.product(coefficient, square))
                accumulate(terms, low + (2 << (shift - BITS)), -coefficient)
                accumulate(terms, low + (2 << (shift - 2 * BITS)), -coefficient)
        return {key: coefficient for key, coefficient in terms.items() if coefficient}
