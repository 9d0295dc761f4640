"""Independent generators at a random point modulo a random prime, for formulas too large for an exact field.

A formula without division by 0 is a quotient of polynomials over Q. If it is not 0, it vanishes at a random point
modulo a random prime with a probability below its degree over the prime, plus that of a prime that divides all its
coefficients.
Each number carries bounds of its degree and of the bits of its coefficients, and `is_sure` bounds the probability.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from numbers import Number
from typing import Any

import flint
import sympy

from ...algebra.element import NotExactError
from .generators import POOLS, Generators
from .intervals import Monomial

PRIME_BITS = 256
SURE_BITS = 120
"""A proof is wrong with a probability below 2 to the power of minus this."""
TERMS_MAX = 6
"""Largest number of terms of a polynomial that an angle may be."""
CANDIDATES_MAX = 3000
"""Largest number of products of known numbers that are tried as roots."""
Polynomial = Mapping[Monomial, Fraction]


class UnluckyError(ArithmeticError):
    """Error for a prime modulo which a number has no root; another prime may have one."""


class Residue:
    """Number modulo a prime, with bounds of degree and bits, and with its terms while it is a short polynomial."""

    __slots__ = ("bits", "degree", "field", "terms", "value")
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, field: Residues, value: int, degree: int, bits: int, terms: Polynomial | None = None) -> None:
        self.field, self.value, self.degree, self.bits, self.terms = field, value % field.prime, degree, bits, terms
        field.largest = max(field.largest[0], degree), max(field.largest[1], bits)

    def _other(self, other: Any) -> Residue | None:
        if isinstance(other, Residue):
            return other
        return self.field.element(other) if isinstance(other, int | Fraction) else None

    def __add__(self, other: Any) -> Any:
        b = self._other(other)
        if b is None:
            return NotImplemented
        terms = _sum(self.terms, b.terms)
        return Residue(self.field, self.value + b.value, self.degree + b.degree, self.bits + b.bits + 1, terms)

    def __mul__(self, other: Any) -> Any:
        b = self._other(other)
        if b is None:
            return NotImplemented
        terms = _product(self.terms, b.terms)
        return Residue(self.field, self.value * b.value, self.degree + b.degree, self.bits + b.bits, terms)

    __radd__, __rmul__ = __add__, __mul__

    def __neg__(self) -> Residue:
        terms = None if self.terms is None else {monomial: -c for monomial, c in self.terms.items()}
        return Residue(self.field, -self.value, self.degree, self.bits, terms)

    def __sub__(self, other: Any) -> Any:
        b = self._other(other)
        return NotImplemented if b is None else self + -b

    def __rsub__(self, other: Any) -> Any:
        return -self + other

    def __truediv__(self, other: Any) -> Any:
        b = self._other(other)
        if b is None:
            return NotImplemented
        if not b.value:
            raise ZeroDivisionError("division by 0 modulo a prime")
        constant = b.terms.get((), Fraction(0)) if b.terms is not None and len(b.terms) == 1 else Fraction(0)
        terms = {m: c / constant for m, c in self.terms.items()} if constant and self.terms is not None else None
        value = self.value * pow(b.value, -1, self.field.prime)
        return Residue(self.field, value, self.degree + b.degree, self.bits + b.bits, terms)

    def __rtruediv__(self, other: Any) -> Any:
        b = self._other(other)
        return NotImplemented if b is None else b / self

    def __pow__(self, exponent: int) -> Any:
        found = self.field.element(1)
        for _ in range(abs(exponent)):
            found = found * self
        return 1 / found if exponent < 0 else found

    def __eq__(self, other: object) -> bool:
        b = self._other(other)
        return NotImplemented if b is None else self.value == b.value

    def __bool__(self) -> bool:
        return bool(self.value)

    def __lt__(self, other: Any) -> bool:
        raise NotExactError("a sign modulo a prime")

    __gt__ = __le__ = __ge__ = __lt__

    def __repr__(self) -> str:
        return f"{self.value} modulo {self.field.prime}"


Number.register(Residue)


def _sum(a: Polynomial | None, b: Polynomial | None) -> Polynomial | None:
    if a is None or b is None or len(a) + len(b) > TERMS_MAX:
        return None
    found = dict(a)
    for monomial, c in b.items():
        found[monomial] = found.get(monomial, Fraction(0)) + c
    return {monomial: c for monomial, c in found.items() if c}


def _product(a: Polynomial | None, b: Polynomial | None) -> Polynomial | None:
    if a is None or b is None or len(a) * len(b) > TERMS_MAX:
        return None
    found: dict[Monomial, Fraction] = {}
    for one, c in a.items():
        for two, d in b.items():
            powers = dict(one)
            for name, power in two:
                powers[name] = powers.get(name, 0) + power
            monomial = tuple(sorted(powers.items()))
            found[monomial] = found.get(monomial, Fraction(0)) + c * d
    return found


class Residues(Generators):
    """Field of `Generators` at a random point modulo a random prime; `seed` determines both."""

    pools = dict.fromkeys(POOLS, 40)

    def __init__(self, *given: Any, seed: str = "", **rest: Any) -> None:
        super().__init__(*given, **rest)
        source = random.Random(seed)  # the same prime and point for all signs of roots
        self.seed = seed
        while True:
            self.prime = source.getrandbits(PRIME_BITS - 1) | 1 << (PRIME_BITS - 1) | 3  # 3 modulo 4: roots are powers
            if flint.fmpz(self.prime).is_prime():
                break
        self.largest = 0, 0

    def is_sure(self, tests: int) -> bool:
        """Return whether so many equalities are all right but for a probability below ``2**-SURE_BITS``."""
        degree, bits = self.largest
        # a root doubles the degree, and halves the primes to draw from
        tests <<= 2 * len(self.roots)
        # fewer than `bits` primes divide all coefficients, of more than 2**(PRIME_BITS - 10) primes
        doubt = Fraction(tests * degree, 2 ** (PRIME_BITS - 1)) + Fraction(tests * bits, 2 ** (PRIME_BITS - 10))
        return doubt < Fraction(1, 2**SURE_BITS)

    # ---- numbers -----------------------------------------------------------------------------------------------------

    def restrict_to(self, equations: Sequence[Any]) -> None:
        raise NotExactError("equations in the domain")

    def symbol(self, name: str) -> Residue:
        value = random.Random(f"{self.seed} {name}").randrange(self.prime)
        return Residue(self, value, 1, 1, {((name, 1),): Fraction(1)})

    def element(self, a: Any) -> Residue:
        if isinstance(a, Residue):
            return a
        a = Fraction(a)
        value = a.numerator * pow(a.denominator, -1, self.prime)
        bits = max(a.numerator.bit_length(), a.denominator.bit_length())
        return Residue(self, value, 0, bits, {(): a} if a else {})

    def terms(self, a: Residue) -> Iterator[tuple[Monomial, Fraction]]:
        if a.terms is None or any(
            name.startswith(("tangent ", "exponential ")) for monomial in a.terms for name, _ in monomial):
            raise NotExactError("an angle or exponent that is no short polynomial")
        yield from a.terms.items()

    def absolute(self, a: Any) -> Any:
        return self.chosen(a) if isinstance(a, Residue) else super(Generators, self).absolute(a)

    # ---- roots and signs ---------------------------------------------------------------------------------------------

    @cached_property
    def _positive(self) -> dict[int, Residue]:
        """Products of known positive numbers: magnitudes, lengths, and half-angle sines and cosines, by residue."""
        found = [self.element(1)]
        for name, (low, high) in self.given.items():
            if low != 0:
                continue
            x, factors = self.symbol(name), [[self.symbol(name)]]
            if high.is_finite and high <= sympy.pi:
                factors = [[x], [self._sin(x)], [self._sin(x / 2), self._cos(x / 2)]]
            for choice in factors:
                found += [a * b for a in list(found) for b in choice][:CANDIDATES_MAX]
        return {a.value: a for a in found}

    @cached_property
    def _candidates(self) -> list[Residue]:
        """Numbers whose squares have known roots."""
        parts = []
        for name in self.names:
            if name.endswith((".0", ".X", ".A")):
                parts.append(self.symbol(name))
                for k in (1, 2, 3, 4):
                    parts += self._circle(self.symbol(name) * Fraction(k, 2))
        return [*self._positive.values(), *parts, *(a * b for i, a in enumerate(parts[:40]) for b in parts[i:40])]

    def is_positive(self, a: Residue) -> bool:
        if a.terms is not None and set(a.terms) == {()}:
            return a.terms[()] > 0
        if any((a / known).value in self._positive for known in self.assumed if known):
            return True
        return a.value in self._positive or any((a * k).value in self._positive for k in (2, 4, Fraction(1, 2)))

    def root(self, a: Residue) -> Residue | None:
        if not a:
            return a
        multiples: Iterator[Residue] = (known * k for known in self._candidates for k in (1, 2, 4, Fraction(1, 2)))
        return next((known for known in multiples if known * known == a), None)

    def positive_factors(self, a: Residue) -> list[tuple[Residue, int]]:
        return [(a, 1)]

    def new_root(self, a: Residue) -> Residue:
        root = pow(a.value, (self.prime + 1) // 4, self.prime)
        if root * root % self.prime != a.value:
            raise UnluckyError
        found: Residue = self.chosen(Residue(self, root, a.degree, a.bits))
        return found

    def restrict(self, what: str, name: str, known: Any) -> None:
        """Leave a generator unbounded: no sign is asked of a residue."""
