r"""Parameterizations ``v = φ(α) u`` of displacements as functions of α: φ and the tangent operator.

.. math::
    T &= \frac{\sin\alpha}{\varphi}\,I + \frac{1 - \cos\alpha}{\varphi^2}\,\tilde v
        + \frac{1/\varphi' - \sin\alpha/\varphi}{\varphi^2}\,v \otimes v \\
    T^{-1} &= \frac{\varphi}{2} \cot\frac{\alpha}{2}\,I - \frac12\,\tilde v
        + \frac{\varphi' - (\varphi/2) \cot(\alpha/2)}{\varphi^2}\,v \otimes v

The space twist is ``ω = T v̇``. All coefficients are smooth functions of ``x = v · v`` at α = 0.
Since ``det T = 2 (1 − cos α)/(φ′ φ²)``, T loses rank at Re α = 2πk, k ≠ 0. T is not defined where φ′ = 0.
"""

from __future__ import annotations

from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any, TypeAlias

import sympy

from ..algebra import Coefficient, Vector, functions
from .elementary import evaluate
from .polynomials import require_order

alpha = sympy.Symbol("alpha")
"""Dual angle α: rotation angle + ε translation along the screw axis."""

Triple: TypeAlias = tuple[sympy.Expr, sympy.Expr, sympy.Expr]


@dataclass(frozen=True)
class Family:
    """Parameterization ``v = φ(α) u`` with a name; φ is a function of `alpha`, odd and smooth near 0."""

    name: str
    phi: sympy.Expr

    @property
    def tangent(self) -> Triple:
        """Coefficients of I, ṽ and v⊗v in T, functions of α ≠ 0."""
        at = of_angle(self.phi)
        return at.f, at.g, at.h

    @property
    def tangent_inv(self) -> Triple:
        """Coefficients of I, ṽ and v⊗v in T⁻¹, functions of Re α ≠ 2πk."""
        at = of_angle(self.phi)
        return at.fi / 2, -sympy.Rational(1, 2), at.hi / 2

    def at(self, angle: Coefficient, library: Any = functions) -> Coefficient:
        """Return φ at a number; `library` provides ``sin``, ``cos`` and ``sqrt``. A pole raises ZeroDivisionError."""
        return evaluate(self.phi, alpha, angle, library)

    def vector(self, angle: Coefficient, axis: Vector, library: Any = functions) -> Vector:
        """Return ``v = φ(α) u`` for a dual angle α and an axis u."""
        v: Vector = axis * self.at(angle, library)
        return v


def rodrigues(n: int) -> Family:
    """Higher-order Rodrigues vector, ``tan(α/2n) u``, CP23 (49) at k = 0."""
    return Family(f"Rodrigues of order {n}", sympy.tan(alpha / (2 * require_order(n))))


def normal_rodrigues(n: int) -> Family:
    """Normal higher-order Rodrigues vector, ``2n tan(α/2n) u``: φ′(0) = 1."""
    return Family(f"normal Rodrigues of order {n}", 2 * n * rodrigues(n).phi)


def sine(n: int) -> Family:
    """Sine family, ``sin(α/2n) u``: orthographic at n = 1, Lambert's equal-area projection at n = 2."""
    return Family(f"sine of order {n}", sympy.sin(alpha / (2 * require_order(n))))


def breusing() -> Family:
    """Breusing's projection, the geometric mean ``√(tan(α/4) sin(α/4)) u`` for α ≥ 0, written as an odd function."""
    return Family("Breusing", sympy.sin(alpha / 4) / sympy.sqrt(sympy.cos(alpha / 4)))


def isochoric() -> Family:
    """Isochoric vector, ``[6 (α − sin α)]^(1/3) u``, with det T = 1: volumes of sets of rotations are preserved."""
    return Family("isochoric", sympy.cbrt(6 * (alpha - sympy.sin(alpha))))


def of_angle(phi: sympy.Expr) -> SimpleNamespace:
    """Return the scalars of a chart (`chart.Scalars`) and x as functions of α."""
    sine, cosine, slope = sympy.sin(alpha / 2), sympy.cos(alpha / 2), phi.diff(alpha)
    f, fi = 2 * sine * cosine / phi, phi * cosine / sine
    g, h, hi = 2 * sine**2 / phi**2, (1 / slope - f) / phi**2, (2 * slope - fi) / phi**2
    return SimpleNamespace(x=phi**2, s=cosine, w=sine / phi, f=f, g=g, h=h, fi=fi, hi=hi)


def by_square(expression: sympy.Expr, phi: sympy.Expr) -> sympy.Expr:
    """Return the derivative of a function of α with respect to x = φ²."""
    return expression.diff(alpha) / (2 * phi * phi.diff(alpha))
