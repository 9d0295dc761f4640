"""Whether a side can have a given value in any reading, where its readings are too many to list.

A target is taken apart along with the tokens: if a stretch is the sum, product or quotient of two, and one of them can
be listed, each of its values says what the other has to be. What is along one vector is a pair (1, v) or, of tensors, a
triple (I, ṽ, v ⊗ v), or (I, ṽ, ṽ²) where squares are written; parts of a sum that share none of these are looked for
one by one. The looks of the parts are not kept, so that more is allowed than anybody prints: a no is final, a yes not.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise

from derive.algebra import Quaternion, Tensor, Vector

from ..language.terms import Number
from ..numbers.residues import PRIME, Residue, residue, square_root
from .items import WIDEST, Item, Shape
from .search import OpenError, Side
from .tokens import Place

Target = tuple[int, ...]
ATTEMPTS = 30_000
"""How often a stretch is asked for a value."""
WIDE = 20_000
"""How many values of one component are held."""


class UndecidedSearchError(Exception):
    """The search cannot tell."""


class Reach:
    """What a side can be.

    Parameters
    ----------
    side : Side
    along : int
        The first coordinate of the vector that all else is along; its others are 0.
    """

    def __init__(self, side: Side, along: int) -> None:
        self.side = side
        self.along = along
        self.squares = any(a.place is Place.AFTER and b.term == Number(2) for a, b in pairwise(side.tokens))
        self.left = ATTEMPTS
        self.known: dict[tuple[int, int, Target], bool] = {}
        self.lists: dict[tuple[int, int, int], dict[Target, None] | None] = {}
        self.components: dict[tuple[int, int, int, int], set[int] | UndecidedSearchError] = {}
        self.supports: dict[tuple[int, int, int], frozenset[int]] = {}
        self.inverses: dict[tuple[int, int], dict[int, int]] = {}
        self.exponents: dict[tuple[int, int], tuple[Fraction, ...]] = {}

    def can(self, i: int, j: int, target: Target) -> bool:
        """Whether a stretch can have a value.

        Raises
        ------
        UndecidedSearchError
            If that takes too long, or two long stretches depend on each other.
        """
        listed = self.listed(i, j, len(target))
        if listed is not None:
            return target in listed
        support = self.support(i, j, len(target))
        if any(c and k not in support for k, c in enumerate(target)):
            return False
        if len(target) > 1:
            components = {k: self._listed_component(i, j, k, len(target)) for k in support}
            if any(values is not None and target[k] not in values for k, values in components.items()):
                return False
            if len(support) == 1 and None not in components.values():
                return True
        where = (i, j, target)
        if where not in self.known:
            self.left -= 1
            if self.left < 0:
                raise UndecidedSearchError("too many stretches")
            self.known[where] = self._open(i, j, target)
        return self.known[where]

    def _open(self, i: int, j: int, t: Target) -> bool:
        if self._splits(i, j, t):
            return True
        square = (t[0] * t[0] % PRIME,)
        return len(t) == 1 and square_root(square[0]) == t[0] and self._splits(i, j, square)

    def _splits(self, i: int, j: int, t: Target) -> bool:
        for g in range(i + 1, j):
            place = self.side.tokens[g].place
            mark = self.side.tokens[g].mark
            if place is Place.BETWEEN and mark is not None:
                if mark.name != "plus":
                    raise UndecidedSearchError(f"a long stretch with {mark.name}")
                if g + 1 < j and self._sum(i, g, g + 1, j, t, 1):
                    return True
            elif place is not Place.AFTER and self._beside(i, g, j, t):
                return True
        return False

    def _beside(self, i: int, g: int, j: int, t: Target) -> bool:
        if len(t) == 1 and self.listed(i, g, 1) is not None and self.listed(g, j, 1) is not None:
            return self._of_listed(self._numbers(i, g), self._numbers(g, j), t[0]) or self._power(i, g, j, t[0])
        return (
            self._sum(i, g, g, j, t, -1) or self._product(i, g, j, t) or self._quotient(i, g, j, t)
            or (len(t) == 1 and self._power(i, g, j, t[0]))
        )  # fmt: skip

    def _numbers(self, i: int, j: int) -> dict[int, int]:
        """The numbers that a listed stretch can be, with their inverses; 0 is its own."""
        if (i, j) not in self.inverses:
            listed = self.listed(i, j, 1) or {}
            self.inverses[i, j] = {a: _inverse(a) if a else 0 for (a,) in listed}
        return self.inverses[i, j]

    @staticmethod
    def _of_listed(first: dict[int, int], second: dict[int, int], t: int) -> bool:
        """Whether a number is a difference, product or quotient of listed ones."""
        if t == 0:
            return 0 in first or 0 in second or not first.keys().isdisjoint(second)
        if len(first) <= len(second):
            inverse = _inverse(t)
            return any((a - t) % PRIME in second or t * b % PRIME in second or a * inverse % PRIME in second
                       for a, b in first.items())  # fmt: skip
        return any((t + a) % PRIME in first or t * b % PRIME in first or t * a % PRIME in first
                   for a, b in second.items())  # fmt: skip

    def _sum(self, i: int, g: int, h: int, j: int, t: Target, sign: int) -> bool:
        n = len(t)
        first, second = self.listed(i, g, n), self.listed(h, j, n)
        if first is not None and (second is None or len(first) <= len(second)):
            return any(self.can(h, j, _scaled(sign, _less(t, a))) for a in first)
        if second is not None:
            return any(self.can(i, g, _less(t, _scaled(sign, b))) for b in second)
        mine, other = self.support(i, g, n), self.support(h, j, n)
        if not mine or not other:
            return False
        if mine & other:
            raise UndecidedSearchError("two long stretches with the same components")
        part = tuple(c if k in mine else 0 for k, c in enumerate(t))
        return self._both((i, g, part), (h, j, _scaled(sign, _less(t, part))))

    def _both(self, first: tuple[int, int, Target], second: tuple[int, int, Target]) -> bool:
        """Whether two stretches can; the shorter one is asked first."""
        return all(self.can(*asked) for asked in sorted((first, second), key=lambda asked: asked[1] - asked[0]))

    def _product(self, i: int, g: int, j: int, t: Target) -> bool:
        n = len(t)
        if not self.support(i, g, 1) or not self.support(g, j, n):
            return self._of_structures(i, g, j, t)
        if not any(t):
            return self.can(i, g, (0,)) or self.can(g, j, t)
        first, second = self.listed(i, g, 1), self.listed(g, j, n)
        if second is not None and (first is None or len(second) <= len(first)):
            factors = {f for b in second for f in _ratio(t, b)}
            found = any(self.can(i, g, (f,)) for f in factors)
        elif first is not None:
            found = any(self.can(g, j, _scaled(_inverse(a[0]), t)) for a in first if a[0])
        else:
            factors = self._factors(g, j, t)
            found = any(self._both((i, g, (f,)), (g, j, _scaled(_inverse(f), t))) for f in factors)
        return found or self._of_structures(i, g, j, t)

    def _of_structures(self, i: int, g: int, j: int, t: Target) -> bool:
        """Products of two tensors or quaternions, of which one is listed."""
        n = len(t)
        mine, other = self.support(i, g, n) - {0}, self.support(g, j, n) - {0}
        if n == 1 or not (self.support(i, g, n) and self.support(g, j, n)) or (n == 2 and not (mine and other)):
            return False
        closed = self._closed(self.support(i, g, n), self.support(g, j, n), n)
        if any(c and k not in closed for k, c in enumerate(t)):
            return False
        if n == 3 and ({0} in (self.support(i, g, n), self.support(g, j, n)) or self._begins_with_numeral(g)):
            return False
        raise UndecidedSearchError("a product of long tensors or quaternions")

    def _closed(self, first: frozenset[int], second: frozenset[int], n: int) -> set[int]:
        """The components of a product."""
        products = OF_QUATERNIONS if n == 2 else OF_SQUARES if self.squares else OF_DYADS
        return {k for a in first for b in second for k in (products[a, b] if a and b else {a + b})}

    def _is_exponent(self, g: int, j: int, n: int) -> bool:
        """Whether a stretch after a tensor is a numeral, which is no divisor there."""
        return n == 3 and j - g == 1 and self._begins_with_numeral(g)

    def _begins_with_numeral(self, i: int) -> bool:
        return isinstance(self.side.tokens[i].term, Number)

    def _factors(self, i: int, j: int, t: Target) -> set[int]:
        """What a number before a stretch can be, by each component for itself."""
        candidates: set[int] | None = None
        for k, c in enumerate(t):
            if c and k in self.support(i, j, len(t)):
                try:
                    values = self.component(i, j, k, len(t))
                except UndecidedSearchError:
                    continue
                found = {c * _inverse(b) % PRIME for b in values if b}
                candidates = found if candidates is None else candidates & found
        if candidates is None:
            raise UndecidedSearchError("no component of a long stretch can be listed")
        return candidates

    def _listed_component(self, i: int, j: int, k: int, n: int) -> set[int] | None:
        """The values of a component, where they can be listed."""
        try:
            return self.component(i, j, k, n)
        except UndecidedSearchError:
            return None

    def component(self, i: int, j: int, k: int, n: int) -> set[int]:
        """The values of one component of a stretch."""
        where = (i, j, k, n)
        if where not in self.components:
            try:
                self.components[where] = self._component(*where)
            except UndecidedSearchError as error:
                self.components[where] = error
        found = self.components[where]
        if isinstance(found, UndecidedSearchError):
            raise found
        return found

    def _component(self, i: int, j: int, k: int, n: int) -> set[int]:
        listed = self.listed(i, j, n)
        if listed is not None:
            return {value[k] for value in listed}
        if n == 1:
            raise UndecidedSearchError("a long stretch that is a number")
        found: set[int] = set()
        for g in range(i + 1, j):
            place = self.side.tokens[g].place
            if place is Place.AFTER or (place is Place.BETWEEN and g + 1 >= j):
                continue
            if place is Place.BETWEEN:
                found |= self._component_of_sum((i, g), (g + 1, j), k, n, 1)
            else:
                found |= self._component_of_sum((i, g), (g, j), k, n, -1)
                found |= self._component_of_product((i, g), (g, j), k, n)
            if len(found) > WIDE:
                raise UndecidedSearchError("a component has too many values")
        return found

    def _component_of_sum(self, left: tuple[int, int], right: tuple[int, int], k: int, n: int, sign: int) -> set[int]:
        mine, other = self.support(*left, n), self.support(*right, n)
        if not mine or not other:
            return set()
        if k not in mine:
            return {sign * b % PRIME for b in self.component(*right, k, n)}
        if k not in other:
            return self.component(*left, k, n)
        return _table(self.component(*left, k, n), self.component(*right, k, n), lambda a, b: a + sign * b)

    def _component_of_product(self, left: tuple[int, int], right: tuple[int, int], k: int, n: int) -> set[int]:
        found: set[int] = set()
        for first, second, combine in (((left, 1, 0), (right, n, k), lambda a, b: a * b),
                                       ((right, 1, 0), (left, n, k), lambda a, b: b * _inverse(a))):
            over = first[0] == right
            if over and self._is_exponent(*right, n):
                continue
            if self.support(*first[0], first[1]) and k in self.support(*second[0], second[1]):
                numbers = {a for a in self.component(*first[0], first[2], first[1]) if a}
                found |= _table(numbers, self.component(*second[0], second[2], second[1]), combine)
        two = self.support(*left, n) - {0} and self.support(*right, n) - {0}
        closed = self._closed(self.support(*left, n), self.support(*right, n), n)
        if n > 1 and two and k in closed and not (n == 3 and self._begins_with_numeral(right[0])):
            raise UndecidedSearchError("a product of long tensors or quaternions")
        return found

    def _quotient(self, i: int, g: int, j: int, t: Target) -> bool:
        n = len(t)
        if not self.support(g, j, 1) or not self.support(i, g, n) or self._is_exponent(g, j, n):
            return False
        if not any(t):
            return self.can(i, g, t)
        below, above = self.listed(g, j, 1), self.listed(i, g, n)
        if below is not None and (above is None or len(below) <= len(above)):
            return any(self.can(i, g, _scaled(b[0], t)) for b in below if b[0])
        if above is not None:
            return any(self.can(g, j, (f,)) for f in {f for a in above for f in _ratio(a, t)})
        if n > 1:
            divisors = {_inverse(f) for f in self._factors(i, g, t)}
            return any(self._both((g, j, (f,)), (i, g, _scaled(f, t))) for f in divisors)
        raise UndecidedSearchError("two long stretches, one over the other")

    def _power(self, i: int, g: int, j: int, t: int) -> bool:
        exponents = self._exponents(g, j) if j - g <= WIDEST else ()
        return any(self.can(i, g, (root,)) for e in exponents for root in _roots(t, e))

    def _exponents(self, i: int, j: int) -> tuple[Fraction, ...]:
        if (i, j) not in self.exponents:
            plain = [Fraction(item.value) for item in self._items(i, j) if item.kind in (int, Fraction)]
            found = {s * e for e in plain for s in (1, -1) if e and s * e != 1 and abs(e) < 10}
            self.exponents[i, j] = tuple(found)
        return self.exponents[i, j]

    # ---- what is known of a stretch without a target ------------------------------------------------------------

    def listed(self, i: int, j: int, n: int) -> dict[Target, None] | None:
        """The values of a stretch with n components; None where they are too many."""
        if (i, j, n) not in self.lists:
            try:
                table = self.side.table(i, j)
                found = (self._components(item, n) for item in table.values())
                self.lists[i, j, n] = dict.fromkeys(value for value in found if value is not None)
            except OpenError:
                self.lists[i, j, n] = None
        return self.lists[i, j, n]

    def _items(self, i: int, j: int) -> Iterator[Item]:
        try:
            yield from self.side.table(i, j).values()
        except OpenError:
            return

    def _components(self, item: Item, n: int) -> Target | None:
        """A value by its components: a number; a number and a vector; or I, ṽ and v ⊗ v or ṽ²."""
        if callable(item.value):
            return None
        if item.kind is Tensor and n == 3:
            return self._triple(item)
        number = residue(item.value) if item.kind not in (Vector, Quaternion, Tensor) else None
        if n == 1:
            return None if number is None else (number,)
        if n == 2 and number is not None:
            return (number, 0)
        if n == 2 and item.coordinates is not None and item.kind in (Vector, Quaternion):
            scalar, c1, c2, c3 = (0, *item.coordinates) if item.kind is Vector else item.coordinates
            if c2 or c3:
                raise UndecidedSearchError("more than one direction")
            return (scalar, c1 * _inverse(self.along) % PRIME)
        return None

    def _triple(self, item: Item) -> Target:
        if item.coordinates is None:
            raise UndecidedSearchError("a dual tensor")
        c = item.coordinates
        if any((c[1], c[2], c[3], c[6])) or c[4] != c[8] or (c[5] + c[7]) % PRIME:
            raise UndecidedSearchError("more than one direction")
        inverse = _inverse(self.along)
        last = (c[0] - c[4]) * inverse * inverse % PRIME
        return (c[0] if self.squares else c[4], c[7] * inverse % PRIME, last)

    def target(self, value: object) -> Target:
        """A value of the other side as a target."""
        item = Item(value, Shape.ATOM, 0, None, ())
        n = 3 if item.kind is Tensor else 1 if item.kind in (Residue, int) else 2
        found = self._components(item, n)
        if found is None:
            raise UndecidedSearchError("a value with dual parts")
        return found

    def support(self, i: int, j: int, n: int) -> frozenset[int]:
        """The components that are not 0 in every reading of a stretch; none if it has no such readings."""
        if (i, j, n) not in self.supports:
            self.supports[i, j, n] = frozenset(self._support(i, j, n))
        return self.supports[i, j, n]

    def _support(self, i: int, j: int, n: int) -> set[int]:
        listed = self.listed(i, j, n)
        if listed is not None:
            return {k for value in listed for k, c in enumerate(value) if c} or ({0} if listed else set())
        found: set[int] = set()
        for g in range(i + 1, j):
            place = self.side.tokens[g].place
            start = g + 1 if place is Place.BETWEEN else g
            if place is Place.AFTER or start >= j:
                continue
            first, second = self.support(i, g, n), self.support(start, j, n)
            if first and second:
                found |= first | second
                if place is None and n > 1:
                    found |= self._closed(first, second, n)
            if place is None and self.support(i, g, 1) and second:
                found |= second
            if place is None and self.support(start, j, 1) and first and not self._is_exponent(g, j, n):
                found |= first
        return found


OF_QUATERNIONS: dict[tuple[int, int], set[int]] = {(1, 1): {0}}
OF_DYADS: dict[tuple[int, int], set[int]] = {(1, 1): {0, 2}, (1, 2): set(), (2, 1): set(), (2, 2): {2}}
OF_SQUARES: dict[tuple[int, int], set[int]] = {(1, 1): {2}, (1, 2): {1}, (2, 1): {1}, (2, 2): {2}}
"""The components of products of components other than the first, which is a number."""


def _table(first: set[int], second: set[int], f: Callable[[int, int], int]) -> set[int]:
    if len(first) * len(second) > 8 * WIDE:
        raise UndecidedSearchError("a component has too many values")
    return {f(a, b) % PRIME for a in first for b in second}


@lru_cache(100_000)
def _inverse(a: int) -> int:
    return pow(a, -1, PRIME)


def _scaled(factor: int, t: Target) -> Target:
    return tuple([factor * c % PRIME for c in t])


def _less(t: Target, a: Target) -> Target:
    return tuple([(c - d) % PRIME for c, d in zip(t, a, strict=True)])


def _ratio(t: Target, b: Target) -> Iterator[int]:
    """The number f with ``t = f b``, if there is one."""
    k = next((k for k, c in enumerate(b) if c), None)
    if k is not None:
        f = t[k] * _inverse(b[k]) % PRIME
        if f and _scaled(f, b) == t:
            yield f


def _roots(t: int, e: Fraction) -> Iterator[int]:
    """Every a with ``a^e = t``; (PRIME − 1)/2 is a prime, so odd roots are unique."""
    if t == 0:
        return
    number = pow(t, e.denominator, PRIME) if e > 0 else pow(_inverse(t), e.denominator, PRIME)
    m, roots = abs(e.numerator), [number]
    while m % 2 == 0:
        m //= 2
        found = [square_root(a) for a in roots]
        roots = [s * a % PRIME for a in found if a is not None for s in (1, -1)]
    yield from (pow(a, pow(m, -1, PRIME - 1), PRIME) for a in roots)
