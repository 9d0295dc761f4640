"""Rational functions of generators in intervals, and which of them have one sign there."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence, Set
from fractions import Fraction
from math import prod
from typing import Any

import sympy

from ...algebra.element import Element, NotExactError
from ...algebra.exact import RationalFunctions
from .boxes import Interval, is_positive

TERMS_MAX = 2000
"""Largest number of terms of a polynomial; a proof modulo a prime has no such limit."""
MARGIN = Fraction(1, 10**9)
"""Distance between a rational bound and the end of an interval for which it stands."""

Bound = Any  # SymPy's number, a multiple of π or rational; ∞ if there is none


class Signed(RationalFunctions):
    """Rational functions of generators in intervals; only numbers of one sign there have a sign.

    Intervals are open, but for names in `closed`: their ends count where a number must not be 0. Those of names in
    `limits` count if asked for. The upper end never counts for names in `endless`.
    """

    def __init__(
        self, names: Sequence[str], ranges: Mapping[str, tuple[Bound, Bound]], closed: Collection[str] = ()
    ) -> None:
        point = {name: Fraction(int(sympy.prime(i + 5)), 7) for i, name in enumerate(names)}
        super().__init__(names, point | {"pi": Fraction(355, 113)})
        self.ranges: dict[str, tuple[Bound, Bound]] = {}
        self.closed = set(closed)
        self.limits: set[str] = set()
        self.endless: set[str] = set()
        self.positive = [False] * len(self.names)
        self._known: dict[tuple[str, bool, bool], bool] = {}  # definite polynomials by their text
        self._ends: dict[str, Any] = {}
        self.restrict("pi", sympy.Integer(3), sympy.Integer(4))
        for name, (low, high) in ranges.items():
            self.restrict(name, low, high)

    def restrict(self, name: str, low: Bound, high: Bound, ends: Sequence[Any] = ()) -> None:
        """Set the interval of a generator; the polynomials `ends` vanish at its irrational ends."""
        self.ranges[name], self._ends[name] = (low, high), ends
        self.positive[self.index(name)] = bool(low >= 0)
        self._known.clear()
        self.point[name] = _between(low, high)

    def reduced(self, a: Any) -> Any:
        """Return the form of a product that is stored; raise if it is too large to go on with."""
        if len(a) > TERMS_MAX:
            raise NotExactError(f"a formula with more than {TERMS_MAX} terms")
        return self.normal_form(a)

    def value(self, a: Any) -> Fraction:
        """Return the value at the reference point of a polynomial that has one sign."""
        if not all(self.definite(factor) for factor, power in self.library.factors(a) if power % 2):
            raise NotExactError("a number whose sign differs from place to place")
        return super().value(a)

    def factors(self, *numbers: Element) -> list[Any]:
        """Return the irreducible factors of numerators and denominators, constants left out."""
        return [f for a in numbers for part in (a.numerator, a.denominator) for f, _ in self.library.factors(part)]

    def definite(self, factor: Any, strict: bool = False, limits: bool = False) -> bool:
        """Return whether a polynomial has one sign, by coefficients, squares, Sturm or boxes; nowhere 0 if `strict`."""
        key = str(factor), strict, limits
        if key not in self._known:
            self._known[key] = self._is_definite(factor, strict, self.closed | self.limits if limits else self.closed)
        return self._known[key]

    def _is_definite(self, factor: Any, strict: bool, closed: Set[str]) -> bool:
        terms = self.library.terms(factor)
        used = {i for powers in terms for i, power in enumerate(powers) if power}
        positive = self.positive
        even = all(power % 2 == 0 or sign for powers in terms for power, sign in zip(powers, positive, strict=True))
        if even and len({c > 0 for c in terms.values()}) == 1:
            apart = (all(self._is_apart(i, closed) for i, power in enumerate(powers) if power) for powers in terms)
            return not strict or any(apart)
        if len(used) == 1:
            (i,) = used
            ends = strict and self.names[i] in closed
            return self._has_no_root(self.names[i], {powers[i]: c for powers, c in terms.items()}, ends)
        return _is_definite_form(terms, sorted(used), strict) or self._is_definite_on_box(
            factor, sorted(used), strict, closed)

    def _is_definite_on_box(self, factor: Any, used: Sequence[int], strict: bool, closed: Set[str]) -> bool:
        """Return whether a polynomial has one sign, that at the reference point, on the box of its intervals."""
        sign = 1 if super().value(factor) > 0 else -1
        terms = {tuple(powers[i] for i in used): sign * c for powers, c in self.library.terms(factor).items()}
        return is_positive(terms, [self._bounds(self.names[i], closed) for i in used], strict)

    def _bounds(self, name: str, closed: Set[str]) -> Interval:
        """Return rational bounds of a generator, a little outside its interval if this has irrational ends."""
        ends = _rational(*self.ranges.get(name, (-sympy.oo, sympy.oo)), -MARGIN)
        low, high = (None if end is None else Fraction(int(end.p), int(end.q)) for end in ends)
        return Interval(low, high, (name in closed, name in closed - self.endless))

    def _is_apart(self, i: int, closed: Set[str]) -> bool:
        """Return whether a generator is never 0, as it is positive."""
        name = self.names[i]
        return self.positive[i] and (name not in closed or bool(self.ranges[name][0] > 0))

    def _has_no_root(self, name: str, terms: Mapping[int, Fraction], ends: bool) -> bool:
        """Return whether a polynomial in one generator has no root in its interval, by Sturm's theorem."""
        x, (low, high) = sympy.Symbol("x"), self.ranges.get(name, (-sympy.oo, sympy.oo))
        a = sympy.Poly({(k,): sympy.Rational(c.numerator, c.denominator) for k, c in terms.items()}, x)
        above = ends and name not in self.endless
        for end, counts in ((low, ends), (high, above)):
            while not counts and end.is_Rational and a.degree() > 0 and a.rem(sympy.Poly(x - end, x)).is_zero:
                a = a.quo(sympy.Poly(x - end, x))
        inner, outer = (_rational(low, high, margin) for margin in (MARGIN, -MARGIN))
        if above:
            return bool(a.count_roots(*outer) == 0)
        at_ends = a.gcd(prod(self._ends.get(name, ()), start=sympy.Poly(1, x)))
        while at_ends.degree() > 0 and (shared := a.gcd(at_ends)).degree() > 0:
            a = a.quo(shared)
        return bool(a.count_roots(*outer) == 0 and (at_ends.degree() < 1 or at_ends.count_roots(*inner) == 0))


