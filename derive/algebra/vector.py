"""Vectors of the free module of rank 3 over any commutative coefficients."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from . import functions
from .dual import Coefficient, Dual, Structure


@dataclass(frozen=True, slots=True)
class Vector(Structure):
    """Vector with components ``c1, c2, c3`` in a right-handed orthonormal basis.

    `Dual` components make it a dual vector.
    """

    c1: Coefficient
    c2: Coefficient
    c3: Coefficient

    @classmethod
    def dual(cls, re: Iterable[Coefficient], du: Iterable[Coefficient]) -> Vector:
        """Return the dual vector ``re + ε du`` from the three components of each part."""
        return cls(*(Dual(a, b) for a, b in zip(re, du, strict=True)))

    def __iter__(self) -> Iterator[Coefficient]:
        return iter((self.c1, self.c2, self.c3))

    def _with(self, components: Iterable[Coefficient]) -> Vector:
        return Vector(*components)

    def dot(self, other: Vector) -> Coefficient:
        """Return the scalar product."""
        return self.c1 * other.c1 + self.c2 * other.c2 + self.c3 * other.c3

    def cross(self, other: Vector) -> Vector:
        """Return the vector product ``self × other``."""
        return Vector(
            self.c2 * other.c3 - self.c3 * other.c2,
            self.c3 * other.c1 - self.c1 * other.c3,
            self.c1 * other.c2 - self.c2 * other.c1,
        )

    def magnitude(self) -> Coefficient:
        """Return the magnitude, a (dual) number whose square is ``self · self``.

        A dual vector has the magnitude ``|a| + ε a·a°/|a|`` if its real part is non-zero, else ``ε |a°|``.
        Real coefficients are assumed.
        """
        if not any(isinstance(c, Dual) for c in self):
            return functions.sqrt(self.dot(self))
        re, du = self.re, self.du
        length = re.magnitude()
        return Dual(length, du.magnitude() if length == 0 else re.dot(du) / length)
