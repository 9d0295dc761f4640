r"""Proofs that the formulas of a chart agree with its φ and, for an algebraic chart, with its scalars.

A chart with formulas in the angle α is an instance of the theorems on every φ. The functions of an algebraic chart are
evaluated at the element x of the exact ring: Q(x), with sqrt(1 + x/k) if formulas contain this root. With
``q̂ = s + w v`` and ``y = v · v̇``, ``ṡ = s_y y``, ``ẇ = w_y y``, the twist ``ω = 2 vec(q̂' q̂*)`` is

.. math:: \omega = 2 s w\,\dot v + 2 w^2\,v \times \dot v + 2 (s w_y - w s_y)\,(v \cdot \dot v)\,v

This gives f, g and h of T = f I + g skew(v) + h v⊗v. For v̇ along v, the twist is ``(f + x h) v̇``, and α̇ = φ̇/φ′.
Let ``(f + x h) φ′ = 1`` at ``x = φ²``, q̂ = 1 at v = 0, and φ = 0 at α = 0. Then ``q̂ = cos(α/2) + u sin(α/2)`` for
``v = φ(α) u``.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property, partial
from types import SimpleNamespace
from typing import Any

import sympy
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from ..algebra.arithmetic import PLAIN
from ..algebra.element import Element, Polynomial
from ..algebra.exact import AngleField
from ..maps.chart import Chart
from ..maps.elementary import alpha, evaluate
from ..maps.polynomials import x
from .evaluation import Evaluation
from .identity import Checks, Equation, Proof, decide
from .notation import Shifted, det, prime
from .phi_premises import PHI, SCALARS, T, cosine, sine
from .phi_theorems import any_phi
from .rings import Ring

METHOD = "residues in Q(x), with the root of 1 + x/k where formulas have it"
BY_ANGLE = "residues in Q(tan(alpha/2M)), M such that phi is made of sines and cosines of multiples of alpha/M"
BY_PHI = "instance of the theorems on every phi, differences of the coefficients as functions of alpha"

VALUES, SLOPES = ("s", "w", "f", "g", "h", "fi", "hi"), ("sy", "wy", "fy", "gy", "hy", "fiy", "hiy")
BENDS = ("fyy", "gyy", "hyy", "fiyy", "hiyy")
s, w, f, g, h, fi, hi = sympy.symbols(VALUES)
sy, wy, fy, gy, hy, fiy, hiy = sympy.symbols(SLOPES)
a, b, phi, slope = sympy.symbols("a b phi phi'")

FORMULAS = {
    "quaternion": (s, w),
    "tensor": (1 - x * g, f, g),
    "tangent": (f, g, h),
    "tangent_inv": (fi / 2, -sympy.Rational(1, 2), hi / 2),
}
"""Coefficients of each map in terms of the scalars."""

STATED = tuple(Equation(e, sympy.Symbol(f"{name}[{i}]")) for name, of in FORMULAS.items() for i, e in enumerate(of))
"""Equations between the scalars and the coefficients that a chart states."""

RELATIONS = (
    Equation(s**2 + x * w**2, 1),
    Equation(f, 2 * s * w),
    Equation(g, 2 * w**2),
    Equation(h, 2 * (s * wy - w * sy)),
    Equation(fi * g, f),
    Equation((f + x * h) * (fi + x * hi), 2),
    Equation(a * w, b * s),
)
"""Equations for |q̂| = 1, R as the tensor of q̂, vect(Ṙ Rᵀ) = T v̇, T T⁻¹ = I, and a + b v as a multiple of q̂."""

DERIVATIVES = tuple(
    Equation(of, 2 * prime(value)) for of, value in zip((sy, wy, fy, gy, hy, fiy, hiy), (s, w, f, g, h, fi, hi))
)
SECOND_DERIVATIVES = tuple(
    Equation(sympy.Symbol(name), 2 * prime(of)) for name, of in zip(BENDS, (fy, gy, hy, fiy, hiy))
)
ANGLE = (Equation((f + x * h) * slope, 1), Equation(Shifted(s, x, 0), 1), Equation(Shifted(phi, alpha, 0), 0))


def _coefficients(chart: Chart) -> list[sympy.Expr]:
    return [coefficient for name in FORMULAS for coefficient in getattr(chart, name).coefficients]


def root_of(expressions: Iterable[sympy.Expr]) -> int:
    """Return the integer k of the root sqrt(1 + x/k) in expressions in x; 0 without a root, ValueError for others."""
    powers = {power for expression in expressions for power in expression.atoms(sympy.Pow)}
    roots = {power for power in powers if not power.exp.is_Integer}
    if not roots:
        return 0
    found = {_divisor(root) for root in roots}
    if len(found) == 1 and None not in found:
        return int(found.pop() or 0)
    named = ", ".join(sorted(map(str, roots)))
    raise ValueError(f"formulas may hold the square root of 1 + x/k for one integer k, not {named}")


def _divisor(root: sympy.Pow) -> sympy.Integer | None:
    """Return k if the root is a power of sqrt(a² + a² x/k) with rational a, else None."""
    start, step = root.base.coeff(x, 0), root.base.coeff(x, 1)
    right = (2 * root.exp).is_Integer and step != 0 and root.base == start + step * x
    if not (right and sympy.sqrt(start).is_Rational and (start / step).is_Integer):
        return None
    return sympy.Integer(start / step)


class ScalarProofs:
    """Proofs about the scalars of a chart."""

    def __init__(self, chart: Chart) -> None:
        self.chart = chart
        self.stated = _coefficients(chart)
        self.ring = Ring(root=root_of(self.stated))

    @cached_property
    def values(self) -> Mapping[sympy.Expr, Element]:
        """Values of the symbols: scalars as the chart computes them, their derivatives, and the stated coefficients."""
        at_x = self.ring.x
        at = self.chart.scalars(at_x, PLAIN)
        found = {name: self.ring.element(getattr(at, name)) for name in (*VALUES, *SLOPES, *BENDS)}
        values = {sympy.Symbol(name): value for name, value in found.items()}
        values |= {prime(sympy.Symbol(name)): self.ring.derivative(found[name], "x") for name in (*VALUES, *SLOPES)}
        values |= {e.right: self.ring.lift(c, {x: at_x}) for e, c in zip(STATED, self.stated, strict=True)}
        size_s, size_w, _ = map(self.ring.element, at.ray)
        return values | {a: size_s, b: size_w, x: at_x}

    def proofs(self) -> Iterator[Proof]:
        statements = {
            "scalars as lowered": STATED, "scalars": RELATIONS, "slopes": DERIVATIVES,
            "second slopes": SECOND_DERIVATIVES,
        }  # fmt: skip
        scope = f"n = {self.chart.order}" if self.chart.cayley else self.chart.name
        for name, claim in statements.items():
            yield decide(name, claim, METHOD, partial(self._residues, claim), scope)
        yield decide("q = cos(alpha/2) + u sin(alpha/2)", ANGLE, BY_ANGLE, self._angle, scope)

    def _residues(self, claim: Iterable[Equation]) -> Checks:
        for equation in claim:
            left, right = (self.ring.lift(side, self.values) for side in (equation.left, equation.right))
            yield equation.text, left - right

    def _angle(self) -> Checks:
        """Yield left side minus right side at ``x = φ²``, and for the initial values at x = 0 and α = 0."""
        field = AngleField((), {alpha.name: _steps(self.chart.phi)})
        functions = SimpleNamespace(sin=field.sin, cos=field.cos, sqrt=Element.sqrt)
        angle, phi = field.symbol(alpha.name), self.chart.phi
        size, rate = (evaluate(e, alpha, angle, functions) for e in (phi, phi.diff(alpha)))
        values = {symbol: self._at(self.values[symbol], size * size) for symbol in (f, h, x)}
        starts = (self._at(self.values[s], size * 0), phi.subs(alpha, 0))
        values |= dict(zip((e.left for e in ANGLE[1:]), starts, strict=True))
        at = Evaluation(values | {slope: rate})
        for equation in ANGLE:
            yield equation.text, at.value(equation.left) - at.value(equation.right)

    def _at(self, element: Element, square: Element) -> Element:
        element = self.ring.fraction(element.numerator, element.denominator)
        generator = (1 + square / self.ring.root).sqrt() if self.ring.root else square

        def value(polynomial: Polynomial) -> Any:
            return sum(c * generator ** powers[-1] for powers, c in self.ring.library.terms(polynomial).items())

        quotient: Element = value(element.numerator) / value(element.denominator)
        return quotient


def _steps(phi: sympy.Expr) -> int:
    """Return the least M such that all trigonometric functions in φ have multiples of α/M as arguments."""
    arguments = (function.args[0] for function in phi.atoms(TrigonometricFunction))
    return int(sympy.ilcm(1, *(argument.coeff(alpha).q for argument in arguments)))


def instance(chart: Chart) -> Iterator[Proof]:
    """Yield the theorems, and the proof that a chart with scalars in α is an instance of them."""
    yield from any_phi()
    in_angle = {premise.equation.left: premise.equation.right for premise in SCALARS}
    claim = tuple(e.replaced(in_angle) for e in STATED)
    symbols = dict(zip(PHI, (chart.written.diff(alpha, order) for order in range(len(PHI))), strict=True))
    symbols |= {sine: sympy.sin(alpha / 2), cosine: sympy.cos(alpha / 2), x: chart.written**2}

    def checks() -> Checks:
        for equation, found in zip(claim, _coefficients(chart), strict=True):
            difference = sympy.together(equation.left.xreplace(symbols) - found)
            yield equation.text, sympy.expand(sympy.fraction(difference)[0])

    yield decide("coefficients in alpha", claim, BY_PHI, checks, chart.name)
    yield _at_origin(chart)
    yield from _volume(chart)


def _volume(chart: Chart) -> Iterator[Proof]:
    """Decide that det T is constant, for a multiple of the homochoric vector: its cube is ``3 k (α − sin α)``."""
    cube = sympy.expand(chart.written**3)
    share = cube.coeff(alpha) / 3
    if share and sympy.expand(cube - 3 * share * (alpha - sympy.sin(alpha))) == 0:
        claim = Equation(det(T), 2 / share)

        def checks() -> Checks:
            yield claim.text, sympy.expand(2 * (1 - sympy.cos(alpha)) - claim.right * cube.diff(alpha) / 3)

        yield decide("constant volume element", (claim,), BY_PHI, checks, chart.name)


def _at_origin(chart: Chart) -> Proof:
    """Decide whether φ is odd, φ(0) = 0 and φ′(0) ≠ 0: this makes every scalar a function of x, analytic at 0."""
    claim = (Equation(Shifted(phi, alpha, 0), 0), Equation(Shifted(phi, alpha, -alpha), -phi))

    def checks() -> Checks:
        for equation in claim:
            there = chart.phi.subs(alpha, equation.left.args[2])
            yield equation.text, sympy.expand(there - equation.right.xreplace({phi: chart.phi}))
        slope = chart.phi.diff(alpha).subs(alpha, 0)
        yield "phi' at 0 is a number other than 0", 0 if slope.is_finite and slope.is_nonzero else 1

    return decide("phi at 0", claim, BY_PHI, checks, chart.name)
