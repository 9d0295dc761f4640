"""Polynomials over Q, with one interface to python-flint and SymPy."""

from __future__ import annotations

import importlib
import importlib.util
from fractions import Fraction
from numbers import Rational
from typing import Any

import sympy

Polynomial = Any  # fmpq_mpoly or PolyElement; both have + - * ** % == degrees() gcd() and an exact quotient /


class Polynomials:
    """Polynomials over Q in SymPy's sparse ring, in lexicographic order with the greatest generator first."""

    def __init__(self, count: int) -> None:
        self._ring, *generators = sympy.polys.rings.ring([f"g{i}" for i in range(count)], sympy.QQ)
        self.generators = tuple(generators)
        self.one, self.zero = self.constant(1), self.constant(0)

    def constant(self, value: Rational | int) -> Polynomial:
        """Return a constant polynomial."""
        return self._ring.ground_new(sympy.QQ(int(value.numerator), int(value.denominator)))

    def leading_coefficient(self, a: Polynomial) -> Any:
        """Return the coefficient of the leading term."""
        return a.LC

    def gcd(self, a: Polynomial, b: Polynomial) -> Polynomial:
        """Return the monic greatest common divisor of a and b.

        The method takes the gcd of b and the coefficients of a with respect to generators absent from b. SymPy's own
        gcd is slower: it treats absent generators too.
        """
        used = [i for i, degree in enumerate(b.degrees()) if degree > 0]
        if not a or not used:
            return (b or a).monic() if not (a and b) else self.one
        small = sympy.polys.rings.ring([f"g{i}" for i in used], sympy.QQ)[0]
        parts: dict[tuple[int, ...], dict[tuple[int, ...], Any]] = {}
        for exponents, coefficient in a.items():
            others = tuple(0 if i in used else power for i, power in enumerate(exponents))
            parts.setdefault(others, {})[tuple(exponents[i] for i in used)] = coefficient
        result = small.from_dict({tuple(e[i] for i in used): c for e, c in b.items()})
        for part in sorted(parts.values(), key=len):
            if result.is_ground:
                break
            result = result.gcd(small.from_dict(part))
        return result.monic().set_ring(self._ring)

    def derivative(self, a: Polynomial, generator: int) -> Polynomial:
        """Return the partial derivative by the generator with the given index."""
        return a.diff(self.generators[generator])

    def square_root(self, a: Polynomial) -> Polynomial | None:
        """Return a polynomial whose square is ``a``, or None."""
        content, factors = a.sqf_list()
        root = sympy.sqrt(sympy.Rational(int(content.numerator), int(content.denominator)))
        if not root.is_Rational or any(power % 2 for _, power in factors):
            return None
        result = self.constant(Fraction(int(root.p), int(root.q)))
        for factor, power in factors:
            result = result * factor ** (power // 2)
        return result

    def factors(self, a: Polynomial) -> list[tuple[Polynomial, int]]:
        """Return the irreducible factors with their exponents, constants left out."""
        return list(a.factor_list()[1])

    def terms(self, a: Polynomial) -> dict[tuple[int, ...], Fraction]:
        """Return the mapping from exponents to coefficients."""
        return {tuple(e): Fraction(int(c.numerator), int(c.denominator)) for e, c in a.items()}


class FlintPolynomials(Polynomials):
    """Polynomials over Q of type ``flint.fmpq_mpoly``."""

    def __init__(self, count: int) -> None:
        self._flint = importlib.import_module("flint")
        names = [f"g{i}" for i in range(count)]
        self._context = self._flint.fmpq_mpoly_ctx.get(names, self._flint.Ordering.lex)
        self.generators = tuple(self._context.gens())
        self.one, self.zero = self.constant(1), self.constant(0)

    def constant(self, value: Rational | int) -> Polynomial:
        return self._context.constant(self._flint.fmpq(int(value.numerator), int(value.denominator)))

    def leading_coefficient(self, a: Polynomial) -> Any:
        return a.leading_coefficient()

    def gcd(self, a: Polynomial, b: Polynomial) -> Polynomial:
        return a.gcd(b)

    def derivative(self, a: Polynomial, generator: int) -> Polynomial:
        return a.derivative(generator)

    def square_root(self, a: Polynomial) -> Polynomial | None:
        try:
            return a.sqrt()
        except self._flint.utils.flint_exceptions.DomainError:
            return None

    def factors(self, a: Polynomial) -> list[tuple[Polynomial, int]]:
        return [(factor, int(power)) for factor, power in a.factor()[1]]

    def terms(self, a: Polynomial) -> dict[tuple[int, ...], Fraction]:
        return {tuple(map(int, e)): Fraction(int(c.p), int(c.q)) for e, c in a.to_dict().items()}


def polynomials(count: int, backend: str | None = None) -> Polynomials:
    """Return the ring of polynomials in `count` generators; the default is python-flint if installed."""
    backend = backend or ("flint" if importlib.util.find_spec("flint") else "sympy")
    if backend not in ("flint", "sympy"):
        raise ValueError(f"no polynomial backend {backend!r}: expected 'flint' or 'sympy'")
    return FlintPolynomials(count) if backend == "flint" else Polynomials(count)
