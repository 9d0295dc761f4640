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
from enum import Enum, auto
from fractions import Fraction
from functools import partial
from typing import Any

from derive.algebra import Dual, Quaternion, Structure, Tensor, Vector

from ..language import values
from ..language.evaluation import Env
from ..language.notation import dyad, norm, over, root
from ..language.terms import MARKS, Apply, Mark, Term
from ..numbers.residues import PRIME, Residue, residue
from .tokens import INSERTED

MEANINGLESS = (ArithmeticError, TypeError, AttributeError, ValueError, KeyError, IndexError)
"""What combining things raises that have no such operation, or no value."""
HIGHEST = 64  # beyond any exponent of the papers
WIDEST = 7  # tokens, as in the argument (α + 2kπ)/2n
MINUS, TIMES, POWER, AT, NEGATIVE = (MARKS[name] for name in ("minus", "times", "power", "at", "negative"))


class Shape(Enum):
    """How a part looks, as far as it matters for what may stand beside it."""

    NUMERAL = auto()
    ATOM = auto()
    POWER = auto()
    PRODUCT = auto()
    LED = auto()
    """A product that begins with a numeral."""
    QUOTIENT = auto()
    SUM = auto()


SIZES = {Residue: 1, Vector: 3, Quaternion: 4, Tensor: 9}
"""How many coordinates the things have that are added and multiplied by numbers as residues."""


class Item:
    """A part read one way: its value, its looks, how many marks were put in, and what it is made of.

    Attributes
    ----------
    kind : type
        Of the value.
    coordinates : tuple of int, optional
        The residues of a value that needs nothing else: no dual part, no angle, no exactness as an exponent.
    """

    __slots__ = ("_value", "coordinates", "inverse", "kind", "mark", "marks", "parts", "shape")

    def __init__(self, value: Any, shape: Shape, marks: int, mark: Mark | None, parts: tuple[Any, ...],
                 kind: type | None = None, coordinates: tuple[int, ...] | None = None) -> None:  # fmt: skip
        self._value, self.shape, self.marks, self.mark, self.parts = value, shape, marks, mark, parts
        self.kind = kind or type(value)
        self.coordinates = coordinates or _coordinates(value)
        self.inverse = 0

    @property
    def value(self) -> Any:
        """The value, made of its coordinates when it is asked for."""
        if self._value is None and self.coordinates is not None:
            self._value = _structure(self.kind, self.coordinates)
        return self._value

    @property
    def term(self) -> Term:
        """The formula."""
        if self.mark is None:
            leaf: Term = self.parts[0]
            return leaf
        return Apply(self.mark.name, *(part.term for part in self.parts))


Table = dict[Any, Item]
"""Readings by value and looks; of equal ones that with fewest added marks."""


def leaf(term: Term, value: Any, numeral: bool) -> Item:
    """A letter or a numeral."""
    return Item(value, Shape.NUMERAL if numeral else Shape.ATOM, 0, None, (term,))


def _coordinates(value: Any) -> tuple[int, ...] | None:
    if isinstance(value, Residue):
        return (value.value,) if value.angle is None else None
    parts = list(values.coefficients(value)) if isinstance(value, Structure) else [None]
    residues = tuple(residue(part) for part in parts)
    return None if len(residues) != SIZES.get(type(value)) or None in residues else residues  # type: ignore[return-value]


def _structure(kind: type, coordinates: tuple[int, ...]) -> Any:
    parts = [Residue(c) for c in coordinates]
    if kind is Residue:
        return parts[0]
    if kind is Tensor:
        return Tensor.from_entries(parts)
    return Vector(*parts) if kind is Vector else Quaternion(parts[0], Vector(*parts[1:]))


def key(value: Any) -> tuple[Any, ...]:
    """Equal for equal values: numbers and vectors are quaternions."""
    if isinstance(value, Vector):
        return (0, *map(flat, value))
    if isinstance(value, Quaternion):
        return (flat(value.scalar), *map(flat, value.vector))
    if isinstance(value, Tensor):
        return tuple(map(flat, value))
    return (flat(value), 0, 0, 0)


def flat(a: Any) -> Any:
    """A number as residues, its dual part beside its real one where it is not 0."""
    if isinstance(a, Dual):
        re, du = flat(a.re), flat(a.du)
        return re if du == 0 else (re, du)
    value = residue(a)
    if value is None:
        raise TypeError(f"no number: {a!r}")
    return value


def is_number(a: Any) -> bool:
    """Whether a value is a number, plain or dual."""
    return isinstance(a, Residue | int | Fraction | Dual)


