r"""Running error analysis: how far rounding may move the results of a program.

Every number carries a bound of its error. An operation takes those of its operands through, exactly (not to first order
only), and adds its own rounding: with unit roundoff u and smallest number t of a type,

.. math:: |\mathrm{fl}(a \circ b) - a \circ b| \le u\,|a \circ b| + t

(Higham, Accuracy and Stability of Numerical Algorithms, 2.2 and 3.3). So the bound of a result is its operation count,
each operation weighted by how much it matters there. Rounded arguments are errors to begin with. Bounds for several
types are found together, one a row. Comparisons go as they do on the computed numbers: where that is not the side a
formula takes, the bound is too small, never too large.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, TypeAlias

import mpmath
import numpy as np
from numpy.typing import NDArray

from ..programs.program import Call, Operand, Program

Array: TypeAlias = NDArray[Any]

FUNCTION_UNITS = 8
"""Units of roundoff in tan, atan2, expm1 and log1p: NumPy's vectorized ones keep within 4 units in the last place."""


HALF = 53
"""Binary digits of a float: two hold as many as `long` takes, more than most long doubles have."""


@dataclass(frozen=True, slots=True)
class Ball:
    """Numbers as computed exactly, and how far those computed in each type may be from them."""

    value: Array
    error: Array


@dataclass(frozen=True)
class Rounding:
    """Arithmetic of balls for some types of numbers; its arrays have the types as first axis, then cases."""

    dtypes: tuple[np.dtype[Any], ...]
    unit: Array = field(init=False)
    tiny: Array = field(init=False)

    def __post_init__(self) -> None:
        facts = [np.finfo(dtype) for dtype in self.dtypes]
        object.__setattr__(self, "unit", np.array([[f.eps / 2] for f in facts], np.longdouble))
        object.__setattr__(self, "tiny", np.array([[f.smallest_subnormal] for f in facts], np.longdouble))

    def given(self, values: Sequence[Any]) -> Ball:
        """Numbers of many digits, off by a rounding in the types that do not hold them."""
        value, bits = long(values), np.array([_bits(value) for value in values])
        digits = np.array([[np.finfo(dtype).nmant + 1] for dtype in self.dtypes])
        return Ball(value, np.where(bits > digits, self.unit * abs(value), 0))

    def number(self, value: Any) -> Ball:
        """The same number for all cases."""
        return self.given([value])

    def _rounded(self, value: Array, error: Array, units: int = 1) -> Ball:
        return Ball(value, error + units * (self.unit * (abs(value) + error) + self.tiny))

    def add(self, a: Ball, b: Ball) -> Ball:
        return self._rounded(a.value + b.value, a.error + b.error)

    def sub(self, a: Ball, b: Ball) -> Ball:
        if a is b:  # exactly 0, unless it is NaN
            return Ball(a.value - b.value, 0 * a.error)
        return self._rounded(a.value - b.value, a.error + b.error)

    def mul(self, a: Ball, b: Ball) -> Ball:
        error = _times(a.error, b.value) + _times(b.error, a.value) + _times(a.error, b.error)
        return self._rounded(a.value * b.value, error)

    def div(self, a: Ball, b: Ball) -> Ball:
        value, least = a.value / b.value, abs(b.value) - b.error
        return self._rounded(value, np.where(least > 0, (a.error + _times(b.error, value)) / least, np.inf))

    @staticmethod
    def neg(a: Ball) -> Ball:
        return Ball(-a.value, a.error)

    @staticmethod
    def abs(a: Ball) -> Ball:
        return Ball(np.abs(a.value), a.error)

    def sqrt(self, a: Ball) -> Ball:
        value = np.sqrt(a.value)
        least = np.sqrt(np.maximum(a.value - a.error, 0))
        error = np.where(a.error > a.value, np.sqrt(a.value + a.error), a.error / (value + least))
        return self._rounded(value, np.where(a.error == 0, 0, error))

    def tan(self, a: Ball) -> Ball:
        """tan(a + e) − tan a = tan e (1 + tan² a)/(1 − tan a tan e)."""
        value, turned = np.tan(a.value), np.tan(a.error)
        least = np.where(a.error < 1, 1 - abs(value) * turned, 0)
        error = np.where(least > 0, turned * (1 + value * value) / least, np.inf)
        return self._rounded(value, error, FUNCTION_UNITS)

    def atan2(self, a: Ball, b: Ball) -> Ball:
        """The angle between two vectors, by their cross and dot products; any, where one may be across the cut."""
        y, x = abs(a.value), abs(b.value)
        across, along = x * a.error + y * b.error, x * x + y * y - y * a.error - x * b.error
        clear = (along > 0) & ((b.value >= 0) | (y > a.error) | (a.error == 0))
        error = np.where(clear, np.arctan2(across, along), np.inf)
        return self._rounded(np.arctan2(a.value, b.value), error, FUNCTION_UNITS)

    def expm1(self, a: Ball) -> Ball:
        """e^(a + e) − e^a = e^a (e^e − 1)."""
        value = np.expm1(a.value)
        return self._rounded(value, (1 + value) * np.expm1(a.error), FUNCTION_UNITS)

    def log1p(self, a: Ball) -> Ball:
        """log(1 + a) − log(1 + a − e) = −log(1 − e/(1 + a))."""
        share = a.error / (1 + a.value)
        error = np.where(share < 1, -np.log1p(-np.minimum(share, 1)), np.inf)
        return self._rounded(np.log1p(a.value), error, FUNCTION_UNITS)

    @staticmethod
    def where(condition: Array, a: Ball, b: Ball) -> Ball:
        return Ball(np.where(condition, a.value, b.value), np.where(condition, a.error, b.error))

    @staticmethod
    def lt(a: Ball, b: Ball) -> Array:
        return np.asarray(a.value < b.value)

    @staticmethod
    def eq(a: Ball, b: Ball) -> Array:
        return np.asarray(a.value == b.value)

    def operation(self, name: str) -> Callable[..., Any]:
        """What an operation of a program does to balls."""
        logic: Mapping[str, Callable[..., Any]] = {"and": np.logical_and, "or": np.logical_or}
        return logic[name] if name in logic else getattr(self, name)

    def run(
        self, program: Program, scalars: Mapping[str, Program], given: Sequence[Ball], table: Sequence[Ball] = ()
    ) -> list[Any]:
        """The results of a program on balls; ``table`` follows what is given, by name or as what calls pass on."""
        names = [name for _, group in program.inputs for name in group]
        known: dict[Operand, Any] = dict(zip(names, [*given, *table]))

        def read(operand: Operand) -> Any:
            if operand not in known:
                known[operand] = self.number(operand)
            return known[operand]

        for statement in program.statements:
            arguments = [read(operand) for operand in statement.args]
            if isinstance(statement, Call):
                rest = table if statement.rest else ()
                found = self.run(scalars[statement.function], scalars, arguments, rest)
                known |= zip(statement.names, found, strict=True)
            else:
                found = self.operation(statement.op)(*arguments)
                known[statement.name] = exact(found) if statement.name in program.corrected else found
        return [read(output) for output in program.outputs]


