"""Definitions of sections 5, 6 and 9: Cayley maps of orders 1 and 2."""

from __future__ import annotations

from typing import Any

from ....algebra import Dual, Quaternion, Tensor, Vector, real_part
from ....maps.exponential import tensor_exponential
from ...language import values
from ...language.common_definitions import condition, screw_tensor
from ...language.environment import Env
from . import dual_algebra, motions, orders


def cayley_map(env: Env) -> values.Map:
    """Return the Cayley map of order 1 from vectors to orthogonal dual tensors, with its only preimage."""
    return values.Map(lambda v: orders.rotation(env, 1, v), lambda R: [rodrigues(env, *motions.invariants(env, R))])


def rodrigues(env: Env, alpha: Any, u: Vector) -> Any:
    """Return ``tan(α/2) u``; raise `values.MissedError` if the tangent is infinite."""
    half = values.divide(alpha, 2)
    cosine = env.field.cos(half)
    if env.field.same(real_part(cosine), 0):
        raise values.MissedError("the tangent is infinite")
    return env.field.sin(half) / cosine * u


def exponential_slope(env: Env, alpha: Any, u: Vector) -> Tensor:
    """Return the derivative of ``exp(α ũ)`` by α at fixed u."""
    alpha = alpha if isinstance(alpha, Dual) else Dual(alpha, 0)
    moving = Dual(Dual(alpha.re, 1), Dual(alpha.du, 0))
    still = u.map(lambda c: Dual(Dual(c.re, 0), Dual(c.du, 0)) if isinstance(c, Dual) else Dual(Dual(c, 0), Dual(0, 0)))
    argument: Any = moving * still
    change = tensor_exponential(argument, env.field)
    slope: Tensor = change.map(lambda c: Dual(c.re.du, c.du.du) if isinstance(c, Dual) else 0)
    return slope


def logarithm(env: Env, R: Tensor) -> Any:
    """Return the Euler vector of a tensor: its angle times its axis."""
    angle, axis = motions.invariants(env, R)
    return angle * axis


@condition
def angle_of_cayley(env: Env, alpha: Any, v: Vector) -> bool:
    """Return whether v represents the rotation by α about its axis at order 1."""
    return env.equal(screw_tensor(env, alpha, dual_algebra.one_axis(env, v)), orders.rotation(env, 1, v))


def quaternion_map(env: Env, order: int) -> values.Map:
    """Return the quaternion Cayley map of an order, with one preimage ``tan(α/2n) u``."""

    def preimages(q: Quaternion) -> list[Vector]:
        angle, axis = motions.half_angle(env, q)
        return [rodrigues(env, 2 * values.divide(angle, order), axis)]

    return values.Map(lambda v: orders.cayley(env, order, v), preimages)


@condition
def preimage(env: Env, value: Any, order: int, q: Quaternion) -> bool:
    """Return whether the Cayley transform of v is q. Order 1 is tested without a root, by ``q₀ (1 + v) = q``."""
    v = value.vector if isinstance(value, Quaternion) else value
    image = orders.cayley(env, 2, v) if order == 2 else q.scalar * Quaternion(1, v)
    return env.equal(value, v) and env.equal(image, q)


def composed(env: Env, order: int, second: Vector, first: Vector) -> Any:
    """Return the quaternion product of two displacements, later one first; at order 1 its norm is not 1."""
    if order == 1:
        return Quaternion(1, second) * Quaternion(1, first)
    return orders.cayley(env, order, second) * orders.cayley(env, order, first)
