r"""The scalars a chart is lowered with are its formulas, and those of φ: decided exactly, for any algebraic chart.

What a chart computes at x runs on the element x of the exact ring, Q(x) with the root s = sqrt(1 ± x) where formulas
have one. With ``q̂ = s + w v`` and ``y = v · v̇``, ``ṡ = s_y y``, ``ẇ = w_y y``, the twist ``ω = 2 vec(q̂' q̂*)`` is

.. math:: \omega = 2 s w\,\dot v + 2 w^2\,v \times \dot v + 2 (s w_y - w s_y)\,(v \cdot \dot v)\,v

so that f, g and h of T = f I + g skew(v) + h v⊗v are these. Along v it is ``(f + x h) v̇``, and α̇ = φ̇/φ′ there:
``(f + x h) φ′ = 1`` at ``x = φ²`` and q̂ = 1 at v = 0 say that ``q̂ = cos(α/2) + u sin(α/2)`` for ``v = φ(α) u``.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property
from types import SimpleNamespace
from typing import Any

import sympy
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from ..algebra.arithmetic import PLAIN
from ..maps.chart import Chart, Scalars
from ..maps.families import alpha, evaluate
from ..maps.polynomials import x
from .element import Element
from .exact import Ring
from .identity import Check, Claim, Proof, decide
from .polynomial_backend import Polynomial
from .ratio import NotExactError, Ratio, RationalFunctions

TRIGONOMETRY = SimpleNamespace(sin=Ratio.sin, cos=Ratio.cos, sqrt=Ratio.sqrt)
METHOD = "residues in Q(x), with the root of 1 ± x where formulas have it"


def root_of(expressions: Iterable[Any]) -> int:
    """The sign in the root sqrt(1 ± x) that expressions in x hold; 0 where they hold none.

    Raises
    ------
    ValueError
        If they hold another root, or both.
    """
    powers = {power for expression in expressions for power in expression.atoms(sympy.Pow)}
    radicands = {power.base for power in powers if not power.exp.is_Integer}
    if not radicands:
        return 0
    for sign in (1, -1):
        if radicands == {1 + sign * x}:
            return sign
    raise ValueError(f"formulas may hold one root, of 1 + x or of 1 - x, not of {', '.join(map(str, radicands))}")


class ScalarProofs:
    """What is decided about the scalars of a chart.

    Parameters
    ----------
    chart : Chart
    backend : {"flint", "sympy"}, optional
        Polynomial library of the exact ring.
    """

    def __init__(self, chart: Chart, backend: str | None = None) -> None:
        self.chart = chart
        maps = (chart.quaternion, chart.tensor, chart.tangent, chart.tangent_inv)
        self.ring = Ring(root=root_of(a for formula in maps for a in formula.coefficients), backend=backend)
        self.x = self.ring.square("v")

    @cached_property
    def at(self) -> Scalars:
        """The scalars at the element x."""
        return self.chart.scalars(self.x, PLAIN)

    def proofs(self) -> Iterator[Proof]:
        """Decide the statements one after another."""
        table = (
            (
                "the scalars that are lowered are those of the formulas",
                r"\hat q = s + w\,v,\ R = I + f\,\tilde v + g\,\tilde v^2",
                self.formulas,
            ),
            (
                "s^2 + x w^2 = 1, f = 2 s w, g = 2 w^2, vect(R' R^T) = T v', T T^-1 = I of these scalars",
                r"s^2 + x w^2 = 1,\ f = 2 s w,\ g = 2 w^2,\ \mathrm{vect}(\dot R R^T) = T \dot v,\ T T^{-1} = I",
                self.relations,
            ),
            ("their slopes are 2 d/dx of them", r"f_y = 2 f'", self.slopes),
            (
                "q = cos(alpha/2) + u sin(alpha/2) for v = phi(alpha) u",
                r"\hat q = \cos\tfrac\alpha2 + u \sin\tfrac\alpha2",
                self.angle,
            ),
        )
        scope = f"n = {self.chart.order}" if self.chart.cayley else self.chart.name
        for statement, latex, checks in table:
            yield decide(Claim(statement, latex, METHOD), checks, scope)

    def formulas(self) -> Iterator[Check]:
        """What the formulas say, less what is computed."""
        at, half = self.at, self.ring.constant(1) / 2
        computed = {
            "quaternion": (at.s, at.w),
            "tensor": (1 - self.x * at.g, at.f, at.g),
            "tangent": (at.f, at.g, at.h),
            "tangent_inv": (at.fi * half, -half, at.hi * half),
        }
        for name, values in computed.items():
            stated = getattr(self.chart, name).coefficients
            for i, (expression, value) in enumerate(zip(stated, values, strict=True)):
                yield f"{name}[{i}]", self.ring.lift(expression, {x: self.x}) - value

    def relations(self) -> Iterator[Check]:
        """Each scalar by s and w and their slopes."""
        at = self.at
        a, b, _ = at.ray
        yield "|q|^2", at.s * at.s + self.x * at.w * at.w - 1
        yield "f", at.f - 2 * at.s * at.w
        yield "g", at.g - 2 * at.w * at.w
        yield "h", at.h - 2 * (at.s * at.wy - at.w * at.sy)
        yield "fi", at.fi * at.g - at.f
        yield "hi", (at.f + self.x * at.h) * (at.fi + self.x * at.hi) - 2
        yield "ray", a * at.w - b * at.s

    def slopes(self) -> Iterator[Check]:
        """2 d/dx of each scalar, less its slope."""
        for name in ("s", "w", "f", "g", "h", "fi", "hi"):
            value = self.ring.element(getattr(self.at, name))
            yield f"{name}y", 2 * value.derivative("x") - getattr(self.at, f"{name}y")

    def angle(self) -> Iterator[Check]:
        """``(f + x h) φ′ − 1`` at ``x = φ²``, and q̂ at v = 0, positive as φ′ is."""
        angle = RationalFunctions((), {alpha.name: _steps(self.chart.phi)}).symbol(alpha.name)
        phi, slope = (evaluate(f, alpha, angle, TRIGONOMETRY) for f in (self.chart.phi, self.chart.phi.diff(alpha)))
        radicand = 1 + self.ring.root * phi * phi
        try:
            at = radicand.sqrt() if self.ring.root else phi * phi
        except NotExactError:
            yield "the root of 1 ± phi^2 is no function of the angle's sine and cosine", radicand
        else:
            yield "(f + x h) phi'", self._value(self.at.f + self.x * self.at.h, at) * slope - 1
            yield "s at x = 0", self._value(self.ring.element(self.at.s), phi * 0 + abs(self.ring.root)) - 1

    def _value(self, element: Element, at: Ratio) -> Ratio:
        """A function of x where x, or the root of 1 ± x, is this; in lowest terms first."""
        library = self.ring.polynomials
        above, below = element.terms.get(0, library.zero), element.denominator
        common = library.gcd(above, below)

        def value(polynomial: Polynomial) -> Any:
            return sum(c * at**power for (power,), c in library.coefficients(polynomial).items())

        quotient: Ratio = value(library.quotient(above, common)) / value(library.quotient(below, common))
        return quotient


def _steps(phi: sympy.Expr) -> int:
    """The least M such that φ holds sines and cosines of multiples of α/M only."""
    arguments = (function.args[0] for function in phi.atoms(TrigonometricFunction))
    return int(sympy.ilcm(1, *(argument.coeff(alpha).q for argument in arguments)))
