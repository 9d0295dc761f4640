"""Programs prepared for batches of one size: their memory and views are made once.

For small batches most of the time of a recorded program goes into views of rows. Prepared programs keep the views.
"""

from __future__ import annotations

from collections import OrderedDict, deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from functools import lru_cache, partial
from itertools import groupby
from math import prod
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ._listing import Function
from ._packed import Packing
from ._program import COMPARISONS, Program, bits, call, truth_bytes

Array: TypeAlias = NDArray[Any]
Call: TypeAlias = Callable[[], Any]
Shape: TypeAlias = tuple[int, ...]

PREPARED_MAX = 1024
"""Largest batch for a prepared program; in larger batches, copies of rows cost more than views."""

PACKED_MAX = 320
"""Largest batch whose operations are packed; in larger batches, copies of rows cost more than calls."""

RUNS_BEFORE_PACKING = 32
"""Runs of a prepared program before its operations are packed: a plan takes as long as some hundred runs."""

KEPT_MAX = 32
"""Largest number of prepared programs kept between calls."""


class Prepared:
    """Recorded program with memory for a batch.

    ``parts`` are the shapes of the arguments, ``table`` is the number of table constants, ``shape`` that of the result.
    """

    def __init__(
        self, program: Program, parts: Sequence[Shape], table: int, shape: Shape, batch: Shape, axis: int
    ) -> None:
        self.program, self.parts, self.shape, self.batch, self.axis = program, parts, shape, batch, axis
        self.runs, self.cells, self.sizes = 0, prod(batch), [*map(prod, parts)]
        self._place(*_row_by_row(program, sum(self.sizes) + table, prod(shape), self.cells))

    def _place(self, rows: Array, made: Array, calls: Sequence[Call]) -> None:
        *blocks, numbers = np.split(rows, np.cumsum(self.sizes))
        laid_out = (_laid_out(block, part, self.batch, self.axis) for block, part in zip(blocks, self.parts))
        self.given, self.calls = [*laid_out, *numbers], calls
        self.result = _laid_out(made, self.shape, self.batch, self.axis)

    def run(self, given: Sequence[Array], result: Array) -> None:
        """Run on arguments that broadcast to the batch, then the table; they may share memory with the result."""
        self.runs += 1
        if self.runs == RUNS_BEFORE_PACKING and self.cells <= PACKED_MAX:
            self._place(*_packing(self.program.listing).calls(self.cells))
        for staged, array in zip(self.given, given):
            np.copyto(staged, array)
        deque(map(call, self.calls), maxlen=0)
        np.copyto(result, self.result, casting="same_kind")


_packing = lru_cache(256)(Packing)


def _row_by_row(program: Program, inputs: int, outputs: int, cells: int) -> tuple[Array, Array, list[Call]]:
    """Return rows for the inputs and for the results, and the calls that compute these, one for each operation."""
    sizes = np.cumsum([inputs, outputs, program.scratch, program.masks])
    given, block, scratch, masks = np.split(np.empty((sizes[-1], cells), program.dtype), sizes[:-1])
    made = [*block]
    rows = [*given, *program.constants, *made, *scratch, *program.mask_rows(masks)]
    raw = np.zeros(cells, bits(program.dtype) or np.int64)
    calls = [one for function, operands in program.calls(rows) for one in _calls(function, operands, raw)]
    constant = {id(number) for number in program.constants}
    kept = [one for one in calls if one.func is np.copyto and id(one.args[1]) in constant]
    for one in kept:  # constant results stay in their rows
        one()
    return given, block, [*_in_blocks([one for one in calls if one not in kept], made, block)]


def _in_blocks(calls: Sequence[partial[Any]], rows: Sequence[Array], block: Array) -> Iterator[partial[Any]]:
    """Yield the calls; copies from consecutive rows of a block to consecutive rows become one copy."""
    places = {id(row): place for place, row in enumerate(rows)}

    def distances(numbered: tuple[int, partial[Any]]) -> tuple[int, ...]:
        number, one = numbered
        copied = one.func is np.copyto and id(one.args[1]) in places
        return tuple(places[id(row)] - number for row in one.args) if copied else (number,)

    for distance, group in groupby(enumerate(calls), distances):
        (number, one), *others = group
        if others:
            target, source = (block[d + number : d + number + 1 + len(others)] for d in distance)
            one = partial(np.copyto, target, source)
        yield one


def _laid_out(rows: Array, part: Shape, batch: Shape, axis: int) -> Array:
    """Return a view of rows, one for each component, in the layout of an argument or a result."""
    array = rows.reshape(part + batch)
    return array if axis == 0 else array.transpose(*range(len(part), array.ndim), *range(len(part)))


def _calls(function: Function, operands: tuple[Array, ...], raw: Array) -> list[partial[Any]]:
    """Return prepared calls of a function; comparisons write booleans into ``raw`` first, without a temporary."""
    if function not in COMPARISONS:
        return [partial(function, *operands)]
    *given, mask = operands
    return [partial(COMPARISONS[function], *given, truth_bytes(raw)), partial(np.negative, raw, mask)]


_kept: OrderedDict[tuple[Program, Shape, int], Prepared] = OrderedDict()
"""Prepared programs, the last used at the end. Each method of it runs to its end before another thread runs."""


def run_prepared(
    program: Program,
    signature: Sequence[tuple[str, Shape]],
    shape: Shape,
    arguments: Sequence[Array],
    table: Sequence[Array],
    result: Array,
    batch: Shape,
    axis: int,
) -> None:
    """Run a program on a batch of at most ``PREPARED_MAX`` poses; concurrent and nested calls get their own memory."""
    key = program, batch, axis
    prepared = _kept.pop(key, None)
    if prepared is None:
        prepared = Prepared(program, [part for _, part in signature], len(table), shape, batch, axis)
    prepared.run([*arguments, *table], result)
    _kept[key] = prepared
    if len(_kept) > KEPT_MAX:
        with suppress(KeyError):  # other threads may have taken out all in between
            _kept.popitem(last=False)
