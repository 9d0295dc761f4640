"""Recorded programs for small batches, in which equal operations on adjacent rows are one call on a block of rows.

In small batches a call of NumPy costs more than its arithmetic. Operations of one depth with equal functions are packed
into a call, if their operands lie in order or can be copied together with fewer calls. Every result keeps its bits.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ._program import COMPARISONS, Function, Listing, where

Array: TypeAlias = NDArray[Any]
Place: TypeAlias = tuple[int, int, int]
Operand: TypeAlias = Place | int

ROW_COST = 0.1
"""Cost of an operation on a row of a small batch, as a share of that of a call."""

ON_BOOLEANS = {**COMPARISONS, np.bitwise_and: np.logical_and, np.bitwise_or: np.logical_or}


def copied(rows: Array, index: Array, out: Array) -> Callable[[], Any]:
    """Return a call that copies rows of another array; faster than indexing."""
    return partial(rows.take, index, 0, out, "clip")


@dataclass(eq=False)
class Packing:
    """Packed calls of a listing: blocks of entries, the memory of each, and steps in order.

    A place is a block, the first of its rows, and their number. An operand is a place, or a constant by its entry. A
    step without a function copies entries to a place. A block is kept in memory from its first step to its last one.
    """

    listing: Listing
    blocks: list[list[int]] = field(default_factory=list)
    memories: list[str] = field(default_factory=list)
    steps: list[tuple[Function | None, list[Operand], Place]] = field(default_factory=list)
    places: dict[int, list[tuple[int, int]]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        of = self.listing
        needed = [index for index in sorted(of.needed()) if of.operations[index]]
        self.uses = Counter(i for index in needed for i in self._operands(index)) + Counter(of.outputs)
        self.given = self._block("numbers", list(of.inputs))
        self._block("numbers", list(of.constants))
        depth = dict.fromkeys((*of.inputs, *of.constants), 0)
        groups: dict[tuple[int, Function], list[int]] = {}
        for index in needed:
            depth[index] = 1 + max(depth[i] for i in self._operands(index))
            groups.setdefault((depth[index], self._function(index)), []).append(index)
        for (_, function), group in sorted(groups.items(), key=lambda item: item[0][0]):
            self._pack(function, group)

    def _function(self, index: int) -> Function:
        operation = self.listing.operations[index]
        assert operation is not None
        return operation[0]

    def _operands(self, index: int) -> tuple[int, ...]:
        operation = self.listing.operations[index]
        assert operation is not None
        return operation[1]

    def _block(self, memory: str, entries: list[int]) -> Place:
        self.blocks.append(entries)
        self.memories.append(memory)
        block = len(self.blocks) - 1
        for row, entry in enumerate(entries):
            self.places.setdefault(entry, []).append((block, row))
        return block, 0, len(entries)

    def _found(self, entries: Sequence[int]) -> Operand | None:
        """Return where entries lie in order; None if they do not."""
        if entries[0] in self.listing.constants and len({*entries}) == 1:
            return entries[0]
        for block, row in self.places.get(entries[0], ()):
            if self.blocks[block][row : row + len(entries)] == entries:
                return block, row, len(entries)
        return None

    def _pack(self, function: Function, group: list[int]) -> None:
        """Add the steps of a group: the cheapest of some orders, in one call or in pieces whose operands lie in order."""
        cost, order, pieces = min((self._costs(order) for order in self._orders(group)), key=lambda made: made[0])
        for start, end in pieces:
            self._step(function, order[start:end])

    def _orders(self, group: list[int]) -> Iterator[list[int]]:
        def place(index: int, operand: int) -> tuple[int, int]:
            return self.places[self._operands(index)[operand]][-1]

        yield group
        if len(group) > 1:
            yield sorted(group, key=lambda index: (place(index, 0), place(index, -1)))
            yield sorted(group, key=lambda index: (place(index, -1), place(index, 0)))

    def _costs(self, order: list[int]) -> tuple[float, list[int], list[tuple[int, int]]]:
        columns = [list(column) for column in zip(*map(self._operands, order))]
        count = len(order)
        whole = 1 + sum(not self._found(column) for column in columns)
        pieces, start = [], 0
        while start < count:
            end = count
            while end > start + 1 and not all(self._found(column[start:end]) for column in columns):
                end -= 1
            pieces.append((start, end))
            start = end
        apart, together = len(pieces) + ROW_COST * count, whole * (1 + ROW_COST * count)
        return (apart, order, pieces) if apart <= together else (together, order, [(0, count)])

    def _step(self, function: Function, group: list[int]) -> None:
        memory = "truths" if group[0] in self.listing.truths else "numbers"
        columns = [list(column) for column in zip(*map(self._operands, group))]
        operands = [self._together(column) for column in columns]
        self.uses -= Counter(entry for column in columns for entry in column)
        if function is not where:
            self.steps.append((ON_BOOLEANS.get(function, function), operands, self._block(memory, group)))
            return
        *chosen, other = operands
        if isinstance(other, tuple) and self._is_free(other, memory):
            block, row, count = other  # written over
            self.blocks[block] = [*self.blocks[block][:row], *group, *self.blocks[block][row + count :]]
            for place, entry in enumerate(group, row):
                self.places[entry] = [(block, place)]
        else:
            made = self._block(memory, group)
            self.steps.append((np.copyto, [other], made))
            other = made
        self.steps.append((np.putmask, chosen, other))

    def _is_free(self, place: Place, memory: str) -> bool:
        """Tell whether no later step reads what lies at a place."""
        block, row, count = place
        entries = self.blocks[block][row : row + count]
        return block > 1 and self.memories[block] == memory and not any(self.uses[entry] for entry in entries)

    def _together(self, entries: list[int]) -> Operand:
        """Return where entries lie in order, perhaps after a step that copies them there."""
        found = self._found(entries)
        if found is None:
            kind = "copied truths" if entries[0] in self.listing.truths else "copied numbers"
            found = self._block(kind, entries)
            self.steps.append((None, [self._original(entry) for entry in entries], found))
        return found

    def _original(self, entry: int) -> Place:
        """Return the place of an entry that is no copy."""
        block, row = next(at for at in self.places[entry] if not self.memories[at[0]].startswith("copied"))
        return block, row, 1

    def layout(self) -> tuple[list[int], Mapping[str, int]]:
        """Return the first row of each block in its memory, and the number of rows of each memory.

        Rows of blocks that no later step reads or writes are used again.
        """
        last = {0: len(self.steps), 1: len(self.steps)} | {self._original(i)[0]: len(self.steps) for i in self.listing.outputs}
        first: dict[int, int] = {0: -1, 1: -1}
        for number, (_, operands, made) in enumerate(self.steps):
            for place in (*operands, made):
                if isinstance(place, tuple):
                    first.setdefault(place[0], number)
                    last[place[0]] = max(last.get(place[0], 0), number)
        starts, sizes, kept = [0] * len(self.blocks), Counter[str](), list[int]()
        for block in sorted(first, key=lambda block: first[block]):
            kept = [other for other in kept if last[other] >= first[block]]
            same = sorted((starts[o], starts[o] + len(self.blocks[o])) for o in kept if self.memories[o] == self.memories[block])
            row, count = 0, len(self.blocks[block])
            for start, end in same:
                if row + count <= start:
                    break
                row = max(row, end)
            starts[block] = row
            sizes[self.memories[block]] = max(sizes[self.memories[block]], row + count)
            kept.append(block)
        return starts, sizes

    def calls(self, cells: int) -> tuple[Array, Array, list[Callable[[], Any]]]:
        """Return rows for the arguments and for the result, and the calls that compute it, for a number of poses."""
        of = self.listing
        starts, sizes = self.layout()
        memory = {name: np.empty((size, cells), bool if name.endswith("truths") else of.dtype) for name, size in sizes.items()}
        numbers = {entry: np.array(value, of.dtype) for entry, value in of.constants.items()}
        for row, number in enumerate(numbers.values(), starts[1]):
            memory["numbers"][row] = number

        def rows(place: Operand) -> Array:
            if not isinstance(place, tuple):
                return numbers[place]
            start = starts[place[0]] + place[1]
            return memory[self.memories[place[0]]][start : start + place[2]]

        def index(places: Sequence[Operand]) -> Array:
            return np.array([starts[place[0]] + place[1] for place in places if isinstance(place, tuple)], np.intp)

        made: list[Callable[[], Any]] = []
        for function, operands, place in self.steps:
            given, out = [rows(operand).reshape(-1) if isinstance(operand, tuple) else rows(operand) for operand in operands], rows(place)
            if function is None:
                source = memory[self.memories[place[0]].removeprefix("copied ")]
                made.append(copied(source, index(operands), out))
            elif function in (np.putmask, np.copyto):
                made.append(partial(function, out.reshape(-1), *given))
            else:
                made.append(partial(function, *given, out.reshape(-1)))
        result = np.empty((len(of.outputs), cells), of.dtype)
        made.append(copied(memory["numbers"], index([self._original(entry) for entry in of.outputs]), result))
        return rows(self.given), result, made
