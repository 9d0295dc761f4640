"""Polynomials over Q, by python-flint."""

from __future__ import annotations

from fractions import Fraction
from numbers import Rational
from typing import Any

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
        """Return a constant polynomial."""
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
        """Return the mapping from exponents to coefficients."""
        return {tuple(map(int, e)): Fraction(int(c.p), int(c.q)) for e, c in a.to_dict().items()}
