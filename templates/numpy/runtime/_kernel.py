"""Kernels and their execution on batches: recorded programs run block by block in reused scratch memory.

The batch is cut into blocks whose values fit into the cache. Components with gaps in memory, as in (N, 6), are copied
to scratch rows before a block and back after it. Rows of unit stride, as in (6, N), are read and written in place.
Operations on an argument of fewer poses, as one vector for many points, run once for each of these poses.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ._prepared import PREPARED_MAX, run_prepared
from ._program import Program, program_of

Array: TypeAlias = NDArray[Any]
Components: TypeAlias = Sequence[Any]
Rows: TypeAlias = Sequence[Array]
Result: TypeAlias = tuple[Any, ...]
Shape: TypeAlias = tuple[int, ...]

BLOCK = 16384
"""Largest number of elements of a block."""

SCATTERED_APART = 6
"""Most components of a result that are copied back one by one; NumPy's loop over them all is slower for so few."""

CACHE_LINE = 64
"""Size in bytes of a cache line and of the widest vector register; scratch rows are aligned to it."""


@dataclass(frozen=True, slots=True, eq=False)
class Kernel:
    """Geometry program with the names and shapes of its arguments.

    ``plain`` runs on numbers of any type and returns the components of the result. ``real`` is true if the program
    selects branches or angles, which complex numbers do not have.
    """

    plain: Callable[..., Result]
    arguments: tuple[tuple[str, Shape], ...]
    shape: Shape
    real: bool


class Scratch:
    """Pool of memory kept between calls, with one buffer per concurrent call."""

    def __init__(self) -> None:
        self._free: list[Array] = []

    def take(self, size: int) -> Array:
        """Return a buffer that begins on a cache line; a nested call, as in a signal handler, gets another buffer."""
        try:
            memory = self._free.pop()  # without a test before it: another thread may take the last one in between
        except IndexError:
            memory = np.empty(0, np.uint8)
        if memory.size < size:
            memory = np.empty(size + CACHE_LINE, np.uint8)
            memory = memory[-memory.ctypes.data % CACHE_LINE :]
        return memory

    def give_back(self, memory: Array) -> None:
        self._free.append(memory)


SCRATCH = Scratch()


def run(kernel: Kernel, program: Program, arguments: Rows, table: Rows, result: Array, axis: int) -> None:
    """Run a recorded program on arguments of any batch shapes.

    The program computes in the dtype of its constants. ``table`` holds the numbers of its table argument, if any. The
    result must share no memory with the arguments, unless the batch is `staged`.
    """
    batch = _batch_of(result, kernel.shape, axis)
    if staged(batch):
        if axis == 0:
            arguments = [_extended(array, part, batch) for array, (_, part) in zip(arguments, kernel.arguments)]
        run_prepared(program, kernel.arguments, kernel.shape, arguments, table, result, batch, axis)
        return
    kernel, program, arguments = _hoisted(kernel, program, arguments, table, batch, axis)
    rows = [_rows(array, part, axis, batch) for array, (_, part) in zip(arguments, kernel.arguments, strict=True)]
    loop = _Loop(kernel, program, rows, table, _rows(result, kernel.shape, axis, batch))
    memory = SCRATCH.take(loop.bytes(min(BLOCK, math.prod(batch))))
    try:
        for index in blocks(batch, BLOCK):
            loop.run(index, memory)
    finally:
        SCRATCH.give_back(memory)


def _hoisted(
    kernel: Kernel, program: Program, arguments: Rows, table: Rows, batch: Shape, axis: int
) -> tuple[Kernel, Program, Rows]:
    """Run what depends on arguments of fewer poses alone; return the rest, which takes these results as an argument."""
    owns = [_own(_batch_of(array, part, axis)) for array, (_, part) in zip(arguments, kernel.arguments)]
    for own in dict.fromkeys(own for own in owns if math.prod(own) < math.prod(batch)):
        few = tuple(place for place, of in enumerate(owns) if of == own)
        halves = _halves(program, tuple(part for _, part in kernel.arguments), few, len(table))
        if halves:
            first, program = halves
            shape = (len(first.listing.outputs),)
            taken = tuple(kernel.arguments[place] for place in few)
            laid = [part + own if axis == 0 else own + part for _, part in taken]
            given = [arguments[place].reshape(shaped) for place, shaped in zip(few, laid)]
            found = np.empty(shape + own if axis == 0 else own + shape, program.dtype)
            run(Kernel(kernel.plain, taken, shape, kernel.real), first, given, table, found, axis)
            kernel = Kernel(kernel.plain, (*kernel.arguments, ("", shape)), kernel.shape, kernel.real)
            arguments = [*arguments, found]
    return kernel, program, arguments


def _own(batch: Shape) -> Shape:
    """Return a batch shape without leading axes of length 1, but with one axis at least."""
    first = next((axis for axis, length in enumerate(batch) if length != 1), len(batch))
    return batch[first:] or (1,)


@lru_cache(256)
def _halves(
    program: Program, parts: tuple[Shape, ...], few: tuple[int, ...], table: int
) -> tuple[Program, Program] | None:
    """Return the programs of what depends on a few arguments alone, and of the rest; None if nothing does."""
    ends = list(itertools.accumulate(map(math.prod, parts), initial=0))
    halves = program.listing.split({i for place in few for i in range(ends[place], ends[place + 1])}, table)
    return (program_of(halves[0]), program_of(halves[1])) if halves else None


