"""Words of a machine on symbols, and their parts.

A word is an integer, a tree, or a tuple of numbers that lie side by side, the lowest first. A tree of the kind
``choice`` stands for one of several words.
"""

from __future__ import annotations

from typing import Any

from .trees import Declined, Tree, Trees


def signed(value: int, width: int) -> int:
    """Return the signed integer of a pattern of some bytes."""
    return value - (1 << 8 * width) if value >> (8 * width - 1) & 1 else value


def ones(width: int) -> int:
    return (1 << 8 * width) - 1


def known(value: Any) -> int:
    if not isinstance(value, int):
        raise Declined("an integer depends on a number, or is unset")
    return value


class Words:
    """Words over the trees of one real type."""

    def __init__(self, trees: Trees) -> None:
        self.trees, self.unit = trees, trees.unit

    def part(self, word: Any, start: int, width: int) -> Any:
        """Return some bytes of a word."""
        if isinstance(word, int):
            return word >> 8 * start & ones(width)
        if isinstance(word, tuple):
            first, within = divmod(start, self.unit)
            if not within and not width % self.unit:
                cells = word[first : first + width // self.unit]
                return cells[0] if len(cells) == 1 else self.joined(*((cell, self.unit) for cell in cells))
            if within + width > self.unit:
                return self.trees.make("unknown", "part", word, start, width)
            return self.part(word[first], within, width)
        if word.kind == "choice":
            return self.trees.lift(lambda each: self.part(each, start, width), word)
        if word.kind == "joined":
            return self._within(word, start, width)
        whole, first, size = word.parts if word.kind == "part" else (word, 0, self.unit)
        if word is self.trees.unset or (not start and width == size):
            return word
        return self.trees.make("part", whole, first + start, width)

    def _within(self, word: Tree, start: int, width: int) -> Any:
        """Return some bytes of a word of unequal parts."""
        found, place = list[tuple[Any, int]](), 0
        for piece, size in word.parts:
            first, last = max(start, place), min(start + width, place + size)
            if first < last:
                found.append((self.part(piece, first - place, last - first), last - first))
            place += size
        return self.joined(*found)

    def cells(self, word: Any, width: int) -> list[Any]:
        """Return the numbers of a word, the lowest first."""
        return [self.part(word, start, self.unit) for start in range(0, width, self.unit)]

    def joined(self, *parts: tuple[Any, int]) -> Any:
        """Return the word of some parts with their widths, the lowest first."""
        if len(parts) == 1:
            return parts[0][0]
        if all(isinstance(word, int) for word, _ in parts):
            made = 0
            for word, width in reversed(parts):
                made = made << 8 * width | word
            return made
        whole = not any(width % self.unit for _, width in parts)
        chosen = any(isinstance(word, Tree) and word.kind == "choice" for word, _ in parts)
        if chosen and (not whole or sum(width for _, width in parts) == 8):  # an integer, as a result of a comparison
            widths = [width for _, width in parts]
            return self.trees.lift(lambda *words: self.joined(*zip(words, widths, strict=True)),
                                   *(word for word, _ in parts))  # fmt: skip
        if whole:
            return tuple(cell for word, width in parts for cell in self.cells(word, width))
        merged = list[tuple[Any, int]]()
        for word, width in parts:
            for piece, size in word.parts if isinstance(word, Tree) and word.kind == "joined" else [(word, width)]:
                merged.append((piece, size))
                while len(merged) > 1 and (one := self._adjacent(*merged[-2:])) is not None:
                    merged[-2:] = [one]
        return merged[0][0] if len(merged) == 1 else self.trees.make("joined", *merged)

    def _adjacent(self, low: tuple[Any, int], high: tuple[Any, int]) -> tuple[Any, int] | None:
        """Return two parts as one, if these are integers, parts of one number, or unset."""
        (a, width), (b, more) = low, high
        if isinstance(a, int) and isinstance(b, int):
            return a | b << 8 * width, width + more
        if a is b is self.trees.unset:
            return a, width + more
        if isinstance(a, Tree) and isinstance(b, Tree) and a.kind == b.kind == "part":
            whole, start, _ = a.parts
            if whole is b.parts[0] and b.parts[1] == start + width:
                every = width + more == self.unit
                return (whole if every else self.trees.make("part", whole, start, width + more)), width + more
        return None
