"""Call a C function as its header says it may be called: single values, rows with strides, results over arguments."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from ..rows import Function
from .c_interpreter import UNSET, CError, Pointer, Unit

Flat = tuple[Any, ...]


@dataclass(frozen=True, slots=True)
class Placed:
    """An array of ``size`` components for ``count`` values in memory: component i of value j at ``i * stride + j``."""

    pointer: Pointer
    size: int
    count: int = 1
    stride: int = 1

    @classmethod
    def new(cls, rows: Sequence[Flat], stride: int = 1) -> Placed:
        """An array with these values, in cells of its own; those between its rows are not set."""
        size = len(rows[0])
        cells = [UNSET] * ((size - 1) * stride + len(rows))
        for j, row in enumerate(rows):
            cells[j : (size - 1) * stride + j + 1 : stride] = row
        return cls(Pointer.to(cells), size, len(rows), stride)

    @property
    def rows(self) -> list[Flat]:
        """The values; an error where a component is not set."""
        steps = [i * self.stride for i in range(self.size)]
        return [tuple(self.pointer.moved(step + j).load() for step in steps) for j in range(self.count)]

    def require_gaps(self) -> None:
        """An error where a cell that holds no component has been written."""
        for i, value in enumerate(self.pointer.cells):
            if i % self.stride >= self.count and value is not UNSET:
                raise CError(f"cell {i} was written: that is beyond {self.count} values, stride {self.stride}")


@dataclass(frozen=True, slots=True)
class Kernel:
    """A function of a header, with its row of a table and perhaps a branch: flat arguments in, the flat result out."""

    unit: Unit
    prefix: str
    row: Function
    branch: tuple[int, ...] = ()

    @property
    def name(self) -> str:
        """What it is called in C."""
        return f"{self.prefix}_{self.row.name}"

    def plain(self, arguments: Sequence[Flat]) -> Flat:
        """One value, every array in its own memory."""
        given = [Placed.new([argument]) for argument in arguments]
        return self._one(given, [_unset(array.size) for array in self.row.results])

    def shared(self, arguments: Sequence[Flat], start: int) -> Flat:
        """One value, all arrays in one piece of memory: results from ``start`` on, arguments behind their length."""
        sizes = [array.size for array in self.row.results]
        cells = [UNSET] * sum(sizes) + [c for argument in arguments for c in argument] + [UNSET] * sum(sizes)
        given = _consecutive(cells, sum(sizes), [len(argument) for argument in arguments])
        return self._one(given, _consecutive(cells, start, sizes))

    def rows(self, batch: Sequence[Sequence[Flat]], over: int | None = None) -> list[Flat]:
        """Several values, every array with a stride of its own; the result may take the place of an argument."""
        count = len(batch)
        columns = list(zip(*batch, strict=True))
        given = [Placed.new(column, count + i) for i, column in enumerate(columns, 1)]
        results = [_unset(array.size, count, count + i) for i, array in enumerate(self.row.results, len(given) + 1)]
        if over is not None:
            results[0] = _over(given[over], results[0].size)
        passed = [item for array in given for item in (array.pointer, array.stride)]
        made = [item for array in results for item in (array.pointer, array.stride)]
        self.unit.call(f"{self.name}_rows", count, *passed, *self.branch, *made)
        for array in results:
            array.require_gaps()
        return [tuple(c for part in parts for c in part) for parts in zip(*(a.rows for a in results), strict=True)]

    def _one(self, given: Sequence[Placed], results: Sequence[Placed]) -> Flat:
        pointers = [array.pointer for array in given]
        self.unit.call(self.name, *pointers, *self.branch, *(array.pointer for array in results))
        return tuple(c for array in results for c in array.rows[0])


def _unset(size: int, count: int = 1, stride: int = 1) -> Placed:
    return Placed.new([(UNSET,) * size] * count, stride)


def _consecutive(cells: list[Any], start: int, sizes: Sequence[int]) -> list[Placed]:
    placed = []
    for size in sizes:
        placed.append(Placed(Pointer(cells, start, 0, len(cells)), size))
        start += size
    return placed


def _over(argument: Placed, size: int) -> Placed:
    """A result of so many components in the place of an argument, with its stride; the memory grows if it must."""
    cells = argument.pointer.cells
    cells += [UNSET] * ((size - 1) * argument.stride + argument.count - len(cells))
    return Placed(Pointer.to(cells), size, argument.count, argument.stride)