def staged(batch: Shape) -> bool:
    """Tell whether a batch runs in memory of its own, to which its arguments are copied first."""
    return math.prod(batch) <= min(PREPARED_MAX, BLOCK)


class _Loop:
    """Loop over blocks of a batch: gather, compute, scatter."""

    def __init__(self, kernel: Kernel, program: Program, rows: Rows, table: Rows, target: Array) -> None:
        self.shape = kernel.shape
        self.program = program
        self.dtype = program.dtype
        self.target = target
        self.scattered = not _unit_stride(target, self.dtype)
        self.arguments = []
        self.count = program.scratch + program.masks + self.scattered * math.prod(kernel.shape)
        for array, (_, part) in zip(rows, kernel.arguments, strict=True):
            gathered = not _unit_stride(array, self.dtype, broadcast=True)
            self.arguments.append((array, part, gathered))
            self.count += gathered * math.prod(part)
        self.fixed = [*table, *program.constants]

    def bytes(self, cells: int) -> int:
        """Return the number of bytes for a block whose rows all begin on a cache line."""
        return self.count * _padded(cells, self.dtype) * self.dtype.itemsize

    def run(self, index: Any, memory: Array) -> None:
        """Run one block of the batch."""
        target = self.target[(slice(None),) * len(self.shape) + index]
        shape = target.shape[len(self.shape) :]
        spare = self._split(memory, shape)
        rows: list[Array] = []
        for array, part, gathered in self.arguments:
            block = array[(slice(None),) * len(part) + index]
            if gathered:
                staged, spare = _cut(spare, math.prod(part))
                np.copyto(staged.reshape(part + shape), block)
                rows.extend(staged)
            else:
                rows += [block[i] for i in components(part)]
        rows += self.fixed
        own, spare = _cut(spare, self.scattered * math.prod(self.shape))
        rows += [*own] if self.scattered else [target[i] for i in components(self.shape)]
        scratch, masks = _cut(spare, self.program.scratch)
        rows += [*scratch, *self.program.mask_rows(masks)]
        self.program.run(rows)
        if self.scattered:
            made = own.reshape(target.shape)
            for place in components(self.shape) if len(own) <= SCATTERED_APART else (...,):
                np.copyto(target[place], made[place], casting="same_kind")

    def _split(self, memory: Array, shape: Shape) -> Array:
        """Split memory into scratch rows of the given block shape."""
        cells = math.prod(shape)
        width = _padded(cells, self.dtype)
        rows = memory[: self.count * width * self.dtype.itemsize].view(self.dtype).reshape(self.count, width)
        return rows[:, :cells].reshape(self.count, *shape)


def blocks(batch: Shape, size: int) -> Iterator[tuple[Any, ...]]:
    """Yield indices of nearly equal pieces of a batch with at most ``size`` elements; inner axes stay whole."""
    axis, inner = len(batch), 1
    while axis and inner * batch[axis - 1] <= size:
        axis -= 1
        inner *= batch[axis]
    if not axis:
        yield ()
        return
    length = batch[axis - 1]
    pieces = -(-length // (size // inner))
    step = -(-length // pieces)
    for outer in np.ndindex(batch[: axis - 1]):
        for start in range(0, length, step):
            yield (*outer, slice(start, start + step))


@cache
def components(part: Shape) -> tuple[Shape, ...]:
    """Return the indices of the components of an argument or a result, in C order."""
    return tuple(np.ndindex(part))


def _batch_of(array: Array, part: Shape, axis: int) -> Shape:
    return array.shape[len(part) :] if axis == 0 else array.shape[: array.ndim - len(part)]


def _rows(array: Array, part: Shape, axis: int, batch: Shape) -> Array:
    """Return a view of shape ``part + batch``."""
    if axis == -1:
        order = (*range(array.ndim - len(part), array.ndim), *range(array.ndim - len(part)))
        array = array.transpose(order)
    return array if array.shape == part + batch else np.broadcast_to(_extended(array, part, batch), part + batch)


def _extended(array: Array, part: Shape, batch: Shape) -> Array:
    """Return an array of shape ``part`` and fewer axes with axes of length 1 for all those of the batch."""
    missing = len(part) + len(batch) - array.ndim
    return array[(slice(None),) * len(part) + (np.newaxis,) * missing] if missing else array


def _unit_stride(rows: Array, dtype: np.dtype[Any], broadcast: bool = False) -> bool:
    """Tell whether components can be used in place; ``broadcast`` also allows one repeated value."""
    return rows.dtype == dtype and (rows.strides[-1] == dtype.itemsize or (broadcast and not rows.strides[-1]))


def _padded(cells: int, dtype: np.dtype[Any]) -> int:
    """Return the padded length of a scratch row, so that the next row begins on a cache line."""
    return -(-cells * dtype.itemsize // CACHE_LINE) * CACHE_LINE // dtype.itemsize


def _cut(rows: Array, count: int) -> tuple[Array, Array]:
    return rows[:count], rows[count:]
