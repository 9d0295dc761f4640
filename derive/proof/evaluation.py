"""Evaluation of sums, products, powers and operators, given the values of the symbols in them."""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from functools import reduce
from typing import Any, cast

import sympy

from ..algebra import Dual, Structure, Tensor, dual_part, mixed, real_part
from ..algebra.first_principles import tensor_by_sandwich
from ..maps.rodrigues import compose_first_order, compose_second_order
from . import notation
from .statement import Equation


class NoValueError(ArithmeticError):
    """Error for an expression to which no premise gives a value."""


MEANING: Mapping[Any, Callable[..., Any]] = {
    notation.transpose: lambda a: a.transpose,
    notation.conjugate: lambda a: mixed.quaternion(a).conjugate(),
    notation.skew: Tensor.skew,
    notation.vect: lambda a: a.vect(),
    notation.cross: lambda a, b: a.cross(b),
    notation.dyad: Tensor.dyad,
    notation.sandwich: lambda a: tensor_by_sandwich(mixed.quaternion(a)),
    notation.first_order: compose_first_order,
    notation.second_order: compose_second_order,
    notation.real: lambda a: a.map(real_part),
    notation.dual: lambda a: a.map(dual_part),
    notation.det: lambda a: a.det(),
    notation.dot: lambda a, b: a.dot(b),
    notation.norm2: lambda a: mixed.quaternion(a).norm2(),
}
"""Functions on values of the algebra, by their operator in statements."""


class Evaluation:
    """Values of expressions, given the values of symbols and terms; the identity and ε are known."""

    def __init__(self, values: Mapping[sympy.Expr, Any]) -> None:
        self.values: dict[sympy.Expr, Any] = {**values, notation.I: Tensor.identity(), notation.epsilon: Dual(0, 1)}
        self.definitions: dict[sympy.Expr, sympy.Expr] = {}  # of further symbols and terms

    def number(self, value: Fraction) -> Any:
        """Return a rational number as a value."""
        return value

    def differentiated(self, by: Any, value: Any) -> Any:
        """Return the derivative of a value by the operator `rate` or `prime`."""
        raise NoValueError("no premise gives a derivative")

    def power(self, base: sympy.Expr, exponent: sympy.Expr) -> Any:
        """Return a power whose exponent is not an integer constant, such as n."""
        raise NoValueError(f"no premise defines {notation.text(base**exponent)}")

    def value(self, expression: sympy.Expr) -> Any:
        """Return the value of an expression: a number, vector, quaternion or tensor."""
        if expression not in self.values:
            self.values[expression] = self._evaluated(expression)
        return self.values[expression]

    def sides(self, equation: Equation) -> list[tuple[Any, Any]]:
        """Return the pairs of left and right components of an equation."""
        left, right = self.value(equation.left), self.value(equation.right)
        if type(left) is not type(right) and (isinstance(left, Structure) or isinstance(right, Structure)):
            left, right = mixed.quaternion(left), mixed.quaternion(right)
        return list(zip(flat(left), flat(right), strict=True))

    def _evaluated(self, e: sympy.Expr) -> Any:
        if e in self.definitions:
            return self.value(self.definitions[e])
        if e.is_Rational:
            return self.number(Fraction(int(e.p), int(e.q)))
        if e.is_Add:
            return reduce(mixed.add, map(self.value, e.args))
        if e.is_Mul:
            numbers, others = e.args_cnc()
            parts = filter(None, (others, numbers))
            return reduce(operator.mul, (reduce(mixed.multiply, map(self.value, part)) for part in parts))
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
        power: Any = reduce(mixed.multiply, [value] * abs(exponent))
        return power if exponent > 0 else power.inverse()


def flat(value: Any) -> list[Any]:
    """Return the components of a value."""
    return [value] if not isinstance(value, Structure) else list(cast(Iterable[Any], value))


def mapped(function: Callable[[Any], Any], value: Any) -> Any:
    """Apply a function to a number, or to every component."""
    return cast(Any, value).map(function) if isinstance(value, Structure) else function(value)
