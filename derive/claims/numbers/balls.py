"""Balls of Arb: numbers with a rigorous bound on their error, in which claims are evaluated.

Two balls that do not overlap are certainly unequal, so a refutation is a proof. Balls that overlap count as equal,
which supports a claim and never decides against one: there, an overlap that is not an exact equality raises
`BlurredError`. So does one that is too wide to tell. The caller repeats the evaluation with more digits.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from fractions import Fraction
from numbers import Number
from operator import gt, lt
from typing import Any

import flint

from ...algebra import Dual
from .fields import Field, UndefinedError, innermost

PRECISIONS = (256, 4096)
"""Bits of the first evaluation, and of its repetition if balls are too wide."""
SPARE = 32
"""Bits by which the terms that an infinite sum leaves out are below its error."""
BLURRED = -64
"""Exponent of 2 of the largest error with which two numbers count as equal."""


class BlurredError(Exception):
    """Error for balls too wide to tell whether two numbers are equal."""


@contextmanager
def precision(bits: int) -> Iterator[None]:
    context, before = flint.ctx, flint.ctx.prec
    context.prec = bits
    try:
        yield
    finally:
        context.prec = before


class Ball:
    """Real number with a bound on its error; it behaves like a number."""

    __slots__ = ("arb",)
    __hash__ = None  # type: ignore[assignment]  # overlapping balls are equal

    def __init__(self, value: Any) -> None:
        self.arb = value

    def __add__(self, other: Any) -> Any:
        b = other.arb if type(other) is Ball else arb(other)
        return NotImplemented if b is None else Ball(self.arb + b)

    def __mul__(self, other: Any) -> Any:
        b = other.arb if type(other) is Ball else arb(other)
        return NotImplemented if b is None else Ball(self.arb * b)

    __radd__, __rmul__ = __add__, __mul__

    def __sub__(self, other: Any) -> Any:
        b = other.arb if type(other) is Ball else arb(other)
        return NotImplemented if b is None else Ball(self.arb - b)

    def __rsub__(self, other: Any) -> Any:
        b = arb(other)
        return NotImplemented if b is None else Ball(b - self.arb)

    def __truediv__(self, other: Any) -> Any:
        b = arb(other)
        return NotImplemented if b is None else Ball(self.arb / _nonzero(b))

    def __rtruediv__(self, other: Any) -> Any:
        a = arb(other)
        return NotImplemented if a is None else Ball(a / _nonzero(self.arb))

    def __pow__(self, exponent: int) -> Ball:
        return Ball(self.arb**exponent) if exponent >= 0 else Ball(_nonzero(self.arb) ** exponent)

    def __neg__(self) -> Ball:
        return Ball(-self.arb)

    def __abs__(self) -> Ball:
        return Ball(abs(self.arb))

    def __eq__(self, other: object) -> bool:
        b = arb(other)
        return NotImplemented if b is None else bool(self.arb.overlaps(b))

    def __lt__(self, other: Any) -> bool:
        return bool(self.arb < arb(other))

    def __gt__(self, other: Any) -> bool:
        return bool(self.arb > arb(other))

    def __le__(self, other: Any) -> bool:
        return not self > other

    def __ge__(self, other: Any) -> bool:
        return not self < other

    def overlaps(self, other: Any) -> bool:
        """Return whether it has a number in common with another one, and both are not exactly equal."""
        b = arb(other)
        return bool(self.arb.overlaps(b)) and not (self.arb.is_exact() and b.is_exact())

    def __bool__(self) -> bool:
        return not self.arb.contains(0)

    def __float__(self) -> float:
        return float(self.arb.mid())

    def __repr__(self) -> str:
        shown = str(self.arb.str(30, radius=False))
        return shown.rstrip("0").rstrip(".") if "." in shown and "e" not in shown else shown


Number.register(Ball)


def arb(value: Any) -> Any:
    """Return a number as Arb's ball, or None for a value of another type."""
    if isinstance(value, Ball):
        return value.arb
    if isinstance(value, int):
        return flint.arb(int(value))
    if isinstance(value, Fraction):
        return flint.arb(flint.fmpq(value.numerator, value.denominator))
    return None


def widened(a: Any, error: Any) -> Ball:
    middle, size = arb(a), abs(arb(error)).upper()
    return Ball((middle - size).union(middle + size))


def is_sharp(a: Any) -> bool:
    """Return whether the error of a number is far below the largest with which two numbers count as equal."""
    return bool(arb(a).rad() < (abs(arb(a)).mid() + 1) * flint.arb(2) ** (2 * BLURRED))


def _nonzero(a: Any) -> Any:
    if a.contains(0):
        raise ZeroDivisionError("division by zero")
    return a