class Combine:
    """The ways to put parts together, by the meaning of the marks over an environment; what is new goes to a table."""

    def __init__(self, env: Env, radicals: bool, quaternions: bool) -> None:
        self.env = env
        self.radicals = radicals
        self.quaternions = quaternions

    def beside(self, left: Table, right: Table, found: Table, inner: bool) -> None:
        """Parts with no mark left between them; the second may be an argument or an exponent if it is `inner`."""
        for b in right.values():
            exponent = inner and b.kind in (int, Fraction)
            for a in left.values():
                if a.coordinates is not None and b.coordinates is not None:
                    self._by_coordinates(a, b, found)
                elif callable(a.value):
                    if inner:
                        self._applied(a, b, found)
                elif not callable(b.value):
                    self._difference(a, b, found)
                    self._quotient(a, b, found)
                    self._product(a, b, found)
                if exponent and not callable(a.value):
                    self._power(a, b, found)

    def _by_coordinates(self, a: Item, b: Item, found: Table) -> None:
        """Difference, quotient and product of things that are residues."""
        assert a.coordinates is not None
        assert b.coordinates is not None
        marks, sum_b = a.marks + b.marks, b.shape is Shape.SUM
        pair = self._aligned(a, b)
        if pair is not None:
            kind, first, second = pair
            difference = tuple([(s - t) % PRIME for s, t in zip(first, second, strict=True)])
            _offer(found, kind, difference, Shape.SUM, marks + 1 + sum_b, MINUS, (a, b))
        if b.kind is Residue and b.coordinates[0] and not (a.kind is Tensor and b.shape is Shape.NUMERAL):
            b.inverse = b.inverse or pow(b.coordinates[0], -1, PRIME)
            quotient = tuple([s * b.inverse % PRIME for s in a.coordinates])
            _offer(found, a.kind, quotient, Shape.QUOTIENT, marks + 1, over, (a, b))
        elif b.kind is Quaternion:
            self._quotient(a, b, found)
        if a.kind is Residue and b.shape is not Shape.LED:
            factor = a.coordinates[0]
            product = tuple([factor * t % PRIME for t in b.coordinates])
            brackets = (a.shape is Shape.SUM) + sum_b
            _offer(found, b.kind, product, _product_shape(a), marks + brackets, TIMES, (a, b))
        elif a.kind is not Residue:
            self._product(a, b, found)

    def between(self, mark: Mark, left: Table, right: Table, found: Table) -> None:
        """Parts with a mark between them that survived."""
        is_sum = mark.name == "plus"
        shape = Shape.SUM if is_sum else Shape.PRODUCT
        for b in right.values():
            for a in left.values():
                if callable(a.value) or callable(b.value) or (is_sum and _both_numerals(a, b)):
                    continue
                pair = self._aligned(a, b) if is_sum else None
                if pair is not None:
                    total = tuple([(s + t) % PRIME for s, t in zip(pair[1], pair[2], strict=True)])
                    _offer(found, pair[0], total, shape, a.marks + b.marks, mark, (a, b))
                    continue
                marks = 0 if is_sum else _bracket(a) + _bracket(b)
                self._made(found, mark, (a, b), shape, marks, partial(mark.value, self.env, a.value, b.value))

    def at_one(self, mark: Mark, table: Table, found: Table) -> None:
        """A part with a mark before or after it that survived."""
        for a in table.values():
            self._made(found, mark, (a,), Shape.ATOM, _bracket(a), partial(mark.value, self.env, a.value))

    def around(self, table: Table, bars: bool) -> None:
        """Radicals, and norm bars if asked for, put around what a table has."""
        for a in list(table.values()):
            if a.kind in (Vector, Quaternion):
                if bars:
                    self._made(table, norm, (a,), Shape.ATOM, 1, partial(values.norm, self.env.field, a.value))
            elif self.radicals and a.kind in (Residue, Dual) and a.shape in (Shape.SUM, Shape.QUOTIENT, Shape.POWER):
                self._made(table, root, (a,), Shape.ATOM, 1, partial(self.env.field.sqrt, a.value))

    def opposite(self, table: Table, found: Table) -> None:
        """A minus in front."""
        for a in table.values():
            if not callable(a.value):
                self._made(found, NEGATIVE, (a,), Shape.SUM, 1 + _bracket(a), partial(values.negative, a.value))

    def _applied(self, f: Item, a: Item, found: Table) -> None:
        if isinstance(a.value, Structure) or is_number(a.value):
            self._made(found, AT, (f, a), Shape.ATOM, 1, lambda: f.value(a.value))
        if isinstance(a.value, int) and a.value > 1 and f.mark is None:
            power = Item(lambda x: self.env.power(f.value(x), a.value), Shape.POWER, 1 + a.marks, POWER, (f, a))
            found["function", f.parts[0], a.value] = power

    def _difference(self, a: Item, b: Item, found: Table) -> None:
        if not _both_numerals(a, b):
            self._made(found, MINUS, (a, b), Shape.SUM, 1 + _bracket(b),
                       lambda: values.add(a.value, values.negative(b.value)))  # fmt: skip

    def _quotient(self, a: Item, b: Item, found: Table) -> None:
        exponent = a.kind is Tensor and b.shape is Shape.NUMERAL
        divides = is_number(b.value) or isinstance(b.value, Quaternion)
        reducible = _both_numerals(a, b) and math.gcd(a.value, b.value) > 1
        if divides and not (_is_one(b) or exponent or reducible):
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
        if _is_one(a) or b.shape in (Shape.NUMERAL, Shape.LED):
            return
        if isinstance(a.value, Vector | Tensor) and is_number(b.value) and not _by_function(b):
            return
        if a.kind is b.kind is Tensor and (_is_multiple(a) or _is_multiple(b) or _begins_with_numeral(b)):
            return
        shape, brackets = _product_shape(a), _bracket(a) + _bracket(b)
        self._made(found, TIMES, (a, b), shape, brackets, lambda: values.multiply(a.value, b.value))
        if a.kind is b.kind is Vector and {a.shape, b.shape} <= {Shape.ATOM, Shape.SUM}:
            self._made(found, dyad, (a, b), shape, 1 + brackets, lambda: Tensor.dyad(a.value, b.value))

    def _aligned(self, a: Item, b: Item) -> tuple[type, tuple[int, ...], tuple[int, ...]] | None:
        """Coordinates that can be added: of the same kind, or of numbers and vectors as quaternions."""
        if a.coordinates is None or b.coordinates is None:
            return None
        if a.kind is b.kind:
            return a.kind, a.coordinates, b.coordinates
        if not self.quaternions or Tensor in (a.kind, b.kind):
            return None
        first, second = ((*c, 0, 0, 0) if len(c) == 1 else (0, *c) if len(c) == 3 else c
                         for c in (a.coordinates, b.coordinates))  # fmt: skip
        return Quaternion, first, second

    def _made(
        self, found: Table, mark: Mark, parts: tuple[Item, ...], shape: Shape, marks: int, value: Callable[[], Any]
    ) -> None:
        try:
            made = value()
            if is_number(made) or (isinstance(made, Structure) and (self.quaternions or type(made) is not Quaternion)):
                _keep(found, Item(made, shape, marks + sum([p.marks for p in parts]), mark, parts))
        except MEANINGLESS:
            return


