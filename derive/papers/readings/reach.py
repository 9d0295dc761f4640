"""Whether a side can have a given value in any reading, where its readings are too many to list.

A target is taken apart along with the tokens: if a stretch is made of two, and one of them can be listed, each of its
values says what the other has to be; parts of a sum that share no component are looked for one by one. What is listed,
and by which components, is said in `lists`. The looks of the parts are not kept, so that more is allowed than anybody
prints: a no is final, a yes not. What cannot be followed is not decided.
"""

from __future__ import annotations

from fractions import Fraction

from ..numbers.residues import PRIME, square_root
from .combine import WIDEST
from .search import Side
from .stretches import Stretches
from .targets import Target, UndecidedSearchError, inverse, less, power, ratio, reciprocal, roots, scaled, times
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
    short : int
        How many tokens a stretch has at most whose values are all known.
    """

    def __init__(self, side: Side, along: int, short: int = WIDEST + 1) -> None:
        self.stretches = Stretches(side, along, short)
        self.left = ATTEMPTS
        self.known: dict[tuple[int, int, Target], bool] = {}

    def can(self, i: int, j: int, target: Target) -> bool:
        """Whether a stretch can have a value.

        Raises
        ------
        UndecidedSearchError
            If that takes too long, or two long stretches depend on each other.
        """
        known = self.stretches.known(i, j, len(target))
        if known is not None:
            return target in known
        support = self.stretches.support(i, j, len(target))
        if any(c and k not in support for k, c in enumerate(target)):
            return False
        if len(target) > 1:
            components = {k: self.stretches.listed_component(i, j, k, len(target)) for k in support}
            if any(values is not None and target[k] and target[k] not in values for k, values in components.items()):
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
        if len(t) == 2 and not t[1] and self.stretches.support(i, j, 1) and self.can(i, j, t[:1]):
            return True
        if t in self.stretches.applied(i, j, len(t)) or self._marked(i, j, t) or self._splits(i, j, t):
            return True
        square = t[0] * t[0] % PRIME
        if len(t) == 1 and square_root(square) == t[0]:
            return self._splits(i, j, (square,)) or (j - i <= WIDEST and self._length(i, j, square))
        return False

    def _marked(self, i: int, j: int, t: Target) -> bool:
        """Whether the mark behind a whole stretch makes a tensor of a vector."""
        behind = self.stretches.side.tokens[j - 1].place is Place.AFTER
        return behind and len(t) == 3 and not (t[0] or t[2]) and self.can(i, j - 1, (0, t[1]))

    def _length(self, i: int, j: int, t: int) -> bool:
        """Whether a vector or a quaternion can have a number as its square."""
        support, square = self.stretches.support(i, j, 2), self.stretches.square
        known = self.stretches.known(i, j, 2)
        if known is not None:
            return any((s * s + square * x * x - t) % PRIME == 0 for s, x in known)
        if 1 in support and (t == 0 or (0 in support and self.stretches.side.quaternions)):
            raise UndecidedSearchError("the norm of a long quaternion")
        return 1 in support and any(self.can(i, j, (0, x)) for x in roots(t * inverse(square) % PRIME, Fraction(2)))

    def _splits(self, i: int, j: int, t: Target) -> bool:
        for g in range(i + 1, j):
            place = self.stretches.side.tokens[g].place
            if place is Place.BETWEEN:
                if g + 1 < j and self._sum(i, g, g + 1, j, t, 1):
                    return True
            elif place is not Place.AFTER and self._beside(i, g, j, t):
                return True
        return False

    def _beside(self, i: int, g: int, j: int, t: Target) -> bool:
        if len(t) == 1 and self.stretches.listed(i, g, 1) is not None and self.stretches.listed(g, j, 1) is not None:
            first, second = self.stretches.numbers(i, g), self.stretches.numbers(g, j)
            return self._of_listed(first, second, t[0]) or self._power(i, g, j, t[0])
        if self._sum(i, g, g, j, t, -1):
            return True
        if len(t) == 2 and (self._at_vector(i, g, j, t) or self._power_of_pair(i, g, j, t)):
            return True
        if len(t) == 2 and self.stretches.side.quaternions:
            return self._of_pairs(i, g, j, t)
        if self._product(i, g, j, t) or self._quotient(i, g, j, t):
            return True
        if len(t) == 1:
            return self._power(i, g, j, t[0])
        return len(t) == 3 and (self._dyad(i, g, j, t) or self._power_of_tensor(i, g, j, t))

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
        """Products of two tensors."""
        n, first, second = len(t), self.stretches.support(i, g, len(t)), self.stretches.support(g, j, len(t))
        if n < 3 or not (first and second):
            return False
        closed = self.stretches.closed(first, second, n)
        if any(c and k not in closed for k, c in enumerate(t)):
            return False
        if {0} in (first, second) or self.stretches.begins_with_numeral(g):
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
        exponents = self.stretches.exponents(g, j)
        return any(self.can(i, g, (root,)) for e in exponents for root in roots(t, e)) or any(
            self._length(i, g, root) for e in exponents if e % 2 == 0 for root in roots(t, e / 2)
        )

    # ---- pairs -------------------------------------------------------------------------------------------------------

    def _of_pairs(self, i: int, g: int, j: int, t: Target) -> bool:
        """Products and quotients."""
        mine, other = self.stretches.support(i, g, 2), self.stretches.support(g, j, 2)
        if not (mine and other):
            return False
        if not any(t):
            return self.can(i, g, t) or self.can(g, j, t)
        square = self.stretches.square
        first, second = self.stretches.listed(i, g, 2), self.stretches.listed(g, j, 2)
        if second is not None and (first is None or len(second) <= len(first)):
            factors = [b for b in second if any(b)]
            return any(self.can(i, g, times(t, b, square)) or self.can(i, g, times(t, reciprocal(b, square), square))
                       for b in factors)  # fmt: skip
        over = reciprocal(t, square)
        if first is not None:
            return any(self.can(g, j, times(t, reciprocal(a, square), square)) or self.can(g, j, times(a, over, square))
                       for a in first if any(a))  # fmt: skip
        if other == {0}:
            numbers = self.stretches.factors(i, g, t)
            return any(self._both((g, j, (b, 0)), (i, g, scaled(inverse(f), t)))
                       for f in numbers for b in (f, inverse(f)))  # fmt: skip
        if mine == {0}:
            parts = [(f, f, t) for f in self.stretches.factors(g, j, t)]
            parts += [(inverse(f), f, over) for f in self.stretches.factors(g, j, over)]
            return any(self._both((i, g, (a, 0)), (g, j, scaled(inverse(f), b))) for a, f, b in parts)
        raise UndecidedSearchError("a product of long tensors or quaternions")

    def _at_vector(self, i: int, g: int, j: int, t: Target) -> bool:
        """Tensors at vectors."""
        if t[0] or not self.stretches.support(i, g, 3) or 1 not in self.stretches.support(g, j, 2):
            return False
        factors = self.stretches.axial(i, g)
        return t[1] == 0 or any(self.can(g, j, (0, t[1] * inverse(f) % PRIME)) for f in factors if f)

    def _power_of_pair(self, i: int, g: int, j: int, t: Target) -> bool:
        raised = self.stretches.side.quaternions and 1 in self.stretches.support(i, g, 2)
        exponents = self.stretches.exponents(g, j) if raised else ()
        known = self.stretches.known(i, g, 2)
        if exponents and (known is None or any(e.denominator > 1 for e in exponents)):
            raise UndecidedSearchError("a power of a long quaternion")
        square = self.stretches.square
        return any(power(a, e.numerator, square) == t for e in exponents for a in known or () if any(a) or e > 0)

    # ---- tensors -----------------------------------------------------------------------------------------------------

    def _dyad(self, i: int, g: int, j: int, t: Target) -> bool:
        if not self.stretches.is_dyad(i, g, j) or t != self._of_dyad(t[2]):
            return False
        first, second = self.stretches.listed(i, g, 2), self.stretches.listed(g, j, 2)
        if t[2] == 0:
            return self.can(i, g, (0, 0)) or self.can(g, j, (0, 0))
        if first is not None:
            return any(self.can(g, j, (0, t[2] * inverse(x) % PRIME)) for s, x in first if x and not s)
        if second is not None:
            return any(self.can(i, g, (0, t[2] * inverse(x) % PRIME)) for s, x in second if x and not s)
        raise UndecidedSearchError("a dyad of two long vectors")

    def _of_dyad(self, x: int) -> Target:
        return (self.stretches.square * x % PRIME if self.stretches.squares else 0, 0, x)

    def _power_of_tensor(self, i: int, g: int, j: int, t: Target) -> bool:
        """Inverses, and squares of what is no product."""
        exponents, base = self.stretches.exponents(g, j), self.stretches.support(i, g, 3)
        if base and -1 in exponents and t[0]:
            if base != {0}:
                raise UndecidedSearchError("the inverse of a long tensor")
            if not (t[1] or t[2]) and self.can(i, g, (inverse(t[0]), 0, 0)):
                return True
        skewed = 0 if self.stretches.squares else -self.stretches.square * t[2] % PRIME
        if 1 in base and 2 in exponents and (t[0], t[1]) == (skewed, 0):
            return any(self._marked(i, g, (0, c, 0)) for c in roots(t[2], Fraction(2)))
        return False
