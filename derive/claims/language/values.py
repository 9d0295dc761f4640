"""Sums, products and equality of numbers, vectors, quaternions and tensors.

A sum of a number and a vector is a quaternion. Two vectors side by side are multiplied as quaternions, as in both
papers. A tensor to the left of a vector or tensor acts on it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from ...algebra import Dual, Quaternion, Structure, Tensor, Vector, matrix, structures
from ...algebra.pose import Pose
from ...algebra.structures import quaternion as quaternion
from ..numbers.fields import Field


@dataclass(frozen=True)
class Either:
    """Pair of values denoted by ±; `map` applies a function to both."""

    first: Any
    second: Any

    def map(self, f: Callable[[Any], Any]) -> Either:
        return Either(f(self.first), f(self.second))


@dataclass(frozen=True)
class Solution:
    """Condition in place of a value: `equal` is true for every value that satisfies the condition."""

    test: Callable[[Any], bool]

    def __neg__(self) -> Solution:
        return Solution(lambda value: self.test(negative(value)))


class MissedError(ArithmeticError):
    """Error for an element without a preimage."""


@dataclass(frozen=True)
class Map:
    """Map with its preimages, for claims such as "onto" and "n branches".

    `image` maps a point to its value. `preimages` maps a value to the list of its preimages; without one, the list is
    empty or `MissedError` is raised.
    """

    image: Callable[[Any], Any]
    preimages: Callable[[Any], list[Any]]

    def reaches(self, field: Field, target: Any) -> int:
        """Return the number of distinct preimages of a target; for ±, of the first value that has a preimage."""
        if isinstance(target, Either):
            return self.reaches(field, target.first) or self.reaches(field, target.second)
        try:
            candidates = self.preimages(target)
        except MissedError:
            return 0
        found: list[Any] = []
        for v in candidates:
            if equal(field, self.image(v), target) and not any(equal(field, v, w) for w in found):
                found.append(v)
        return len(found)


def _of_either(f: Callable[[Any, Any], Any]) -> Callable[[Any, Any], Any]:
    """Lift a binary function: apply it to both values of an operand of type `Either`."""

    def lifted(a: Any, b: Any) -> Any:
        if isinstance(a, Either):
            return a.map(lambda value: lifted(value, b))
        return b.map(lambda value: lifted(a, value)) if isinstance(b, Either) else f(a, b)

    return lifted


add = _of_either(structures.add)
"""Sum; a number plus a vector is a quaternion."""


def negative(a: Any) -> Any:
    return a.map(negative) if isinstance(a, Either) else -a


@_of_either
def multiply(a: Any, b: Any) -> Any:
    """Return the product of two factors printed side by side."""
    if isinstance(a, Pose) and isinstance(b, Pose):
        return a @ b
    if isinstance(a, Structure) and isinstance(b, Structure) and matrix.Matrix in (type(a), type(b)):
        return matrix.product(a, b)
    return structures.multiply(a, b)


@_of_either
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


def dualise(re: Any, du: Any) -> Any:
    """Return ``re + ε du`` for numbers and structures."""
    return re + du * Dual(0, 1)


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
    """Return whether two values are equal, component by component; ± matches with either sign."""
    if isinstance(b, Solution) or (isinstance(b, Either) and not isinstance(a, Either)):
        a, b = b, a
    if isinstance(a, Either):
        return equal(field, a.first, b) or equal(field, a.second, b)
    if isinstance(a, Solution):
        return a.test(b.first) or a.test(b.second) if isinstance(b, Either) else a.test(b)
    if isinstance(a, Structure) and isinstance(b, int) and b == 0:
        b = 0 * a
    if type(a) is not type(b) and (isinstance(a, Structure) or isinstance(b, Structure)):
        a, b = quaternion(a), quaternion(b)
    return all(field.same(s, t) for s, t in _pairs(a, b))


def coefficients(a: Any) -> Iterator[Any]:
    """Yield the plain numbers of a value, all real parts before the dual parts; for ±, use the first value."""
    if isinstance(a, Structure) and any(isinstance(component, Dual) for component in a):
        yield from (number for part in (re, du) for number in coefficients(a.map(part)))
        return
    parts = _parts(a)
    if not parts:
        yield a
    for part in parts:
        yield from coefficients(part)


def _parts(a: Any) -> tuple[Any, ...]:
    if isinstance(a, Pose):
        return a.rotation, a.displacement
    if isinstance(a, Structure):
        return tuple(a)
    if isinstance(a, Either):
        return (a.first,)
    return (a.re, a.du) if isinstance(a, Dual) else ()


def _pairs(a: Any, b: Any) -> Iterator[tuple[Any, Any]]:
    """Yield the pairs of plain numbers to compare; the dual part of a plain number is 0."""
    numbers = isinstance(a, Dual) or isinstance(b, Dual)
    pairs = [(re(a), re(b)), (du(a), du(b))] if numbers else list(zip(_parts(a), _parts(b), strict=True))
    if not pairs:
        yield a, b
    for s, t in pairs:
        yield from _pairs(s, t)
