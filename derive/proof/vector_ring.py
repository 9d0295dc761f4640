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
    """Rational functions of the components v1, v2, v3 of a vector ``v``, of its square ``x``, and of further symbols.

    Parameters
    ----------
    extra : sequence of str
        Further independent symbols (dual parts, rates, points).
    root : int
        Integer k of the generator s = sqrt(1 + x/k), in which the ring expresses x. Odd powers of 1 + x/k then have a
        square root. With 0, the generator is x.
    backend : {"flint", "sympy"}, optional
        Library for the polynomials; by default python-flint if installed.
    """

    def __init__(self, extra: Iterable[str] = (), root: int = 0, backend: str | None = None) -> None:
        generator = "s" if root else "x"
        small = 1 + NEAR_ZERO * (1 if root > 0 else -1) if root else NEAR_ZERO
        super().__init__(["v3", "v2", "v1", *extra, generator], {generator: small}, backend)
        self.root, self.generator = root, self.symbol(generator)
        self.v = self.symbol("v1"), self.symbol("v2"), self.symbol("v3")
        self.x = (self.generator**2 - 1) * root if root else self.generator
        v1, v2, v3 = self.v
        self.relations.append((v3**2 + v2**2 + v1**2 - self.x).numerator)

    def derivative(self, element: Element, name: str) -> Element:
        """Return a partial derivative.

        Parameters
        ----------
        element : Element
        name : str
            A component or an extra symbol, or ``"x"`` for the square x with all components fixed.
        """
        by_x = 1 / (2 * self.root * self.generator) if self.root else self.constant(1)  # s² = 1 + x/k
        last = len(self.names) - 1
        if name == "x":
            return element.derivative({last: by_x})
        rates = {self.index(name): self.constant(1)}
        if name in ("v1", "v2", "v3"):  # x = v·v depends on v1: its derivative is 2 v1
            rates[last] = 2 * self.symbol(name) * by_x
        return element.derivative(rates)

    def derivatives(self, expression: Any, symbol: Any, square: Element, order: int) -> list[Element]:
        """Return an expression at ``symbol = square``, followed by its derivatives by the symbol up to an order."""
        if square != self.x:
            raise ValueError(f"derivatives are by the square of v, not by {square!r}")
        found = [self.lift(expression, {symbol: square})]
        while len(found) <= order:
            found.append(self.derivative(found[-1], "x"))
        return found
