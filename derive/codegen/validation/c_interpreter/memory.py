"""Memory as lists of cells, and pointers that know the bounds of what they point into."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final

from .errors import CError


class _Unset:
    def __repr__(self) -> str:
        return "unset"


UNSET: Final = _Unset()
"""The content of a cell that was never written."""

Cells = list[Any]


@dataclass(frozen=True, slots=True)
class Pointer:
    """A position in a list of cells, and the bounds low <= i < high of the object it belongs to."""

    cells: Cells
    index: int
    low: int
    high: int

    @classmethod
    def to(cls, cells: Cells) -> Pointer:
        """The pointer to the first of some cells, which are one object."""
        return cls(cells, 0, 0, len(cells))

    def moved(self, by: int) -> Pointer:
        """The pointer so many cells on: it stays in its object, or is one past the end."""
        index = self.index + by
        if not self.low <= index <= self.high:
            raise CError(f"a pointer moves to cell {index - self.low} of {self.high - self.low}")
        return Pointer(self.cells, index, self.low, self.high)

    def narrowed(self, size: int) -> Pointer:
        """The pointer to an object of that many cells, which begins here."""
        if self.index + size > self.high:
            raise CError(f"an array of {self.high - self.index} is given where {size} are promised")
        return Pointer(self.cells, self.index, self.index, self.index + size)

    def load(self) -> Any:
        """What stands here; an error beyond the bounds, and where nothing was written."""
        value = self.cells[self._inside()]
        if value is UNSET:
            raise CError(f"cell {self.index - self.low} of {self.high - self.low} is read before it is written")
        return value

    def store(self, value: Any) -> None:
        """Write here; an error beyond the bounds."""
        self.cells[self._inside()] = value

    def _inside(self) -> int:
        if not self.low <= self.index < self.high:
            raise CError(f"access to cell {self.index - self.low} of {self.high - self.low}")
        return self.index
