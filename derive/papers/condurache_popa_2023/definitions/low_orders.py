"""Definitions of sections 5, 6 and 9: Cayley maps of orders 1 and 2."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import mpmath

from derive.algebra import Dual, Quaternion, Tensor, Vector, real_part
from derive.maps.exponential import tensor_exponential
from derive.maps.pose import pose_from_tensor

from ...language import claims, values
from ...language.definitions import screw_quaternion, screw_tensor
from ...language.evaluation import Env
from ...language.terms import Symbol
from ...language.values import dualise
from ...numbers.draw import Draw
from . import dual_algebra, motions, orders

Points = Callable[[Draw], Mapping[str, Mapping[Symbol, Any]]]
"""Function that draws further points of an entry, by name."""


def cayley_map(env: Env) -> values.Map:
    """Return the Cayley map of order 1 from vectors to orthogonal dual tensors, with its only preimage."""
    return values.Map(lambda v: orders.rotation(env, 1, v), lambda R: [rodrigues(env, *motions.invariants(env, R))])


def rodrigues(env: Env, alpha: Any, u: Vector) -> Vector:
    """Return ``tan(α/2) u``; raise `values.MissedError` if the tangent is infinite."""
    half = values.divide(alpha, 2)
    cosine = env.field.cos(half)
    if env.field.same(real_part(cosine), 0):
        raise values.MissedError("the tangent is infinite")
    vector: Vector = env.field.sin(half) / cosine * u
    return vector


def exponential_map(env: Env) -> values.Map:
    """Return the exponential map from dual vectors to orthogonal dual tensors."""
    return values.Map(lambda a: tensor_exponential(a, env.field), lambda R: [logarithm(env, R)])


def exponential_slope(env: Env, alpha: Any, u: Vector) -> Tensor:
    """Return the derivative of ``exp(α ũ)`` by α at fixed u."""
    alpha = alpha if isinstance(alpha, Dual) else Dual(alpha, 0)
    moving = Dual(Dual(alpha.re, 1), Dual(alpha.du, 0))
    still = u.map(lambda c: Dual(Dual(c.re, 0), Dual(c.du, 0)) if isinstance(c, Dual) else Dual(Dual(c, 0), Dual(0, 0)))
    argument: Any = moving * still
    change = tensor_exponential(argument, env.field)
    slope: Tensor = change.map(lambda c: Dual(c.re.du, c.du.du) if isinstance(c, Dual) else 0)
    return slope


def logarithm(env: Env, R: Tensor) -> Vector:
    """Return the Euler vector of a tensor: its angle times its axis."""
    angle, axis = motions.invariants(env, R)
    vector: Vector = angle * axis
    return vector


def is_below_half_turn(env: Env, alpha: Any) -> bool:
    """Return whether ``|Re α| < π``; True for generic symbols."""
    angle = real_part(alpha)
    return not isinstance(angle, mpmath.mpf) or bool(abs(angle) < mpmath.pi)


def angle_of_cayley(env: Env, v: Vector) -> values.Solution:
    """Return the condition on α: v represents the rotation by α about its axis at order 1."""
    R, axis = orders.rotation(env, 1, v), dual_algebra.one_axis(env, v)
    return values.Solution(lambda alpha: values.equal(env.field, screw_tensor(env, alpha, axis), R))


def displacement_types(
    rotates: Symbol, translates: Symbol, general: Symbol
) -> tuple[tuple[Symbol, Callable[..., bool]], ...]:
    """Return three statements about a displacement, each with its definition in terms of the tensor."""
    table = ((rotates, claims.fixes_a_point), (translates, claims.fixes_directions), (general, claims.is_general))

    def of_tensor(check: Callable[..., bool]) -> Callable[..., bool]:
        return lambda env, R: check(env, pose_from_tensor(R))

    return tuple((symbol, of_tensor(check)) for symbol, check in table)


def map_of_order(order: int) -> Callable[[Env], values.Map]:
    """Return the definition of the quaternion Cayley map of an order, with one preimage ``tan(α/2n) u``."""

    def make(env: Env) -> values.Map:
        def preimages(q: Quaternion) -> list[Vector]:
            angle, axis = motions.half_angle(env, q)
            return [rodrigues(env, 2 * values.divide(angle, order), axis)]

        return values.Map(lambda v: orders.cayley(env, order, v), preimages)

    return make


def preimage(order: int) -> Callable[[Env, Quaternion], values.Solution]:
    """Return the condition on v: its Cayley transform is q. Order 1 is tested without a root, by ``q₀ (1 + v) = q``."""

    def make(env: Env, q: Quaternion) -> values.Solution:
        def has_image(value: Any) -> bool:
            v = value.vector if isinstance(value, Quaternion) else value
            if isinstance(value, Quaternion) and not values.equal(env.field, value, v):
                return False
            image = orders.cayley(env, 2, v) if order == 2 else q.scalar * Quaternion(1, v)
            return values.equal(env.field, image, q)

        return values.Solution(has_image)

    return make


def composed(order: int) -> Callable[[Env, Vector, Vector], Quaternion]:
    """Return the quaternion product of two displacements, later one first; at order 1 its norm is not 1."""

    def one(env: Env, v: Vector) -> Quaternion:
        return orders.cayley(env, 2, v) if order == 2 else Quaternion(1, v)

    return lambda env, second, first: one(env, second) * one(env, first)


def rodrigues_by_quotient(env: Env, alpha: Any, u: Vector) -> Vector:
    """Return the vector of order 1 for this angle and axis: vector part over scalar part of the quaternion."""
    q = screw_quaternion(env, alpha, u)
    b: Vector = q.vector / q.scalar
    return b


# ---- points -----------------------------------------------------------------------------------------------------


def real_magnitude(v: Symbol) -> Points:
    """Return a point where |v| is real although v is dual."""

    def point(draw: Draw) -> Mapping[str, Mapping[Symbol, Any]]:
        re, across = draw.vector().re, draw.vector().re
        return {"|v| real, v dual": {v: dualise(re, re.cross(across))}}

    return point


def unit_magnitude(v: Symbol) -> Points:
    """Return a point where |v| = 1."""
    return lambda draw: {"|v| = 1": {v: draw.unit()}}


def three_turns(alpha: Symbol) -> Points:
    """Return a point where Re α = 6π, the second positive angle at which tan α/4 is infinite."""
    return lambda draw: {"real part 6π": {alpha: draw.number(6 * mpmath.mpf(mpmath.pi))}}


def back_to_back(second: Symbol, first: Symbol) -> Points:
    """Return a point with two equal half turns at order 2, whose product is −1."""
    return lambda draw: {"two half turns about one axis": dict.fromkeys((first, second), draw.unit())}


def to_a_half_turn(first: Symbol, second: Symbol) -> Points:
    """Return a point where the scalar product of two vectors of order 1 has real part 1."""

    def point(draw: Draw) -> Mapping[str, Mapping[Symbol, Any]]:
        v = draw.vector()
        w = v / real_part(v.dot(v)) + dualise(0 * v.re, draw.vector().re)
        return {"a half turn as the result": {first: v, second: w}}

    return point
