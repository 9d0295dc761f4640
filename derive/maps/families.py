r"""Scalars of a parameterization ``v = φ(α) u`` as functions of α, from φ.

.. math::
    T &= \frac{\sin\alpha}{\varphi}\,I + \frac{1 - \cos\alpha}{\varphi^2}\,\tilde v
        + \frac{1/\varphi' - \sin\alpha/\varphi}{\varphi^2}\,v \otimes v \\
    T^{-1} &= \frac{\varphi}{2} \cot\frac{\alpha}{2}\,I - \frac12\,\tilde v
        + \frac{\varphi' - (\varphi/2) \cot(\alpha/2)}{\varphi^2}\,v \otimes v

The space twist is ``ω = T v̇``. All coefficients are smooth functions of ``x = v · v`` at α = 0.
Since ``det T = 2 (1 − cos α)/(φ′ φ²)``, T loses rank at Re α = 2πk, k ≠ 0. T is not defined where φ′ = 0.
"""

from __future__ import annotations

from types import SimpleNamespace

import sympy

alpha = sympy.Symbol("alpha")
"""Dual angle α: rotation angle + ε translation along the screw axis."""


def of_angle(phi: sympy.Expr) -> SimpleNamespace:
    """Return the scalars of a chart (`chart.Scalars`) and x as functions of α."""
    sine, cosine, slope = sympy.sin(alpha / 2), sympy.cos(alpha / 2), phi.diff(alpha)
    f, fi = 2 * sine * cosine / phi, phi * cosine / sine
    g, h, hi = 2 * sine**2 / phi**2, (1 / slope - f) / phi**2, (2 * slope - fi) / phi**2
    return SimpleNamespace(x=phi**2, s=cosine, w=sine / phi, f=f, g=g, h=h, fi=fi, hi=hi)