class Balls(Field):
    """Real numbers as balls."""

    ordered = True

    def __init__(self, certainly: bool = False, moving: bool = False) -> None:
        self.certainly = certainly  # whether an overlap tells nothing
        self.moving = moving  # whether numbers carry rates, which the magnitude of a vector near 0 does not have

    @property
    def certain(self) -> Balls:
        return Balls(certainly=True, moving=self.moving)

    @property
    def usual(self) -> Balls:
        return Balls(moving=self.moving)

    def same(self, a: Any, b: Any) -> bool:
        gap, size = arb(a) - arb(b), abs(arb(a)).mid() + 1
        if not gap.is_finite():
            raise BlurredError
        found = self._contains_zero(gap, size)
        if found and self.certainly and Ball(arb(a)).overlaps(b):
            raise BlurredError
        return found

    def compared(self, test: Callable[[Any, Any], bool], a: Any, b: Any) -> bool:
        a = Ball(arb(a))
        if a.overlaps(b) and (self.certainly or test in (lt, gt) or not self.same(a, b)):
            raise BlurredError
        return test(a, b)

    def vanishes(self, a: Any) -> bool:
        return self._contains_zero(arb(a), 1)

    def is_null(self, a: Any) -> bool:
        """Return whether a number is exactly 0; raise BlurredError if it has a ball around 0."""
        if isinstance(a, Dual):
            return self.is_null(a.re) and self.is_null(a.du)
        ball = arb(a)
        if ball.contains(0) and not ball.is_exact():
            raise BlurredError
        return bool(ball.contains(0))

    def negligible(self, a: Any) -> bool:
        return bool(abs(arb(a)) < flint.arb(2) ** -(flint.ctx.prec + SPARE))

    @staticmethod
    def _contains_zero(gap: Any, size: Any) -> bool:
        if not gap.contains(0):
            return False
        if not gap.rad() < size * flint.arb(2) ** BLURRED:
            raise BlurredError
        return True

    @staticmethod
    def convolved(a: Sequence[Any], b: Sequence[Any]) -> list[Any]:
        """Return the first coefficients of the product of two polynomials, as many as each has."""
        product = (flint.arb_poly(list(map(arb, a))) * flint.arb_poly(list(map(arb, b)))).coeffs()
        return [Ball(c) for c in (*product, *[flint.arb(0)] * len(a))[: len(a)]]

    @staticmethod
    def divided(a: Sequence[Any], b: Sequence[Any]) -> list[Any]:
        """Return the first coefficients of the quotient of two power series, as many as each has."""
        context, before = flint.ctx, flint.ctx.cap
        context.cap = len(b)
        try:
            inverse = flint.arb_series(list(map(arb, b)), len(b)).inv()
        finally:
            context.cap = before
        return Balls.convolved(a, [Ball(inverse[k]) for k in range(len(b))])

    def magnitude(self, v: Any) -> Any:
        """Return the magnitude of a vector; that of a dual vector without real part needs exact numbers."""
        square = v.dot(v)
        if isinstance(square, Dual) and self.vanishes(real := innermost(square)):
            if self.moving:
                raise UndefinedError("the magnitude of a vector whose real part is 0 has no rate")
            if not arb(real).is_exact():
                raise BlurredError
        return super().magnitude(v)

    def real(self, name: str, *values: Any) -> Callable[..., Any]:
        if hasattr(self, f"_{name}"):
            return super().real(name, *values)
        return lambda a: Ball(getattr(arb(a), name)())  # functions without a singularity, such as the sine

    def _log(self, a: Any) -> Ball:
        if not arb(a) > 0:
            raise UndefinedError("logarithm of a number that is not positive")
        return Ball(arb(a).log())

    def _sqrt(self, a: Any) -> Ball:
        if arb(a) < 0:
            raise UndefinedError("square root of a negative number")
        return Ball(arb(a).nonnegative_part().sqrt())

    def _asin(self, a: Any) -> Ball:
        if abs(arb(a)) > 1:
            raise UndefinedError("inverse sine of a number beyond 1")
        low, high = (arb(end).max(-1).min(1).asin() for end in (Ball(arb(a).lower()), Ball(arb(a).upper())))
        return Ball(low.union(high))

    def _acos(self, a: Any) -> Ball:
        angle: Ball = self.pi / 2 - self._asin(a)
        return angle

    def _atan2(self, y: Any, x: Any) -> Ball:
        y, x = arb(y), arb(x)
        if y.contains(0) and x.contains(0):
            raise UndefinedError("the angle of 0")
        if y.contains(0) and x < 0:  # on the cut, where angles are positive
            return Ball(flint.arb.atan2(y.upper(), x).union(flint.arb.pi()))
        return Ball(flint.arb.atan2(y, x))

    def floor(self, a: Any) -> int:
        """Return the greatest integer that is not greater; raise if a ball has numbers on both sides of one."""
        found = arb(a).floor().unique_fmpz()
        if found is None:
            raise BlurredError
        return int(found)

    @property
    def pi(self) -> Ball:
        return Ball(flint.arb.pi())
