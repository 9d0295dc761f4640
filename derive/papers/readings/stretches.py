"""What is known of a stretch of tokens without asking for a value: its list, its components, those that are not 0.

What is along one vector is a pair (1, v) or, of tensors, a triple (I, ṽ, v ⊗ v), or (I, ṽ, ṽ²) where squares are
written.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import pairwise

from derive.algebra import Quaternion, Tensor, Vector

from ..language.terms import Number
from ..numbers.residues import PRIME, Residue, residue
from .items import Item, OpenError, Shape
from .search import Side
from .targets import Target, UndecidedSearchError, inverse
from .tokens import Place

WIDE = 20_000
"""How many values of one component are held."""


class Stretches:
    """The stretches of a side.

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
        self.lists: dict[tuple[int, int, int], dict[Target, None] | None] = {}
        self.components: dict[tuple[int, int, int, int], set[int] | UndecidedSearchError] = {}
        self.supports: dict[tuple[int, int, int], frozenset[int]] = {}
        self.inverses: dict[tuple[int, int], dict[int, int]] = {}
        self.powers: dict[tuple[int, int], tuple[Fraction, ...]] = {}

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
        if n == 2 and not item.dual and item.coordinates is not None and item.kind in (Vector, Quaternion):
            scalar, c1, c2, c3 = (0, *item.coordinates) if item.kind is Vector else item.coordinates
            if c2 or c3:
                raise UndecidedSearchError("more than one direction")
            return (scalar, c1 * inverse(self.along) % PRIME)
        return None

    def _triple(self, item: Item) -> Target:
        if item.coordinates is None or item.dual:
            raise UndecidedSearchError("a dual tensor")
        c = item.coordinates
        if any((c[1], c[2], c[3], c[6])) or c[4] != c[8] or (c[5] + c[7]) % PRIME:
            raise UndecidedSearchError("more than one direction")
        reciprocal = inverse(self.along)
        last = (c[0] - c[4]) * reciprocal * reciprocal % PRIME
        return (c[0] if self.squares else c[4], c[7] * reciprocal % PRIME, last)

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
                    found |= self.closed(first, second, n)
            if place is None and self.support(i, g, 1) and second:
                found |= second
            if place is None and self.support(start, j, 1) and first and not self.is_exponent(g, j, n):
                found |= first
        return found

    def closed(self, first: frozenset[int], second: frozenset[int], n: int) -> set[int]:
        """The components of a product."""
        products = OF_QUATERNIONS if n == 2 else OF_SQUARES if self.squares else OF_DYADS
        return {k for a in first for b in second for k in (products[a, b] if a and b else {a + b})}

    def is_exponent(self, g: int, j: int, n: int) -> bool:
        """Whether a stretch after a tensor is a numeral, which is no divisor there."""
        return n == 3 and j - g == 1 and self.begins_with_numeral(g)

    def begins_with_numeral(self, i: int) -> bool:
        return isinstance(self.side.tokens[i].term, Number)

    def exponents(self, i: int, j: int) -> tuple[Fraction, ...]:
        if (i, j) not in self.powers:
            plain = [Fraction(item.value) for item in self._items(i, j) if item.kind in (int, Fraction)]
            found = {s * e for e in plain for s in (1, -1) if e and s * e != 1 and abs(e) < 10}
            self.powers[i, j] = tuple(found)
        return self.powers[i, j]

    def numbers(self, i: int, j: int) -> dict[int, int]:
        """The numbers that a listed stretch can be, with their inverses; 0 is its own."""
        if (i, j) not in self.inverses:
            listed = self.listed(i, j, 1) or {}
            self.inverses[i, j] = {a: inverse(a) if a else 0 for (a,) in listed}
        return self.inverses[i, j]

    def factors(self, i: int, j: int, t: Target) -> set[int]:
        """What a number before a stretch can be, by each component for itself."""
        candidates: set[int] | None = None
        for k, c in enumerate(t):
            if c and k in self.support(i, j, len(t)):
                try:
                    values = self.component(i, j, k, len(t))
                except UndecidedSearchError:
                    continue
                found = {c * inverse(b) % PRIME for b in values if b}
                candidates = found if candidates is None else candidates & found
        if candidates is None:
            raise UndecidedSearchError("no component of a long stretch can be listed")
        return candidates

    def listed_component(self, i: int, j: int, k: int, n: int) -> set[int] | None:
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
                                       ((right, 1, 0), (left, n, k), lambda a, b: b * inverse(a))):
            over = first[0] == right
            if over and self.is_exponent(*right, n):
                continue
            if self.support(*first[0], first[1]) and k in self.support(*second[0], second[1]):
                numbers = {a for a in self.component(*first[0], first[2], first[1]) if a}
                found |= _table(numbers, self.component(*second[0], second[2], second[1]), combine)
        two = self.support(*left, n) - {0} and self.support(*right, n) - {0}
        closed = self.closed(self.support(*left, n), self.support(*right, n), n)
        if n > 1 and two and k in closed and not (n == 3 and self.begins_with_numeral(right[0])):
            raise UndecidedSearchError("a product of long tensors or quaternions")
        return found


OF_QUATERNIONS: dict[tuple[int, int], set[int]] = {(1, 1): {0}}
OF_DYADS: dict[tuple[int, int], set[int]] = {(1, 1): {0, 2}, (1, 2): set(), (2, 1): set(), (2, 2): {2}}
OF_SQUARES: dict[tuple[int, int], set[int]] = {(1, 1): {2}, (1, 2): {1}, (2, 1): {1}, (2, 2): {2}}
"""The components of products of components other than the first, which is a number."""


def _table(first: set[int], second: set[int], f: Callable[[int, int], int]) -> set[int]:
    if len(first) * len(second) > 8 * WIDE:
        raise UndecidedSearchError("a component has too many values")
    return {f(a, b) % PRIME for a in first for b in second}
