"""Emitted programs as terms of Coq and Gappa: the operations that a program performs when its text is executed.

A program runs on numbers that write each operation as a step. Nothing is simplified or shared here. A transcript thus
rests on the text on disk and on the interpreter that executes it.
"""

from __future__ import annotations

import operator
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from itertools import chain, count, islice
from typing import Any, NamedTuple, TypeAlias

import numpy as np

Operand: TypeAlias = str | int | Fraction  # name of a parameter or of an earlier step, or a constant
OPERATIONS: Mapping[tuple[str, int], Callable[..., Any]] = {
    ("+", 2): operator.add, ("-", 2): operator.sub, ("*", 2): operator.mul, ("/", 2): operator.truediv,
    ("-", 1): operator.neg, ("sqrt", 1): np.sqrt,
}  # fmt: skip
"""Operations by symbol and number of operands."""


class Step(NamedTuple):
    """Operation, or call of an opaque program, with the names of its results."""

    names: tuple[str, ...]
    symbol: str
    operands: tuple[Operand, ...]

    def text(self, write: Callable[[Operand], str]) -> str:
        """Return the step as a term; ``write`` returns the text of an operand."""
        texts = [write(each) for each in self.operands]
        if len(texts) == 2 and (self.symbol, 2) in OPERATIONS:
            return f"{texts[0]} {self.symbol} {texts[1]}"
        return " ".join((self.symbol, *(f"({text})" for text in texts)))


def _operation(symbol: str, swapped: bool = False) -> Callable[[Written, object], Written]:
    def operation(self: Written, other: object) -> Written:
        return self.transcript.enter(symbol, (other, self) if swapped else (self, other))[0]

    return operation


class Written:
    """Number that writes its operations into a transcript; it has no value and cannot be compared."""

    __slots__ = ("name", "transcript")

    def __init__(self, name: str, transcript: Transcript) -> None:
        self.name, self.transcript = name, transcript

    __add__, __radd__ = _operation("+"), _operation("+", swapped=True)
    __sub__, __rsub__ = _operation("-"), _operation("-", swapped=True)
    __mul__, __rmul__ = _operation("*"), _operation("*", swapped=True)
    __truediv__, __rtruediv__ = _operation("/"), _operation("/", swapped=True)

    def __neg__(self) -> Written:
        return self.transcript.enter("-", [self])[0]

    def sqrt(self) -> Written:
        return self.transcript.enter("sqrt", [self])[0]

    def __bool__(self, other: object = None) -> bool:
        raise TypeError("the program compares numbers: it is not a straight line")

    __eq__ = __bool__
    __hash__ = None  # type: ignore[assignment]


class Transcript:
    """Straight-line program, run on numbers and tuples with the given names; ``place`` is a file and line."""

    def __init__(
        self,
        program: Callable[..., Iterable[Any]],
        arguments: Sequence[str | tuple[str, ...]],
        place: str = "",
        letter: str = "t",
    ) -> None:
        self.place, self.steps = place, list[Step]()
        self._names = (f"{letter}{number}" for number in count(1))
        given = [tuple(Written(n, self) for n in ((a,) if isinstance(a, str) else a)) for a in arguments]
        self.parameters = tuple(number.name for numbers in given for number in numbers)
        passed = (numbers[0] if isinstance(a, str) else numbers for a, numbers in zip(arguments, given, strict=True))
        self.results = tuple(map(_operand, program(*passed)))

    def enter(self, symbol: str, operands: Iterable[Any], results: int = 1) -> tuple[Written, ...]:
        """Write an operation, or the call of an opaque program, and return its results."""
        names = tuple(islice(self._names, results))
        self.steps.append(Step(names, symbol, tuple(map(_operand, operands))))
        return tuple(Written(name, self) for name in names)

    def definition(self, name: str) -> str:
        """Return the program as a definition of Coq; a step used once stands where it is used."""
        lines = [f"Definition {name} ({' '.join(self.parameters)} : K) : {product(len(self.results))} :="]
        uses = Counter(chain(self.results, *(step.operands for step in self.steps)))
        texts = dict(zip(self.parameters, self.parameters, strict=True))

        def write(operand: Operand) -> str:
            return texts[operand] if isinstance(operand, str) else constant(operand)

        for step in self.steps:
            text = step.text(write)
            if len(step.names) == 1 and uses[step.names[0]] < 2:
                texts[step.names[0]] = f"({text})"
                continue
            pattern = step.names[0] if len(step.names) == 1 else f"'({', '.join(step.names)})"
            lines.append(f"  let {pattern} := {text} in")
            texts |= zip(step.names, step.names, strict=True)
        return "\n".join([*lines, f"  ({', '.join(map(write, self.results))})."])

    def values(self, inputs: Mapping[str, Any], sqrt: Callable[[Any], Any] = np.sqrt) -> dict[Any, Any]:
        """Return the values of all steps on any numbers, by name."""
        known: dict[Any, Any] = dict(inputs)
        for (name,), symbol, operands in self.steps:
            apply = sqrt if symbol == "sqrt" else OPERATIONS[symbol, len(operands)]
            known[name] = apply(*(known.get(each, each) for each in operands))
        return known


def _operand(number: Any) -> Operand:
    if isinstance(number, Written):
        return number.name
    if isinstance(number, int | Fraction):
        return number
    raise TypeError(f"{number!r} is neither an exact number nor the result of an operation")


def product(count: int) -> str:
    """Return the type of tuples of numbers."""
    return f"({' * '.join(['K'] * count)})%type"


def constant(value: Fraction | int) -> str:
    """Return a rational number as a term of ones.

    Examples
    --------
    >>> constant(6), constant(Fraction(-1, 2))
    ('(2 * (1 + 2 * 1))', '(- ((1 / 2)))')
    """
    value = Fraction(value)
    if value < 0:
        return f"(- ({constant(-value)}))"
    if value.denominator != 1:
        return f"({constant(value.numerator)} / {constant(value.denominator)})"
    half, odd = divmod(int(value), 2)
    if half == 0 or (half, odd) == (1, 0):
        return str(value)
    return f"(1 + 2 * {constant(half)})" if odd else f"(2 * {constant(half)})"
