"""All readings of one side of an equation: a table of the values that each stretch of its tokens can have.

Longer stretches are put together from shorter ones, by `combine.Combine`. Readings with the same value are one; the one
with fewest added marks stands for it. A table that grows beyond the cap is left open.
"""

from __future__ import annotations

from collections.abc import Sequence

from ..language.evaluation import Env
from ..language.notation import pm
from ..language.terms import Number
from .combine import WIDEST, Combine
from .items import OpenError, Table, key, leaf
from .tokens import Place, Token

CAP = 10_000
"""Distinct readings beyond which they are not counted, and no true one is looked for one by one."""


class Side:
    """The readings of one side.

    Parameters
    ----------
    tokens : sequence of Token
    env : Env
        Where the letters have their values, over residues.
    radicals, quaternions : bool
        Whether radicals are put in, and whether numbers and vectors make quaternions.
    cap : int
        How many readings of a stretch are listed.
    """

    def __init__(
        self, tokens: Sequence[Token], env: Env, radicals: bool = True, quaternions: bool = True, cap: int = CAP
    ) -> None:
        self.radicals, self.quaternions = radicals, quaternions
        self.either = bool(tokens) and tokens[0].mark is pm
        self.tokens = tuple(tokens[1:] if self.either else tokens)
        self.combine = Combine(env, radicals, quaternions, cap)
        self.env = env
        self.cap = cap
        self.tables: dict[tuple[int, int], Table | None] = {}

    def readings(self) -> Table:
        """The whole side by value; `OpenError` beyond the cap."""
        table = self.table(0, len(self.tokens))
        signed = dict(table)
        if not self.either:
            self.combine.opposite(table, signed)
        found: Table = {}
        for item in sorted(signed.values(), key=lambda item: item.marks):
            if not item.function:
                found.setdefault(key(self.env.now(item.value)) if self.env.moving else item.key, item)
        if len(found) > self.cap:
            raise OpenError
        return found

    def table(self, i: int, j: int) -> Table:
        """The readings of a stretch, by value and looks; `OpenError` beyond the cap."""
        if (i, j) not in self.tables:
            try:
                self.tables[i, j] = self._table(i, j)
            except OpenError:
                self.tables[i, j] = None
        table = self.tables[i, j]
        if table is None:
            raise OpenError
        return table

    def _table(self, i: int, j: int) -> Table:
        found: Table = {}
        first, last = self.tokens[i], self.tokens[j - 1]
        if j - i == 1:
            if first.term is not None:
                found[first] = leaf(first.term, self.env.value(first.term), isinstance(first.term, Number))
        else:
            if first.place is Place.BEFORE and first.mark is not None and j - i <= WIDEST + 1:
                self.combine.at_one(first.mark, self.table(i + 1, j), found)
            if last.place is Place.AFTER and last.mark is not None:
                self.combine.at_one(last.mark, self.table(i, j - 1), found)
            for g in range(i + 1, j):
                self._split(i, g, j, found)
        self.combine.around(found, bars=j - i <= WIDEST)
        return found

    def _split(self, i: int, g: int, j: int, found: Table) -> None:
        token = self.tokens[g]
        if token.place is Place.AFTER:
            return
        between = token.place is Place.BETWEEN
        right = (g + 1, j) if between else (g, j)
        if right[0] < right[1] and (first := self.table(i, g)):
            if between and token.mark is not None:
                self.combine.between(token.mark, first, self.table(*right), found)
            else:
                self.combine.beside(first, self.table(*right), found, inner=j - g <= WIDEST)
        if len(found) > self.cap:
            raise OpenError
