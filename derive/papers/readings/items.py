"""Parts of a formula that are read one way: their value, their looks, what they are made of."""

from __future__ import annotations

from enum import IntEnum, auto
from fractions import Fraction
from typing import Any

from derive.algebra import Dual, Quaternion, Tensor, Vector

from ..language.terms import Apply, Mark, Term
from ..numbers.residues import Residue, residue
from .coordinates import SIZES, Coordinates, coordinates, made
from .tokens import INSERTED

MEANINGLESS = (ArithmeticError, TypeError, AttributeError, ValueError, KeyError, IndexError)
"""What combining things raises that have no such operation, or no value."""


class OpenError(Exception):
    """There are more readings than the cap."""


class Shape(IntEnum):
    """How a part looks, as far as it matters for what may stand beside it."""

    NUMERAL = auto()
    ATOM = auto()
    POWER = auto()
    PRODUCT = auto()
    LED = auto()
    """A product that begins with a numeral."""
    QUOTIENT = auto()
    SUM = auto()


class Item:
    """A part read one way: its value, its looks, how many marks were put in, and what it is made of.

    Attributes
    ----------
    kind : type
        Of the value.
    coordinates : tuple of int, optional
        The residues of a value that needs nothing else: no derivative in time, no angle.
    function : bool
        Whether the value is one.
    inverse : tuple of int, optional
        The coordinates of the inverse, once it was asked for.
    """

    __slots__ = ("_value", "coordinates", "function", "inverse", "kind", "mark", "marks", "parts", "shape")

    def __init__(self, value: Any, shape: Shape, marks: int, mark: Mark | None, parts: tuple[Any, ...],
                 kind: type | None = None, c: Coordinates | None = None) -> None:  # fmt: skip
        self._value, self.shape, self.marks, self.mark, self.parts = value, shape, marks, mark, parts
        self.kind = kind or type(value)
        self.coordinates = c or coordinates(value)
        self.function = self.coordinates is None and callable(value)
        self.inverse: Coordinates | None = None

    @property
    def value(self) -> Any:
        """The value, made of its coordinates when it is asked for."""
        if self._value is None and self.coordinates is not None:
            self._value = made(self.kind, self.coordinates)
        return self._value

    @property
    def dual(self) -> bool:
        """Whether the coordinates are those of a dual value."""
        return self.coordinates is not None and len(self.coordinates) > SIZES[self.kind]

    @property
    def key(self) -> tuple[Any, ...]:
        """That of the value."""
        if self.coordinates is None:
            return key(self.value)
        n, c = SIZES[self.kind], self.coordinates
        flat = c if len(c) == n else tuple([(re, du) if du else re for re, du in zip(c[:n], c[n:], strict=True)])
        return (*flat, 0, 0, 0) if n == 1 else (0, *flat) if n == 3 else flat

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


def offer(
    found: Table, kind: type, value: Coordinates, shape: Shape, marks: int, mark: Mark, parts: tuple[Item, ...]
) -> None:
    known = found.get((kind, value, shape))
    if known is None or marks < known.marks:
        found[kind, value, shape] = Item(None, shape, marks, mark, parts, kind, value)


def keep(found: Table, item: Item) -> None:
    value = item.coordinates or item.key
    known = found.get((item.kind, value, item.shape))
    if known is None or item.marks < known.marks:
        found[item.kind, value, item.shape] = item


def both_numerals(a: Item, b: Item) -> bool:
    return a.shape is b.shape is Shape.NUMERAL


def is_one(a: Item) -> bool:
    return a.shape is Shape.NUMERAL and bool(a.value == 1)


def is_multiple(a: Item) -> bool:
    """Of the identity."""
    c = a.coordinates
    return c is not None and len(c) == SIZES[Tensor] and c[0] == c[4] == c[8] and not any(c[1:4] + c[5:8])


def begins_with_numeral(a: Item) -> bool:
    while a.mark is not None:
        a = a.parts[0]
    return a.shape is Shape.NUMERAL


def by_function(a: Item) -> bool:
    return a.mark is not None and a.mark.name not in INSERTED


def brackets(a: Item) -> int:
    return 1 if a.shape is Shape.SUM else 0


def product_shape(a: Item) -> Shape:
    return Shape.LED if a.shape in (Shape.NUMERAL, Shape.LED) else Shape.PRODUCT
