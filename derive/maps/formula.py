"""Formulas of the paper as objects with coefficients, equation numbers and domain."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import ClassVar

import sympy

from ..algebra import Dual, Isotropic, Quaternion, Tensor, Vector
from ..algebra.isotropic import BASIS
from ..algebra.latex import combination
from ..output.typeset import Typeset
from .polynomials import x


@dataclass(frozen=True, slots=True)
class Formula(Typeset):
    """Map of order n whose coefficients are functions of ``x = v · v``, exact and reduced."""

    name: str  # quaternion, tensor, tangent or tangent_inv
    order: int
    coefficients: tuple[sympy.Expr, ...]
    equations: tuple[int, ...]  # numbers in CP23: the general equations, then the one for this order, if printed
    identities: tuple[str, ...] = field(repr=False)
    domain: str = field(repr=False)
    singular: str = field(repr=False)  # text on the singular set of the map or its inverse
    symbol: str = field(repr=False)  # LaTeX of the left-hand side
    definition: str = field(repr=False)  # LaTeX of the right-hand side in p_n, q_n

    basis: ClassVar[tuple[str, ...]] = ()
    """LaTeX of the basis that the coefficients multiply."""

    def latex(self) -> str:
        r"""Return the formula as LaTeX with explicit coefficients, ``symbol = definition = a I + …``.

        Examples
        --------
        >>> import derive
        >>> print(derive.Cayley(1).tangent_inv.latex().rpartition("= ")[2])
        \frac{1}{2} I - \frac{1}{2} \tilde{v} + \frac{1}{2} v \otimes v
        """
        return f"{self.symbol} = {self.definition} = {self.explicit}"

    @property
    def explicit(self) -> str:
        """LaTeX of the right-hand side with explicit coefficients, ``a I + …``."""
        return combination(self.coefficients, self.basis)

    def _typeset(self) -> str:
        return self.latex()

    def _expand(self, v: Sequence[sympy.Expr]) -> tuple[tuple[Dual, ...], Vector]:
        """Return the coefficients ``f(x) + ε x° f′(x)`` at the dual vector `v`, and the vector itself."""
        if len(v) != 6:
            raise ValueError(f"expected 6 symbols, real part v1 v2 v3 then dual part, got {len(v)}")
        vector = Vector.dual(v[:3], v[3:])
        square = vector.dot(vector)
        at = {x: square.re}
        duals = (Dual(a.xreplace(at), square.du * a.diff(x).xreplace(at)) for a in self.coefficients)
        return tuple(duals), vector


class IsotropicMap(Formula):
    """Dual tensor ``a I + b skew(v) + c v⊗v``; its coefficients are (a, b, c), rational in x."""

    __slots__ = ()

    basis = BASIS

    @property
    def isotropic(self) -> Isotropic:
        """Formula as an element of the algebra {I, skew(v), v⊗v} over the rational functions of x."""
        a, b, c = self.coefficients
        return Isotropic(a, b, c, x)

    def matrix(self, v: Sequence[sympy.Expr]) -> tuple[sympy.Matrix, sympy.Matrix]:
        """Return the real and the dual part as 3x3 matrices, for the 6 components of v, real part first.

        Examples
        --------
        >>> import derive, sympy
        >>> t, s = sympy.symbols("t s")
        >>> re, du = derive.Cayley(2).tensor.matrix([0, 0, t, 0, 0, s])  # about and along the third axis
        >>> sympy.factor(re[1, 0])
        -4*t*(t - 1)*(t + 1)/(t**2 + 1)**2
        """
        (a, b, c), vector = self._expand(v)
        entries: Tensor = Isotropic(a, b, c, vector.dot(vector)).tensor(vector)
        return sympy.Matrix(3, 3, list(entries.re)), sympy.Matrix(3, 3, list(entries.du))


class QuaternionMap(Formula):
    """Unit dual quaternion ``s + t v``; its coefficients (s, t) have the denominator ``(1+x)^(n/2)``."""

    __slots__ = ()

    basis = ("", "v")

    def matrix(self, v: Sequence[sympy.Expr]) -> tuple[sympy.Matrix, sympy.Matrix]:
        """Return the real and the dual part as columns, scalar first, for the 6 components of v, real part first.

        Examples
        --------
        >>> import derive, sympy
        >>> t = sympy.Symbol("t")
        >>> re, du = derive.Cayley(2).quaternion.matrix([0, 0, t, 0, 0, 0])
        >>> re.T
        Matrix([[(1 - t**2)/(t**2 + 1), 0, 0, 2*t/(t**2 + 1)]])
        """
        (s, t), vector = self._expand(v)
        components = Quaternion(s, vector * t)
        return sympy.Matrix(list(components.re)), sympy.Matrix(list(components.du))
