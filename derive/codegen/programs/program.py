"""Straight-line programs, lowered from formulas (see ``trace``) and turned into source by printers."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from math import lcm
from typing import Any

from ...algebra import Structure
from ...algebra.arithmetic import Arithmetic

Constant = int | Fraction
Operand = str | int | Fraction  # name of an input or step, or an exact constant
BESIDE = "beside"  # sum in the precision of the data; a plain sum in most languages
FUNCTIONS = ("reciprocal", "abs", "sqrt", "tan", "atan2", "expm1", "log1p")


@dataclass(frozen=True, slots=True)
class Assignment:
    """Assignment ``name = op(*args)``; an ``inline`` step is used once and printed inside its only reader."""

    name: str
    op: str
    args: tuple[Operand, ...]
    inline: bool


@dataclass(frozen=True, slots=True)
class Call:
    """Call of another program, which gives several values at once: ``f, g, h = pose(x)``."""

    names: tuple[str, ...]  # unread values have the name ``_``
    function: str
    args: tuple[Operand, ...]
    rest: str = ""  # argument of the caller whose components, of any number, follow ``args``
    truths: frozenset[str] = frozenset()  # names of the truth values
    lists: tuple[int, ...] = ()  # of a geometry program: lengths of list arguments in ``args``, 0 for a number
    result: str = ""  # of a geometry program: name of the list of all values
    context: str = ""  # of a geometry program: leading arguments among ``m`` and ``c``

    @property
    def groups(self) -> tuple[Operand | tuple[Operand, ...], ...]:
        if not self.result:
            return self.args
        left, found = list(self.args), []
        for length in self.lists:
            found.append(tuple(left[:length]) if length else left[0])
            del left[: length or 1]
        return tuple(found)


Statement = Assignment | Call


@dataclass(frozen=True, slots=True)
class Program:
    """Assignments in order, from named inputs (grouped by argument) to outputs in C order."""

    name: str
    inputs: tuple[tuple[str, tuple[str, ...]], ...]
    statements: tuple[Statement, ...]
    outputs: tuple[Operand, ...]
    corrected: frozenset[str] = frozenset()  # values that are corrected afterwards, so that their rounding is harmless
    called: tuple[Program, ...] = ()  # geometry programs
    results: tuple[str, ...] = ()  # names of the outputs, for a program that others call
    contract: str = ""  # description of the outputs

    @property
    def context(self) -> str:
        """Leading arguments: ``m`` (functions of numbers) and ``c`` (the chart's scalars), ``m`` alone, or none."""
        if any(not call.result or "c" in call.context for call in self.calls):
            return "m, c"
        functions = {*FUNCTIONS, "where", BESIDE}.intersection(self.operations)
        return "m" if functions or any(call.context for call in self.calls) else ""

    @property
    def steps(self) -> tuple[Assignment, ...]:
        return tuple(statement for statement in self.statements if isinstance(statement, Assignment))

    @property
    def calls(self) -> tuple[Call, ...]:
        return tuple(statement for statement in self.statements if isinstance(statement, Call))

    @property
    def conditions(self) -> dict[Operand, frozenset[tuple[Operand, bool]]]:
        """Return for each operand the conditions, with a truth value, outside which no result depends on it."""
        found: dict[Operand, frozenset[tuple[Operand, bool]]] = dict.fromkeys(self.outputs, frozenset())
        for statement in reversed(self.statements):
            of = found.get(statement.name, frozenset()) if isinstance(statement, Assignment) else frozenset()
            chosen = isinstance(statement, Assignment) and statement.op == "where"
            for place, arg in enumerate(statement.args):
                needed = of | {(statement.args[0], place == 1)} if chosen and place else of
                found[arg] = found.get(arg, needed) & needed
        return found

    @property
    def operations(self) -> Counter[str]:
        """Count each operation, without operations inside calls."""
        return Counter(step.op for step in self.steps)

    @property
    def constants(self) -> tuple[int, ...]:
        return tuple(sorted({int(operand) for operand in self.operands if not isinstance(operand, str)}))

    @property
    def operands(self) -> set[Operand]:
        read = {arg for statement in self.statements for arg in statement.args}
        return read | set(self.outputs)


Number = Any  # traced :class:`Value` or exact constant; generic code treats both alike


def _operator(operation: str, swapped: bool = False) -> Callable[[Any, Number], Number]:
    """Return the method of a binary operator, or of its form with swapped operands."""

    def method(self: Value, other: Number) -> Number:
        if isinstance(other, Structure):
            return NotImplemented
        first, second = (other, self) if swapped else (self, other)
        return getattr(self.arithmetic, operation)(first, second)

    return method


class Value:
    """Traced number ``op(*args)``; arithmetic with it is recorded. An unnamed value has the empty name."""

    __slots__ = ("args", "arithmetic", "index", "name", "op")

    def __init__(self, arithmetic: Folding, index: int, op: str, args: tuple[Number, ...]) -> None:
        self.arithmetic = arithmetic
        self.index = index
        self.op = op
        self.args = args
        self.name = ""

    __add__, __radd__ = _operator("add"), _operator("add", swapped=True)
    __sub__, __rsub__ = _operator("sub"), _operator("sub", swapped=True)
    __mul__, __rmul__ = _operator("mul"), _operator("mul", swapped=True)
    __truediv__, __rtruediv__ = _operator("div"), _operator("div", swapped=True)

    def __neg__(self) -> Number:
        return self.arithmetic.neg(self)

    @property
    def operands(self) -> list[Value]:
        return [arg for arg in self.args if isinstance(arg, Value)]


def label(number: Number) -> Operand:
    """Return the name of a value in a program; unnamed values are numbered, and constants stay unchanged."""
    return (number.name or f"t{number.index}") if isinstance(number, Value) else number


def _recorded(op: str) -> Callable[..., Number]:
    def method(self: Folding, *operands: Number) -> Number:
        return self.record(op, *operands)

    return method


class Folding(Arithmetic, ABC):
    """Arithmetic that folds constants while formulas are lowered; subclasses record the other operations."""

    @abstractmethod
    def record(self, op: str, *operands: Number) -> Value:
        """Return the value of ``op(*operands)``."""

    def negated(self, number: Number) -> Number:
        """Return −number if the number is negative or was recorded as a negative; None otherwise."""
        if not isinstance(number, Value):
            return -number if number < 0 else None
        if not number.name and number.op == "neg":
            return number.args[0]
        if not number.name and number.op == "mul" and _constant(number.args[0]) and number.args[0] < 0:
            return self.mul(-number.args[0], number.args[1])
        return None

    def add(self, a: Number, b: Number) -> Number:
        if _constant(a, b):
            return _tidy(a + b)
        for one, other in ((a, b), (b, a)):
            if one == 0:
                return other
        for one, other in ((b, a), (a, b)):
            if (negated := self.negated(one)) is not None:
                return self.sub(other, negated)
        for one, other in ((a, b), (b, a)):
            if isinstance(one, Fraction):
                return self.div(self.add(one.numerator, self.mul(one.denominator, other)), one.denominator)
        return self.record("add", a, b)

    def sub(self, a: Number, b: Number) -> Number:
        if _constant(a, b):
            return _tidy(a - b)
        if a == 0:
            return self.neg(b)
        if b == 0:
            return a
        if (negated := self.negated(b)) is not None:
            return self.add(a, negated)
        if isinstance(a, Fraction):
            return self.div(self.sub(a.numerator, self.mul(a.denominator, b)), a.denominator)
        if isinstance(b, Fraction):
            return self.div(self.sub(self.mul(b.denominator, a), b.numerator), b.denominator)
        return self.record("sub", a, b)

    def mul(self, a: Number, b: Number) -> Number:
        if _constant(a, b):
            return _tidy(a * b)
        if isinstance(a, Value) and isinstance(b, Value):
            return self.record("mul", a, b)
        constant, value = (b, a) if isinstance(a, Value) else (a, b)
        if constant == 0:
            return 0
        if constant == 1:
            return value
        if constant == -1 or (constant < 0 and constant.denominator != 1):  # a sum absorbs the sign
            return self.neg(self.mul(-constant, value))
        if constant.denominator != 1:
            return self.div(self.mul(constant.numerator, value), constant.denominator)
        return self.record("mul", constant, value)

    def div(self, a: Number, b: Number) -> Number:
        if b == 0:
            raise ZeroDivisionError("a traced program divides by the constant 0")
        if _constant(a, b):
            return _tidy(Fraction(a) / Fraction(b))
        if b == 1 or a == 0:
            return a
        if isinstance(b, Fraction):
            return self.mul(1 / b, a)
        if isinstance(a, Fraction):
            return self.div(a.numerator, self.mul(a.denominator, b))
        return self.record("div", a, b)

    def neg(self, a: Number) -> Number:
        if _constant(a):
            return -a
        negated = self.negated(a)
        return self.record("neg", a) if negated is None else negated

    reciprocal, beside = map(_recorded, ("reciprocal", "beside"))
    tan, atan2, expm1, log1p = map(_recorded, ("tan", "atan2", "expm1", "log1p"))

    def abs(self, a: Number) -> Number:
        return abs(a) if _constant(a) else self.record("abs", a)

    def sqrt(self, a: Number) -> Number:
        return a if a in (0, 1) else self.record("sqrt", a)

    def less(self, a: Number, b: Number) -> Number:
        return bool(a < b) if _constant(a, b) else self.record("lt", a, b)

    def equal(self, a: Number, b: Number) -> Number:
        return bool(a == b) if _constant(a, b) else self.record("eq", a, b)

    def both(self, a: Number, b: Number) -> Number:
        for one, other in ((a, b), (b, a)):
            if isinstance(one, bool):
                return other if one else False
        return self.record("and", a, b)

    def either(self, a: Number, b: Number) -> Number:
        for one, other in ((a, b), (b, a)):
            if isinstance(one, bool):
                return True if one else other
        return self.record("or", a, b)

    def where(self, condition: Number, a: Number, b: Number) -> Number:
        if isinstance(condition, bool):
            return a if condition else b
        if a == b:
            return a
        if (common := lcm(*(value.denominator for value in (a, b) if isinstance(value, Fraction)))) > 1:
            return self.div(self.where(condition, self.mul(common, a), self.mul(common, b)), common)
        return self.record("where", condition, a, b)


def _constant(*numbers: Number) -> bool:
    return Value not in map(type, numbers)


def _tidy(value: Constant) -> Constant:
    """Return an int if the value is an integer, so that printed constants stay short."""
    return int(value) if value == int(value) else value
