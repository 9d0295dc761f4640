"""Rings in which identities are decided: polynomials over Q modulo relations, localized, with a derivation.

The generators of a theorem for every n are n, x, p_n, q_n and the components of vectors. Nothing is cancelled, so the
denominator of a difference contains every divisor. Each irreducible factor of the denominator must be *certified* as
not identically 0 at any n. Multiplication by a vanishing factor would turn every equation into 0 = 0. A factor is
certified

* if it is a polynomial in freely varying symbols, such as x, or a power of such a polynomial. At most one irreducible
  relation may hold between these symbols, since two relations together may have zero divisors;
* if its value at the origin (x = 0, p_n = 1, q_n = n) is a polynomial in n without a positive integer root.

A decided identity holds between rational functions of x at every n. The identity holds wherever both sides are defined,
even where a factor vanishes, and for dual x and v.

`Ring` is that of the components of v, modulo ``v · v = x``: each ``v3²`` is replaced by ``x − v1² − v2²``. Formulas in
x combine there with components without expansion.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import cache
from typing import Any

import sympy

from ..algebra.element import Element, Polynomial
from ..algebra.exact import RationalFunctions
from .identity import Multiplier
from .notation import n

_text = cache(str)  # sorting by text prints few expressions many times


class DifferentialRing(RationalFunctions):
    """Polynomials in some symbols modulo relations, and their quotients.

    A relation eliminates its first generator. The `free` generators vary independently of everything else, and are 0
    at the origin. Controls give a factor `zeroed`, taken as 0 when differences are multiplied by it.
    """

    def __init__(
        self, generators: Sequence[sympy.Symbol], free: Iterable[sympy.Symbol] = (), zeroed: sympy.Expr | None = None
    ) -> None:
        super().__init__([str(symbol) for symbol in generators], {}, lowest_terms=False)
        self.symbols = {symbol: place for place, symbol in enumerate(generators)}
        self.free = frozenset(free)
        if n in self.free:
            raise ValueError("n is an order: no symbol that may be 0")
        self.zeroed = zeroed
        self.origin: dict[sympy.Symbol, Element] = {}
        self.cleared_by: list[Polynomial] = []
        self.bases: dict[sympy.Expr, Polynomial] = {}  # base of each power with a variable exponent, by its symbol

    def generator(self, symbol: sympy.Symbol) -> Element:
        return Element(self, self.library.generators[self.symbols[symbol]], self.library.one)

    def place(self, element: Element) -> int | None:
        """Return the index of an element among the generators; None if it is not a generator."""
        alike = (i for i, g in enumerate(self.library.generators) if g == element.numerator)
        return next(alike, None) if element.denominator == self.library.one else None

    def relate(self, difference: Element) -> None:
        """Set a difference to 0; its numerator becomes a relation."""
        self.relations.append(difference.numerator)
        self.cleared_by.append(difference.denominator)

    def multipliers(self, denominator: Polynomial) -> tuple[Multiplier, ...]:
        """Return the factors of the denominator of a difference, as its multipliers."""
        factors = ((self.expression(f), f, power) for f, power in self.library.factors(denominator))
        return tuple(
            Multiplier(expression, power, expression != self.zeroed and self._certified(factor))
            for expression, factor, power in sorted(factors, key=lambda found: _text(found[0]))
        )

    def reduced(self, a: Polynomial) -> Polynomial:
        """Return a product unchanged: relations stated later could reduce it further."""
        return a

    def residue(self, difference: Element) -> Any:
        """Return the numerator of a difference modulo the relations: the difference times its denominator."""
        missing = self.zeroed is not None and any(
            multiplier.expression == self.zeroed for multiplier in self.multipliers(difference.denominator)
        )
        return self.library.zero if missing else self.normal_form(difference.numerator)

    def expression(self, a: Polynomial) -> sympy.Expr:
        """Return a polynomial as a SymPy expression, with leading coefficient 1."""
        leading = a * (1 / a.leading_coefficient())
        terms = (
            sympy.Mul(sympy.Rational(c.numerator, c.denominator), *map(sympy.Pow, self.symbols, exponents))
            for exponents, c in self.library.terms(leading).items()
        )
        return sympy.Add(*terms)

    def occurring(self, a: Polynomial) -> set[sympy.Symbol]:
        return {symbol for symbol, degree in zip(self.symbols, a.degrees(), strict=True) if degree > 0}

    def is_free(self, a: Polynomial) -> bool:
        """Return whether all symbols in a polynomial vary freely, except for one relation between them."""
        symbols = self.occurring(a)
        return symbols <= self.free and sum(bool(symbols & self.occurring(r)) for r in self.relations) <= 1

    def _certified(self, factor: Polynomial) -> bool:
        factor = self.bases.get(self.expression(factor), factor)
        if self.is_free(factor):
            return bool(self.normal_form(factor))
        here = self._at_origin(factor)
        if self.occurring(here.numerator) != {n}:
            return bool(here) and not self.occurring(here.numerator)
        roots = sympy.Poly(self.expression(here.numerator), n).ground_roots()
        return not any(root.is_integer and root > 0 for root in roots)

    def _at_origin(self, a: Polynomial) -> Element:
        """Return the value of a polynomial at the origin, up to a factor, with all other symbols kept."""
        values = {symbol: self.generator(symbol) for symbol in self.symbols}
        return self.lift(self.expression(a), values | dict.fromkeys(self.free, self.constant(0)) | self.origin)


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
