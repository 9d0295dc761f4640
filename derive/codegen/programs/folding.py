"""Arithmetic on values and constants: constants are folded, and other operations are recorded.

Fractions divide by their denominators, so that exact types stay exact. Signs move outwards to be absorbed by sums.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from fractions import Fraction
from math import lcm

from ...algebra.arithmetic import Arithmetic
from .program import Constant
from .value import Number, Value


class Folding(Arithmetic, ABC):
    """Arithmetic (``algebra.arithmetic``) with which formulas are lowered; subclasses record its operations."""

    @abstractmethod
    def record(self, op: str, *operands: Number) -> Value:
        """Return the value of ``op(*operands)``."""

    @abstractmethod
    def negated(self, value: Number) -> Number:
        """Return −value if the value was recorded as a negative; None otherwise."""

    def add(self, a: Number, b: Number) -> Number:
        if not isinstance(a, Value) and not isinstance(b, Value):
            return _tidy(a + b)
        if _is(a, 0):
            return b
        if _is(b, 0):
            return a
        if (negated := self.negated(b)) is not None:
            return self.sub(a, negated)
        if (negated := self.negated(a)) is not None:
            return self.sub(b, negated)
        for constant, value in ((a, b), (b, a)):
            if isinstance(constant, Fraction):
                numerator, denominator = constant.numerator, constant.denominator
                return self.div(self.add(numerator, self.mul(denominator, value)), denominator)
        return self.record("add", a, b)

    def sub(self, a: Number, b: Number) -> Number:
        if not isinstance(a, Value) and not isinstance(b, Value):
            return _tidy(a - b)
        if _is(a, 0):
            return self.neg(b)
        if _is(b, 0):
            return a
        if (negated := self.negated(b)) is not None:
            return self.add(a, negated)
        if isinstance(a, Fraction):
            return self.div(self.sub(a.numerator, self.mul(a.denominator, b)), a.denominator)
        if isinstance(b, Fraction):
            return self.div(self.sub(self.mul(b.denominator, a), b.numerator), b.denominator)
        return self.record("sub", a, b)

    def mul(self, a: Number, b: Number) -> Number:
        if not isinstance(a, Value) and not isinstance(b, Value):
            return _tidy(a * b)
        for one, other in ((a, b), (b, a)):
            if _is(one, 0):
                return 0
            if _is(one, 1):
                return other
            if _is(one, -1):
                return self.neg(other)
        return self.record("mul", a, b) if isinstance(a, Value) and isinstance(b, Value) else self._multiple(a, b)

    def _multiple(self, a: Number, b: Number) -> Number:
        """Return a constant times a value, the constant first; fractions divide, so that exact types stay exact.

        The sign of a fraction moves outside, where a sum absorbs it.
        """
        constant, value = (b, a) if isinstance(a, Value) else (a, b)
        if constant.denominator != 1 and constant < 0:
            return self.neg(self._multiple(-constant, value))
        if constant.denominator != 1:
            return self.div(self.mul(constant.numerator, value), constant.denominator)
        return self.record("mul", constant, value)

    def div(self, a: Number, b: Number) -> Number:
        if _is(b, 0):
            raise ZeroDivisionError("a traced program divides by the constant 0")
        if not isinstance(a, Value) and not isinstance(b, Value):
            return _tidy(Fraction(a) / Fraction(b))
        if _is(b, 1) or _is(a, 0):
            return a
        if isinstance(b, Fraction):
            return self.mul(1 / b, a)
        if isinstance(a, Fraction):
            return self.div(a.numerator, self.mul(a.denominator, b))
        return self.record("div", a, b)

    def neg(self, a: Number) -> Number:
        if not isinstance(a, Value):
            return -a
        negated = self.negated(a)
        return self.record("neg", a) if negated is None else negated

    # --- elementary functions and selection -----------------------------------------------------------------------

    def abs(self, a: Number) -> Number:
        return self.record("abs", a) if isinstance(a, Value) else abs(a)

    def sqrt(self, a: Number) -> Number:
        return a if _is(a, 1) or _is(a, 0) else self.record("sqrt", a)

    def tan(self, a: Number) -> Number:
        return self.record("tan", a)

    def atan2(self, a: Number, b: Number) -> Number:
        return self.record("atan2", a, b)

    def expm1(self, a: Number) -> Number:
        return self.record("expm1", a)

    def log1p(self, a: Number) -> Number:
        return self.record("log1p", a)

    def less(self, a: Number, b: Number) -> Number:
        if not isinstance(a, Value) and not isinstance(b, Value):
            return bool(a < b)
        return self.record("lt", a, b)

    def equal(self, a: Number, b: Number) -> Number:
        if not isinstance(a, Value) and not isinstance(b, Value):
            return bool(a == b)
        return self.record("eq", a, b)

    def both(self, a: Number, b: Number) -> Number:
        if isinstance(a, bool):
            return b if a else False
        if isinstance(b, bool):
            return a if b else False
        return self.record("and", a, b)

    def either(self, a: Number, b: Number) -> Number:
        if isinstance(a, bool):
            return True if a else b
        if isinstance(b, bool):
            return True if b else a
        return self.record("or", a, b)

    def where(self, condition: Number, a: Number, b: Number) -> Number:
        if isinstance(condition, bool):
            return a if condition else b
        if a is b or (a == b and not isinstance(a, Value) and not isinstance(b, Value)):
            return a
        if (common := lcm(*(value.denominator for value in (a, b) if isinstance(value, Fraction)))) > 1:
            return self.div(self.where(condition, self.mul(common, a), self.mul(common, b)), common)
        return self.record("where", condition, a, b)


def _is(value: Number, constant: int) -> bool:
    return not isinstance(value, Value) and value == constant


def _tidy(value: Constant) -> Constant:
    """Return an int if the value is an integer, so that printed constants stay short."""
    return int(value) if value == int(value) else value
