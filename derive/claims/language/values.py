"""Sums, products and equality of numbers, vectors, quaternions and tensors.

A sum of a number and a vector is a quaternion. Two vectors side by side are multiplied as quaternions, as in both
papers. A tensor to the left of a vector or tensor acts on it.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from ...algebra import Dual, Quaternion, Structure, Tensor, Vector, matrix, structures
from ...algebra.structures import quaternion as quaternion
from ..numbers.fields import Field

add = structures.add
"""Sum; a number plus a vector is a quaternion."""


def multiply(a: Any, b: Any) -> Any:
    """Return the product of two factors printed side by side."""
    if isinstance(a, Structure) and isinstance(b, Structure) and matrix.Matrix in (type(a), type(b)):
        return matrix.product(a, b)
    return structures.multiply(a, b)


def divide(a: Any, b: Any) -> Any:
    """Return the quotient; division by a quaternion multiplies by its inverse on the right."""
    if isinstance(b, int):
        b = Fraction(b)
    if not isinstance(b, Structure):
        quotient = a / b
        return int(quotient) if isinstance(quotient, Fraction) and quotient.denominator == 1 else quotient
    return multiply(a, quaternion(b).inverse())


def dot(a: Any, b: Any) -> Any:
    if isinstance(a, Vector) and isinstance(b, Vector):
        return a.dot(b)
    return multiply(matrix.transposed(a) if isinstance(a, matrix.Matrix) else a, b)


def norm(field: Field, a: Any) -> Any:
    """Return the magnitude of a column, quaternion or number."""
    if isinstance(a, Vector):
        return field.magnitude(a)
    return field.sqrt(square(a)) if isinstance(a, Structure) else field.absolute(a)


def square(a: Any) -> Any:
    """Return the square of the magnitude, which needs no root."""
    if isinstance(a, matrix.Matrix):
        return matrix.product(matrix.transposed(a), a)
    return a.dot(a) if isinstance(a, Vector) else a.norm2() if isinstance(a, Quaternion) else a * a


def re(a: Any) -> Any:
    return getattr(a, "re", a)


def du(a: Any) -> Any:
    return getattr(a, "du", 0)


# ---- matrices, poses and twists ---------------------------------------------------------------------------------


def det(a: Any) -> Any:
    """Return the determinant; that of a tensor needs no division."""
    return a.det() if isinstance(a, Tensor) else matrix.det(a)


def rotation(T: Any) -> Any:
    return matrix.part(T, range(3), range(3))


def translation(T: Any) -> Any:
    return matrix.part(T, range(3), range(3, 4))


def pose(R: Any, p: Any, one: int = 1) -> Any:
    return matrix.blocks([[R, p], [matrix.shaped([[Fraction(0)] * 3]), Fraction(one)]])


def halves(xi: Any) -> tuple[Vector, Vector]:
    """Return the angular part and the other part of a twist."""
    return matrix.part(xi, range(3), range(1)), matrix.part(xi, range(3, 6), range(1))


def skew(a: Any) -> Any:
    """Return the skew tensor of a vector, or the 4x4 matrix of a twist."""
    if isinstance(a, Vector):
        return Tensor.skew(a)
    w, v = halves(a)
    return pose(Tensor.skew(w), v, 0)


def vect(a: Any) -> Any:
    """Return the axial vector of a tensor, or the twist of a 4x4 matrix."""
    return a.vect() if isinstance(a, Tensor) else matrix.blocks([[rotation(a).vect()], [translation(a)]])


# ---- equality ---------------------------------------------------------------------------------------------------


def equal(field: Field, a: Any, b: Any) -> bool:
    """Return whether two values are equal, component by component."""
    if isinstance(a, Structure) and isinstance(b, int) and b == 0:
        b = 0 * a
    if type(a) is not type(b) and (isinstance(a, Structure) or isinstance(b, Structure)):
        a, b = quaternion(a), quaternion(b)
    return all(field.same(s, t) for s, t in _pairs(a, b))


def coefficients(a: Any) -> Iterator[Any]:
    """Yield the plain numbers of a value, all real parts before the dual parts."""
    if isinstance(a, Structure) and any(isinstance(component, Dual) for component in a):
        yield from (number for part in (re, du) for number in coefficients(a.map(part)))
        return
    parts = _parts(a)
    if not parts:
        yield a
    for part in parts:
        yield from coefficients(part)


def _parts(a: Any) -> tuple[Any, ...]:
    if isinstance(a, Structure):
        return tuple(a)
    return (a.re, a.du) if isinstance(a, Dual) else ()


def _pairs(a: Any, b: Any) -> Iterator[tuple[Any, Any]]:
    """Yield the pairs of plain numbers to compare; the dual part of a plain number is 0."""
    numbers = isinstance(a, Dual) or isinstance(b, Dual)
    pairs = [(re(a), re(b)), (du(a), du(b))] if numbers else list(zip(_parts(a), _parts(b), strict=True))
    if not pairs:
        yield a, b
    for s, t in pairs:
        yield from _pairs(s, t)
