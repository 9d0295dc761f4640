"""Definitions of sections 3 to 8: poses, orthogonal dual tensors and unit dual quaternions that act on lines; twists.

Twists and tangent operators follow by differentiation from first principles. Symbols may depend on time: `Env.now`
returns their current value, `Env.rate` their time derivative.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ....algebra import Dual, Quaternion, Tensor, Vector, first_principles, real_part
from ....algebra.first_principles import quaternion_exponential, tensor_exponential
from ....algebra.pose import Pose, line_through, pose_from_tensor
from ....claims.language import values
from ....claims.language.environment import Env
from ....claims.language.values import dualise
from ....claims.numbers.fields import innermost
from .dual_algebra import condition, nilpotent, one_axis, plain, screw_quaternion, screw_tensor

AXES = tuple(Vector(*row) for row in Tensor.identity().rows)

rotation_of = plain(lambda R: pose_from_tensor(R).rotation)
displacement_of = plain(lambda R: pose_from_tensor(R).displacement)


def moved_lines(g: Pose) -> Tensor:
    """Return the tensor of a pose's action on lines; its columns are the moved coordinate axes."""
    columns = (line_through(g.displacement, g.rotation @ e) for e in AXES)
    return Tensor.from_entries(entry for column in columns for entry in column).transpose


pose_of = condition(lambda env, g, R: env.equal(moved_lines(g), R))


def invariants(env: Env, R: Tensor) -> tuple[Any, Vector]:
    """Return an angle in [0, π] and an axis of an orthogonal dual tensor."""
    w, cosine, field = R.vect(), (R.trace() - 1) / 2, env.field
    if not field.same(real_part(w.dot(w)), 0):
        length = field.magnitude(w)
        return field.atan2(length, cosine), w / length
    if real_part(cosine) > 0:  # a translation
        along = nilpotent(env, pose_from_tensor(R).displacement)
        return field.magnitude(along), one_axis(env, along)
    outer = (R + R.transpose) / 2 - Tensor.identity() * cosine
    column = outer @ max(AXES, key=lambda e: real_part(e.dot(outer @ e)))
    axis = column / field.magnitude(column)
    return field.atan2(w.dot(axis), cosine), axis


@condition
def angles_of(env: Env, angle: Any, R: Tensor, sign: int) -> bool:
    """Return whether R turns by an angle about `sign` times its axis."""
    Q = R.map(real_part)
    _, axis = invariants(env, Q)
    return env.equal(screw_tensor(env, angle, sign * axis), Q)


@condition
def axes_of(env: Env, w: Vector, R: Tensor, sign: int) -> bool:
    """Return whether R turns about a unit vector by `sign` times its angle, or translates along it."""
    pose = pose_from_tensor(R)
    Q, rho = pose.rotation, pose.displacement
    angle, _ = invariants(env, Q)
    if not (env.equal(w.dot(w), 1) and env.equal(screw_tensor(env, sign * angle, w), Q)):
        return False
    return not env.equal(Q, Tensor.identity()) or env.equal(rho.cross(w), 0 * rho)


@condition
def moments_of(env: Env, m: Vector, alpha: Any, u: Vector) -> bool:
    """Return whether α about the axis ``Re u + ε m`` gives the same displacement as about u."""
    across = env.equal(u.re.dot(m), 0)
    return across and env.equal(screw_tensor(env, alpha, dualise(u.re, m)), screw_tensor(env, alpha, u))


def exponential(env: Env, a: Vector) -> Tensor:
    return tensor_exponential(a, env.field)


# ---- unit dual quaternions --------------------------------------------------------------------------------------


@condition
def lift(env: Env, value: Any, alpha: Any, u: Vector) -> bool:
    """Return whether a unit quaternion acts on lines as the displacement by α about u."""
    q, R = values.quaternion(value), tensor_exponential(alpha * u, env.field)
    return env.equal(q.norm2(), 1) and env.equal(first_principles.tensor_by_sandwich(q), R)


