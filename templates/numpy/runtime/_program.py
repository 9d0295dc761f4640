"""Recorded programs: lists of NumPy calls on rows, in an order that frees rows early.

Each call writes its result into a row. Truth values are masks. For float32 and float64 a mask has all bits set or none,
and selects without a temporary. For other types masks are booleans.
"""

from __future__ import annotations

import operator
import sys
from collections import deque
from collections.abc import Iterable, Iterator, Sequence, Set
from dataclasses import dataclass
from functools import cache
from itertools import groupby
from operator import itemgetter
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ._listing import Function, Listing, Operation

Array: TypeAlias = NDArray[Any]
Run: TypeAlias = tuple[tuple[Function, ...], tuple["itemgetter[Any]", ...]]


def _call(function: Function, *arguments: Any) -> Any:
    """Return the result of a function; Python 3.10, where a folder of kernels runs too, has no ``operator.call``."""
    return function(*arguments)


call: Function = getattr(operator, "call", _call)
"""``operator.call``: a call without bytecode in a loop of `map`."""

BITWISE = (np.bitwise_and, np.bitwise_or, np.bitwise_xor)
"""Bitwise operations on masks and on the bits of numbers."""

LONG_RUN = 6
"""Least number of consecutive calls with equally many operands that run in one loop without bytecode."""


@cache
def bits(dtype: np.dtype[Any]) -> np.dtype[Any] | None:
    """Return the integer type of masks for numbers of a dtype, or None if masks are booleans."""
    return np.dtype(f"i{dtype.itemsize}") if dtype in (np.float64, np.float32) else None


def less(a: Array, b: Array, out: Array) -> None:
    """Set all bits of ``out`` where a < b, else none."""
    np.copyto(out, np.less(a, b))
    np.negative(out, out)


def equal(a: Array, b: Array, out: Array) -> None:
    """Set all bits of ``out`` where a equals b, else none."""
    np.copyto(out, np.equal(a, b))
    np.negative(out, out)


COMPARISONS: dict[Function, Function] = {less: np.less, equal: np.equal}
"""Comparisons on booleans, by the comparisons that set bits."""


def truth_bytes(row: Array) -> Array:
    """Return a view of the lowest byte of each integer of a row, as booleans."""
    place = 0 if sys.byteorder == "little" else -1
    return row.view(np.bool_).reshape(*row.shape, row.itemsize)[..., place]


@dataclass(frozen=True, slots=True, eq=False)
class Program:
    """Recorded program: calls of ``function(*operands, out)`` on rows, in order.

    Rows are numbered in the order: components of arguments, constants, outputs, ``scratch`` rows, rows of ``masks``,
    integer views of the rows in ``views``. A run holds the functions of calls with equally many operands. It has one
    column of rows for each operand and for ``out``. A single call keeps all its rows in one column. ``listing`` holds
    the operations as they were recorded.
    """

    dtype: np.dtype[Any]
    runs: tuple[Run, ...]
    constants: tuple[Array, ...]
    scratch: int
    masks: int
    views: tuple[int, ...]
    listing: Listing

    def run(self, rows: list[Array]) -> None:
        """Run every call on rows, given up to the masks; outputs must share no memory with arguments."""
        rows += self._integer_views(rows)
        for functions, columns in self.runs:
            if len(functions) == 1:
                functions[0](*columns[0](rows))
            else:
                deque(map(call, functions, *[column(rows) for column in columns]), maxlen=0)

    def calls(self, rows: list[Array]) -> Iterator[tuple[Function, tuple[Array, ...]]]:
        """Yield each function with its rows, the operands and ``out``; the given rows are those of `run`."""
        rows = rows + self._integer_views(rows)
        for functions, columns in self.runs:
            if len(functions) == 1:
                yield functions[0], columns[0](rows)
            else:
                yield from zip(functions, zip(*[column(rows) for column in columns], strict=True), strict=True)

    def _integer_views(self, rows: list[Array]) -> list[Array]:
        integer = bits(self.dtype)
        return [] if integer is None else [rows[row].view(integer) for row in self.views]

    def mask_rows(self, rows: Array) -> Array:
        """Return mask rows of the shape of the given scratch rows; a view of these rows if masks are bits."""
        integer = bits(self.dtype)
        return np.empty(rows.shape, bool) if integer is None else rows.view(integer)


def program_of(listing: Listing) -> Program:
    """Return the program with the fewer scratch rows, of the order depth first and that of recording."""
    of = listing if bits(listing.dtype) is None else listing.on_bits()
    fixed, first = [*of.inputs, *of.constants], ordered(of.operations, of.outputs)
    both = [Rows(of.operations, of.truths, fixed, of.outputs, order) for order in (first, sorted(first))]
    rows = min(both, key=lambda rows: rows.scratch.size)
    runs = tuple(rows.runs())
    numbers = tuple(np.array(value, of.dtype) for value in of.constants.values())
    return Program(of.dtype, runs, numbers, rows.scratch.size, rows.masks.size, tuple(rows.views), listing)


