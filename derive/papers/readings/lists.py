"""The values that a stretch of tokens can have, where they can be listed.

What is along one vector is a pair (1, v), of which beside tensors only (0, v) is made, or of tensors a triple
(I, ṽ, v ⊗ v), or (I, ṽ, ṽ²) where squares are written. Only few values of a stretch are tried one by one, but all of a
short one are known: nothing wider is between norm bars, an argument or an exponent, and what these can be does not
follow from what their parts can be.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import pairwise

from derive.algebra import Quaternion, Tensor, Vector

from ..language.terms import Number
from ..numbers.residues import PRIME, Residue, residue
from .combine import HIGHEST, WIDEST
from .items import Item, OpenError, Shape, Table
from .search import Side
from .targets import Target, UndecidedSearchError, inverse
from .tokens import Place

SHORT = 20_000
"""How many readings of a short stretch are known."""


class Lists:
    """The values of the stretches of a side.

    Parameters
    ----------
    side : Side
    along : int
        The first coordinate of the vector that all else is along; its others are 0.
    short : int
        How many tokens a short stretch has at most.
    """

    def __init__(self, side: Side, along: int, short: int = WIDEST + 1) -> None:
        self.side = side
        self.along = along
        self.square = along * along % PRIME
        self.short = short
        self.all = Side(side.tokens, side.env, side.radicals, side.quaternions, SHORT)
        self.squares = any(a.place is Place.AFTER and b.term == Number(2) for a, b in pairwise(side.tokens))
        self.lists: dict[tuple[int, int, int, bool], dict[Target, None] | None] = {}
        self.inverses: dict[tuple[int, int], dict[int, int]] = {}
        self.powers: dict[tuple[int, int], tuple[Fraction, ...]] = {}

    def listed(self, i: int, j: int, n: int) -> dict[Target, None] | None:
        """The values of a stretch with n components; None where they are too many to try."""
        return self._list(i, j, n, self.side)

    def known(self, i: int, j: int, n: int) -> dict[Target, None] | None:
        """The same, where they are not too many to know."""
        found = self.listed(i, j, n)
        return self._list(i, j, n, self.all) if found is None and j - i <= self.short else found

    def _list(self, i: int, j: int, n: int, side: Side) -> dict[Target, None] | None:
        where = (i, j, n, side is self.all)
        if where not in self.lists:
            try:
                self.lists[where] = self._values(side.table(i, j).values(), n)
            except OpenError:
                self.lists[where] = None
        return self.lists[where]

    def _values(self, items: Iterable[Item], n: int) -> dict[Target, None]:
        found = (self._components(item, n) for item in items)
        return dict.fromkeys(value for value in found if value is not None)

    def _short(self, i: int, j: int) -> Table:
        """All readings of a stretch that is an argument or an exponent."""
        for side in (self.side, self.all) if j - i <= self.short else (self.side,):
            try:
                return side.table(i, j)
            except OpenError:
                continue
        raise UndecidedSearchError("a long argument or exponent")

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
            return (number, 0) if self.side.quaternions else None
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
        """A value of the other side as a target; beside vectors a number is a quaternion."""
        item = Item(value, Shape.ATOM, 0, None, ())
        n = 3 if item.kind is Tensor else 1 if item.kind in (Residue, int) else 2
        found = self._components(item, n)
        if found is None:
            raise UndecidedSearchError("a value with dual parts")
        return (*found, 0) if n == 1 and self._has_vectors() else found

    def _has_vectors(self) -> bool:
        terms = [token.term for token in self.side.tokens if token.term is not None]
        return self.side.quaternions and any(isinstance(self.side.env.value(term), Vector) for term in terms)

    def begins_with_numeral(self, i: int) -> bool:
        return isinstance(self.side.tokens[i].term, Number)

    def exponents(self, i: int, j: int) -> tuple[Fraction, ...]:
        if (i, j) not in self.powers:
            items = self._short(i, j).values() if j - i <= WIDEST and self._is_exact(i, j) else ()
            plain = [Fraction(item.value) for item in items if item.kind in (int, Fraction)]
            found = {s * e for e in plain for s in (1, -1) if e and s * e != 1 and abs(e) <= HIGHEST}
            self.powers[i, j] = tuple(found)
        return self.powers[i, j]

    def _is_exact(self, i: int, j: int) -> bool:
        """Whether a stretch can be a plain number: a letter is none, except as the argument of a mark before it."""
        values = [self.side.env.value(token.term) for token in self.side.tokens[i:j] if token.term is not None]
        marks = any(token.place is Place.BEFORE for token in self.side.tokens[i:j])
        return marks or all(isinstance(value, int | Fraction) or callable(value) for value in values)

    def applied(self, i: int, j: int, n: int) -> dict[Target, None]:
        """What a function's value can be that takes up a whole stretch."""
        first, found = self.side.tokens[i], Table()
        if first.place is Place.BEFORE and first.mark is not None and j - i <= WIDEST + 1:
            self.side.combine.at_one(first.mark, self._short(i + 1, j), found)
        if first.term is not None and callable(self.side.env.value(first.term)):
            for g in range(max(i + 1, j - WIDEST), j):
                if g == i + 1 or self._is_exact(i + 1, g):
                    self._apply(self._short(i, g), self._short(g, j), found)
        return self._values(found.values(), n)

    def _apply(self, functions: Table, arguments: Table, found: Table) -> None:
        for f in functions.values():
            for a in arguments.values() if f.function else ():
                self.side.combine.applied(f, a, found)

    def numbers(self, i: int, j: int) -> dict[int, int]:
        """The numbers that a listed stretch can be, with their inverses; 0 is its own."""
        if (i, j) not in self.inverses:
            listed = self.listed(i, j, 1) or {}
            self.inverses[i, j] = {a: inverse(a) if a else 0 for (a,) in listed}
        return self.inverses[i, j]

    def vectors(self, i: int, j: int) -> Iterator[int]:
        """The vectors of a stretch that are not under a mark of their own."""
        after = [token.place is Place.AFTER for token in self.side.tokens[i + 1 : j]]
        for k, under in zip(range(i, j), [*after, False], strict=True):
            term = self.side.tokens[k].term
            if term is not None and not under and isinstance(self.side.env.value(term), Vector):
                yield k