def _is_definite_form(terms: Mapping[tuple[int, ...], Fraction], used: Sequence[int], strict: bool) -> bool:
    """Return whether a polynomial of degree 2 has one sign, as a quadratic form in its generators and 1."""
    if max(map(sum, terms)) > 2:
        return False
    size = len(used) + 1
    matrix = [[sympy.Integer(0)] * size for _ in range(size)]
    for powers, c in terms.items():
        places = [k for k, i in enumerate(used) for _ in range(powers[i])]
        a, b = (places + [size - 1] * 2)[:2]
        half = sympy.Rational(c.numerator, 2 * c.denominator)
        matrix[a][b] += half
        matrix[b][a] += half
    forms = (sympy.Matrix(matrix), -sympy.Matrix(matrix))
    return any(bool(form.is_positive_definite if strict else form.is_positive_semidefinite) for form in forms)


def _between(low: Bound, high: Bound) -> Fraction:
    """Return a number in an interval, one third of the way if both ends are finite."""
    if low.is_finite and high.is_finite:
        low, high = Fraction(str(low.evalf(30))), Fraction(str(high.evalf(30)))
        return Fraction((2 * low + high) / 3)
    return Fraction(str(low)) + 3 if low.is_finite else Fraction(str(high)) - 3 if high.is_finite else Fraction(3)


def _rational(low: Bound, high: Bound, margin: Fraction) -> tuple[Bound, Bound]:
    """Return rational bounds inside an interval, or outside it if the margin is negative; rational ones stay."""
    shift = sympy.Rational(margin.numerator, margin.denominator)

    def near(end: Bound, sign: int) -> Bound:
        if end.is_Rational or not end.is_finite:
            return end if end.is_finite else None
        return sympy.Rational(str(end.evalf(30))) + sign * shift

    return near(low, 1), near(high, -1)


def turns_to_principal(part: Fraction, low: Bound, high: Bound, closed: bool, half: int = 0) -> int | None:
    """Return the number of turns that brings a multiple of each angle of an interval into (−π, π], or None.

    Half a turn is added to each angle if `half` is 1.
    """
    ends = [sympy.Rational(part.numerator, part.denominator) * end + half * sympy.pi for end in (low, high)]
    if not all(end.is_finite for end in ends):
        return None
    turns = int(sympy.ceiling((-sympy.pi - min(ends)) / (2 * sympy.pi)))
    least, most = (end + 2 * sympy.pi * turns for end in (min(ends), max(ends)))
    return turns if most <= sympy.pi and not (closed and least == -sympy.pi) else None
