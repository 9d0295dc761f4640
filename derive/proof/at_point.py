"""Evaluation of printed statements about one order, at one rational point of a motion.

The evaluation is not a proof. It guards against a printed statement that differs from the decided components.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import sympy

from ..algebra import Dual, Isotropic, Quaternion, Vector, cayley_pairs, dual_part, functions, real_part
from . import notation as m
from .evaluation import Evaluation, mapped
from .formulas import tangent, tangent_inv, tensor
from .identity import Checks
from .statement import Equation

PLACE, SPEED, OTHER = (2, -4, 10), (3, 5, -1), (1, -2, 3)
"""Values of v, of its rate and of a point. Since 1 + 2² + 4² + 10² = 11², sqrt(1 + x) is rational."""


class AtPoint(Evaluation):
    """Values of the symbols at order n and a moving v = (2, −4, 10). Dual parts are time derivatives."""

    def __init__(self, n: int) -> None:
        self.n = n
        v = Vector.dual(map(sympy.Integer, PLACE), map(sympy.Integer, SPEED))
        x = v.dot(v)
        p, q = (Dual(sympy.Integer(1)) * value for value in cayley_pairs.pair_by_squaring(n, x))
        root = functions.sqrt(1 + x)
        tensors = {m.R: tensor, m.dcay: tangent, m.dcay_inv: tangent_inv}
        values = {symbol: Isotropic(*formula(n, x, p, q), x).tensor(v) for symbol, formula in tensors.items()}
        rates, z = v.map(dual_part), Quaternion(p, v * q)
        known = {m.x: x, m.p: p, m.q: q, m.v: v, m.v_dot: rates, m.omega: values[m.dcay].map(real_part) @ rates}
        known |= {m.point: Vector(*map(sympy.Integer, OTHER)), m.z: z, m.q_hat: z * (1 / root**n)}
        super().__init__(known | values)

    def number(self, value: Fraction) -> sympy.Rational:
        return sympy.Rational(value)  # SymPy's numbers have exact roots

    def differentiated(self, operator: Any, value: Any) -> Any:
        return mapped(dual_part, value)

    def power(self, base: sympy.Expr, exponent: sympy.Expr) -> Any:
        return functions.sqrt(self.value(base)) ** int(2 * exponent)

    def checks(self, equation: Equation) -> Checks:
        """Yield left side minus right side at the point, component by component."""
        at_order = equation.replaced({m.n: sympy.Integer(self.n)})
        for place, (left, right) in enumerate(self.sides(at_order), 1):
            yield f"{equation.text} at v = {PLACE}, component {place}", real_part(left) - real_part(right)
