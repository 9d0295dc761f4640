"""Definitions of sections 3 to 5: poses, orthogonal dual tensors that act on lines, screws."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import mpmath

from derive.algebra import Tensor, Vector, real_part
from derive.maps.exponential import tensor_exponential
from derive.maps.pose import Pose, line_through, pose_from_tensor

from ...language import values
from ...language.definitions import plain, screw_tensor
from ...language.evaluation import Env
from ...language.terms import Symbol
from ...language.values import dualise
from ...numbers.draw import Draw
from ...numbers.draw import rotation as sandwich

AXES = tuple(Vector(*row) for row in Tensor.identity().rows)

rotation_of = plain(lambda R: pose_from_tensor(R).rotation)
displacement_of = plain(lambda R: pose_from_tensor(R).displacement)


def moved_lines(g: Pose) -> Tensor:
    """Return the tensor of a pose's action on lines; its columns are the moved coordinate axes."""
    columns = (line_through(g.displacement, g.rotation @ e) for e in AXES)
    return Tensor.from_entries(entry for column in columns for entry in column).transpose


def poses_of(env: Env) -> Callable[[Tensor], values.Solution]:
    """Return a function from a tensor to the condition on a pose: both act equally on lines."""
    return lambda R: values.Solution(lambda g: values.equal(env.field, moved_lines(g), R))


def invariants(env: Env, R: Tensor) -> tuple[Any, Vector]:
    """Return an angle in [0, π] and an axis of an orthogonal dual tensor."""
    w, cosine, field = R.vect(), (R.trace() - 1) / 2, env.field
    if not field.same(real_part(w.dot(w)), 0):
        length = field.magnitude(w)
        return field.atan2(length, cosine), w / length
    if real_part(cosine) > 0:  # a translation
        rho = pose_from_tensor(R).displacement
        length = field.magnitude(rho)
        direction = AXES[0] if length == 0 else rho / length
        return dualise(0 * length, length), dualise(direction, 0 * direction)
    outer = (R + R.transpose) / 2 - Tensor.identity() * cosine
    column = outer @ max(AXES, key=lambda e: real_part(e.dot(outer @ e)))
    axis = column / field.magnitude(column)
    return field.atan2(w.dot(axis), cosine), axis


def screw_map(env: Env) -> values.Map:
    """Return the map from (angle, axis) to the orthogonal dual tensor."""
    return values.Map(lambda screw: screw_tensor(env, *screw), lambda R: [invariants(env, R)])


def angles_of(env: Env, R: Tensor, sign: int) -> values.Solution:
    """Return the condition on the rotation angle of R about its axis times `sign`."""
    Q = R.map(real_part)
    _, axis = invariants(env, Q)
    return values.Solution(lambda angle: values.equal(env.field, screw_tensor(env, angle, sign * axis), Q))


def axes_of(env: Env, R: Tensor, sign: int) -> values.Solution:
    """Return the condition on a unit vector: R turns about it by `sign` times its angle, or translates along it."""
    pose = pose_from_tensor(R)
    Q, rho = pose.rotation, pose.displacement
    angle, _ = invariants(env, Q)

    def is_axis(w: Vector) -> bool:
        turned = screw_tensor(env, sign * angle, w)
        if not values.equal(env.field, w.dot(w), 1) or not values.equal(env.field, turned, Q):
            return False
        return not values.equal(env.field, Q, Tensor.identity()) or values.equal(env.field, rho.cross(w), 0 * rho)

    return values.Solution(is_axis)


def moments_of(env: Env, alpha: Any, u: Vector) -> values.Solution:
    """Return the condition on the moment of an axis along Re u: the displacement by α is unchanged."""
    R = screw_tensor(env, alpha, u)

    def is_moment(m: Vector) -> bool:
        across = values.equal(env.field, u.re.dot(m), 0)
        return across and values.equal(env.field, screw_tensor(env, alpha, dualise(u.re, m)), R)

    return values.Solution(is_moment)


def is_principal(env: Env, alpha: Any) -> bool:
    """Return whether Re α is in (−π, π]; True for generic symbols."""
    angle = real_part(alpha)
    return not isinstance(angle, mpmath.mpf) or bool(-mpmath.pi < angle <= mpmath.pi)


def half_turn_across(draw: Draw, R: Symbol, v: Symbol) -> Mapping[Symbol, Any]:
    """Return a half turn and a vector orthogonal to its axis."""
    q = draw.quaternion(mpmath.mpf(mpmath.pi) / 2)
    return {R: sandwich(q), v: q.vector.re.cross(Vector(1, 0, 0))}


def exponential(env: Env, a: Vector) -> Tensor:
    """Return the exponential of the skew-symmetric tensor of a vector."""
    return tensor_exponential(a, env.field)
