"""Vectors, second-order tensors and quaternions over any commutative coefficients, and isotropic tensors.

An isotropic tensor of a vector v is ``a I + b skew(v) + c v⊗v``, with ``x = v · v``. Since ``skew(v)² = v⊗v − x I`` and
``skew(v) v = 0``, products, transposes and inverses stay isotropic, and commute. Their coefficients are rational in a,
b, c and x, without v. An identity between them is one between functions of x, for real and dual vectors alike.

In the notation of the papers a number plus a vector is a quaternion, and two adjacent vectors are multiplied as
quaternions. A tensor left of a vector or a tensor acts on it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any, TypeAlias, overload

from . import functions
from .dual import Coefficient, Dual, Structure
from .latex import combination

Row: TypeAlias = tuple[Coefficient, Coefficient, Coefficient]


@dataclass(frozen=True, slots=True)
class Vector(Structure):
    """Vector ``c1, c2, c3`` in a right-handed orthonormal basis; `Dual` components make it a dual vector."""

    c1: Coefficient
    c2: Coefficient
    c3: Coefficient

    @classmethod
    def from_components(cls, components: Iterable[Coefficient]) -> Vector:
        return cls(*components)

    def __iter__(self) -> Iterator[Coefficient]:
        return iter((self.c1, self.c2, self.c3))

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


@dataclass(frozen=True, slots=True)
class Tensor(Structure):
    """Tensor with the given 3x3 `rows`; `Dual` entries make it a dual tensor."""

    rows: tuple[Row, Row, Row]

    columns = 3

    @classmethod
    def from_entries(cls, entries: Iterable[Coefficient]) -> Tensor:
        """Return the tensor with nine `entries`, row by row."""
        e = tuple(entries)
        if len(e) != 9:
            raise ValueError(f"a tensor has 9 entries, got {len(e)}")
        return cls(((e[0], e[1], e[2]), (e[3], e[4], e[5]), (e[6], e[7], e[8])))

    from_components = from_entries

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
        return self.rows[0][0] + self.rows[1][1] + self.rows[2][2]

    def det(self) -> Coefficient:
        first, second, third = (Vector(*row) for row in self.rows)
        return first.dot(second.cross(third))

    def inverse(self) -> Tensor:
        """Return the inverse, adjugate over determinant; a singular tensor raises ZeroDivisionError."""
        first, second, third = (Vector(*row) for row in self.rows)
        adjugate = Tensor.from_entries((*second.cross(third), *third.cross(first), *first.cross(second))).transpose
        inverse: Tensor = adjugate / self.det()
        return inverse


@dataclass(frozen=True, slots=True)
class Quaternion(Structure):
    """Quaternion ``scalar + vector``, scalar first; `Dual` coefficients make it a dual quaternion."""

    scalar: Coefficient
    vector: Vector

    @classmethod
    def from_components(cls, components: Iterable[Coefficient]) -> Quaternion:
        """Return the quaternion with four components, scalar first."""
        scalar, c1, c2, c3 = components
        return cls(scalar, Vector(c1, c2, c3))

    def __iter__(self) -> Iterator[Coefficient]:
        return iter((self.scalar, *self.vector))

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


BASIS = ("I", r"\tilde{v}", r"v \otimes v")
"""Basis of the algebra in LaTeX."""


@dataclass(frozen=True, slots=True)
class Isotropic(Structure):
    """Tensor ``a I + b skew(v) + c v⊗v`` for any v with ``v · v = x``."""

    a: Coefficient
    b: Coefficient
    c: Coefficient
    x: Coefficient

    @property
    def coefficients(self) -> tuple[Coefficient, Coefficient, Coefficient]:
        """Coefficients (a, b, c) of I, skew(v) and v⊗v."""
        return self.a, self.b, self.c

    @property
    def transpose(self) -> Isotropic:
        """Transpose ``a I − b skew(v) + c v⊗v``."""
        return Isotropic(self.a, -self.b, self.c, self.x)

    @property
    def axial(self) -> Coefficient:
        """Eigenvalue along v, ``a + x c``."""
        return self.a + self.x * self.c

    @property
    def planar2(self) -> Coefficient:
        """Squared modulus ``a² + x b²`` of the conjugate pair of eigenvalues across v."""
        return self.a * self.a + self.x * self.b * self.b

    def det(self) -> Coefficient:
        """Return the determinant ``(a + x c)(a² + x b²)``."""
        return self.axial * self.planar2

    def inverse(self) -> Isotropic:
        """Return the inverse ``(a I − b skew(v) + (b² − a c)/(a + x c) v⊗v) / (a² + x b²)``.

        A singular tensor raises ZeroDivisionError.
        """
        planar2 = self.planar2
        c = (self.b * self.b - self.a * self.c) / (planar2 * self.axial)
        return Isotropic(self.a / planar2, -self.b / planar2, c, self.x)

    def apply(self, v: Vector, w: Vector) -> Vector:
        """Return the image ``a w + b v × w + c (v · w) v`` of `w`; the requirement ``v · v = x`` is not checked."""
        image: Vector = w * self.a + v.cross(w) * self.b + v * (self.c * v.dot(w))
        return image

    def tensor(self, v: Vector) -> Tensor:
        """Return the tensor at a vector `v`; ``v · v = x`` is not checked, since it may need simplification."""
        expanded: Tensor = Tensor.identity() * self.a + Tensor.skew(v) * self.b + Tensor.dyad(v, v) * self.c
        return expanded

    def __iter__(self) -> Iterator[Coefficient]:
        return iter(self.coefficients)

    def _typeset(self) -> str:
        return combination(self, BASIS)

    def _with(self, components: Iterable[Coefficient]) -> Isotropic:
        a, b, c = components
        return Isotropic(a, b, c, self.x)

    def _matches(self, other: object) -> bool:
        if not isinstance(other, Isotropic):
            return False
        if self.x != other.x:
            raise ValueError(f"tensors of different vectors: x = {self.x!r} and x = {other.x!r}")
        return True

    def __matmul__(self, other: Isotropic) -> Isotropic:
        """Return the product, which is commutative."""
        if not self._matches(other):
            return NotImplemented
        x = self.x
        return Isotropic(
            self.a * other.a - x * (self.b * other.b),
            self.a * other.b + self.b * other.a,
            self.a * other.c + self.c * other.a + self.b * other.b + x * (self.c * other.c),
            x,
        )


class MeaninglessError(TypeError):
    """Error for an operation that is not defined for its operands."""


def quaternion(a: Any) -> Quaternion:
    """Return a number, vector or quaternion as a quaternion."""
    if isinstance(a, Quaternion):
        return a
    if isinstance(a, Vector):
        return Quaternion(0, a)
    if isinstance(a, Structure):
        raise MeaninglessError(f"a {type(a).__name__.lower()} is no quaternion")
    return Quaternion(a, Vector(0, 0, 0))


def add(a: Any, b: Any) -> Any:
    """Return the sum; a number plus a vector is a quaternion."""
    if type(a) is type(b) or not (isinstance(a, Structure) or isinstance(b, Structure)):
        return a + b
    return quaternion(a) + quaternion(b)


def multiply(a: Any, b: Any) -> Any:
    """Return the product of two adjacent factors in a formula."""
    if not (isinstance(a, Structure) and isinstance(b, Structure)):
        return a * b
    if isinstance(a, Tensor) and isinstance(b, Tensor | Vector):
        return a @ b
    return quaternion(a) * quaternion(b)
