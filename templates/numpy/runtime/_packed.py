"""Recorded programs for small batches, in which equal operations on adjacent rows are one call on a block of rows.

In small batches a call of NumPy costs more than its arithmetic. Equal functions whose operands are made are packed into
a call, if their operands lie in order or can be copied together with fewer calls. Every result keeps its bits.
"""

from __future__ import annotations

import itertools
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ._listing import Function, Listing, where
from ._program import COMPARISONS

Array: TypeAlias = NDArray[Any]
Place: TypeAlias = tuple[int, int, int]
Operand: TypeAlias = Place | int

COPIED = "copied "
"""Prefix of the names of memories for copies: rows are copied faster from one array to another."""

ON_BOOLEANS: Mapping[Function, Function] = {**COMPARISONS, np.bitwise_and: np.logical_and, np.bitwise_or: np.logical_or}
"""Functions on truth values that are booleans, by those of recorded programs."""


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
        for function, group in self._groups(needed):
            self._pack(function, group)

    def _groups(self, needed: Sequence[int]) -> Iterator[tuple[Function, list[int]]]:
        """Yield operations after their operands: at once those of a function whose operands are made.

        Of all functions it is the one whose operations are the farthest from the outputs, on average.
        """
        readers, ready = defaultdict[int, list[int]](list), defaultdict[Function, list[int]](list)
        for index in needed:
            for operand in {*self._operands(index)}:
                readers[operand].append(index)
        missing, far = {index: len({*self._operands(index)}) for index in needed}, dict[int, int]()
        for index in reversed(needed):
            far[index] = 1 + max((far[reader] for reader in readers[index]), default=0)

        def free(made: Iterable[int]) -> None:
            for reader in (reader for index in made for reader in readers[index]):
                missing[reader] -= 1
                if not missing[reader]:
                    ready[self._function(reader)].append(reader)

        free((*self.listing.inputs, *self.listing.constants))
        while ready:
            function = max(ready, key=lambda of: sum(map(far.__getitem__, ready[of])) / len(ready[of]))
            group = sorted(ready.pop(function))
            yield function, group
            free(group)

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
        length, found = self._longest(entries, 0)
        return found if length == len(entries) else None

    def _longest(self, entries: Sequence[int], start: int) -> tuple[int, Operand]:
        """Return how many entries lie in order from a start on, at most, and where."""
        first, most = entries[start], len(entries) - start
        if first in self.listing.constants:
            same = next((i for i in range(most) if entries[start + i] != first), most)
            if same == most or same > 1:
                return same, first
        best: tuple[int, Operand] = (0, first)
        for block, row in self.places[first]:
            lie = self.blocks[block]
            room, count = min(most, len(lie) - row), 1
            while count < room and lie[row + count] == entries[start + count]:
                count += 1
            if count > best[0]:
                best = count, (block, row, count)
        return best

    def _pack(self, function: Function, group: list[int]) -> None:
        """Add the steps of a group, in the order and the parts that need the fewest calls."""
        least, best = len(group) + 1, [group]
        for order in self._orders(group) if len(group) > 1 else ():
            calls, parts = self._cut(order)
            if calls < least:
                least, best = calls, parts
            if least == 1:
                break
        for part in best:
            self._step(function, part)

    def _orders(self, group: list[int]) -> Iterator[list[int]]:
        """Yield orders of a group: as recorded, and by the places of the first or of the last operands."""
        yield group
        ends = {index: [self.places[self._operands(index)[end]][-1] for end in (0, -1)] for index in group}
        yield sorted(group, key=lambda index: ends[index])
        yield sorted(group, key=lambda index: ends[index][::-1])

    def _cut(self, order: list[int]) -> tuple[int, list[list[int]]]:
        """Return the calls of an order and its parts: pieces whose operands lie in order, or all of it after copies."""
        columns, pieces, start = [*zip(*map(self._operands, order))], list[list[int]](), 0
        whole = len(order)
        while start < len(order):
            lengths = [self._longest(column, start)[0] for column in columns]
            if not start:
                whole = 1 + sum(length < len(order) for length in lengths)
            elif len(pieces) == whole:
                return whole, [order]
            pieces.append(order[start : start + min(lengths)])
            start += min(lengths)
        return len(pieces), pieces

    def _step(self, function: Function, group: list[int]) -> None:
        """Add a call for a group, after copies of operands that do not lie in order."""
        memory = "truths" if group[0] in self.listing.truths else "numbers"
        columns = [*zip(*map(self._operands, group))]
        operands = [self._together(column) for column in columns]
        self.uses.subtract(itertools.chain.from_iterable(columns))
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

    def _together(self, entries: Sequence[int]) -> Operand:
        """Return where entries lie in order, perhaps after a step that copies them there."""
        found = self._found(entries)
        if found is None:
            kind = "truths" if entries[0] in self.listing.truths else "numbers"
            found = self._block(COPIED + kind, [*entries])
            self.steps.append((None, [self._original(entry) for entry in entries], found))
        return found

    def _original(self, entry: int) -> Place:
        """Return the place of an entry that is no copy."""
        block, row = next(at for at in self.places[entry] if not self.memories[at[0]].startswith(COPIED))
        return block, row, 1

    @cached_property
    def layout(self) -> tuple[Sequence[int], Mapping[str, int]]:
        """Return the first row of each block in its memory, and the number of rows of each memory.

        Rows of blocks that no later step reads or writes are used again.
        """
        end = len(self.steps)
        first, last = {0: -1, 1: -1}, {0: end, 1: end}
        for number, (_, operands, made) in enumerate(self.steps):
            for block in (place[0] for place in (*operands, made) if isinstance(place, tuple)):
                first.setdefault(block, number)
                last[block] = max(last.get(block, 0), number)
        last |= {self._original(entry)[0]: end for entry in self.listing.outputs}
        starts, sizes, kept = [0] * len(self.blocks), dict[str, int](), list[int]()
        for block in sorted(first, key=lambda block: first[block]):
            memory, count, row = self.memories[block], len(self.blocks[block]), 0
            kept = [other for other in kept if last[other] >= first[block]]
            same = (other for other in kept if self.memories[other] == memory)
            for start, size in sorted((starts[other], len(self.blocks[other])) for other in same):
                if row + count <= start:
                    break
                row = max(row, start + size)
            starts[block] = row
            sizes[memory] = max(sizes.get(memory, 0), row + count)
            kept.append(block)
        return starts, sizes

    def calls(self, cells: int) -> tuple[Array, Array, list[Callable[[], Any]]]:
        """Return rows for the arguments and for the result, and the calls that compute it, for a number of poses."""
        of, (starts, sizes) = self.listing, self.layout
        types = {name: bool if name.endswith("truths") else of.dtype for name in sizes}
        memory = {name: np.empty((size, cells), types[name]) for name, size in sizes.items()}
        numbers = {entry: np.array(value, of.dtype) for entry, value in of.constants.items()}
        for row, number in enumerate(numbers.values(), starts[1]):
            memory["numbers"][row] = number

        def table(block: int, row: int, count: int) -> Array:
            return memory[self.memories[block]][starts[block] + row : starts[block] + row + count]

        def rows(operand: Operand) -> Array:
            return table(*operand).reshape(-1) if isinstance(operand, tuple) else numbers[operand]

        def copies(places: Sequence[Operand], source: str, out: Array) -> Callable[[], Any]:
            index = [starts[place[0]] + place[1] for place in places if isinstance(place, tuple)]
            return partial(memory[source].take, np.array(index, np.intp), 0, out, "clip")  # faster than by an index

        made: list[Callable[[], Any]] = []
        for function, operands, place in self.steps:
            if function is None:
                source = self.memories[place[0]].removeprefix(COPIED)
                made.append(copies(operands, source, table(*place)))
            elif function in (np.putmask, np.copyto):
                made.append(partial(function, rows(place), *map(rows, operands)))
            else:
                made.append(partial(function, *map(rows, operands), rows(place)))
        result = np.empty((len(of.outputs), cells), of.dtype)
        made.append(copies([self._original(entry) for entry in of.outputs], "numbers", result))
        return table(*self.given), result, made
