"""Points at which a claim is evaluated: coordinates of its letters, and what is known of them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import chain
from typing import Any

from ..language.printed import Symbol, Term
from ..numbers.balls import arb
from ..numbers.kinds import Numbers

Coordinates = Mapping[Symbol, Numbers]


@dataclass(frozen=True)
class Place:
    """Point at which a claim is evaluated.

    `generic` points are drawn without relation between letters and near 1, where a region of truth shows; `pair` ones
    have two special letters. `on` tells what is special about a point that lies on a zero set.
    """

    label: str
    at: Coordinates
    generic: bool = False
    on: str = ""
    parts: Mapping[Symbol, Numbers] = field(default_factory=dict)  # dual parts and rates, if not by a fixed seed
    pair: bool = False
    zero: Term | None = None  # number that certainly vanishes somewhere in the balls of the coordinates
    known: Mapping[Term, Term] = field(default_factory=dict)  # parts with a value that is certain there
    turns: dict[Symbol, tuple[Numbers, Numbers]] = field(default_factory=dict)  # coordinates, and those over π

    @property
    def exact(self) -> bool:
        """Whether all numbers are rational, or rational multiples of π."""
        rows = chain((row for a, row in self.at.items() if self.over_pi(a) is None), self.parts.values())
        return all(isinstance(c, int | Fraction) for c in _numbers(rows))

    def over_pi(self, letter: Symbol) -> Numbers | None:
        """Return the coordinates of a letter over π, if they are known to be rational."""
        coordinates, over = self.turns.get(letter, (None, ()))
        return over if coordinates is self.at[letter] else None

    @property
    def sharp(self) -> bool:
        """Whether all numbers have no error."""
        rows = chain(self.at.values(), self.parts.values())
        return all(arb(c).is_exact() or isinstance(c, Fraction) for c in _numbers(rows))


def _numbers(rows: Iterable[Any]) -> Iterator[Any]:
    """Yield the numbers of rows of coordinates, and those that stand alone."""
    for row in rows:
        yield from row if isinstance(row, Iterable) else (row,)
