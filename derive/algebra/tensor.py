"""Second-order tensors: linear maps of vectors, over any commutative coefficients."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import TypeAlias, overload

from .dual import Coefficient, Dual, Structure
from .vector import Vector

Row: TypeAlias = tuple[Coefficient, Coefficient, Coefficient]


@dataclass(frozen=True, slots=True)
class Tensor(Structure):
    """Tensor with the given 3x3 `rows`; `Dual` entries make it a dual tensor."""

    rows: tuple[Row, Row, Row]

    @classmethod
    def from_entries(cls, entries: Iterable[Coefficient]) -> Tensor:
        """Return the tensor with nine `entries`, row by row."""
        e = tuple(entries)
        if len(e) != 9:
            raise ValueError(f"a tensor has 9 entries, got {len(e)}")
        return cls(((e[0], e[1], e[2]), (e[3], e[4], e[5]), (e[6], e[7], e[8])))

    @classmethod
    def dual(cls, re: Tensor, du: Tensor) -> Tensor:
        """Return the dual tensor ``re + ε du``."""
        return cls.from_entries(Dual(a, b) for a, b in zip(re, du, strict=True))

    @classmethod
    def identity(cls) -> Tensor:
        """Return the identity tensor I."""
        return cls(((1, 0, 0), (0, 1, 0), (0, 0, 1)))

    @classmethod
    def skew(cls, a: Vector) -> Tensor:
        """Return the skew-symmetric tensor with ``skew(a) b = a × b``."""
        return cls(((0, -a.c3, a.c2), (a.c3, 0, -a.c1), (-a.c2, a.c1, 0)))

    @classmethod
    def dyad(cls, a: Vector, b: Vector) -> Tensor:
        """Return the dyadic product ``a ⊗ b``, which takes w to ``a (b · w)``."""
        return cls.from_entries(s * t for s in a for t in b)

    @property
    def transpose(self) -> Tensor:
        """Transpose Tᵀ, with ``a · Tᵀ b = b · T a``."""
        (a, b, c), (d, e, f), (g, h, i) = self.rows
        return Tensor(((a, d, g), (b, e, h), (c, f, i)))

    def __iter__(self) -> Iterator[Coefficient]:
        return (entry for row in self.rows for entry in row)

    def _with(self, components: Iterable[Coefficient]) -> Tensor:
        return self.from_entries(components)

    def __getitem__(self, index: tuple[int, int]) -> Coefficient:
        row, column = index
        return self.rows[row][column]

    @overload
    def __matmul__(self, other: Vector) -> Vector: ...
    @overload
    def __matmul__(self, other: Tensor) -> Tensor: ...
    def __matmul__(self, other: Vector | Tensor) -> Vector | Tensor:
        """Apply to a vector, or compose with a tensor (`other` acts first)."""
        rows = [Vector(*row) for row in self.rows]
        if isinstance(other, Vector):
            return Vector(*(row.dot(other) for row in rows))
        if isinstance(other, Tensor):
            columns = [Vector(*column) for column in other.transpose.rows]
            return Tensor.from_entries(row.dot(column) for row in rows for column in columns)
        return NotImplemented

    def vect(self) -> Vector:
        """Return the axial vector of the skew-symmetric part ``(T − Tᵀ)/2``; ``skew(a).vect() == a``."""
        t = self.rows
        return Vector((t[2][1] - t[1][2]) / 2, (t[0][2] - t[2][0]) / 2, (t[1][0] - t[0][1]) / 2)

    def trace(self) -> Coefficient:
        """Return the trace."""
        return self.rows[0][0] + self.rows[1][1] + self.rows[2][2]

    def det(self) -> Coefficient:
        """Return the determinant, the triple product of the rows."""
        first, second, third = (Vector(*row) for row in self.rows)
        determinant: Coefficient = first.dot(second.cross(third))
        return determinant

    def inverse(self) -> Tensor:
        """Return the inverse, adjugate over determinant; without one, the division raises ZeroDivisionError."""
        first, second, third = (Vector(*row) for row in self.rows)
        adjugate = Tensor.from_entries((*second.cross(third), *third.cross(first), *first.cross(second))).transpose
        inverse: Tensor = adjugate / self.det()
        return inverse
