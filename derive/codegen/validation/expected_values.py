"""Expected values of algebraic kernel functions, from the formulas alone: exactly on ring elements, or at numbers.

Formulas in x are lifted into an exact ring. Formulas in α have no exact ring and are evaluated at numbers only.
Derivatives of the formulas use one more level of dual numbers; slopes of a chart's scalars are not used.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Any

import sympy

from ...algebra import Coefficient, Dual, Isotropic, Quaternion, Tensor, Vector
from ...algebra.pose import Pose, pose_from_tensor
from ...maps import Formula, x
from ...maps.chart import Chart
from ...maps.elementary import alpha, evaluate
from ..rows import Function
from .vectors import Flat, Vectors, dual, flat


@lru_cache(maxsize=256)  # free_symbols walks the whole expression tree
def _has_angle(expression: sympy.Expr) -> bool:
    return alpha in expression.free_symbols


@dataclass(frozen=True, slots=True)
class Formulas:
    """Formulas of a chart at ring elements, or at numbers if ``ring`` is the `Vectors` of the chart."""

    chart: Chart
    ring: Any

    def lifted(self, expression: sympy.Expr, at: Coefficient) -> Coefficient:
        """Return an expression at a number with any levels of dual parts: ``f(a + ε b) = f(a) + ε b f′(a)``."""
        if isinstance(self.ring, Vectors) and not _has_angle(expression):
            return evaluate(expression, x, at)
        order, plain = 0, at
        while isinstance(plain, Dual):
            order, plain = order + 1, plain.re
        derivatives = self.ring.derivatives(expression, x, plain, order)

        def raised(k: int, at: Coefficient) -> Coefficient:
            return Dual(raised(k, at.re), raised(k + 1, at.re) * at.du) if isinstance(at, Dual) else derivatives[k]

        return raised(0, at)

    def _operator(self, formula: Formula, v: Vector, hand: int = 1) -> Isotropic:
        square = v.dot(v)
        a, b, c = (self.lifted(coefficient, square) for coefficient in formula.coefficients)
        return Isotropic(a, hand * b, c, square)

    def quaternion(self, v: Vector) -> Quaternion:
        s, w = (self.lifted(coefficient, v.dot(v)) for coefficient in self.chart.quaternion.coefficients)
        return Quaternion(s, v * w)

    def tensor(self, v: Vector) -> Isotropic:
        return self._operator(self.chart.tensor, v)

    def pose(self, v: Vector) -> Pose:
        return pose_from_tensor(self.tensor(v).tensor(v))

    def tangent(self, v: Vector, hand: int = 1) -> Isotropic:
        """Return T for ``hand`` 1, or its transpose for ``hand`` −1."""
        return self._operator(self.chart.tangent, v, hand)

    def tangent_inv(self, v: Vector, hand: int = 1) -> Isotropic:
        """Return T⁻¹ for ``hand`` 1, or its transpose for ``hand`` −1."""
        return self._operator(self.chart.tangent_inv, v, hand)


def rows_of_pose(pose: Pose) -> Flat:
    """Return the homogeneous matrix of a pose by rows."""
    Q, rho = pose.rotation, tuple(pose.displacement)
    rows = (entry for i in range(3) for entry in (Q[i, 0], Q[i, 1], Q[i, 2], rho[i]))
    return (*rows, 0, 0, 0, 1)


# --- derivatives: the outer dual part is a derivative by time or by a component of v ------------------------------


def moving(a: Vector, rate: Vector) -> Vector:
    """Return ``a + τ rate`` with τ² = 0."""
    return Vector.dual(a, rate)


def matrix6(columns: Sequence[Vector]) -> Flat:
    """Return the real 6 × 6 matrix of the dual tensor with these columns, acting on dual vectors."""
    re, du = ([column.re for column in columns], [column.du for column in columns])
    upper = (entry for row in zip(*re, strict=True) for entry in (*row, 0, 0, 0))
    lower = (entry for row, below in zip(zip(*du, strict=True), zip(*re, strict=True)) for entry in (*row, *below))
    return (*upper, *lower)


def jacobian(function: Callable[[Vector], Vector], v: Vector) -> Flat:
    zero = 0 * v.c1
    units = ([zero + int(i == j) for i in range(3)] for j in range(3))
    return matrix6([function(moving(v, Vector(*unit))).du for unit in units])


Value = Callable[..., Flat]
Operator = Callable[..., Isotropic]


def _applied(operator: Operator, hand: int, at: Formulas, v: Flat, w: Flat) -> Flat:
    return flat(operator(at, dual(v), hand).apply(dual(v), dual(w)))


def _applied_jacobian(operator: Operator, hand: int, at: Formulas, v: Flat, w: Flat) -> Flat:
    fixed = moving(dual(w), 0 * dual(w))
    return jacobian(lambda there: operator(at, there, hand).apply(there, fixed), dual(v))


def _tangent_dot(hand: int, at: Formulas, v: Flat, v_dot: Flat) -> Flat:
    there = moving(dual(v), dual(v_dot))
    return flat(at.tangent(there, hand).tensor(there).du)


def _twist_dot(hand: int, at: Formulas, v: Flat, v_dot: Flat, v_ddot: Flat) -> Flat:
    there = moving(dual(v), dual(v_dot))
    return flat(at.tangent(there, hand).apply(there, moving(dual(v_dot), dual(v_ddot))).du)


def _rate_dot(hand: int, at: Formulas, v: Flat, omega: Flat, omega_dot: Flat) -> Flat:
    here, twist = dual(v), dual(omega)
    there = moving(here, at.tangent_inv(here, hand).apply(here, twist))
    return flat(at.tangent_inv(there, hand).apply(there, moving(twist, dual(omega_dot))).du)


def _point_jacobians(at: Formulas, v: Flat, r: Flat) -> Flat:
    """Return the derivative of the transformed point by v, then its derivative Q by the point."""
    here, point = dual(v), Vector(*r)
    still = 0 * here.re
    columns = []
    for place in range(6):
        rate = [0 * c + int(i == place) for i, c in enumerate(v)]
        there = Vector.dual(moving(here.re, Vector(*rate[:3])), moving(here.du, Vector(*rate[3:])))
        columns.append(at.pose(there).apply(moving(point, still)).du)
    rows = (entry for row in zip(*columns, strict=True) for entry in row)
    return (*rows, *at.pose(here).rotation)


def _line_jacobians(at: Formulas, v: Flat, line: Flat) -> Flat:
    fixed = moving(dual(line), 0 * dual(line))
    by_v = jacobian(lambda there: at.tensor(there).apply(there, fixed), dual(v))
    return (*by_v, *_adjoint(at, v))


def _adjoint(at: Formulas, v: Flat) -> Flat:
    return _matrix6(at.tensor(dual(v)).tensor(dual(v)))


def _matrix6(tensor: Tensor) -> Flat:
    return matrix6([Vector(*column) for column in tensor.transpose.rows])


def _transition(hand: int, at: Formulas, v: Flat, v0: Flat) -> Flat:
    here, start = dual(v), dual(v0)
    return _matrix6(at.tangent_inv(here, -hand).tensor(here) @ at.tangent(start, -hand).tensor(start))


BY_QUATERNION: Mapping[str, Value] = {"quaternion": lambda at, v: flat(at.quaternion(dual(v)))}
"""Functions of the quaternion, whose formulas may contain a root."""

BY_HAND: Mapping[str, Value] = {
    "tangent": lambda hand, at, v: flat(at.tangent(dual(v), hand).tensor(dual(v))),
    "tangent_inv": lambda hand, at, v: flat(at.tangent_inv(dual(v), hand).tensor(dual(v))),
    "twist": partial(_applied, Formulas.tangent),
    "rate": partial(_applied, Formulas.tangent_inv),
    "tangent_dot": _tangent_dot,
    "twist_dot": _twist_dot,
    "rate_dot": _rate_dot,
    "twist_jacobian": partial(_applied_jacobian, Formulas.tangent),
    "rate_jacobian": partial(_applied_jacobian, Formulas.tangent_inv),
    "transition": _transition,
}
"""Functions of the tangent operator: in the space frame with hand 1, in the body frame with hand −1."""

ALGEBRAIC: Mapping[str, Value] = {
    **BY_QUATERNION,
    "tensor": lambda at, v: flat(at.tensor(dual(v)).tensor(dual(v))),
    "pose": lambda at, v: rows_of_pose(at.pose(dual(v))),
    "transform_point": lambda at, v, r: tuple(at.pose(dual(v)).apply(Vector(*r))),
    "adjoint": _adjoint,
    "transform_point_jacobians": _point_jacobians,
    "transform_line_jacobians": _line_jacobians,
    "transform_line": lambda at, v, line: flat(at.tensor(dual(v)).apply(dual(v), dual(line))),
    "inverse": lambda at, v: tuple(-c for c in v),
    "cotangent": partial(_applied, Formulas.tangent, -1),
    "body_cotangent": partial(_applied, Formulas.tangent, 1),
    "cotangent_jacobian": partial(_applied_jacobian, Formulas.tangent, -1),
    "body_cotangent_jacobian": partial(_applied_jacobian, Formulas.tangent, 1),
    **{frame + name: partial(made, hand) for name, made in BY_HAND.items() for frame, hand in (("", 1), ("body_", -1))},
}
"""Expected values by kernel function, as functions of a chart's formulas and flat arguments."""


def arguments_of(row: Function, drawn: Sequence[Flat]) -> tuple[Flat, ...]:
    """Return drawn components as arguments of a function; a second vector of the chart is half of v, in other order."""
    second = tuple(drawn[0][i] / 2 for i in (1, 2, 0, 4, 5, 3))
    pairs = zip(row.arguments[1:], drawn[1:])
    further = ((second if array.vector else given)[: array.size] for array, given in pairs)
    return drawn[0][: row.arguments[0].size], *further


def evaluated(row: Function, at: Formulas, arguments: Sequence[Flat], zero: Any) -> Flat:
    """Return the value of an algebraic function; for rotations, its real part with ``zero`` for all dual parts."""
    return row.part(ALGEBRAIC[row.source](at, *row.embedded(arguments, zero)))