def ordered(operations: Sequence[Operation | None], outputs: Iterable[int]) -> list[int]:
    """Return the operations for the outputs, depth first; operands that need most rows come first (Sethi, Ullman)."""
    needs = [0] * len(operations)
    for index, operation in enumerate(operations):
        if operation:
            read = sorted((needs[i] for i in set(operation[1])), reverse=True)
            needs[index] = max([1, *(held + need for held, need in enumerate(read))])
    order: dict[int, None] = {}
    pending = list(outputs)[::-1]
    while pending:
        operation = operations[pending[-1]]
        missing = {i for i in operation[1] if operations[i] and i not in order} if operation else set()
        if missing:
            pending += sorted(missing, key=lambda i: (needs[i], -i))
            continue
        index = pending.pop()
        if operation:
            order[index] = None
    return list(order)


class _Bank:
    """Pool of reusable rows of one kind; the row freed last is taken first."""

    def __init__(self) -> None:
        self.size = 0
        self.free: list[int] = []

    def take(self) -> int:
        if self.free:
            return self.free.pop()
        self.size += 1
        return self.size - 1


class Rows:
    """Assignment of a row to every entry of a tape: an output's own row, or a row of scratch that is used again.

    Entries are ``operations`` on earlier entries, run in an ``order``. The entries in ``fixed`` are None: arguments and
    constants.
    """

    def __init__(
        self, operations: Sequence[Operation | None], truths: Set[int], fixed: Sequence[int], outputs: Sequence[int],
        order: Sequence[int],
    ) -> None:  # fmt: skip
        self.operations, self.truths, self.fixed, self.outputs, self.order = operations, truths, fixed, outputs, order
        self.scratch, self.masks = _Bank(), _Bank()
        self.views: dict[int, int] = {}
        made = {index: step for step, index in enumerate(order)}
        self.last = {i: step for step, index in enumerate(order) for i in self._operation(index)[1]}
        self.own = {index: row for row, index in reversed(list(enumerate(outputs))) if index in made}
        self.placed = self._placed()

    def runs(self) -> Iterator[Run]:
        """Yield long runs of calls as columns of rows, and all other calls one by one."""
        start = {"fixed": 0, "output": len(self.fixed)}
        start["scratch"] = start["output"] + len(self.outputs)
        start["mask"] = start["scratch"] + self.scratch.size
        placed = self.placed
        calls = [(f, [self._number(f, kind, start[kind] + row, start) for kind, row in places]) for f, places in placed]
        for _, group in groupby(calls, key=lambda made: len(made[1])):
            run = list(group)
            if len(run) < LONG_RUN:
                yield from (((function,), (itemgetter(*rows),)) for function, rows in run)
            else:
                functions, rows = zip(*run, strict=True)
                yield functions, tuple(itemgetter(*column) for column in zip(*rows, strict=True))

    def _number(self, function: Function, kind: str, row: int, start: dict[str, int]) -> int:
        """Return the index of a row or, for bitwise operations on numbers, of its integer view."""
        if function not in BITWISE or kind == "mask":
            return row
        return self.views.setdefault(row, start["mask"] + self.masks.size + len(self.views))

    def _placed(self) -> list[tuple[Function, list[tuple[str, int]]]]:
        """Return each call with the places (kind and row) of its operands and its result."""
        places: dict[int, tuple[str, int]] = {index: ("fixed", row) for row, index in enumerate(self.fixed)}
        found: list[tuple[Function, list[tuple[str, int]]]] = []
        for step, index in enumerate(self.order):
            function, operands = self._operation(index)
            self._release(step, operands, places)
            places[index] = self._place(index)
            found.append((function, [*(places[i] for i in operands), places[index]]))
        return [*found, *self._copies(places)]

    def _copies(self, places: dict[int, tuple[str, int]]) -> Iterator[tuple[Function, list[tuple[str, int]]]]:
        """Yield copies to the outputs that no call writes; consecutive outputs have consecutive sources if possible."""
        # Source of the last copy, and first target of its block. A block is copied at once, so that all of its sources
        # must lie before its first target.
        kind, place, first = "", 0, 0
        for row, index in enumerate(self.outputs):
            if self.own.get(index) == row:
                kind = ""
                continue
            place += 1
            if kind != "output" or place == first or self.outputs[place] != index:
                (kind, place), first = places[index], row
            yield np.copyto, [("output", row), (kind, place)]

    def _operation(self, index: int) -> Operation:
        operation = self.operations[index]
        assert operation is not None, "arguments and constants are in no order"
        return operation

    def _place(self, index: int) -> tuple[str, int]:
        """Return a place for the result of a step: a row of masks, its own output row, or a row of scratch."""
        if index in self.truths:
            return "mask", self.masks.take()
        if index in self.own:
            return "output", self.own[index]
        return "scratch", self.scratch.take()

    def _release(self, step: int, operands: Iterable[int], places: dict[int, tuple[str, int]]) -> None:
        """Free the rows of operands that no later step reads."""
        for index in dict.fromkeys(operands):
            kind, row = places[index]
            if self.last[index] == step and kind in ("scratch", "mask"):
                (self.scratch if kind == "scratch" else self.masks).free.append(row)
