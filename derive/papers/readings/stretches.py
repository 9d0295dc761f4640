"""What is known of a stretch of tokens without asking for a value: its components, and those that are not 0."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from itertools import product

from ..language.notation import skew
from ..numbers.residues import PRIME
from .combine import WIDEST
from .lists import Lists
from .search import Side
from .targets import Target, UndecidedSearchError, inverse, reciprocal, times
from .tokens import Place

WIDE = 20_000
"""How many values of one component are held."""


class Stretches(Lists):
    """The stretches of a side, by the components of their values."""

    def __init__(self, side: Side, along: int, short: int = WIDEST + 1) -> None:
        super().__init__(side, along, short)
        self.components: dict[tuple[int, int, int, int], set[int] | UndecidedSearchError] = {}
        self.supports: dict[tuple[int, int, int], frozenset[int]] = {}

    def support(self, i: int, j: int, n: int) -> frozenset[int]:
        """The components that are not 0 in every reading of a stretch; none if it has no such readings."""
        if (i, j, n) not in self.supports:
            self.supports[i, j, n] = frozenset(self._support(i, j, n))
        return self.supports[i, j, n]

    def _support(self, i: int, j: int, n: int) -> set[int]:
        known = self.known(i, j, n)
        if known is not None:
            return _other_than_0(known)
        found = _other_than_0(self.applied(i, j, n)) | self._of_marks(i, j, n)
        for g in range(i + 1, j):
            token = self.side.tokens[g]
            if token.place is Place.BETWEEN and token.mark is not None:
                if token.mark.name != "plus":
                    raise UndecidedSearchError(f"a long stretch with {token.mark.name}")
                if g + 1 < j and self.support(i, g, n) and self.support(g + 1, j, n):
                    found |= self.support(i, g, n) | self.support(g + 1, j, n)
            elif token.place is not Place.AFTER:
                found |= self._beside(i, g, j, n)
        has_norm = j - i <= WIDEST and n < 3 and 1 in (found if n == 2 else self.support(i, j, 2))
        if has_norm and (n == 1 or self.side.quaternions):
            found.add(0)
        return found

    def _of_marks(self, i: int, j: int, n: int) -> set[int]:
        """Of what a mark behind a whole stretch makes."""
        last = self.side.tokens[j - 1]
        if last.place is Place.AFTER and last.mark is not skew and any(self.support(i, j - 1, m) for m in (1, 2, 3)):
            raise UndecidedSearchError("a mark behind a long stretch")
        return {1} if last.place is Place.AFTER and n == 3 and 1 in self.support(i, j - 1, 2) else set()

    def _beside(self, i: int, g: int, j: int, n: int) -> set[int]:
        first, second, found = self.support(i, g, n), self.support(g, j, n), set[int]()
        if first and second:
            found |= first | second
            found |= self.closed(first, second, n) if n > 2 or (n == 2 and self.side.quaternions) else set()
        if self.support(i, g, 1) and second:
            found |= second
        if self.support(g, j, 1) and first and not self.is_exponent(g, j, n):
            found |= first
        if n == 1 and self.exponents(g, j) and 1 in self.support(i, g, 2):
            found.add(0)
        if n == 2 and self.side.quaternions and first and self.exponents(g, j):
            found |= {0} | first
        if n == 2 and self.support(i, g, 3) and 1 in self.support(g, j, 2):
            found.add(1)
        if n == 3:
            found |= self._of_powers(first, g, j)
            found |= self.of_dyads if self.is_dyad(i, g, j) else set()
        return found

    def _of_powers(self, base: frozenset[int], g: int, j: int) -> set[int]:
        """Of squares and inverses of tensors."""
        found: set[int] = set()
        if base and -1 in self.exponents(g, j):
            found |= {0} if base == {0} else {0, 1, 2}
        if 1 in base and 2 in self.exponents(g, j):
            found |= self.closed(frozenset({1}), frozenset({1}), 3)
        return found

    @property
    def of_dyads(self) -> set[int]:
        return {0, 2} if self.squares else {2}

    def is_dyad(self, i: int, g: int, j: int) -> bool:
        """Whether both parts can be vectors: those between whose marks there is no product, but sums of several."""
        return all(1 in self.support(*part, 2) and (part[1] - part[0] == 1 or len(list(self.vectors(*part))) > 1)
                   for part in ((i, g), (g, j)))  # fmt: skip

    def closed(self, first: frozenset[int], second: frozenset[int], n: int) -> set[int]:
        """The components of a product."""
        products = OF_QUATERNIONS if n == 2 else OF_SQUARES if self.squares else OF_DYADS
        return {k for a in first for b in second for k in (products[a, b] if a and b else {a + b})}

    def is_exponent(self, g: int, j: int, n: int) -> bool:
        """Whether a stretch after a tensor is a numeral, which is no divisor there."""
        return n == 3 and j - g == 1 and self.begins_with_numeral(g)

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
        known = self.known(i, j, n)
        if known is not None:
            return {value[k] for value in known}
        if n == 1 or (n == 2 and k == 0 and self.side.quaternions and self.support(i, j, 1)):
            raise UndecidedSearchError("a long stretch that is a number")
        found = {value[k] for value in self.applied(i, j, n)}
        if self._of_marks(i, j, n):
            found |= self.component(i, j - 1, 1, 2) if k == 1 else {0}
        for g in range(i + 1, j):
            place = self.side.tokens[g].place
            if place is Place.AFTER or (place is Place.BETWEEN and g + 1 >= j):
                continue
            if place is Place.BETWEEN:
                found |= self._component_of_sum((i, g), (g + 1, j), k, n, 1)
            else:
                found |= self._component_of_sum((i, g), (g, j), k, n, -1)
                found |= self._component_of_pairs(i, g, j, k) if n == 2 else self._component_of_tensors(i, g, j, k)
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

    def _component_of_pairs(self, i: int, g: int, j: int, k: int) -> set[int]:
        """Of products and quotients of numbers and vectors, and of products of tensors and vectors."""
        first, second = self.support(i, g, 2), self.support(g, j, 2)
        if self.side.quaternions and 1 in first and self.exponents(g, j):
            raise UndecidedSearchError("a power of a long quaternion")
        found = self._component_of_multiples((i, g), (g, j), k, 2) if not self.side.quaternions else set()
        if first and second and self.side.quaternions:
            if len(second) > 1 and self.known(g, j, 2) is None:
                raise UndecidedSearchError("something over a long quaternion")
            left, right = self._pairs(i, g, k, second), self._pairs(g, j, k, first)
            if len(left) * len(right) > 8 * WIDE:
                raise UndecidedSearchError("a component has too many values")
            below = [reciprocal(b, self.square) for b in right if any(b)]
            found |= {times(a, b, self.square)[k] for a, b in product(left, [*right, *below])}
        if self.support(i, g, 3) and 1 in second:
            found |= _table(self.axial(i, g), self.component(g, j, 1, 2), lambda a, b: a * b) if k == 1 else {0}
        return found

    def _pairs(self, i: int, j: int, k: int, other: frozenset[int]) -> list[Target]:
        """Values of a stretch: all that matter to one component of a product with something else."""
        known, mine = self.known(i, j, 2), self.support(i, j, 2)
        if known is not None:
            return list(known)
        if len(mine) == 1 or len(other) == 1:
            m = min(mine) if len(mine) == 1 else k ^ min(other)  # of number and vector k the other makes k
            return [(c, 0) if m == 0 else (0, c) for c in self.component(i, j, m, 2)]
        raise UndecidedSearchError("a product of long tensors or quaternions")

    def axial(self, i: int, j: int) -> set[int]:
        """What tensors make of a vector."""
        known = self.known(i, j, 3)
        if known is not None:
            return {t[0] if self.squares else (t[0] + self.square * t[2]) % PRIME for t in known}
        if 2 in self.support(i, j, 3) and not self.squares:
            raise UndecidedSearchError("a long tensor at a vector")
        return self.component(i, j, 0, 3)

    def _component_of_multiples(self, left: tuple[int, int], right: tuple[int, int], k: int, n: int) -> set[int]:
        """Of a number times something, and of something over a number."""
        found: set[int] = set()
        for number, other, over in ((left, right, False), (right, left, True)):
            support = self.support(*other, n)
            if not (support and self.support(*number, 1)) or (over and self.is_exponent(*number, n)):
                continue
            if k not in support:
                found.add(0)
                continue
            numbers = self.component(*number, 0, 1)
            found |= {0} & numbers
            factors = {inverse(a) if over else a for a in numbers if a}
            found |= _table(factors, self.component(*other, k, n), lambda a, b: a * b)
        return found

    def _component_of_tensors(self, i: int, g: int, j: int, k: int) -> set[int]:
        left, right = (i, g), (g, j)
        found = self._component_of_multiples(left, right, k, 3)
        first, second = self.support(i, g, 3), self.support(g, j, 3)
        closed = self.closed(first, second, 3)
        if first - {0} and second - {0} and k in closed and not self.begins_with_numeral(g):
            raise UndecidedSearchError("a product of long tensors or quaternions")
        if self.is_dyad(i, g, j):
            scale = self.square if k == 0 and self.squares else int(k == 2)
            found |= _table(self.component(*left, 1, 2), self.component(*right, 1, 2), lambda a, b: scale * a * b)
        return found | self._component_of_powers(left, right, k)

    def _component_of_powers(self, left: tuple[int, int], right: tuple[int, int], k: int) -> set[int]:
        base, exponents, found = self.support(*left, 3), self.exponents(*right), set[int]()
        if base and -1 in exponents:
            if base != {0}:
                raise UndecidedSearchError("the inverse of a long tensor")
            found |= {inverse(a) for a in self.component(*left, 0, 3) if a} if k == 0 else {0}
        if self._of_marks(*left, 3) and 2 in exponents:
            scale = (0 if self.squares else -self.square, 0, 1)[k]
            found |= {scale * a * a % PRIME for a in self.component(left[0], left[1] - 1, 1, 2)}
        return found


OF_QUATERNIONS: dict[tuple[int, int], set[int]] = {(1, 1): {0}}
OF_DYADS: dict[tuple[int, int], set[int]] = {(1, 1): {0, 2}, (1, 2): set(), (2, 1): set(), (2, 2): {2}}
OF_SQUARES: dict[tuple[int, int], set[int]] = {(1, 1): {2}, (1, 2): {1}, (2, 1): {1}, (2, 2): {2}}
"""The components of products of components other than the first, which is a number."""


def _table(first: set[int], second: set[int], f: Callable[[int, int], int]) -> set[int]:
    if len(first) * len(second) > 8 * WIDE:
        raise UndecidedSearchError("a component has too many values")
    return {f(a, b) % PRIME for a in first for b in second}


def _other_than_0(values: Iterable[Target]) -> set[int]:
    values = list(values)
    return {k for value in values for k, c in enumerate(value) if c} or ({0} if values else set())
