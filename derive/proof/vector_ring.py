r"""Exact ring of rational functions of the components of a vector v, modulo :math:`v \cdot v = x`.

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
"""Value of x at the reference point, small so that roots are positive near v = 0."""


class Ring(RationalFunctions):
    """Rational functions of the components v1, v2, v3 of a vector ``v``, of its square ``x``, and of `extra` symbols.

    A second vector w (`vectors` "vw") has the components w1, w2, w3 and the square ``y``. For a `root` k other than 0,
    the generator is s = sqrt(1 + x/k) in place of x. Odd powers of 1 + x/k then have a square root. The root of the
    second vector is t.
    """

    def __init__(
        self, extra: Iterable[str] = (), root: int = 0, vectors: str = "v"
    ) -> None:
        generators = ("st" if root else "xy")[: len(vectors)]
        small = 1 + NEAR_ZERO * (1 if root > 0 else -1) if root else NEAR_ZERO
        components = [f"{letter}{i}" for letter in vectors for i in (3, 2, 1)]
        super().__init__([*components, *extra, *generators], dict.fromkeys(generators, small))
        roots = [self.symbol(generator) for generator in generators]
        self.root, self.generator = root, roots[0]
        self.squares = [(s**2 - 1) * root if root else s for s in roots]
        self.v, self.x = (self.symbol("v1"), self.symbol("v2"), self.symbol("v3")), self.squares[0]
        for letter, square in zip(vectors, self.squares):
            c1, c2, c3 = (self.symbol(f"{letter}{i}") for i in (1, 2, 3))
            self.relations.append((c3**2 + c2**2 + c1**2 - square).numerator)

    def derivative(self, element: Element, name: str) -> Element:
        """Return a derivative by a component, an extra symbol, or ``"x"``: the square x with all components fixed."""
        if name == "x":
            return self._by_square(element, 0)
        slope = element.derivative({self.index(name): self.constant(1)})
        if name in ("v1", "v2", "v3"):  # x = v·v depends on v1: its derivative is 2 v1
            slope += 2 * self.symbol(name) * self._by_square(element, 0)
        return slope

    def _by_square(self, element: Element, place: int) -> Element:
        """Return the derivative by the square of a vector with all components fixed."""
        generator = len(self.names) - len(self.squares) + place
        s = Element(self, self.library.generators[generator], self.library.one)
        by_square = 1 / (2 * self.root * s) if self.root else self.constant(1)  # s² = 1 + x/k
        return element.derivative({generator: by_square})

    def derivatives(self, expression: Any, symbol: Any, square: Element, order: int) -> list[Element]:
        """Return an expression at ``symbol = square``, followed by its derivatives by the symbol up to an order."""
        if square not in self.squares:
            raise ValueError(f"derivatives are by the square of v or w, not by {square!r}")
        found = [self.lift(expression, {symbol: square})]
        while len(found) <= order:
            found.append(self._by_square(found[-1], self.squares.index(square)))
        return found
