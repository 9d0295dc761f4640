"""Quaternions, scalar part first, over any commutative coefficients."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from .dual import Coefficient, Dual, Structure
from .vector import Vector


@dataclass(frozen=True, slots=True)
class Quaternion(Structure):
    """Quaternion ``scalar + vector``; `Dual` coefficients make it a dual quaternion."""

    scalar: Coefficient
    vector: Vector

    @classmethod
    def from_components(cls, components: Iterable[Coefficient]) -> Quaternion:
        """Return the quaternion with four components, scalar first."""
        scalar, c1, c2, c3 = components
        return cls(scalar, Vector(c1, c2, c3))

    @classmethod
    def dual(cls, re: Iterable[Coefficient], du: Iterable[Coefficient]) -> Quaternion:
        """Return the dual quaternion ``re + ε du`` from the four components of each part, scalar first."""
        return cls.from_components(Dual(a, b) for a, b in zip(re, du, strict=True))

    def __iter__(self) -> Iterator[Coefficient]:
        return iter((self.scalar, *self.vector))

    def _with(self, components: Iterable[Coefficient]) -> Quaternion:
        return self.from_components(components)

    def __mul__(self, other: Any) -> Quaternion:
        """Return the quaternion product ``(s t − a·b, s b + t a + a × b)``, or the multiple by a scalar."""
        if isinstance(other, Quaternion):
            s, t, a, b = self.scalar, other.scalar, self.vector, other.vector
            return Quaternion(s * t - a.dot(b), b * s + a * t + a.cross(b))
        return Structure.__mul__(self, other)

    def conjugate(self) -> Quaternion:
        """Return ``scalar − vector``."""
        return Quaternion(self.scalar, -self.vector)

    def norm2(self) -> Coefficient:
        """Return the squared norm, ``q q*``."""
        return self.scalar * self.scalar + self.vector.dot(self.vector)

    def inverse(self) -> Quaternion:
        """Return ``q* / |q|²``; a dual quaternion with real part zero raises `ZeroDivisorError`."""
        inverse: Quaternion = self.conjugate() / self.norm2()
        return inverse

    def sandwich(self, v: Vector) -> Vector:
        """Return ``q v q*``, the vector turned by a unit quaternion."""
        return (self * Quaternion(0, v) * self.conjugate()).vector