def _offer(
    found: Table, kind: type, value: tuple[int, ...], shape: Shape, marks: int, mark: Mark, parts: tuple[Item, Item]
) -> None:
    known = found.get((kind, value, shape))
    if known is None or marks < known.marks:
        found[kind, value, shape] = Item(None, shape, marks, mark, parts, kind, value)


def _keep(found: Table, item: Item) -> None:
    value = item.coordinates
    if value is None:
        value = item.value if item.kind in (int, Fraction) else key(item.value)
    known = found.get((item.kind, value, item.shape))
    if known is None or item.marks < known.marks:
        found[item.kind, value, item.shape] = item


def _both_numerals(a: Item, b: Item) -> bool:
    return a.shape is b.shape is Shape.NUMERAL


def _is_one(a: Item) -> bool:
    return a.shape is Shape.NUMERAL and bool(a.value == 1)


def _is_multiple(a: Item) -> bool:
    """Of the identity."""
    c = a.coordinates
    return c is not None and c[0] == c[4] == c[8] and not any(c[1:4] + c[5:8])


def _begins_with_numeral(a: Item) -> bool:
    while a.mark is not None:
        a = a.parts[0]
    return a.shape is Shape.NUMERAL


def _by_function(a: Item) -> bool:
    return a.mark is not None and a.mark.name not in INSERTED


def _bracket(a: Item) -> int:
    return 1 if a.shape is Shape.SUM else 0


def _product_shape(a: Item) -> Shape:
    return Shape.LED if a.shape in (Shape.NUMERAL, Shape.LED) else Shape.PRODUCT
