"""Proofs that a chart's formulas in the angle α are instances of the theorems on every φ."""

from __future__ import annotations

from collections.abc import Iterator

import sympy

from ..maps.chart import Chart
from ..maps.families import alpha
from ..maps.polynomials import x
from .identity import Check, Proof, decide
from .notation import Shifted
from .phi_theorems import PHI, SCALARS, any_phi, cosine, phi, sine
from .scalars import FORMULAS
from .statement import Equation

METHOD = "instance of the theorems on every phi, differences of the coefficients as functions of alpha"


def instance(chart: Chart) -> Iterator[Proof]:
    """Yield the theorems, and the proof that a chart with scalars in α is an instance of them."""
    yield from any_phi()
    scalars = {premise.equation.left: premise.equation.right for premise in SCALARS}
    claim = tuple(
        Equation(expected.xreplace(scalars), sympy.Symbol(f"{name}[{i}]"))
        for name, values in FORMULAS.items()
        for i, expected in enumerate(values)
    )
    stated = [c for name in FORMULAS for c in getattr(chart, name).coefficients]
    symbols = dict(zip(PHI, (chart.phi.diff(alpha, order) for order in range(len(PHI))), strict=True))
    symbols |= {sine: sympy.sin(alpha / 2), cosine: sympy.cos(alpha / 2), x: chart.phi**2}

    def checks() -> Iterator[Check]:
        for equation, found in zip(claim, stated, strict=True):
            difference = sympy.together(equation.left.xreplace(symbols) - found)
            yield equation.text, sympy.expand(sympy.fraction(difference)[0])

    yield decide("coefficients in alpha", claim, METHOD, checks, chart.name)
    yield _at_origin(chart)


def _at_origin(chart: Chart) -> Proof:
    """Decide whether φ is odd with φ(0) = 0 and φ′(0) ≠ 0; then every scalar is a function of x, analytic at 0."""
    claim = (Equation(Shifted(phi, alpha, 0), 0), Equation(Shifted(phi, alpha, -alpha), -phi))

    def checks() -> Iterator[Check]:
        for equation in claim:
            there = chart.phi.subs(alpha, equation.left.args[2])
            yield equation.text, sympy.expand(there - equation.right.xreplace({phi: chart.phi}))
        slope = chart.phi.diff(alpha).subs(alpha, 0)
        yield "phi' at 0 is a number other than 0", 0 if slope.is_finite and slope.is_nonzero else 1

    return decide("phi at 0", claim, METHOD, checks, chart.name)