def _times(error: Array, value: Array) -> Array:
    """An error beside a factor: 0 times what may be anything, next to a pole, is 0."""
    return np.where(value == 0, 0, error * abs(value))


def exact(ball: Ball) -> Ball:
    """The number without its error."""
    return Ball(ball.value, 0 * ball.value)


def long(values: Sequence[Any]) -> Array:
    """Numbers of many digits as the widest floats there are."""
    heads, tails, exponents = zip(*map(_split, values), strict=True)
    mantissas = np.array(heads, np.longdouble) + np.ldexp(np.array(tails, np.longdouble), -HALF)
    return np.ldexp(mantissas, exponents)


def _split(value: Any) -> tuple[float, float, int]:
    """The leading digits of a number as two whole floats, and the power of 2 of the first; others are cut off."""
    number = _many(value)
    sign, mantissa, exponent, bits = number._mpf_
    if not mantissa:
        return float(number), 0.0, 0  # 0, infinite or none
    surplus = bits - 2 * HALF
    leading = int(mantissa >> surplus if surplus > 0 else mantissa << -surplus)
    head, tail = divmod(-leading if sign else leading, 1 << HALF)
    return float(head), float(tail), exponent + surplus + HALF


def _many(value: Any) -> Any:
    if isinstance(value, int | Fraction):
        return mpmath.mpf(value.numerator) / value.denominator
    return value if isinstance(value, mpmath.mpf) else mpmath.mpf(value)


def _bits(value: Any) -> int:
    """Binary digits of a number, without zeros at either end."""
    return int(_many(value)._mpf_[3])
