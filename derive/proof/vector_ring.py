r"""The exact ring of rational functions of vector components, modulo :math:`v \cdot v = x`.

Each :math:`v_3^2` is replaced by :math:`x - v_1^2 - v_2^2`. Hence :math:`v_1 v_1 + v_2 v_2 + v_3 v_3` becomes the
generator :math:`x`, and formulas in x combine with components without expansion.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from ..algebra.element import Element
from ..algebra.exact import RationalFunctions

NEAR_ZERO = Fraction(1, 10**30)
"""Square of the first vector at the reference point, small so that roots are positive near v = 0."""


class Ring(RationalFunctions):
    """Rational functions of the components of some vectors and of further symbols.

    Parameters
    ----------
    vectors : sequence of str
        Each name ``v`` stands for three components ``v1``, ``v2``, ``v3`` and the square v·v.
    extra : sequence of str
        Further independent symbols (dual parts, rates, points).
    root : int
        Integer k of the generator s = sqrt(1 + x/k), by which the ring expresses the square x of the first vector. Odd
        powers of 1 + x/k then have a square root. With 0, the generator is x.
    backend : {"flint", "sympy"}, optional
        Library for the polynomials; by default python-flint where it is installed.
    """

    def __init__(
        self, vectors: Iterable[str] = ("v",), extra: Iterable[str] = (), root: int = 0, backend: str | None = None
    ) -> None:
        self.vectors, self.root = tuple(vectors), root
        components = [f"{name}{i}" for name in self.vectors for i in (3, 2, 1)]
        self._generators = ["s" if root else "x", *(f"{name}_square" for name in self.vectors[1:])]
        small = 1 + NEAR_ZERO * (1 if root > 0 else -1) if root else NEAR_ZERO
        point = {name: small if i == 0 else Fraction(1, 10**6) for i, name in enumerate(self._generators)}
        super().__init__([*components, *extra, *self._generators], point, backend)
        for name in self.vectors:
            v1, v2, v3 = self.vector(name)
            self.relations.append((v3**2 + v2**2 + v1**2 - self.square(name)).numerator)

    def vector(self, name: str) -> tuple[Element, Element, Element]:
        """Return the three components of a vector."""
        return self.symbol(f"{name}1"), self.symbol(f"{name}2"), self.symbol(f"{name}3")

    def square(self, name: str) -> Element:
        """Return the square v·v of a vector."""
        generator = self.symbol(self._generators[self.vectors.index(name)])
        return (generator**2 - 1) * self.root if self.root and name == self.vectors[0] else generator

    def square_root(self) -> Element:
        """Return the element s = sqrt(1 + x/root) of a ring made with a root."""
        return self.symbol("s")

    def derivative(self, element: Element, name: str) -> Element:
        """Return a partial derivative.

        Parameters
        ----------
        element : Element
        name : str
            A component or an extra symbol, or ``"x"`` for the square of the first vector with all components fixed.
        """
        one, first = self.constant(1), self._generators[0]
        by_first = 1 / (2 * self.root * self.symbol("s")) if self.root else one  # s² = 1 + x/k
        if name == "x":
            return element.derivative({self.index(first): by_first})
        rates = {self.index(name): one}
        for vector, generator in zip(self.vectors, self._generators, strict=True):
            if name in (f"{vector}1", f"{vector}2", f"{vector}3"):  # x = v·v too: its derivative by v1 is 2 v1
                rates[self.index(generator)] = 2 * self.symbol(name) * (by_first if generator == first else 1)
        return element.derivative(rates)

    def derivatives(self, expression: Any, symbol: Any, square: Element, order: int) -> list[Element]:
        """Return an expression at ``symbol = square``, followed by its derivatives by the symbol up to an order."""
        if square != self.square(self.vectors[0]):
            raise ValueError(f"derivatives are by the square of {self.vectors[0]}, not by {square!r}")
        found = [self.lift(expression, {symbol: square})]
        while len(found) <= order:
            found.append(self.derivative(found[-1], "x"))
        return found
