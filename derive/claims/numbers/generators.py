"""Exact field whose generators are independent: letters in polar form, a tangent for each angle, roots of either sign.

An identity between independent generators holds for all their values, so it also holds for the numbers that they stand
for. Each of these has a generator of its own:

* the tangent of a fraction of each monomial in a sine, and the exponential of each monomial in an exponent;
* the root of a number that is no square, the logarithm of a number, and an angle that is no multiple of a known one.

A root ``sqrt(r**2)`` is ``r`` or ``-r`` on each connected part of the domain. If nothing decides, its sign is the next
of `signs`, and a claim is proved if it is true for all of them.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import suppress
from fractions import Fraction
from functools import cached_property
from itertools import combinations
from math import prod
from typing import Any

import sympy

from ...algebra.element import Element, NotExactError
from .angles import Angles
from .ideal import Ideal
from .intervals import INTERVALS, Monomial
from .signed import Bound, Signed

POOLS = {"tangent": 7, "exponential": 2, "root": 4, "logarithm": 4, "angle": 4, "turn": 3, "power": 0}
"""Number of generators of the exact field that are given a meaning when a formula needs one; a turn is an integer."""
PI = sympy.Rational(314159265, 10**8), sympy.Rational(314159266, 10**8)
"""Interval of π."""
POWERS_MAX = 12
"""Number of generators of powers in a field with integers."""


class Generators(Angles):
    """Rational functions of independent generators, with sines, exponentials, logarithms and roots.

    Multiples of ``m/steps`` have exact sine and cosine, for every monomial m of the names. `ranges` gives intervals of
    names, closed ones for names in `closed`; `integers` are the names of integers, and `signs` the signs of the first
    roots of unknown sign. Sines of multiples of π are written by roots if `radicals`, else by a tangent.
    """

    pools: Mapping[str, int] = POOLS

    def __init__(
        self, names: Sequence[str], ranges: Mapping[str, tuple[Bound, Bound]], integers: Sequence[str], steps: int,
        signs: Sequence[int] = (), closed: Collection[str] = (), radicals: bool = False,
    ) -> None:  # fmt: skip
        super().__init__(signs)
        self.radicals = radicals
        self.names, self.given, self.steps = tuple(names), {"pi": PI, **ranges}, steps
        self.closed, self.limits, self.endless = closed, set[str](), set[str]()
        self.ratios: dict[Monomial, tuple[Bound, Bound]] = {}  # intervals of quotients
        self.pools = {**self.pools, "power": POWERS_MAX if integers else 0}
        self.integers = {*integers, *self.pool("turn")}
        self.meanings: dict[tuple[str, Monomial], str] = {}  # generators of tangents and exponentials
        self.taken = dict.fromkeys(POOLS, 0)  # numbers of generators with a meaning
        self.extensions: list[tuple[Any, str]] = []  # numbers that are no squares, with the generators of their roots
        self.logarithms: list[tuple[Any, Any]] = []
        self.assumed: list[Any] = []  # numbers that are not negative in the stated domain
        self.angles: list[tuple[tuple[Any, Any], Any]] = []
        self.ideal: Ideal | None = None  # what the equations of a domain make 0

    @cached_property
    def ring(self) -> Any:
        """Ring of all generators; later roots come first, since a relation eliminates its first generator."""
        first, *others = map(self.pool, ("root", "turn", "angle", "logarithm", "tangent", "exponential", "power"))
        names = [*reversed(first), *self.names, "pi", *(name for pool in others for name in pool)]
        found = Signed(names, self.given, self.closed)
        found.limits |= self.limits
        found.endless |= self.endless
        return found

    def pool(self, what: str) -> list[str]:
        """Return the generators for a tangent, an exponential, a root, a logarithm, an angle or a number of turns."""
        return [f"{what} {i}" for i in range(self.pools[what])]

    # ---- numbers, which a field modulo a prime has otherwise ---------------------------------------------------------

    def symbol(self, name: str) -> Any:
        return self.ring.symbol(name)

    def element(self, a: Any) -> Any:
        return self.ring.element(a)

    def terms(self, a: Any) -> Iterator[tuple[Monomial, Fraction]]:
        """Yield the terms of a number that is a polynomial in the names and their inverses."""
        a = self.ring.fraction(a.numerator, a.denominator, lowest_terms=True)
        (below, _), *rest = self.ring.library.terms(a.denominator).items()
        if rest:
            raise NotExactError("an angle or exponent with a sum as divisor")
        for powers, c in self.ring.library.terms(a.numerator).items():
            degrees = zip(self.ring.names, powers, below, strict=True)
            monomial = tuple((name, k - m) for name, k, m in degrees if k != m)
            if any(name.startswith(("tangent ", "exponential ")) for name, _ in monomial):
                raise NotExactError("an angle or exponent that contains a sine or an exponential")
            yield monomial, c

    @property
    def meaning(self) -> dict[str, tuple[str, Any]]:
        """Meaning of each generator, such as a root, with its number, its monomial, or the point (y, x) of an angle."""
        found = {name: (what, self.product(monomial)) for (what, monomial), name in self.meanings.items()}
        rows = (("root", self.extensions), ("logarithm", self.logarithms), ("angle", [*self.angles, *self.lines]))
        found |= {name: ("power", (factor, twice)) for factor, name, twice in self.powers.values()}
        return {str(name): (what, known) for what, pairs in rows for known, name in pairs} | found

    def used(self, a: Any) -> set[str]:
        """Return the generators in a number."""
        degrees = (part.degrees() for part in (a.numerator, a.denominator))
        return {name for row in degrees for name, degree in zip(self.ring.names, row, strict=True) if degree}

    def is_positive(self, a: Any) -> bool:
        """Return whether a number that is not 0 is proved to be positive, or not negative by an assumption."""
        for known in (self.element(1), *filter(None, self.assumed)):
            with suppress(NotExactError):
                return bool((a / known).sign() > 0)
        return False

    def root(self, a: Any) -> Any:
        """Return a root of a number up to its sign, or None if it is no square."""
        found = self.ring.library.square_root(a.numerator * a.denominator)
        return None if found is None else self.ring.fraction(found, a.denominator)

    def new_root(self, a: Any) -> Any:
        """Return the root of a number that is no square: by the root of another one, or with a generator."""
        for count in range(1, len(self.extensions) + 1):
            for some in combinations(self.extensions, count):
                squares = prod((other.numerator for other, _ in some), start=self.ring.library.one)
                product = squares * a.numerator * a.denominator
                for square in (product, self.ring.normal_form(product)):
                    if (found := self.ring.library.square_root(square)) is not None:
                        ratio = self.ring.fraction(found, squares * a.denominator)
                        return self.chosen(ratio * prod(self.symbol(name) for _, name in some))
        name, square = self.next_of("root"), a.numerator * a.denominator
        generator = self.symbol(name)
        self.ring.relations.append(generator.numerator**2 - square)
        self.restrict("root", name, self.ring.fraction(square, self.ring.library.one))
        self.extensions.append((self.ring.fraction(square, self.ring.library.one), name))
        return self.chosen(self.ring.fraction(generator.numerator, a.denominator))

    def restrict(self, what: str, name: str, known: Any) -> None:
        """Set the interval of a generator by what it stands for."""
        INTERVALS[what](self, name, known)

    # ---- roots -------------------------------------------------------------------------------------------------------

    def same(self, a: Any, b: Any) -> bool:
        gap = self.element(a - b)
        return not gap or (self.ideal is not None and self.ideal.contains(gap))

    def restrict_to(self, equations: Sequence[Any]) -> None:
        """Note the numbers that the equations of a domain make 0."""
        if found := [a for a in equations if a]:
            self.ideal = Ideal(found)

    def _sqrt(self, a: Any) -> Any:
        a = self.element(a)
        found = self.root(a)
        return self.new_root(a) if found is None else self.chosen(found)

    def absolute(self, a: Any) -> Any:
        return self.chosen(a) if isinstance(a, Element) else super().absolute(a)

    def chosen(self, root: Any) -> Any:
        """Return ``root`` or ``-root``, the one that is not negative; by the next of `signs` if nothing decides."""
        if not root or self.is_positive(root):
            return root
        if self.is_positive(-root):
            return -root
        known = [(sign, root) for sign, root in zip(self.signs, self.roots, strict=False) if root is not None]
        for count in range(1, len(known) + 1):
            for some in combinations(known, count):
                sign, ratio = prod(sign for sign, _ in some), root / prod(known for _, known in some)
                if self.is_positive(ratio) or self.is_positive(-ratio):
                    return root * sign if self.is_positive(ratio) else -root * sign
        self.assumed.append(root * self.next_sign(root))
        return self.assumed[-1]

    # ---- exponents and logarithms ------------------------------------------------------------------------------------

    def _exp(self, a: Any) -> Any:
        found = self.element(1)
        for monomial, multiple in self.terms(self.element(a)):
            if multiple.denominator != 1 or not monomial:
                raise NotExactError("a number or a fraction of a letter in an exponent")
            found = found * self.symbol(self.meaning_of("exponential", monomial)) ** int(multiple)
        return found

    def meaning_of(self, what: str, monomial: Monomial) -> str:
        """Return the generator for the tangent or exponential of a monomial."""
        if (what, monomial) not in self.meanings:
            name = self.next_of(what)
            self.meanings[what, monomial] = name
            self.restrict(what, name, monomial)
        return self.meanings[what, monomial]

    def next_of(self, what: str) -> str:
        """Return the next generator of a pool."""
        if self.taken[what] == self.pools[what]:
            raise NotExactError(f"no generator is left for another {what}")
        self.taken[what] += 1
        return f"{what} {self.taken[what] - 1}"

    def _log(self, a: Any) -> Any:
        """Return the logarithm of a number, a generator for each argument."""
        a = self.element(a)
        if a == 1:
            return self.element(0)
        return sum((power * self._log_of(factor) for factor, power in self.positive_factors(a)), start=self.element(0))

    def _log_of(self, a: Any) -> Any:
        for (what, monomial), name in self.meanings.items():
            if what == "exponential" and a == self.symbol(name):
                return self.product(monomial)
        for known, found in self.logarithms:
            if a == known:
                return found
        self.logarithms.append((a, self.symbol(self.next_of("logarithm"))))
        return self.logarithms[-1][1]

    def positive_factors(self, a: Any) -> list[tuple[Any, int]]:
        """Return the factors of a number with their exponents if all are positive, else the number itself."""
        found, rest = [], a
        for part, sign in ((a.numerator, 1), (a.denominator, -1)):
            for factor, count in self.ring.library.factors(part):
                number = self.ring.fraction(factor, self.ring.library.one)
                number = number if self.is_positive(number) else -number
                if not self.is_positive(number):
                    return [(a, 1)]
                found.append((number, sign * count))
                rest = rest / number ** (sign * count)
        return found if rest == 1 else [*found, (rest, 1)]

    def product(self, monomial: Monomial) -> Any:
        return prod((self.symbol(name) ** power for name, power in monomial), start=self.element(1))

    @property
    def pi(self) -> Any:
        return self.symbol("pi")