def half_angle(env: Env, q: Quaternion) -> tuple[Any, Vector]:
    """Return the half angle in [0, π] and the axis of a unit quaternion."""
    return env.field.atan2(env.field.magnitude(q.vector), q.scalar), one_axis(env, q.vector)


def quaternion_exponential_map(env: Env) -> values.Map:
    """Return the map from dual vectors a to quaternions ``exp(a/2)``."""

    def preimage(q: Quaternion) -> list[Vector]:
        angle, axis = half_angle(env, q)
        return [2 * angle * axis]

    return values.Map(lambda a: quaternion_exponential(values.divide(a, 2), env.field), preimage)


def covering(env: Env) -> values.Map:
    """Return the map from unit quaternions to orthogonal dual tensors, with both preimages ±q."""

    def preimages(R: Tensor) -> list[Quaternion]:
        q = screw_quaternion(env, *invariants(env, R))
        return [q, -q]

    return values.Map(first_principles.tensor_by_sandwich, preimages)


def at_rest(env: Env, a: Any) -> Any:
    def still(c: Any) -> Any:
        if not isinstance(c, Dual):
            return c
        return Dual(Dual(c.re.re, 0), Dual(c.du.re, 0)) if env.dual else Dual(c.re, 0)

    return a.map(still)


def twist(env: Env, R: Tensor) -> Vector:
    """Return the twist ``vect(Ṙ Rᵀ)``."""
    return first_principles.twist(R, env.rate(R))


def body_twist(env: Env, R: Tensor) -> Vector:
    """Return the twist in the body frame, ``vect(Rᵀ Ṙ)``."""
    return first_principles.body_twist(R, env.rate(R))


def moves_lines(env: Env, R: Tensor, operator: Callable[[Vector], Vector]) -> bool:
    """Return whether an operator gives the rates of three body-fixed lines."""
    lines = [R @ axis for axis in AXES]
    return all(env.equal(env.now(operator(line)), env.now(env.rate(line))) for line in lines)


velocity_tensor = condition(lambda env, T, R: moves_lines(env, R, lambda line: T @ line))
angular_velocity = condition(lambda env, w, R: moves_lines(env, R, w.cross))


def moved_line(env: Env, R: Tensor, point: Vector, along: Vector) -> Vector:
    """Return the line through a point along a direction, displaced by the pose of R."""
    pose = pose_from_tensor(R)
    return line_through(pose.apply(point), pose.rotation @ along)


rotation_part = plain(lambda R: R.map(lambda c: Dual(c.re, 0 * c.re)))
"""Rotation Q in ``R = (I + ε ρ̃) Q``: the real parts as dual numbers, with their rates."""


def velocity_at_origin(env: Env, Q: Tensor, rho: Vector) -> Any:
    """Return the velocity of the body point at the origin; its body coordinates are ``−Qᵀρ``."""
    body_point = at_rest(env, -(Q.transpose @ rho))
    return env.rate(Q @ body_point + rho)


def half_sine(env: Env, alpha: Any) -> Any:
    """Return the current value of ``sin(α/2)``."""
    return env.field.sin(values.divide(env.now(alpha), 2))


def sinc(env: Env) -> Callable[[Any], Any]:
    """Return the function ``(sin α)/α``, with value 1 and slope 0 at α = 0."""
    return lambda a: 1 + 0 * a if innermost(a) == 0 else values.divide(env.field.sin(a), a)


def sinc_by_series(env: Env) -> Callable[[Any], Any]:
    """Return the power series of sinc, accurate to 60 digits for arguments up to 20."""

    def series(a: Any) -> Any:
        total, term = 1 + 0 * a, 1 + 0 * a
        for k in range(1, 80):
            term = -term * (a * a) / (2 * k * (2 * k + 1))
            total = total + term
        return total

    return series
