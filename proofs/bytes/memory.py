"""Memory and registers: words by address."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .trees import Tree
from .words import Words


class Memory(dict[int, Any]):
    """Cells of one number by address; what was not stored is unset."""

    def __init__(self, words: Words, cells: Mapping[int, Any] | None = None) -> None:
        super().__init__(cells or {})
        self.words, self.unit = words, words.unit

    def copy(self) -> Memory:
        return Memory(self.words, self)

    def __missing__(self, address: int) -> Tree:
        return self.words.trees.unset

    def put(self, address: int, word: Any, width: int) -> None:
        """Store a word; a cell of which it is a part keeps the rest."""
        first = address % self.unit
        if not first and width == self.unit:
            self[address] = word
            return
        part, start = self.words.part, 0
        while start < width:
            first = (address + start) % self.unit
            size, cell = min(self.unit - first, width - start), address + start - first
            own, rest = part(word, start, size), self.unit - first - size
            old = self[cell]
            pieces = [(part(old, 0, first), first), (own, size), (part(old, first + size, rest), rest)]
            self[cell] = self.words.joined(*(piece for piece in pieces if piece[1]))
            start += size

    def take(self, address: int, width: int) -> Any:
        """Return the word at an address."""
        first = address % self.unit
        if not first and width == self.unit:
            return self[address]
        if first + width <= self.unit:
            return self.words.part(self[address - first], first, width)
        pieces, start = [], 0
        while start < width:
            first = (address + start) % self.unit
            size = min(self.unit - first, width - start)
            cell = self[address + start - first]
            pieces.append((cell if size == self.unit else self.words.part(cell, first, size), size))
            start += size
        return self.words.joined(*pieces)
