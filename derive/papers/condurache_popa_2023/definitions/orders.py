"""Definitions of p_n and q_n, and of the Cayley map of order n with its rotation, tangent operator and preimage."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ....algebra import Dual, Quaternion, Tensor, Vector, first_principles, real_part
from ....algebra.first_principles import tensor_exponential
from ....claims.language import values
from ....claims.language.environment import Env
from ....claims.numbers.fields import UndefinedError
from . import dual_algebra, motions
from .dual_algebra import condition, screw_quaternion, screw_tensor


def polynomial(which: int, step: int = 0) -> Callable[[Env, Any], Callable[[Any], Any]]:
    """Return the definition of p (0) or q (1) of order n + step, as a function of X = |v| or of v."""
    return lambda env, n: lambda a: env.field.pair(n + step, _square(a))[which]


p, q, next_p, next_q = polynomial(0), polynomial(1), polynomial(0, 1), polynomial(1, 1)


def cayley(env: Env, n: Any, v: Vector) -> Any:
    """Return ``(1 + v)^(n/2) (1 − v)^(−n/2)``: the n-th power of 1 + v divided by its norm."""
    return env.field.power(Quaternion(1, v), n) / env.field.power(1 + v.dot(v), values.divide(n, 2))


def rotation(env: Env, n: Any, v: Vector) -> Tensor:
    """Return the orthogonal dual tensor of v at order n, from the action ``q r q*``."""
    return first_principles.tensor_by_sandwich(cayley(env, n, v))


def tangent(env: Env, n: Any, v: Vector) -> Tensor:
    """Return the operator T of ω = T v̇ at the current v, from ω = vect(Ṙ Rᵀ) by differentiation."""
    return first_principles.tangent(lambda w: rotation(env, n, w), env.now(v))


def preimage(env: Env, n: Any, alpha: Any, u: Vector) -> values.Solution:
    """Return the condition on v: at order n, it represents the displacement with angle α and axis u."""
    return solution(env, n, screw_quaternion(env, alpha, u))


@condition
def solution(env: Env, v: Any, n: Any, target: Quaternion, a: Any = 1) -> bool:
    """Return whether the Cayley map of order n takes v/a to the target or its negative."""
    return env.equal(values.Either(target, -target), cayley(env, n, as_vector(env, v) / a))


def as_vector(env: Env, a: Vector | Quaternion) -> Vector:
    """Return a vector or the vector part of a quaternion; raise if its scalar part is not 0."""
    if isinstance(a, Vector):
        return a
    if not env.equal(a.scalar, 0):
        raise UndefinedError("no vector: the scalar part is not 0")
    return a.vector


def at_order(order: int, function: Callable[..., Any]) -> Callable[..., Any]:
    return lambda env, *arguments: function(env, order, *arguments)


def _square(a: Any) -> Any:
    return a.dot(a) if isinstance(a, Vector) else a * a


# ---- orders 1 and 2: sections 5 and 6 ---------------------------------------------------------------------------


def cayley_map(env: Env) -> values.Map:
    """Return the Cayley map of order 1 from vectors to orthogonal dual tensors, with its only preimage."""
    return values.Map(lambda v: rotation(env, 1, v), lambda R: [rodrigues(env, *motions.invariants(env, R))])


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
    return env.equal(screw_tensor(env, alpha, dual_algebra.one_axis(env, v)), rotation(env, 1, v))


def quaternion_map(env: Env, order: int) -> values.Map:
    """Return the quaternion Cayley map of an order, with one preimage ``tan(α/2n) u``."""

    def preimages(q: Quaternion) -> list[Vector]:
        angle, axis = motions.half_angle(env, q)
        return [rodrigues(env, 2 * values.divide(angle, order), axis)]

    return values.Map(lambda v: cayley(env, order, v), preimages)


@condition
def image_is(env: Env, value: Any, order: int, q: Quaternion) -> bool:
    """Return whether q is the Cayley transform of v. Order 1 is tested without a root, by ``q₀ (1 + v) = q``."""
    v = value.vector if isinstance(value, Quaternion) else value
    image = cayley(env, 2, v) if order == 2 else q.scalar * Quaternion(1, v)
    return env.equal(value, v) and env.equal(image, q)


def composed(env: Env, order: int, second: Vector, first: Vector) -> Any:
    """Return the quaternion product of two displacements, later one first; at order 1 its norm is not 1."""
    if order == 1:
        return Quaternion(1, second) * Quaternion(1, first)
    return cayley(env, order, second) * cayley(env, order, first)
