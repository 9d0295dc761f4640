"""Recorder that runs the Python code of a kernel once, on recording numbers, to get a program of in-place NumPy calls.

Every entry of a tape is one operation. Equal operations are entered once, so common subexpressions of nested programs
are shared.
"""

from __future__ import annotations

from collections.abc import Sequence
from operator import add
from typing import Any

import numpy as np

from ._listing import Function, Listing, Operation, where
from ._program import BITWISE, Program, bits, equal, less, program_of

COMMUTATIVE = (np.add, np.multiply, *BITWISE)
"""Operations whose operands are sorted, so that a + b and b + a are one entry."""


class Number:
    """Number or truth value of the recorded code, an entry of a tape."""

    __slots__ = ("index", "tape")

    def __init__(self, tape: Tape, index: int) -> None:
        self.tape = tape
        self.index = index

    def __bool__(self) -> bool:
        raise TypeError("a recorded number has no truth value: select with m.where")

    def __add__(self, other: Any) -> Number:
        return self if _is(other, 0) else self.tape.sum(self, other)

    def __sub__(self, other: Any) -> Number:
        return self if _is(other, 0) else self.tape.difference(self, other)

    def __rsub__(self, other: Any) -> Number:
        return -self if _is(other, 0) else self.tape.difference(other, self)

    def __mul__(self, other: Any) -> Any:
        if _is(other, 0):
            return 0
        if _is(other, -1):
            return -self
        return self if _is(other, 1) else self.tape.enter(np.multiply, self, other)

    def __truediv__(self, other: Any) -> Number:
        if _is(other, 1):
            return self
        if self.tape.integer and type(other) is int and other & -other == other > 0:
            return self.tape.enter(np.multiply, self, 1 / other)  # the same number, in less time
        return self.tape.enter(np.divide, self, other)

    def __rtruediv__(self, other: Any) -> Number:
        return self.tape.enter(np.divide, other, self)

    def __neg__(self) -> Number:
        return self.tape.negative(self)

    def __lt__(self, other: Any) -> Number:
        return self.tape.compare(less, np.less, self, other)

    def __gt__(self, other: Any) -> Number:
        return self.tape.compare(less, np.less, other, self)

    def __eq__(self, other: object) -> Number:  # type: ignore[override]
        return self.tape.compare(equal, np.equal, self, other)

    def __and__(self, other: Any) -> Any:
        if isinstance(other, bool):  # a comparison of two constants
            return self if other else other
        return self.tape.enter(np.bitwise_and, self, other, mask=True)

    def __or__(self, other: Any) -> Any:
        if isinstance(other, bool):
            return other or self
        return self.tape.enter(np.bitwise_or, self, other, mask=True)

    __radd__, __rmul__, __rand__, __ror__, __hash__ = __add__, __mul__, __and__, __or__, object.__hash__


def _is(operand: Any, integer: int) -> bool:
    """Tell whether an operand is an integer constant: a + 0, 0 a, 1 a and a/1 need no operation."""
    return type(operand) is int and operand == integer


def _entered(function: Function) -> Function:
    """Return the method of a tape that enters a function of NumPy."""
    return lambda tape, *operands: tape.enter(function, *operands)


class Tape:
    """List of numbered entries: arguments, constants, operations. Methods are the functions that kernels call."""

    def __init__(self, dtype: np.dtype[Any]) -> None:
        self.dtype, self.integer = dtype, bits(dtype)
        self.operations: list[Operation | None] = []
        self.constants: dict[str, tuple[Number, Any]] = {}
        self.masks: set[int] = set()
        self._known: dict[Operation, Number] = {}
        self._opposite: dict[int, Number] = {}

    def argument(self) -> Number:
        """Return a new entry for a component of an argument."""
        return self._append(None)

    def enter(self, function: Function, *operands: Any, mask: bool = False) -> Number:
        """Return the entry of an operation, new or equal to an earlier one; ``mask`` marks a truth value."""
        indices = [self.index(operand) for operand in operands]
        operation = function, tuple(sorted(indices) if function in COMMUTATIVE else indices)
        if operation not in self._known:
            self._known[operation] = self._append(operation)
            if mask:
                self.masks.add(self._known[operation].index)
        return self._known[operation]

    def negative(self, a: Number) -> Number:
        """Return the entry of −a; its negative is a itself."""
        if a.index in self._opposite:
            return self._opposite[a.index]
        # a product has two operands as most calls have, which makes runs longer; complex zeros would lose their sign
        made = self.enter(np.multiply, a, -1) if self.integer else self.enter(np.negative, a)
        self._opposite[made.index] = a
        return made

    def sum(self, a: Any, b: Any) -> Number:
        """Return the entry of a + b; a negative operand is subtracted."""
        opposite = self._opposite.get(self.index(b))
        return self.enter(np.add, a, b) if opposite is None else self.enter(np.subtract, a, opposite)

    def difference(self, a: Any, b: Any) -> Number:
        """Return the entry of a − b; a negative operand is added."""
        opposite = self._opposite.get(self.index(b))
        return self.enter(np.subtract, a, b) if opposite is None else self.enter(np.add, a, opposite)

    def compare(self, on_bits: Function, on_booleans: Function, a: Any, b: Any) -> Number:
        """Return the entry of a comparison."""
        return self.enter(on_bits if self.integer else on_booleans, a, b, mask=True)

    def where(self, mask: Any, a: Any, b: Any) -> Any:
        """Return the entry that selects a if the mask is true, else b."""
        if isinstance(mask, bool):
            return a if mask else b
        truth = self.masks.issuperset((self.index(a), self.index(b)))
        return self.enter(where, mask, a, b, mask=truth)

    beside = staticmethod(add)

    def reciprocals(self, like: Any, *integers: int) -> list[Number]:
        """Return constants of the dtype."""
        return [self._constant(f"1/{integer}", 1 / self.dtype.type(integer)) for integer in integers]

    abs, sqrt, tan = map(_entered, (np.absolute, np.sqrt, np.tan))
    atan2, expm1, log1p = map(_entered, (np.arctan2, np.expm1, np.log1p))

    def index(self, operand: Any) -> int:
        """Return the entry number of a recorded number or a constant."""
        return operand.index if isinstance(operand, Number) else self._constant(repr(operand), operand).index

    def _constant(self, key: str, value: Any) -> Number:
        if key not in self.constants:
            self.constants[key] = self._append(None), value
        return self.constants[key][0]

    def _append(self, operation: Operation | None) -> Number:
        self.operations.append(operation)
        return Number(self, len(self.operations) - 1)


def record(text: Function, sizes: Sequence[int], dtype: np.dtype[Any]) -> Program:
    """Return the recorded program of a Python function for one dtype.

    Parameters
    ----------
    text : callable
        Function to record. It takes a :class:`Tape`, which has the functions it calls, and a list of numbers for each
        argument; it returns the outputs.
    sizes : sequence of int
        Number of components of each argument.
    dtype : dtype
        Type of constants and results; it also determines the type of masks.
    """
    tape = Tape(dtype)
    arguments = [[tape.argument() for _ in range(size)] for size in sizes]
    outputs = [tape.index(output) for output in text(tape, *arguments)]
    inputs = [number.index for argument in arguments for number in argument]
    constants = {number.index: value for number, value in tape.constants.values()}
    return program_of(Listing(dtype, tape.operations, tape.masks, inputs, constants, outputs))
