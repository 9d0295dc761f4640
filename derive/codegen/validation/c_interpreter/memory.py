"""Memory as lists of cells, and pointers that know the bounds of their array."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final

UNSET: Final = object()  # content of a cell that was never written


class CError(Exception):
    """Error in C text that does not parse, breaks a rule of C, or lies outside the supported subset."""


@dataclass(frozen=True, slots=True)
class Pointer:
    """Position in a list of cells, with the bounds low <= i < high of its array."""

    cells: list[Any]
    index: int
    low: int
    high: int

    @classmethod
    def to(cls, cells: list[Any]) -> Pointer:
        """Return the pointer to the first cell of an array of all given cells."""
        return cls(cells, 0, 0, len(cells))

    def moved(self, by: int) -> Pointer:
        """Return the pointer ``by`` cells further; it must stay in its array or one cell past the end."""
        index = self.index + by
        if not self.low <= index <= self.high:
            raise CError(f"a pointer moves to cell {index - self.low} of {self.high - self.low}")
        return Pointer(self.cells, index, self.low, self.high)

    def narrowed(self, size: int) -> Pointer:
        """Return a pointer bounded to the ``size`` cells that begin here."""
        if self.index + size > self.high:
            raise CError(f"an array of {self.high - self.index} is given where {size} are promised")
        return Pointer(self.cells, self.index, self.index, self.index + size)

    def __getitem__(self, by: int) -> Any:
        value = self.cells[self._inside(by)]
        if value is UNSET:
            raise CError(f"cell {self.index + by - self.low} of {self.high - self.low} is read before it is written")
        return value

    def __setitem__(self, by: int, value: Any) -> None:
        self.cells[self._inside(by)] = value

    def _inside(self, by: int) -> int:
        index = self.index + by
        if not self.low <= index < self.high:
            raise CError(f"access to cell {index - self.low} of {self.high - self.low}")
        return index
