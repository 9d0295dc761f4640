"""Definitions of sections 5, 6 and 9: Cayley maps of the orders 1 and 2 by their rotations."""

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
from . import dual_algebra, motions, orders, quaternion_maps

Points = Callable[[Draw], Mapping[str, Mapping[Symbol, Any]]]
"""Further points of an entry, by name."""


def cayley_map(env: Env) -> values.Map:
    """Return the map from vectors to orthogonal dual tensors, with its one preimage."""
    return values.Map(lambda v: orders.rotation(env, 1, v), lambda R: [rodrigues(env, *motions.invariants(env, R))])


def rodrigues(env: Env, alpha: Any, u: Vector) -> Vector:
    """Return ``tan(α/2) u``; raise `values.MissedError` where it is infinite."""
    half = values.divide(alpha, 2)
    cosine = env.field.cos(half)
    if env.field.same(real_part(cosine), 0):
        raise values.MissedError("the tangent is infinite")
    vector: Vector = env.field.sin(half) / cosine * u
    return vector


def exponential_map(env: Env) -> values.Map:
    """Return the map from dual vectors to orthogonal dual tensors."""
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
    """Return the Euler vector by angle and axis."""
    angle, axis = motions.invariants(env, R)
    vector: Vector = angle * axis
    return vector


def is_below_half_turn(env: Env, alpha: Any) -> bool:
    """Return whether ``|Re α| < π``, which generic symbols fulfil."""
    angle = real_part(alpha)
    return not isinstance(angle, mpmath.mpf) or bool(abs(angle) < mpmath.pi)


def angle_of_cayley(env: Env, v: Vector) -> values.Solution:
    """Return the condition on α that v makes the rotation by α about its axis."""
    R, axis = orders.rotation(env, 1, v), dual_algebra.one_axis(env, v)
    return values.Solution(lambda alpha: values.equal(env.field, screw_tensor(env, alpha, axis), R))


def displacement_types(
    rotates: Symbol, translates: Symbol, general: Symbol
) -> tuple[tuple[Symbol, Callable[..., bool]], ...]:
    """Return the three statements about a displacement, with their definitions by its tensor."""
    table = ((rotates, claims.fixes_a_point), (translates, claims.fixes_directions), (general, claims.is_general))

    def of_tensor(check: Callable[..., bool]) -> Callable[..., bool]:
        return lambda env, R: check(env, pose_from_tensor(R))

    return tuple((symbol, of_tensor(check)) for symbol, check in table)


def map_of_order(order: int) -> Callable[[Env], values.Map]:
    """Return the same as a map; a preimage is the tangent of the half angle over the order."""

    def make(env: Env) -> values.Map:
        def preimages(q: Quaternion) -> list[Vector]:
            angle, axis = quaternion_maps.half_angle(env, q)
            return [rodrigues(env, 2 * values.divide(angle, order), axis)]

        return values.Map(lambda v: orders.cayley(env, order, v), preimages)

    return make


def preimage(order: int) -> Callable[[Env, Quaternion], values.Solution]:
    """Return the condition on v to have a quaternion as its transform; at order 1 as ``q₀ (1 + v)``, without a root."""

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
    """Return the quaternion of two displacements, the second argument first; at order 1 not of unit norm."""

    def one(env: Env, v: Vector) -> Quaternion:
        return orders.cayley(env, 2, v) if order == 2 else Quaternion(1, v)

    return lambda env, second, first: one(env, second) * one(env, first)


def rodrigues_by_quotient(env: Env, alpha: Any, u: Vector) -> Vector:
    """Return the v of order 1 with this angle and axis: vector part over scalar part of its quaternion."""
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
    """Return a point where Re α is the second angle, after 2π, with an infinite tangent of α/4."""
    return lambda draw: {"real part 6π": {alpha: draw.number(6 * mpmath.mpf(mpmath.pi))}}


def back_to_back(second: Symbol, first: Symbol) -> Points:
    """Return two equal half turns at order 2: their product is −1."""
    return lambda draw: {"two half turns about one axis": dict.fromkeys((first, second), draw.unit())}


def to_a_half_turn(first: Symbol, second: Symbol) -> Points:
    """Return two vectors of order 1 whose product has the real part 1."""

    def point(draw: Draw) -> Mapping[str, Mapping[Symbol, Any]]:
        v = draw.vector()
        w = v / real_part(v.dot(v)) + dualise(0 * v.re, draw.vector().re)
        return {"a half turn as the result": {first: v, second: w}}

    return point
