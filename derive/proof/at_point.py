"""Evaluation of printed statements about one order, at one rational point of a motion.

The evaluation is not a proof. It guards against a printed statement that differs from the decided components.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import sympy

from ..algebra import Dual, Isotropic, Quaternion, Vector, dual_part, real_part
from ..maps import polynomials
from . import notation as m
from .evaluation import Evaluation, NoValueError, mapped
from .formulas import Formulas
from .identity import Checks
from .statement import Equation

PLACE, SPEED, OTHER = (2, -4, 10), (3, 5, -1), (1, -2, 3)
"""Values of v, of its rate and of a point. Since 1 + 2² + 4² + 10² = 11², sqrt(1 + x) is rational."""


def _root(square: Dual) -> Dual:
    """Return the square root of a dual number whose real part is the square of a rational number."""
    above, below = map(math.isqrt, real_part(square).as_integer_ratio())
    root = Fraction(above, below)
    if root * root != real_part(square):
        raise NoValueError(f"{real_part(square)} is the square of no rational number")
    return Dual(root, dual_part(square) / (2 * root))


class AtPoint(Evaluation):
    """Values of the symbols at order n and a moving v = (2, −4, 10). Dual parts are time derivatives."""

    def __init__(self, n: int) -> None:
        self.n = n
        v = Vector(*(Dual(Fraction(place), Fraction(speed)) for place, speed in zip(PLACE, SPEED, strict=True)))
        x = v.dot(v)
        p, q = (Dual(Fraction(1)) * value for value in polynomials.pair_by_squaring(n, x))
        root = _root(1 + x)
        formulas, rates = Formulas(), v.map(dual_part)
        tensors = {m.R: formulas.tensor, m.dcay: formulas.tangent, m.dcay_inv: formulas.tangent_inv}
        values = {symbol: Isotropic(*formula(n, x, p, q), x).tensor(v) for symbol, formula in tensors.items()}
        omega = values[m.dcay].map(real_part) @ rates
        z = Quaternion(p, v * q)
        known = {m.x: x, m.p: p, m.q: q, m.v: v, m.v_dot: rates, m.omega: omega}
        known |= {m.point: Vector(*map(Fraction, OTHER)), m.z: z, m.q_hat: z * (1 / root**n)}
        super().__init__(known | values)

    def differentiated(self, operator: Any, value: Any) -> Any:
        return mapped(dual_part, value)

    def power(self, base: sympy.Expr, exponent: sympy.Expr) -> Any:
        return _root(self.value(base)) ** int(2 * exponent)

    def checks(self, equation: Equation) -> Checks:
        """Yield left side minus right side at the point, component by component."""
        at_order = equation.replaced({m.n: sympy.Integer(self.n)})
        for place, (left, right) in enumerate(self.sides(at_order), 1):
            yield f"{equation.text} at v = {PLACE}, component {place}", real_part(left) - real_part(right)
