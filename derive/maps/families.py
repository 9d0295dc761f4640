r"""Parameterizations ``v = φ(α) u`` of displacements: φ, the factor a(v) of their Cayley map, and the tangent operator.

With ``q̂ = cos α/2 + u sin α/2`` and φ odd and smooth,

.. math::
    \hat q = \pm\frac{(a + v)^n}{(a^2 + v \cdot v)^{n/2}}, \qquad a = \varphi(\alpha) \cot\frac{\alpha}{2n}
        \qquad \text{CP23 (60), (61)}

.. math::
    T &= \frac{\sin\alpha}{\varphi}\,I + \frac{1 - \cos\alpha}{\varphi^2}\,\tilde v
        + \frac{1/\varphi' - \sin\alpha/\varphi}{\varphi^2}\,v \otimes v \\
    T^{-1} &= \frac{\varphi}{2} \cot\frac{\alpha}{2}\,I - \frac12\,\tilde v
        + \frac{\varphi' - (\varphi/2) \cot(\alpha/2)}{\varphi^2}\,v \otimes v

where ``ω = T v̇`` is the space twist. All coefficients are smooth functions of ``x = v · v`` at α = 0.
``det T = 2 (1 − cos α)/(φ′ φ²)``, so that T loses rank at Re α = 2πk, k ≠ 0, and is not defined where φ′ = 0.
"""

from __future__ import annotations

from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any, TypeAlias

import sympy

from ..algebra import Coefficient, Vector, functions
from .any_phi.elementary import evaluate
from .polynomials import require_order, x

alpha = sympy.Symbol("alpha")
"""Dual angle α: rotation angle + ε translation along the screw axis."""

Triple: TypeAlias = tuple[sympy.Expr, sympy.Expr, sympy.Expr]


@dataclass(frozen=True)
class Family:
    """Parameterization ``v = φ(α) u``.

    Parameters
    ----------
    name : str
    order : int
        Order n of the Cayley map with the factor a(v).
    phi : Expr
        φ as a function of `alpha`: odd, smooth near 0, φ′(0) rational and not 0.
    scale : Expr
        Factor a(v) as a function of ``x = v · v``.
    domain : str
        Range of Re α in which φ is defined and increases, and `scale` holds.
    """

    name: str
    order: int
    phi: sympy.Expr
    scale: sympy.Expr
    domain: str

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
    phi = sympy.tan(alpha / (2 * require_order(n)))
    return Family(f"Rodrigues of order {n}", n, phi, sympy.Integer(1), f"|Re alpha| < {n} pi")


def normal_rodrigues(n: int) -> Family:
    """Normal higher-order Rodrigues vector, ``2n tan(α/2n) u``: φ′(0) = 1."""
    phi = 2 * require_order(n) * sympy.tan(alpha / (2 * n))
    return Family(f"normal Rodrigues of order {n}", n, phi, sympy.Integer(2 * n), f"|Re alpha| < {n} pi")


def sine(n: int) -> Family:
    """Sine family, ``sin(α/2n) u``: orthographic at n = 1, Lambert at n = 2."""
    phi = sympy.sin(alpha / (2 * require_order(n)))
    return Family(f"sine of order {n}", n, phi, sympy.sqrt(1 - x), f"|Re alpha| < {n} pi")


def orthographic() -> Family:
    """Orthographic projection, ``sin(α/2) u``."""
    return sine(1)


def lambert() -> Family:
    """Lambert's equal-area projection, ``sin(α/4) u``."""
    return sine(2)


def breusing() -> Family:
    """Breusing's projection, the geometric mean ``√(tan(α/4) sin(α/4)) u`` for α ≥ 0, written as an odd function."""
    phi = sympy.sin(alpha / 4) / sympy.sqrt(sympy.cos(alpha / 4))
    scale = sympy.sqrt((sympy.sqrt(4 + x**2) - x) / 2)
    return Family("Breusing", 2, phi, scale, "|Re alpha| < 2 pi")


def isochoric() -> Family:
    """Isochoric vector, ``[6 (α − sin α)]^(1/3) u``, with det T = 1: volumes of sets of rotations are preserved."""
    phi = sympy.cbrt(6 * (alpha - sympy.sin(alpha)))
    scale = phi * sympy.cot(alpha / 2)  # not an elementary function of x
    return Family("isochoric", 1, phi, scale, "every alpha; T loses rank at |Re alpha| = 2 pi k")


def of_angle(phi: sympy.Expr) -> SimpleNamespace:
    """Return the scalars of a chart (`chart.Scalars`) and x as functions of α."""
    sine, cosine, slope = sympy.sin(alpha / 2), sympy.cos(alpha / 2), phi.diff(alpha)
    f, fi = 2 * sine * cosine / phi, phi * cosine / sine
    g, h, hi = 2 * sine**2 / phi**2, (1 / slope - f) / phi**2, (2 * slope - fi) / phi**2
    return SimpleNamespace(x=phi**2, s=cosine, w=sine / phi, f=f, g=g, h=h, fi=fi, hi=hi)


def by_square(expression: sympy.Expr, phi: sympy.Expr) -> sympy.Expr:
    """Return the derivative of a function of α with respect to x = φ²."""
    return expression.diff(alpha) / (2 * phi * phi.diff(alpha))
