"""Integer polynomials for the exact ring: one interface, served by python-flint or by SymPy.

The exact ring needs very little of a polynomial: ``+``, ``-``, ``*``, ``==`` and truth from the object itself, and the
few operations below, which the two libraries spell differently. python-flint is used where it can be imported.
"""

from __future__ import annotations

import importlib
import importlib.util
from abc import ABC, abstractmethod
from collections.abc import Mapping
from typing import Any

import sympy

Polynomial = Any  # fmpz_mpoly or PolyElement: neither library offers a type common to both


class Polynomials(ABC):
    """Polynomials with integer coefficients in the named generators.

    Attributes
    ----------
    generators : tuple of polynomials
        In the order of the names.
    one, zero : polynomial
    """

    name: str
    generators: tuple[Polynomial, ...]
    one: Polynomial
    zero: Polynomial

    @abstractmethod
    def constant(self, value: int) -> Polynomial:
        """The constant polynomial."""

    @abstractmethod
    def product(self, a: Polynomial, b: Polynomial) -> Polynomial:
        """``a * b``."""

    @abstractmethod
    def gcd(self, a: Polynomial, b: Polynomial) -> Polynomial:
        """Greatest common divisor over the integers, content included."""

    @abstractmethod
    def quotient(self, a: Polynomial, b: Polynomial) -> Polynomial:
        """``a / b``, where ``b`` is known to divide ``a``."""

    @abstractmethod
    def square_root(self, a: Polynomial) -> Polynomial | None:
        """One of the two polynomials whose square is ``a``, or None where there is none."""

    @abstractmethod
    def derivative(self, a: Polynomial, generator: int) -> Polynomial:
        """Partial derivative with respect to the generator of that index."""

    @abstractmethod
    def coefficients(self, a: Polynomial) -> Mapping[tuple[int, ...], int]:
        """Coefficient of every monomial, by its exponents."""


class FlintPolynomials(Polynomials):
    """Backed by ``flint.fmpz_mpoly``."""

    name = "python-flint"

    def __init__(self, names: tuple[str, ...]) -> None:
        flint = importlib.import_module("flint")
        self._not_a_square = flint.utils.flint_exceptions.DomainError
        context = flint.fmpz_mpoly_ctx.get(list(names), flint.Ordering.lex)
        self.generators = tuple(context.gens())
        self._context = context
        self.one, self.zero = self.constant(1), self.constant(0)

    def constant(self, value: int) -> Polynomial:
        return self._context.constant(value)

    def product(self, a: Polynomial, b: Polynomial) -> Polynomial:
        return a * b

    def gcd(self, a: Polynomial, b: Polynomial) -> Polynomial:
        return a.gcd(b)

    def quotient(self, a: Polynomial, b: Polynomial) -> Polynomial:
        return a / b

    def square_root(self, a: Polynomial) -> Polynomial | None:
        try:
            return a.sqrt()
        except self._not_a_square:
            return None

    def derivative(self, a: Polynomial, generator: int) -> Polynomial:
        return a.derivative(generator)

    def coefficients(self, a: Polynomial) -> Mapping[tuple[int, ...], int]:
        return {tuple(map(int, exponents)): int(c) for exponents, c in a.to_dict().items()}


class SympyPolynomials(Polynomials):
    """Backed by SymPy's ``PolyRing`` over the integers."""

    name = "SymPy"
    _LONG = 200  # term products from which packing both factors into two integers is the faster way (measured)

    def __init__(self, names: tuple[str, ...]) -> None:
        self._ring = sympy.polys.rings.ring(",".join(names), sympy.ZZ)[0]
        self.generators = tuple(self._ring.gens)
        self.one, self.zero = self._ring.one, self._ring.zero

    def constant(self, value: int) -> Polynomial:
        return self._ring.ground_new(value)

    def product(self, a: Polynomial, b: Polynomial) -> Polynomial:
        if len(self.generators) > 1 or len(a) * len(b) < self._LONG:
            return a * b
        product = packed_product([int(c) for c in _dense(a)], [int(c) for c in _dense(b)])
        to_domain = self._ring.domain.convert
        return self._ring.from_dict({(i,): to_domain(c) for i, c in enumerate(product) if c})

    def gcd(self, a: Polynomial, b: Polynomial) -> Polynomial:
        return a.gcd(b)

    def quotient(self, a: Polynomial, b: Polynomial) -> Polynomial:
        return a.exquo(b)

    def square_root(self, a: Polynomial) -> Polynomial | None:
        content, factors = a.sqf_list()
        root = sympy.integer_nthroot(abs(int(content)), 2)
        if not root[1] or content < 0 or any(power % 2 for _, power in factors):
            return None
        result = self.constant(root[0])
        for factor, power in factors:
            result = result * factor ** (power // 2)
        return result

    def derivative(self, a: Polynomial, generator: int) -> Polynomial:
        return a.diff(self.generators[generator])

    def coefficients(self, a: Polynomial) -> Mapping[tuple[int, ...], int]:
        return {exponents: int(c) for exponents, c in a.items()}


def _dense(a: Polynomial) -> list[Any]:
    coefficients: list[Any] = [0] * (max(i for (i,) in a) + 1)
    for (i,), c in a.items():
        coefficients[i] = c
    return coefficients


def packed_product(a: list[int], b: list[int]) -> list[int]:
    """Product of two dense univariate polynomials by Kronecker substitution.

    Both are evaluated at a power of two large enough that the coefficients of the product cannot overlap, so one
    multiplication of two long integers, which Python does in subquadratic time, gives all of them.
    """
    bound = min(len(a), len(b)) * max(1, *map(abs, a)) * max(1, *map(abs, b))  # factors must fit too
    width = bound.bit_length() // 8 + 1  # bytes per coefficient, sign included
    length = len(a) + len(b) - 1
    half = 1 << (8 * width - 1)
    offset = int.from_bytes(half.to_bytes(width, "little") * length, "little")  # makes every digit non-negative
    digits = (_packed(a, width) * _packed(b, width) + offset).to_bytes(width * length + 1, "little")
    return [int.from_bytes(digits[i * width : (i + 1) * width], "little") - half for i in range(length)]


def _packed(a: list[int], width: int) -> int:
    positive = b"".join(max(c, 0).to_bytes(width, "little") for c in a)
    negative = b"".join(max(-c, 0).to_bytes(width, "little") for c in a)
    return int.from_bytes(positive, "little") - int.from_bytes(negative, "little")


def polynomials(names: tuple[str, ...], backend: str | None = None) -> Polynomials:
    """The polynomials in these generators.

    Parameters
    ----------
    names : tuple of str
    backend : {"flint", "sympy"}, optional
        By default python-flint where it is installed, else SymPy.
    """
    if backend is None:
        backend = "flint" if importlib.util.find_spec("flint") else "sympy"
    classes: dict[str, type[Any]] = {"flint": FlintPolynomials, "sympy": SympyPolynomials}
    if backend not in classes:
        raise ValueError(f"no polynomial backend {backend!r}: expected 'flint' or 'sympy'")
    result: Polynomials = classes[backend](names)
    return result
