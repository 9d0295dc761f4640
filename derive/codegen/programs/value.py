"""Traced numbers: ordinary arithmetic with them is recorded in their trace."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ...algebra import Structure

if TYPE_CHECKING:
    from .trace import Trace

Number = Any
"""Traced :class:`Value` or exact constant; generic code treats both alike."""


class Value:
    """Traced number: arithmetic with it is recorded in its trace."""

    __slots__ = ("index", "trace")

    def __init__(self, trace: Trace, index: int) -> None:
        self.trace = trace
        self.index = index

    def __add__(self, other: Number) -> Number:
        if isinstance(other, Structure):
            return NotImplemented
        return self.trace.add(self, other)

    def __radd__(self, other: Number) -> Number:
        return self.trace.add(other, self)

    def __sub__(self, other: Number) -> Number:
        if isinstance(other, Structure):
            return NotImplemented
        return self.trace.sub(self, other)

    def __rsub__(self, other: Number) -> Number:
        return self.trace.sub(other, self)

    def __mul__(self, other: Number) -> Number:
        if isinstance(other, Structure):
            return NotImplemented
        return self.trace.mul(self, other)

    def __rmul__(self, other: Number) -> Number:
        return self.trace.mul(other, self)

    def __truediv__(self, other: Number) -> Number:
        if isinstance(other, Structure):
            return NotImplemented
        return self.trace.div(self, other)

    def __rtruediv__(self, other: Number) -> Number:
        return self.trace.div(other, self)

    def __neg__(self) -> Number:
        return self.trace.neg(self)
