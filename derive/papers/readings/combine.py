"""How parts of a formula are put together again: every mark that was lost between two parts, or around one.

Nothing is combined that nobody prints. Of numerals no two are multiplied, added or subtracted, a fraction is in lowest
terms, 1 is neither a factor nor a denominator, none is raised to a power or divides a tensor, and each stands before
what it multiplies. A number stands before a vector or a tensor unless a function makes it. A tensor is not multiplied
by a multiple of I nor by one that begins with a numeral, and only a letter is squared. No power is raised to another,
and nothing wider than `WIDEST` is an argument, an exponent or between norm bars. What has no meaning drops out.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from functools import partial
from typing import Any

from derive.algebra import Dual, Quaternion, Structure, Tensor, Vector

from ..language import values
from ..language.evaluation import Env
from ..language.notation import dyad, norm, over, root
from ..language.terms import MARKS, Mark
from ..numbers.residues import PRIME, Residue
from .coordinates import EXACT, NUMBERS, Coordinates, inner, inverse, made, plus, scale, times
from .items import (
    MEANINGLESS,
    Item,
    OpenError,
    Shape,
    Table,
    begins_with_numeral,
    both_numerals,
    brackets,
    by_function,
    is_multiple,
    is_number,
    is_one,
    keep,
    offer,
    product_shape,
)  # fmt: skip

HIGHEST = 64  # beyond any exponent of the papers
WIDEST = 7  # tokens, as in the argument (α + 2kπ)/2n
MINUS, TIMES, POWER, AT, NEGATIVE = (MARKS[name] for name in ("minus", "times", "power", "at", "negative"))


class Combine:
    """The ways to put parts together, by the meaning of the marks over an environment; what is new goes to a table."""

    def __init__(self, env: Env, radicals: bool, quaternions: bool, cap: int) -> None:
        self.env = env
        self.cap = cap
        self.radicals = radicals
        self.quaternions = quaternions

    def beside(self, left: Table, right: Table, found: Table, inner: bool) -> None:
        """Parts with no mark left between them; the second may be an argument or an exponent if it is `inner`."""
        for b in right.values():
            exponent, exact = inner and b.kind in EXACT, b.kind in EXACT
            for a in left.values():
                if a.coordinates and b.coordinates and not (exact and a.kind in EXACT):
                    self._by_coordinates(a, b, found)
                elif a.function:
                    if inner:
                        self.applied(a, b, found)
                elif not b.function:
                    self._difference(a, b, found)
                    self._quotient(a, b, found)
                    self._product(a, b, found)
                if exponent and not a.function:
                    self._power(a, b, found)
            self._require_few(found)

    def _require_few(self, found: Table) -> None:
        if len(found) > self.cap:
            raise OpenError

    def _by_coordinates(self, a: Item, b: Item, found: Table) -> None:
        """Difference, quotient and product of things that are residues."""
        assert a.coordinates is not None
        assert b.coordinates is not None
        marks, sum_b = a.marks + b.marks, b.shape is Shape.SUM
        difference = plus(a.kind, a.coordinates, b.kind, b.coordinates, -1)
        if difference is not None:
            self._offer(found, difference, Shape.SUM, marks + 1 + sum_b, MINUS, (a, b))
        quotient = self._divided(a, b)
        if quotient is not None:
            self._offer(found, quotient, Shape.QUOTIENT, marks + 1, over, (a, b))
        if not self._is_product(a, b):
            return
        marks += sum_b + (a.shape is Shape.SUM)
        multiple = self._multiplied(a, b)
        if multiple is not None:
            self._offer(found, multiple, product_shape(a), marks, TIMES, (a, b))
        if self._in_dyad(a) and self._in_dyad(b):
            dyadic = times(Tensor.dyad, Vector, a.coordinates, Vector, b.coordinates)
            assert dyadic is not None
            self._offer(found, dyadic, product_shape(a), 1 + marks, dyad, (a, b))

    @staticmethod
    def _multiplied(a: Item, b: Item) -> tuple[type, Coordinates] | None:
        assert a.coordinates is not None
        assert b.coordinates is not None
        if a.kind in NUMBERS:
            return scale(a.coordinates, b.kind, b.coordinates)
        if b.kind in NUMBERS:
            return scale(b.coordinates, a.kind, a.coordinates)
        return times(values.multiply, a.kind, a.coordinates, b.kind, b.coordinates)

    @staticmethod
    def _divided(a: Item, b: Item) -> tuple[type, Coordinates] | None:
        assert a.coordinates is not None
        assert b.coordinates is not None
        if b.kind in (Vector, Tensor) or is_one(b) or (a.kind is Tensor and b.shape is Shape.NUMERAL):
            return None
        b.inverse = b.inverse or inverse(b.kind, b.coordinates)
        if b.inverse is None:
            return None
        if b.kind is not Quaternion:
            return scale(b.inverse, a.kind, a.coordinates)
        if a.kind in NUMBERS:
            return scale(a.coordinates, Quaternion, b.inverse)
        return times(values.multiply, a.kind, a.coordinates, Quaternion, b.inverse)

    def _offer(self, found: Table, value: tuple[type, Coordinates], shape: Shape, marks: int, mark: Mark,
               parts: tuple[Item, ...]) -> None:  # fmt: skip
        if self.quaternions or value[0] is not Quaternion:
            offer(found, *value, shape, marks, mark, parts)

    def between(self, mark: Mark, left: Table, right: Table, found: Table) -> None:
        """Parts with a mark between them that survived."""
        if mark.name == "plus":
            self._sums(mark, left, right, found)
            return
        for b in right.values():
            for a in left.values():
                if not (a.function or b.function):
                    self._made(found, mark, (a, b), Shape.PRODUCT, brackets(a) + brackets(b),
                               partial(mark.value, self.env, a.value, b.value))  # fmt: skip

    def _sums(self, mark: Mark, left: Table, right: Table, found: Table) -> None:
        for a in left.values():
            for b in right.values():
                if a.coordinates and b.coordinates and not (a.kind in EXACT and b.kind in EXACT):
                    total = plus(a.kind, a.coordinates, b.kind, b.coordinates)
                    if total is not None:
                        self._offer(found, total, Shape.SUM, a.marks + b.marks, mark, (a, b))
                elif not (both_numerals(a, b) or a.function or b.function):
                    self._made(found, mark, (a, b), Shape.SUM, 0, partial(mark.value, self.env, a.value, b.value))
            self._require_few(found)

    def at_one(self, mark: Mark, table: Table, found: Table) -> None:
        """A part with a mark before or after it that survived."""
        for a in table.values():
            self._made(found, mark, (a,), Shape.ATOM, brackets(a), partial(mark.value, self.env, a.value))

    def around(self, table: Table, bars: bool) -> None:
        """Radicals, and norm bars if asked for, put around what a table has."""
        for a in list(table.values()):
            if a.kind in (Vector, Quaternion):
                if bars:
                    self._made(table, norm, (a,), Shape.ATOM, 1, partial(self._norm, a))
            elif self.radicals and a.kind in (Residue, Dual) and a.shape in (Shape.SUM, Shape.QUOTIENT, Shape.POWER):
                self._made(table, root, (a,), Shape.ATOM, 1, partial(self.env.field.sqrt, a.value))

    def _norm(self, a: Item) -> Any:
        """The root of the square, where that has one."""
        c = a.coordinates
        square = None if c is None else times(inner, a.kind, c, a.kind, c)
        if square is None or square[1][0] == 0:
            return values.norm(self.env.field, a.value)
        return self.env.field.sqrt(made(*square))

    def opposite(self, table: Table, found: Table) -> None:
        """A minus in front."""
        for a in table.values():
            if a.coordinates and a.kind not in EXACT:
                opposite = tuple([-c % PRIME for c in a.coordinates])
                offer(found, a.kind, opposite, Shape.SUM, a.marks + 1 + brackets(a), NEGATIVE, (a,))
            elif not a.function:
                self._made(found, NEGATIVE, (a,), Shape.SUM, 1 + brackets(a), partial(values.negative, a.value))

    def applied(self, f: Item, a: Item, found: Table) -> None:
        """A function at an argument, and its power where that is a numeral."""
        if isinstance(a.value, Structure) or is_number(a.value):
            self._made(found, AT, (f, a), Shape.ATOM, 1, lambda: f.value(a.value))
        if isinstance(a.value, int) and a.value > 1 and f.mark is None:
            power = Item(lambda x: self.env.power(f.value(x), a.value), Shape.POWER, 1 + a.marks, POWER, (f, a))
            found["function", f.parts[0], a.value] = power

    def _difference(self, a: Item, b: Item, found: Table) -> None:
        if not both_numerals(a, b):
            self._made(found, MINUS, (a, b), Shape.SUM, 1 + brackets(b),
                       lambda: values.add(a.value, values.negative(b.value)))  # fmt: skip

    def _quotient(self, a: Item, b: Item, found: Table) -> None:
        exponent = a.kind is Tensor and b.shape is Shape.NUMERAL
        divides = is_number(b.value) or isinstance(b.value, Quaternion)
        reducible = both_numerals(a, b) and math.gcd(a.value, b.value) > 1
        if divides and not (is_one(b) or exponent or reducible):
            self._made(found, over, (a, b), Shape.QUOTIENT, 1, lambda: over.value(self.env, a.value, b.value))

    def _power(self, a: Item, b: Item, found: Table) -> None:
        """Exponents with the sign they have or with a minus that was lost."""
        if not 0 < abs(b.value) <= HIGHEST or a.shape in (Shape.NUMERAL, Shape.POWER):
            return
        for e, exponent in ((b.value, b), (-b.value, Item(-b.value, b.shape, b.marks + 1, NEGATIVE, (b,)))):
            if e != 1:
                self._raised(a, e, exponent, found)

    def _raised(self, a: Item, e: int | Fraction, exponent: Item, found: Table) -> None:
        if isinstance(a.value, Vector | Quaternion) and isinstance(e, int) and e % 2 == 0:
            length = Item(None, Shape.ATOM, a.marks + 1, norm, (a,))  # its even powers need no root
            self._made(found, POWER, (length, exponent), Shape.POWER, 1,
                       lambda: self.env.power(values.square(a.value), e // 2))  # fmt: skip
        if a.kind is not Tensor or e == -1 or (e == 2 and a.shape is Shape.ATOM):
            marks = 1 if a.shape is Shape.ATOM else 2
            self._made(found, POWER, (a, exponent), Shape.POWER, marks, lambda: self.env.power(a.value, e))

    def _product(self, a: Item, b: Item, found: Table) -> None:
        if not self._is_product(a, b):
            return
        shape, marks = product_shape(a), brackets(a) + brackets(b)
        self._made(found, TIMES, (a, b), shape, marks, lambda: values.multiply(a.value, b.value))
        if self._in_dyad(a) and self._in_dyad(b):
            self._made(found, dyad, (a, b), shape, 1 + marks, lambda: Tensor.dyad(a.value, b.value))

    @staticmethod
    def _is_product(a: Item, b: Item) -> bool:
        """Whether anybody prints one beside the other."""
        if is_one(a) or b.shape in (Shape.NUMERAL, Shape.LED):
            return False
        if a.kind in (Vector, Tensor) and b.kind in NUMBERS and not by_function(b):
            return False
        return not (a.kind is b.kind is Tensor and (is_multiple(a) or is_multiple(b) or begins_with_numeral(b)))

    @staticmethod
    def _in_dyad(a: Item) -> bool:
        return a.kind is Vector and a.shape in (Shape.ATOM, Shape.SUM)

    def _made(
        self, found: Table, mark: Mark, parts: tuple[Item, ...], shape: Shape, marks: int, value: Callable[[], Any]
    ) -> None:
        try:
            new = value()
            if is_number(new) or (isinstance(new, Structure) and (self.quaternions or type(new) is not Quaternion)):
                keep(found, Item(new, shape, marks + sum([p.marks for p in parts]), mark, parts))
        except MEANINGLESS:
            return
