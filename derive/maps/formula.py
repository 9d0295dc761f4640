"""Formulas of the paper as objects with coefficients, equation numbers and domain."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar

import mpmath
import sympy

from ..algebra import Dual, Isotropic, Quaternion, Structure, Tensor, Vector
from ..algebra.latex import Typeset, combination
from ..algebra.structures import BASIS
from .elementary import alpha
from .polynomials import x


@dataclass(frozen=True, slots=True)
class Formula(Typeset):
    """Map of order n with exact coefficients: functions of ``x = v · v``, or of α with `angle` as function of x."""

    name: str  # quaternion, tensor, tangent or tangent_inv
    order: int | sympy.Expr
    coefficients: tuple[sympy.Expr, ...]
    equations: tuple[int, ...]  # numbers in CP23: the general equations, then the one for this order, if printed
    identities: tuple[str, ...] = field(repr=False)
    domain: str = field(repr=False)
    singular: str = field(repr=False)  # text on the singular set of the map or its inverse
    symbol: str = field(repr=False)  # LaTeX of the left-hand side
    definition: str = field(repr=False)  # LaTeX of the right-hand side in p_n, q_n
    angle: sympy.Expr = field(default=alpha, repr=False)  # α as a function of x
    at_zero: tuple[sympy.Expr, ...] = field(default=(), repr=False)  # coefficients at α = 0 if they are 0/0

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
        definition, *letters = self.definition.split(r" \qquad ")
        return r" \qquad ".join((f"{self.symbol} = {definition} = {self.explicit}", *letters))

    @property
    def explicit(self) -> str:
        """LaTeX of the right-hand side with explicit coefficients, ``a I + …``."""
        return combination(self.coefficients, self.basis)

    def _typeset(self) -> str:
        return self.latex()

    def matrix(self, v: Sequence[Any]) -> Any:
        """Return the real and the dual part of the map at v, as functions of its components.

        Components are symbols, expressions or numbers. Floats are exact numbers here, and results are rounded once.
        Formulas in α contain ``α = φ⁻¹(|v|)`` as a function that SymPy differentiates. They are 0/0 at symbols that
        become 0 later.

        Parameters
        ----------
        v : sequence of 6 or 3 components
            Dual vector, real part first; or a real vector, for rotations alone.

        Returns
        -------
        tuple of two Matrix, or Matrix
            Real and dual part for 6 components, the real part for 3: 3x3 matrices, or 4x1 columns of a quaternion,
            scalar first. Floats beyond the edge of the chart give entries that are not real: NaN or complex.

        Raises
        ------
        ValueError
            If v has another number of components, or one of them is no number or expression.

        Examples
        --------
        >>> import derive, sympy
        >>> t, s = sympy.symbols("t s")
        >>> re, du = derive.Cayley(2).tensor.matrix([0, 0, t, 0, 0, s])  # about and along the third axis
        >>> sympy.factor(re[1, 0])
        -4*t*(t - 1)*(t + 1)/(t**2 + 1)**2
        >>> derive.family("exponential").quaternion.matrix([0, 0, sympy.pi / 2]).T
        Matrix([[sqrt(2)/2, 0, 0, sqrt(2)/2]])
        """
        given, digits, working = _prepared(v)
        vector = Vector.dual(given[:3], given[3:] or (0, 0, 0))
        value = self._at(vector, tuple(self._at_vector(vector)))
        columns = (sympy.Matrix([*part]) for part in (value.re, value.du))
        re, du = (part.reshape(len(part) // value.columns, value.columns) for part in columns)
        if digits:
            re, du = re.evalf(working).evalf(digits), du.evalf(working).evalf(digits)
        return (re, du) if len(given) == 6 else re

    def _at_vector(self, v: Vector) -> Iterator[Dual]:
        """Yield the coefficients ``f(x) + ε x° f′(x)`` at a dual vector."""
        square = v.dot(v)
        if self.at_zero and all(c.re == 0 for c in v):  # x° is 0 too
            yield from (Dual(c, 0) for c in self.at_zero)
            return
        for coefficient in self.coefficients:
            value = coefficient.xreplace({alpha: self.angle})
            yield Dual(value.xreplace({x: square.re}), square.du * value.diff(x).xreplace({x: square.re}))

    def _at(self, v: Vector, coefficients: tuple[Dual, ...]) -> Structure:
        """Return the value at a vector, from the coefficients there."""
        raise NotImplementedError


def _prepared(v: Sequence[Any]) -> tuple[list[sympy.Expr], int, int]:
    """Return components as expressions, and digits of results and of work; 0 digits if there is a symbol or no float.

    With floats, all numbers get the working digits. At a small α up to five times its digits cancel, in the slope of h;
    near an edge, twice the digits of a float.
    """
    if len(v) not in (3, 6):
        raise ValueError(f"expected 6 components, real part v1 v2 v3 then dual part, or 3 for a rotation, got {len(v)}")
    given = [sympy.sympify(c, strict=True) for c in v]
    floats = [c for c in given if c.is_Float]
    if not floats or not all(c.is_number for c in given):
        return given, 0, 0
    digits = min(mpmath.libmp.prec_to_dps(c._prec) for c in floats)
    spread = max((abs(mpmath.log10(abs(mpmath.mpf(c)))) for c in floats if c), default=0)
    working = 4 * digits + 5 * int(spread)
    return [c.evalf(working) for c in given], digits, working


class IsotropicMap(Formula):
    """Dual tensor ``a I + b skew(v) + c v⊗v``; its coefficients are (a, b, c), rational in x."""

    __slots__ = ()

    basis = BASIS

    def _at(self, v: Vector, coefficients: tuple[Dual, ...]) -> Tensor:
        a, b, c = coefficients
        return Isotropic(a, b, c, v.dot(v)).tensor(v)


class QuaternionMap(Formula):
    """Unit dual quaternion ``s + t v``; its coefficients (s, t) have the denominator ``(1+x)^(n/2)``."""

    __slots__ = ()

    basis = ("", "v")

    def _at(self, v: Vector, coefficients: tuple[Dual, ...]) -> Quaternion:
        s, t = coefficients
        return Quaternion(s, v * t)
