"""Values of statements: formulas and operators in them, from values of the symbols, and at one rational point.

The evaluation at a point is not a proof. It guards against a printed statement that differs from what is decided.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from functools import reduce
from typing import Any, cast

import sympy

from ..algebra import (
    Coefficient,
    Dual,
    Isotropic,
    Quaternion,
    Structure,
    Tensor,
    Vector,
    arithmetic,
    dual_part,
    functions,
    real_part,
    structures,
)
from ..algebra.first_principles import tensor_by_sandwich
from . import notation
from . import notation as m
from .identity import Checks, Equation, Premise, definition


def compose_first_order(b2: Vector, b1: Vector) -> Vector:
    """Return ``(b1 + b2 + b2 × b1)/(1 − b1 · b2)``, composition at n = 1, CP23 (45): b1 acts first.

    A composed rotation by π, which n = 1 cannot represent, raises ZeroDivisorError.
    """
    composed: Vector = (b1 + b2 + b2.cross(b1)) / (1 - b1.dot(b2))
    return composed


def compose_second_order(s2: Vector, s1: Vector) -> Vector:
    r"""Return the composition at n = 2, CP23 (41): s1 acts first, and the sign of the product quaternion is kept.

    .. math::
        \sigma = \frac{(1 - \sigma_2^2)\,\sigma_1 + (1 - \sigma_1^2)\,\sigma_2 + 2\,\sigma_2 \times \sigma_1}
            {(1 - \sigma_2 \cdot \sigma_1)^2 + (\sigma_2 \times \sigma_1)^2}

    The result is the principal v where the product has real scalar part ≥ 0, and its shadow elsewhere. A product −1,
    where the shadow is v = 0, raises ZeroDivisorError.
    """
    cross, dot = s2.cross(s1), s2.dot(s1)
    numerator = s1 * (1 - s2.dot(s2)) + s2 * (1 - s1.dot(s1)) + cross * 2
    composed: Vector = numerator / ((1 - dot) ** 2 + cross.dot(cross))
    return composed


Triple = tuple[Coefficient, Coefficient, Coefficient]
CoefficientsOfOrder = Callable[[Any, Any, Any, Any], Triple]
SYMBOLS = (notation.n, notation.x, notation.p, notation.q)


def tensor(n: Coefficient, x: Coefficient, p: Coefficient, q: Coefficient) -> Triple:
    """Return the coefficients of I, skew(v), v⊗v in R, CP23 (57) with skew(v)² = v⊗v − x I."""
    power = p * p + x * q * q
    return 1 - 2 * x * q * q / power, 2 * p * q / power, 2 * q * q / power


def tangent(n: Coefficient, x: Coefficient, p: Coefficient, q: Coefficient) -> Triple:
    """Return the coefficients of I, skew(v), v⊗v in dcay, CP23 (88)."""
    power = p * p + x * q * q
    bracket = (n * power / (1 + x) - p * q) / x
    return 2 * p * q / power, 2 * q * q / power, 2 * bracket / power


def tangent_inv(n: Coefficient, x: Coefficient, p: Coefficient, q: Coefficient) -> Triple:
    """Return the coefficients of I, skew(v), v⊗v in the inverse of dcay, CP23 (89)."""
    bracket = ((1 + x) * q - n * p) / x
    return p / (2 * q), (x - x - 1) / 2, bracket / (2 * n * q)


def defined(
    symbol: Any, formula: CoefficientsOfOrder, at: Any = SYMBOLS, v: Any = notation.v, numbers: tuple[int, ...] = ()
) -> Premise:
    """Return the definition of a symbol by a formula at (n, x, p_n, q_n), ``a I + b skew(v) + c v⊗v``."""
    a, b, c = formula(*at)
    rest = b * notation.skew(v) + c * notation.dyad(v, v)
    return definition(symbol, a * notation.I + rest, numbers, wrong=2 * a * notation.I + rest)


class NoValueError(ArithmeticError):
    """Error for an expression to which no premise gives a value."""


MEANING: Mapping[Any, Callable[..., Any]] = {
    notation.transpose: lambda a: a.transpose,
    notation.conjugate: lambda a: structures.quaternion(a).conjugate(),
    notation.skew: Tensor.skew,
    notation.vect: lambda a: a.vect(),
    notation.cross: lambda a, b: a.cross(b),
    notation.dyad: Tensor.dyad,
    notation.sandwich: lambda a: tensor_by_sandwich(structures.quaternion(a)),
    notation.first_order: compose_first_order,
    notation.second_order: compose_second_order,
    notation.real: lambda a: a.map(real_part),
    notation.dual: lambda a: a.map(dual_part),
    notation.det: lambda a: a.det(),
    notation.dot: lambda a, b: a.dot(b),
    notation.norm2: lambda a: structures.quaternion(a).norm2(),
}
"""Functions on values of the algebra, by their operator in statements."""


class Evaluation:
    """Values of expressions, given the values of symbols and terms; the identity and ε are known."""

    def __init__(self, values: Mapping[sympy.Expr, Any]) -> None:
        self.values: dict[sympy.Expr, Any] = {**values, notation.I: Tensor.identity(), notation.epsilon: Dual(0, 1)}
        self.definitions: dict[sympy.Expr, sympy.Expr] = {}  # of further symbols and terms

    def number(self, value: Fraction) -> Any:
        return value

    def differentiated(self, by: Any, value: Any) -> Any:
        raise NoValueError("no premise gives a derivative")

    def power(self, base: sympy.Expr, exponent: sympy.Expr) -> Any:
        """Return a power whose exponent is not an integer constant, such as n."""
        raise NoValueError(f"no premise defines {notation.text(base**exponent)}")

    def value(self, expression: sympy.Expr) -> Any:
        if expression not in self.values:
            self.values[expression] = self._evaluated(expression)
        return self.values[expression]

    def sides(self, equation: Equation) -> list[tuple[Any, Any]]:
        left, right = self.value(equation.left), self.value(equation.right)
        if type(left) is not type(right) and (isinstance(left, Structure) or isinstance(right, Structure)):
            left, right = structures.quaternion(left), structures.quaternion(right)
        return list(zip(flat(left), flat(right), strict=True))

    def _evaluated(self, e: sympy.Expr) -> Any:
        if e in self.definitions:
            return self.value(self.definitions[e])
        if e.is_Rational:
            return self.number(Fraction(int(e.p), int(e.q)))
        if e.is_Add:
            return reduce(structures.add, map(self.value, e.args))
        if e.is_Mul:
            numbers, others = e.args_cnc()
            parts = filter(None, (others, numbers))
            return reduce(operator.mul, (reduce(structures.multiply, map(self.value, part)) for part in parts))
        if e.is_Pow:
            return self._integer_power(self.value(e.base), int(e.exp)) if e.exp.is_Integer else self.power(*e.args)
        if e.func in (notation.rate, notation.prime):
            return self.differentiated(e.func, self.value(e.args[0]))
        if e.func in MEANING:
            return MEANING[e.func](*map(self.value, e.args))
        raise NoValueError(f"no premise defines {notation.text(e)}")

    @staticmethod
    def _integer_power(value: Any, exponent: int) -> Any:
        if not isinstance(value, Structure):
            return value**exponent
        power: Any = reduce(structures.multiply, [value] * abs(exponent))
        return power if exponent > 0 else power.inverse()


def flat(value: Any) -> list[Any]:
    return [value] if not isinstance(value, Structure) else list(cast(Iterable[Any], value))


def mapped(function: Callable[[Any], Any], value: Any) -> Any:
    return cast(Any, value).map(function) if isinstance(value, Structure) else function(value)


PLACE, SPEED, OTHER = (2, -4, 10), (3, 5, -1), (1, -2, 3)
"""Values of v, of its rate and of a point. Since 1 + 2² + 4² + 10² = 11², sqrt(1 + x) is rational."""


class AtPoint(Evaluation):
    """Values of the symbols at order n and a moving v = (2, −4, 10). Dual parts are time derivatives."""

    def __init__(self, n: int) -> None:
        self.n = n
        v = Vector.dual(map(sympy.Integer, PLACE), map(sympy.Integer, SPEED))
        x = v.dot(v)
        p, q = (Dual(sympy.Integer(1)) * value for value in arithmetic.pair_by_squaring(n, x))
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
