r"""The ring in which identities are decided: polynomials over Q modulo relations, localized, with a derivation.

A theorem for every n has n, x, p_n, q_n and the components of vectors as generators. A quotient is a polynomial over a
product of *units*. Whatever is divided by becomes a unit, and every unit must be certified: it must not vanish
identically for any n, or multiplying by it would turn everything into 0 = 0. It is certified

* if it is a polynomial in letters that vary freely, such as x, or a power of one; one relation at most, which is
  irreducible, may hold between these, since two may have zero divisors together;
* if its value at the origin (x = 0, p_n = 1, q_n = n) is a polynomial in n without a positive integer root.

An identity so decided holds between rational functions of x at every n, hence wherever both sides are defined, where a
unit vanishes too; for dual x and v as well.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from numbers import Rational
from typing import Any

import sympy
from sympy.polys.rings import PolyElement, ring

from .identity import Multiplier
from .marks import n


@dataclass(frozen=True)
class _Unit:
    """A polynomial that is divided by, what differences are multiplied by for it, and whether that is certified."""

    polynomial: PolyElement
    value: PolyElement
    certified: bool

    @cached_property
    def expression(self) -> sympy.Expr:
        return self.polynomial.as_expr()


class DifferentialRing:
    """Polynomials in some letters modulo relations, and their quotients by units.

    Parameters
    ----------
    generators : sequence of Symbol
        The letter that a relation eliminates stands before the others in it.
    free : iterable of Symbol
        Those of them that vary independently of everything else, and are 0 at the origin.
    zeroed : Expr, optional
        A unit in whose place differences are multiplied by 0, as by a slip of the pen; for controls.
    """

    def __init__(
        self, generators: Sequence[sympy.Symbol], free: Iterable[sympy.Symbol] = (), zeroed: sympy.Expr | None = None
    ) -> None:
        self.polynomials, *symbols = ring(generators, sympy.QQ)
        self.letters = dict(zip(generators, symbols, strict=True))
        self.free = frozenset(free)
        if n in self.free:
            raise ValueError("n is an order: no letter that may be 0")
        self.zeroed = zeroed
        self.origin: dict[PolyElement, PolyElement] = {}
        self.relations: list[PolyElement] = []
        self.cleared: list[tuple[int, ...]] = []
        self.units: list[_Unit] = []
        self._bases: dict[PolyElement, PolyElement] = {}

    def generator(self, letter: sympy.Symbol) -> Quotient:
        """The generator of that letter."""
        return Quotient(self, self.letters[letter], ())

    def constant(self, value: Rational | int) -> Quotient:
        """An integer or a fraction."""
        return Quotient(self, self.polynomials.ground_new(_rational(value)), ())

    def relate(self, difference: Quotient) -> None:
        """Let this be 0; a quotient is multiplied by its units for that."""
        self.relations.append(difference.numerator)
        self.cleared.append(difference.powers)

    def grows(self, letter: sympy.Symbol, base: Quotient) -> None:
        """Let the letter be a power of this base, with an exponent that varies."""
        self._bases[self.letters[letter]] = base.numerator

    def reduced(self, polynomial: PolyElement) -> PolyElement:
        """The polynomial modulo the relations: 0 exactly if it is."""
        return polynomial.rem(self.relations) if self.relations else polynomial

    def factored(self, divisor: PolyElement) -> tuple[Any, tuple[int, ...]]:
        """A divisor as a rational number times powers of units, new ones among them."""
        divisor = self.reduced(divisor)
        powers = [0] * len(self.units)
        for place, unit in enumerate(self.units):
            divisor, powers[place] = _divided(divisor, unit.polynomial)
        if divisor == 0:
            raise ZeroDivisionError("division by zero")
        lowest = zip(self.letters.values(), divisor.tail_degrees(), strict=True)
        for new in (*(letter for letter, degree in lowest if degree > 0), None):
            factor = divisor.monic() if new is None else new
            divisor, power = _divided(divisor, factor)
            if power:
                self.units.append(self._unit(factor))
                powers.append(power)
        return divisor.LC, tuple(powers)

    def multiplier(self, powers: Sequence[int]) -> tuple[Multiplier, ...]:
        """What a difference over these powers of units was multiplied by, unit by unit."""
        used = ((unit, power) for unit, power in zip(self.units, powers, strict=False) if power)
        return tuple(Multiplier(unit.expression, power, unit.certified) for unit, power in used)

    def raised(self, polynomial: PolyElement, powers: Sequence[int]) -> PolyElement:
        """The polynomial times powers of units."""
        for unit, power in zip(self.units, powers, strict=False):
            if power:
                polynomial = polynomial * unit.polynomial**power
        return polynomial

    def _unit(self, polynomial: PolyElement) -> _Unit:
        value = polynomial
        if self.zeroed is not None and polynomial.as_expr() == self.zeroed:
            value = self.polynomials.zero
        return _Unit(polynomial, value, self._certified(value))

    def _certified(self, polynomial: PolyElement) -> bool:
        """Whether a polynomial vanishes identically for no n."""
        polynomial = self._bases.get(polynomial, polynomial)
        letters = self._occurring(polynomial)
        if letters <= self.free and sum(bool(letters & self._occurring(r)) for r in self.relations) <= 1:
            return bool(polynomial != 0)
        zero = self.polynomials.zero
        here = polynomial.compose([*((self.letters[letter], zero) for letter in self.free), *self.origin.items()])
        if self._occurring(here) != {n}:
            return bool(here.is_ground and here != 0)
        return not any(root.is_integer and root > 0 for root in sympy.Poly(here.as_expr(), n).ground_roots())

    def letters_of(self, value: Quotient) -> set[sympy.Symbol]:
        """The letters in a numerator."""
        return self._occurring(value.numerator)

    def _occurring(self, polynomial: PolyElement) -> set[sympy.Symbol]:
        """The letters in a polynomial."""
        return {letter for letter, degree in zip(self.letters, polynomial.degrees(), strict=True) if degree > 0}


class Quotient:
    """A polynomial over a product of powers of units: a number for formulas. Made by the ring, not directly."""

    __slots__ = ("numerator", "powers", "ring")
    __hash__ = None  # type: ignore[assignment]  # equal quotients are stored with different denominators
    __array_ufunc__ = None

    def __init__(self, ring: DifferentialRing, numerator: PolyElement, powers: tuple[int, ...]) -> None:
        self.ring = ring
        self.numerator = numerator
        self.powers = powers

    def _partner(self, other: object) -> Quotient | None:
        if isinstance(other, Quotient):
            return other
        return self.ring.constant(other) if isinstance(other, Rational) else None

    def __neg__(self) -> Quotient:
        return Quotient(self.ring, -self.numerator, self.powers)

    def __add__(self, other: object) -> Quotient:
        partner = self._partner(other)
        if partner is None:
            return NotImplemented
        if self.powers == partner.powers:
            return Quotient(self.ring, self.numerator + partner.numerator, self.powers)
        common, raised = _joined(max, self.powers, partner.powers), self.ring.raised
        mine, theirs = (raised(a.numerator, _joined(int.__sub__, common, a.powers)) for a in (self, partner))
        return Quotient(self.ring, mine + theirs, common)

    __radd__ = __add__

    def __sub__(self, other: object) -> Quotient:
        partner = self._partner(other)
        return NotImplemented if partner is None else self + (-partner)

    def __rsub__(self, other: object) -> Quotient:
        return (-self) + other

    def __mul__(self, other: object) -> Quotient:
        if isinstance(other, Rational):
            return Quotient(self.ring, self.numerator * _rational(other), self.powers)
        if not isinstance(other, Quotient):
            return NotImplemented
        powers = _joined(int.__add__, self.powers, other.powers)
        return Quotient(self.ring, self.numerator * other.numerator, powers)

    __rmul__ = __mul__

    def __truediv__(self, other: object) -> Quotient:
        partner = self._partner(other)
        if partner is None:
            return NotImplemented
        number, powers = self.ring.factored(partner.numerator)
        over = _joined(int.__add__, self.powers, powers)
        common = _joined(min, over, partner.powers)
        above = _joined(int.__sub__, partner.powers, common)
        numerator = self.ring.raised(self.numerator, above) * (1 / number)
        return Quotient(self.ring, numerator, _joined(int.__sub__, over, common))

    def __rtruediv__(self, other: object) -> Quotient:
        partner = self._partner(other)
        return NotImplemented if partner is None else partner / self

    def __pow__(self, exponent: int) -> Quotient:
        if exponent < 0:
            return 1 / self**-exponent
        return Quotient(self.ring, self.numerator**exponent, tuple(power * exponent for power in self.powers))

    def __eq__(self, other: object) -> bool:
        partner = self._partner(other)
        return NotImplemented if partner is None else self.ring.reduced((self - partner).numerator) == 0

    def __repr__(self) -> str:
        below = " * ".join(f"({m.text})^{m.power}" for m in self.ring.multiplier(self.powers))
        return f"({self.numerator})/({below})" if below else f"{self.numerator}"

    @property
    def residue(self) -> PolyElement:
        """The numerator modulo the relations: the quotient multiplied by all its units."""
        missing = any(power and unit.value == 0 for unit, power in zip(self.ring.units, self.powers, strict=False))
        return self.ring.polynomials.zero if missing else self.ring.reduced(self.numerator)

    def derivative(self, rates: Mapping[PolyElement, Quotient]) -> Quotient:
        """The derivative by a derivation of the ring, given by its values at generators (elsewhere 0)."""
        result = _derived(self.numerator, rates, self.ring)
        over = Quotient(self.ring, result.numerator, _joined(int.__add__, result.powers, self.powers))
        for place, power in enumerate(self.powers):
            if power:
                growth = _derived(self.ring.units[place].polynomial, rates, self.ring) * power
                once = tuple(int(i == place) for i in range(place + 1))
                over = over - self * Quotient(self.ring, growth.numerator, _joined(int.__add__, growth.powers, once))
        return over


def _derived(polynomial: PolyElement, rates: Mapping[PolyElement, Quotient], of: DifferentialRing) -> Quotient:
    total = of.constant(0)
    for generator, rate in rates.items():
        total = total + Quotient(of, polynomial.diff(generator), ()) * rate
    return total


def _divided(polynomial: PolyElement, factor: PolyElement) -> tuple[PolyElement, int]:
    """The polynomial without a factor, and how often it had it."""
    power = 0
    while not polynomial.is_ground:
        quotient, remainder = polynomial.div([factor])
        if remainder != 0:
            break
        polynomial, power = quotient[0], power + 1
    return polynomial, power


def _joined(operation: Callable[[int, int], int], a: Sequence[int], b: Sequence[int]) -> tuple[int, ...]:
    """The operation on two lists of exponents, the shorter one filled up with zeros."""
    length = max(len(a), len(b))
    filled = ((*powers, *[0] * (length - len(powers))) for powers in (a, b))
    return tuple(map(operation, *filled))


def _rational(value: Rational | int) -> Any:
    fraction = Fraction(value)
    return sympy.QQ(fraction.numerator, fraction.denominator)
