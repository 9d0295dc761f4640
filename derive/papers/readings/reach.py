"""Whether a side can have a given value in any reading, where its readings are too many to list.

A target is taken apart along with the tokens: if a stretch is the sum, product or quotient of two, and one of them can
be listed, each of its values says what the other has to be. What is along one vector is a pair (1, v) or, of tensors, a
triple (I, ṽ, v ⊗ v), or (I, ṽ, ṽ²) where squares are written; parts of a sum that share none of these are looked for
one by one. The looks of the parts are not kept, so that more is allowed than anybody prints: a no is final, a yes not.
"""

from __future__ import annotations

from ..numbers.residues import PRIME, square_root
from .combine import WIDEST
from .search import Side
from .stretches import Stretches
from .targets import Target, UndecidedSearchError, inverse, less, ratio, roots, scaled
from .tokens import Place

ATTEMPTS = 10_000
"""How often a stretch is asked for a value."""


class Reach:
    """What a side can be.

    Parameters
    ----------
    side : Side
    along : int
        The first coordinate of the vector that all else is along; its others are 0.
    """

    def __init__(self, side: Side, along: int) -> None:
        self.stretches = Stretches(side, along)
        self.left = ATTEMPTS
        self.known: dict[tuple[int, int, Target], bool] = {}

    def can(self, i: int, j: int, target: Target) -> bool:
        """Whether a stretch can have a value.

        Raises
        ------
        UndecidedSearchError
            If that takes too long, or two long stretches depend on each other.
        """
        listed = self.stretches.listed(i, j, len(target))
        if listed is not None:
            return target in listed
        support = self.stretches.support(i, j, len(target))
        if any(c and k not in support for k, c in enumerate(target)):
            return False
        if len(target) > 1:
            components = {k: self.stretches.listed_component(i, j, k, len(target)) for k in support}
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
            place = self.stretches.side.tokens[g].place
            mark = self.stretches.side.tokens[g].mark
            if place is Place.BETWEEN and mark is not None:
                if mark.name != "plus":
                    raise UndecidedSearchError(f"a long stretch with {mark.name}")
                if g + 1 < j and self._sum(i, g, g + 1, j, t, 1):
                    return True
            elif place is not Place.AFTER and self._beside(i, g, j, t):
                return True
        return False

    def _beside(self, i: int, g: int, j: int, t: Target) -> bool:
        if len(t) == 1 and self.stretches.listed(i, g, 1) is not None and self.stretches.listed(g, j, 1) is not None:
            first, second = self.stretches.numbers(i, g), self.stretches.numbers(g, j)
            return self._of_listed(first, second, t[0]) or self._power(i, g, j, t[0])
        return (
            self._sum(i, g, g, j, t, -1) or self._product(i, g, j, t) or self._quotient(i, g, j, t)
            or (len(t) == 1 and self._power(i, g, j, t[0]))
        )  # fmt: skip

    @staticmethod
    def _of_listed(first: dict[int, int], second: dict[int, int], t: int) -> bool:
        """Whether a number is a difference, product or quotient of listed ones."""
        if t == 0:
            return 0 in first or 0 in second or not first.keys().isdisjoint(second)
        if len(first) <= len(second):
            reciprocal = inverse(t)
            return any((a - t) % PRIME in second or t * b % PRIME in second or a * reciprocal % PRIME in second
                       for a, b in first.items())  # fmt: skip
        return any((t + a) % PRIME in first or t * b % PRIME in first or t * a % PRIME in first
                   for a, b in second.items())  # fmt: skip

    def _sum(self, i: int, g: int, h: int, j: int, t: Target, sign: int) -> bool:
        n = len(t)
        first, second = self.stretches.listed(i, g, n), self.stretches.listed(h, j, n)
        if first is not None and (second is None or len(first) <= len(second)):
            return any(self.can(h, j, scaled(sign, less(t, a))) for a in first)
        if second is not None:
            return any(self.can(i, g, less(t, scaled(sign, b))) for b in second)
        mine, other = self.stretches.support(i, g, n), self.stretches.support(h, j, n)
        if not mine or not other:
            return False
        if mine & other:
            raise UndecidedSearchError("two long stretches with the same components")
        part = tuple(c if k in mine else 0 for k, c in enumerate(t))
        return self._both((i, g, part), (h, j, scaled(sign, less(t, part))))

    def _both(self, first: tuple[int, int, Target], second: tuple[int, int, Target]) -> bool:
        """Whether two stretches can; the shorter one is asked first."""
        return all(self.can(*asked) for asked in sorted((first, second), key=lambda asked: asked[1] - asked[0]))

    def _product(self, i: int, g: int, j: int, t: Target) -> bool:
        n = len(t)
        if not self.stretches.support(i, g, 1) or not self.stretches.support(g, j, n):
            return self._of_structures(i, g, j, t)
        if not any(t):
            return self.can(i, g, (0,)) or self.can(g, j, t)
        first, second = self.stretches.listed(i, g, 1), self.stretches.listed(g, j, n)
        if second is not None and (first is None or len(second) <= len(first)):
            factors = {f for b in second for f in ratio(t, b)}
            found = any(self.can(i, g, (f,)) for f in factors)
        elif first is not None:
            found = any(self.can(g, j, scaled(inverse(a[0]), t)) for a in first if a[0])
        else:
            factors = self.stretches.factors(g, j, t)
            found = any(self._both((i, g, (f,)), (g, j, scaled(inverse(f), t))) for f in factors)
        return found or self._of_structures(i, g, j, t)

    def _of_structures(self, i: int, g: int, j: int, t: Target) -> bool:
        """Products of two tensors or quaternions, of which one is listed."""
        n, first, second = len(t), self.stretches.support(i, g, len(t)), self.stretches.support(g, j, len(t))
        if n == 1 or not (first and second) or (n == 2 and not (first - {0} and second - {0})):
            return False
        closed = self.stretches.closed(first, second, n)
        if any(c and k not in closed for k, c in enumerate(t)):
            return False
        if n == 3 and ({0} in (first, second) or self.stretches.begins_with_numeral(g)):
            return False
        raise UndecidedSearchError("a product of long tensors or quaternions")

    def _quotient(self, i: int, g: int, j: int, t: Target) -> bool:
        n = len(t)
        supported = self.stretches.support(g, j, 1) and self.stretches.support(i, g, n)
        if not supported or self.stretches.is_exponent(g, j, n):
            return False
        if not any(t):
            return self.can(i, g, t)
        below, above = self.stretches.listed(g, j, 1), self.stretches.listed(i, g, n)
        if below is not None and (above is None or len(below) <= len(above)):
            return any(self.can(i, g, scaled(b[0], t)) for b in below if b[0])
        if above is not None:
            return any(self.can(g, j, (f,)) for f in {f for a in above for f in ratio(a, t)})
        if n > 1:
            divisors = {inverse(f) for f in self.stretches.factors(i, g, t)}
            return any(self._both((g, j, (f,)), (i, g, scaled(f, t))) for f in divisors)
        raise UndecidedSearchError("two long stretches, one over the other")

    def _power(self, i: int, g: int, j: int, t: int) -> bool:
        exponents = self.stretches.exponents(g, j) if j - g <= WIDEST else ()
        return any(self.can(i, g, (root,)) for e in exponents for root in roots(t, e))
