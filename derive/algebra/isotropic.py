"""Commutative algebra of the tensors ``a I + b skew(v) + c v⊗v`` of one vector v, with ``x = v · v``.

Since ``skew(v)² = v⊗v − x I`` and ``skew(v) v = 0``, products, transposes and inverses stay in the algebra. Their
coefficients are rational in a, b, c and x, without v. Hence an identity between such tensors is an identity between
functions of x, for real and dual vectors alike.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from .dual import Coefficient, Structure
from .latex import combination
from .structures import Tensor, Vector

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
