"""Numbers a + ε b with ε² = 0 over any number type, also nested; quaternions and 3x3 matrices of such numbers.

Only tests use this arithmetic; it shares nothing with the code under test. A ``Nil`` over mpf is a dual number. A
``Nil`` over ``Nil`` also carries a derivative, so that differentiation is exact arithmetic without difference
quotients. Operations must not mix levels: all components in a computation have the same depth, or are plain numbers.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np


class Nil:
    """Number a + ε b; a plain number a counts as a + ε 0."""

    __slots__ = ("du", "re")

    def __init__(self, re: Any, du: Any) -> None:
        self.re = re
        self.du = du

    def __add__(self, other: Any) -> Nil:
        if isinstance(other, Nil):
            return Nil(self.re + other.re, self.du + other.du)
        return Nil(self.re + other, self.du)

    __radd__ = __add__

    def __neg__(self) -> Nil:
        return Nil(-self.re, -self.du)

    def __sub__(self, other: Any) -> Nil:
        if isinstance(other, Nil):
            return Nil(self.re - other.re, self.du - other.du)
        return Nil(self.re - other, self.du)

    def __rsub__(self, other: Any) -> Nil:
        return -self + other

    def __mul__(self, other: Any) -> Nil:
        if isinstance(other, Nil):
            return Nil(self.re * other.re, self.re * other.du + self.du * other.re)
        return Nil(self.re * other, self.du * other)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Nil:
        if isinstance(other, Nil):
            quotient = self.re / other.re
            return Nil(quotient, (self.du - quotient * other.du) / other.re)
        return Nil(self.re / other, self.du / other)

    def __rtruediv__(self, other: Any) -> Nil:
        quotient = other / self.re
        return Nil(quotient, -quotient * self.du / self.re)


class Field:
    """Number type with functions, lifted to nilpotent arguments by f(a + ε b) = f(a) + ε b f'(a)."""

    def __init__(self, number: Any, functions: Any) -> None:
        self.number = number
        self._functions = functions

    @property
    def pi(self) -> Any:
        return +self._functions.pi

    def sqrt(self, a: Any) -> Any:
        if isinstance(a, Nil):
            root = self.sqrt(a.re)
            return Nil(root, a.du / (2 * root))
        return self._functions.sqrt(a)

    def tan(self, a: Any) -> Any:
        if isinstance(a, Nil):
            tangent = self.tan(a.re)
            return Nil(tangent, a.du * (1 + tangent * tangent))
        return self._functions.tan(a)

    def sin(self, a: Any) -> Any:
        return Nil(self.sin(a.re), a.du * self.cos(a.re)) if isinstance(a, Nil) else self._functions.sin(a)

    def cos(self, a: Any) -> Any:
        return Nil(self.cos(a.re), -a.du * self.sin(a.re)) if isinstance(a, Nil) else self._functions.cos(a)

    def exp(self, a: Any) -> Any:
        if isinstance(a, Nil):
            power = self.exp(a.re)
            return Nil(power, a.du * power)
        return self._functions.exp(a)

    def log(self, a: Any) -> Any:
        return Nil(self.log(a.re), a.du / a.re) if isinstance(a, Nil) else self._functions.log(a)

    def atan2(self, y: Any, x: Any) -> Any:
        if isinstance(y, Nil):
            return Nil(self.atan2(y.re, x.re), (x.re * y.du - y.re * x.du) / (x.re * x.re + y.re * y.re))
        return self._functions.atan2(y, x)


def mp_field(dps: int) -> Field:
    """Return the field of mpmath numbers of `dps` digits, in a new context; it converts floats of any type exactly."""
    context = mpmath.MPContext()
    context.dps = dps

    def number(value: Any) -> Any:
        if isinstance(value, np.longdouble):
            head = float(value)
            return context.mpf(head) + (context.mpf(float(value - np.longdouble(head))) if math.isfinite(head) else 0)
        if isinstance(value, complex | np.complexfloating):
            return context.mpc(float(value.real), float(value.imag))
        if isinstance(value, Fraction):
            return context.mpf(value.numerator) / value.denominator
        if isinstance(value, context.mpf | context.mpc):
            return value
        # Numbers of another precision keep their digits.
        return context.mpf(value._mpf_ if hasattr(value, "_mpf_") else float(value))

    return Field(number, context)


def float_field() -> Field:
    """Return the field of Python floats, which suffices for the norms in denominators of errors."""
    return Field(float, math)


def exact_field() -> Field:
    """Return the field of fractions, for computations without roots or trigonometric functions."""
    return Field(Fraction, None)


# Quaternions are 4-tuples, vectors 3-tuples, matrices 3-tuples of rows; components are numbers or Nil.


def dot(a: Any, b: Any) -> Any:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def hamilton(a: Any, b: Any) -> tuple[Any, ...]:
    """Return Hamilton's product, written out from i² = j² = k² = ijk = −1."""
    return (
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    )


def conjugate(a: Any) -> tuple[Any, ...]:
    return (a[0], -a[1], -a[2], -a[3])


def power(a: Any, n: int) -> Any:
    """Return the n-th power of the quaternion a, n ≥ 1."""
    if n == 1:
        return a
    half = power(a, n // 2)
    square = hamilton(half, half)
    return hamilton(square, a) if n % 2 else square


def matmul(a: Any, b: Any) -> tuple[Any, ...]:
    columns = transpose(b)
    return tuple(tuple(dot(row, column) for column in columns) for row in a)


def matvec(a: Any, b: Any) -> tuple[Any, ...]:
    return tuple(dot(row, b) for row in a)


def transpose(a: Any) -> tuple[Any, ...]:
    return tuple(zip(*a, strict=True))


def vect(a: Any) -> tuple[Any, ...]:
    """Return the vector of the skew part: skew(vect(A)) = (A − Aᵀ)/2."""
    return ((a[2][1] - a[1][2]) / 2, (a[0][2] - a[2][0]) / 2, (a[1][0] - a[0][1]) / 2)


def inverse(a: Any) -> tuple[Any, ...]:
    """Return the inverse of a 3x3 matrix by cofactors; the real part of the determinant must not vanish."""
    cross = [
        [
            a[(i + 1) % 3][(j + 1) % 3] * a[(i + 2) % 3][(j + 2) % 3]
            - a[(i + 1) % 3][(j + 2) % 3] * a[(i + 2) % 3][(j + 1) % 3]
            for i in range(3)
        ]
        for j in range(3)
    ]
    determinant = a[0][0] * cross[0][0] + a[0][1] * cross[1][0] + a[0][2] * cross[2][0]
    return tuple(tuple(entry / determinant for entry in row) for row in cross)


def split(value: Any) -> tuple[Any, Any]:
    """Return (inner value, inner derivative) of nested tuples of two-level numbers: (a + δ a') + ε (b + δ b')."""
    if isinstance(value, tuple):
        parts = [split(entry) for entry in value]
        return tuple(p[0] for p in parts), tuple(p[1] for p in parts)
    return Nil(value.re.re, value.du.re), Nil(value.re.du, value.du.du)
