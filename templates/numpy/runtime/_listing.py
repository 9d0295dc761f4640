"""Recorded operations before they have rows: what depends on what, and selections as bitwise operations."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence, Set
from dataclasses import dataclass, replace
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[Any]
Function: TypeAlias = Callable[..., Any]
Operation: TypeAlias = tuple[Function, tuple[int, ...]]


def where(mask: Array, a: Array, b: Array, out: Array) -> None:
    """Write a to ``out`` where a boolean mask is true, else b."""
    np.copyto(out, np.where(mask, a, b))


@dataclass(frozen=True, slots=True, eq=False)
class Listing:
    """Entries of a recorded program: components of arguments, constants, and operations on earlier entries.

    ``constants`` holds numbers by entry. Entries in ``truths`` are masks, or bits on the way to a selection.
    """

    dtype: np.dtype[Any]
    operations: Sequence[Operation | None]
    truths: Set[int]
    inputs: Sequence[int]
    constants: Mapping[int, Any]
    outputs: Sequence[int]

    def needed(self) -> set[int]:
        """Return the entries on which the outputs depend, with them."""
        found, pending = set[int](), list(self.outputs)
        while pending:
            index = pending.pop()
            if index not in found:
                found.add(index)
                pending += (self.operations[index] or (None, ()))[1]
        return found

    def on_bits(self) -> Listing:
        """Return the listing with ``((a ^ b) & mask) ^ b`` for each selection; the mask has all bits set or none."""
        made, truths, constants, place, known = [], set[int](), dict[int, Any](), list[int](), dict[Operation, int]()

        def enter(operation: Operation | None, truth: bool = True) -> int:
            if operation is None or operation not in known:
                made.append(operation)
                if operation is None:
                    return len(made) - 1
                known[operation] = len(made) - 1
                if truth:
                    truths.add(len(made) - 1)
            return known[operation]

        for index, operation in enumerate(self.operations):
            if operation is None:
                place.append(enter(None))
                if index in self.constants:
                    constants[place[-1]] = self.constants[index]
                continue
            function, operands = operation[0], tuple(place[i] for i in operation[1])
            if function is where:
                mask, a, b = operands
                if a in constants and b in constants:
                    differing = enter(None)
                    constants[differing] = self._differing(constants[a], constants[b])
                else:
                    differing = enter((np.bitwise_xor, (a, b)))
                function, operands = np.bitwise_xor, (enter((np.bitwise_and, (differing, mask))), b)
            place.append(enter((function, operands), index in self.truths))
        inputs, outputs = ([place[index] for index in of] for of in (self.inputs, self.outputs))
        return Listing(self.dtype, made, truths, inputs, constants, outputs)

    def _differing(self, *numbers: Any) -> Any:
        """Return the number whose bits are those that differ between two numbers."""
        a, b = (np.array(number, self.dtype).view(f"i{self.dtype.itemsize}") for number in numbers)
        return (a ^ b).view(self.dtype)

    def split(self, few: Set[int], table: int) -> tuple[Listing, Listing] | None:
        """Return a listing of what depends on some inputs alone, and one of the rest; None if nothing does.

        ``few`` are places of inputs; the last ``table`` inputs count as few. The results of the first listing are
        inputs of the second one, before the table.
        """
        places = [place for place in range(len(self.inputs)) if place in few or place >= len(self.inputs) - table]
        given = [self.inputs[place] for place in places]
        early = {*given, *self.constants}
        for index, operation in enumerate(self.operations):
            if operation and early.issuperset(operation[1]):
                early.add(index)
        shared, seen, pending = dict[int, None](), set[int](), list(self.outputs)[::-1]
        while pending:
            index = pending.pop()
            operation = self.operations[index]
            if operation and index in early and index not in self.truths:
                shared[index] = None
            elif operation and index not in seen:
                pending += operation[1]
            seen.add(index)
        if not shared:
            return None
        left = [None if index in shared else operation for index, operation in enumerate(self.operations)]
        alone = len(self.inputs) - table
        inputs = [*self.inputs[:alone], *shared, *self.inputs[alone:]]
        return replace(self, inputs=given, outputs=[*shared]), replace(self, operations=left, inputs=inputs)
