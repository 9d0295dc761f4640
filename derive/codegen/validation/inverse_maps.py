"""Expected values of inverse maps, screws, shadows, composition and steps at given numbers, from φ alone."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

from flint import arb_mat

from ...algebra import Dual, Quaternion, Tensor, Vector
from ...algebra.first_principles import quaternion_exponential
from ...algebra.functions import atan2
from ...algebra.pose import Pose, Screw, is_zero, orientation, polar, tensor_from_pose
from ..rows import Function
from . import reals
from .expected_values import ALGEBRAIC, Formulas, evaluated, matrix6
from .reals import Real, nearest
from .vectors import Flat, Vectors, along, axial, dual, flat, screw_of_quaternion

ZERO: Flat = (Real(0),) * 6
IDENTITY = matrix6([Vector(*row) for row in Tensor.identity().rows])


def reached(chart: Vectors, angle: Dual) -> Dual:
    """Return the angle less the fewest whole turns after which it does not exceed the edge."""
    while angle.re > chart.edge:
        angle = angle - 2 * Real.pi()
    return angle


def _vector(screw: Screw) -> Vector:
    return along(screw.axis, screw.angle)


def _numbers(screw: Screw) -> Flat:
    return (screw.angle.re, screw.angle.du, *flat(screw.axis))


def _own_screw(chart: Vectors, v: Flat) -> Screw:
    """Return the screw of v: the axis of v, and the angle on the branch of v."""
    length, u = axial(dual(v))
    return Screw(chart.angle(length), u)


def _from_tensor(chart: Vectors, branch: int, tensor: Flat) -> Flat:
    re, du = map(Tensor.from_entries, (tensor[:9], tensor[9:]))
    return flat(chart.of_tensor(Tensor.dual(re, du), branch))


def _from_pose(chart: Vectors, branch: int, pose: Flat) -> Flat:
    rotation = Tensor.from_entries((*pose[0:3], *pose[4:7], *pose[8:11]))
    displacement = Vector(pose[3], pose[7], pose[11])
    return flat(chart.of_tensor(tensor_from_pose(Pose(rotation, displacement)), branch))


def _from_exponential(chart: Vectors, branch: int, w: Flat) -> Flat:
    angle, u = axial(dual(w))
    return flat(along(u, chart.size(reached(chart, angle))))


def _shadow(chart: Vectors, branch: int, v: Flat) -> Flat:
    return flat(chart.shadow(dual(v), branch))


def _compose(chart: Vectors, branch: int, v2: Flat, v1: Flat) -> Flat:
    return flat(chart.of_quaternion(chart.quaternion(dual(v2)) * chart.quaternion(dual(v1))))


def _motion(chart: Vectors, v2: Flat, v1: Flat, body: bool) -> Screw:
    """Return the screw of the motion from v1 to v2, in the body or space frame."""
    later, sooner = chart.quaternion(dual(v2)), chart.quaternion(dual(v1)).conjugate()
    return screw_of_quaternion(sooner * later if body else later * sooner)


def _between(chart: Vectors, branch: int, v2: Flat, v1: Flat) -> Flat:
    return flat(chart.at(_motion(chart, v2, v1, body=True))) if v2 != v1 else ZERO


def _local(body: bool, chart: Vectors, branch: int, v2: Flat, v1: Flat) -> Flat:
    """Return δ = α u of the motion from v1 to v2, in the body or space frame."""
    return flat(_vector(_motion(chart, v2, v1, body))) if v2 != v1 else ZERO


def _retract(body: bool, chart: Vectors, branch: int, v: Flat, delta: Flat) -> Flat:
    """Return v of exp(δ) R(v), or R(v) exp(δ).

    Of two branches it is the one that a step of at most half a turn leads to; of more, the one with the angle nearest
    the projection of α u on the new axis.
    """
    small, here = chart.once(_turning, *delta), chart.quaternion(dual(v))
    if chart.chart.branches == 2:
        q = (here * small if body else small * here) * orientation(small.scalar.re)
        length, u = polar(q.vector)
        return flat(chart.at(Screw(2 * atan2(length, q.scalar), u)))
    q = here * small if body else small * here
    (length, u), (own, axis) = polar(q.vector), polar(dual(v))
    angle = 2 * atan2(length, q.scalar)
    along = chart.angle(own.re) * axis.re.dot(u.re)
    turns = nearest((along - angle.re) / (2 * Real.pi()))
    return flat(chart.at(Screw(angle + 2 * Real.pi() * turns, u)))


def _turning(*delta: Any) -> Quaternion:
    """Return exp(δ/2); most difference quotients leave δ unchanged."""
    return quaternion_exponential(dual(delta) / 2)


def _interpolate(chart: Vectors, branch: int, v1: Flat, v2: Flat, t: Flat) -> Flat:
    """Return the vector of exp(t δ) R(v1) on the branch reached continuously from the branch of v1."""
    if v1 == v2:
        return v1
    first, delta = chart.quaternion(dual(v1)), _vector(_motion(chart, v2, v1, body=False))
    (extent, own), moved = polar(dual(v1)), quaternion_exponential(delta * t[0] / 2) * first
    before = chart.angle(extent.re)
    size, u = polar(moved.vector)
    across = delta.re.cross(own.re)
    if across.dot(across) < reals.rounding(1.6) and not is_zero(extent.re):
        side = orientation(moved.vector.re.dot(own.re))
        gone, turn = before + t[0] * delta.re.dot(own.re), 4
    else:
        side = orientation(first.vector.re.dot(own.re))
        gone, turn = 2 * Real.pi() * (before / (2 * Real.pi())).mid().floor() + Real.pi(), 2
    angle = 2 * atan2(size, moved.scalar * side) if turn == 2 else 2 * atan2(size * side, moved.scalar)
    turns = nearest((gone - angle.re) / (turn * Real.pi()))
    return flat(chart.at(Screw(angle + turn * turns * Real.pi(), u * side)))


def _jacobians(function: Callable[..., Flat], chart: Vectors, branch: int, *arguments: Flat) -> Flat:
    """Return the Jacobians of a function by each dual vector, as difference quotients in twice the precision."""
    with reals.bits(2 * reals.precision()):
        step = Real(2) ** (-reals.precision() // 2)
        start = function(chart, branch, *arguments)
        found: list[Any] = []
        for place, argument in enumerate(arguments):
            columns = []
            for j in range(3):
                moved = (*argument[:j], argument[j] + step, *argument[j + 1 :])
                there = function(chart, branch, *arguments[:place], moved, *arguments[place + 1 :])
                columns.append(dual(tuple((b - a) / step for a, b in zip(start, there, strict=True))))
            found += matrix6(columns)
    return tuple(+entry for entry in found)


def _principal(chart: Vectors, branch: int, v: Flat) -> Flat:
    return flat(chart.at(chart.screw(dual(v))[0]))


def _switch(chart: Vectors, branch: int, v: Flat, v_dot: Flat, covariance: Flat) -> Flat:
    """Return the principal vector, J v̇ and J P Jᵀ, with the derivative J of the principal vector."""
    there, by_v = chart.once(_at_principal, chart, *v)
    J, P = (arb_mat(6, 6, entries) for entries in (by_v, covariance))
    return (*there, *(J * arb_mat(6, 1, v_dot)).entries(), *(J * P * J.transpose()).entries())


def _at_principal(chart: Vectors, *v: Any) -> tuple[Flat, Flat]:
    """Return the principal vector and its derivative; most difference quotients leave v unchanged."""
    return _principal(chart, 0, v), _jacobians(_principal, chart, 0, v)


DIFFERENTIABLE: Mapping[str, Callable[..., Flat]] = {
    "compose": _compose,
    "between": _between,
    "retract": partial(_retract, False),
    "body_retract": partial(_retract, True),
    "local": partial(_local, False),
    "body_local": partial(_local, True),
}
"""Functions of two dual vectors, whose Jacobians are kernel functions too."""

MAPS: Mapping[str, Callable[..., Flat]] = {
    "from_quaternion": lambda at, k, q: flat(at.of_quaternion(Quaternion.dual(q[:4], q[4:]), k)),
    "from_tensor": _from_tensor,
    "from_pose": _from_pose,
    "from_screw": lambda at, k, angle, line: flat(at.at(Screw(Dual(*angle), dual(line)), k)),
    "to_screw": lambda at, k, v: _numbers(at.screw(dual(v))[0]),
    "angle": lambda at, k, v: _numbers(_own_screw(at, v))[:2],
    "to_exponential": lambda at, k, v: flat(_vector(_own_screw(at, v))),
    "from_exponential": _from_exponential,
    "shadow": _shadow,
    "shadow_jacobian": lambda at, k, v: _jacobians(_shadow, at, k, v) if k else IDENTITY,
    "principal": _principal,
    "switch": _switch,
    "interpolate": _interpolate,
    **DIFFERENTIABLE,
    **{f"{name}_jacobians": partial(_jacobians, function) for name, function in DIFFERENTIABLE.items()},
}
"""Expected values by kernel function, as functions of a chart, a branch and arguments."""


def value(chart: Vectors, row: Function, branch: int | None, arguments: Sequence[Flat]) -> Flat:
    """Return the value of any kernel function at given numbers."""
    zero = Real(0)
    if row.source in ALGEBRAIC:
        return evaluated(row, Formulas(chart.chart, chart), arguments, zero)
    return row.part(MAPS[row.source](chart, branch or 0, *row.embedded(arguments, zero)))
