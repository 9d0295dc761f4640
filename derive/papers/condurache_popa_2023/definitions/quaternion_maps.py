"""Definitions of section 4: unit dual quaternions, their displacements and exponentials."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from derive.algebra import Quaternion, Tensor, Vector
from derive.maps import first_principles
from derive.maps.exponential import quaternion_exponential, tensor_exponential
from derive.maps.pose import pose_from_tensor

from ...language import values
from ...language.definitions import screw_quaternion
from ...language.evaluation import Env
from ...language.terms import Symbol
from ...language.values import dualise
from ...numbers.draw import Draw
from . import motions


def displacement(env: Env, q: Quaternion) -> Vector:
    """Return the displacement vector of the pose whose action on lines is ``l -> q l q*``."""
    return pose_from_tensor(first_principles.tensor_by_sandwich(q)).displacement


def lift(env: Env, alpha: Any, u: Vector) -> values.Solution:
    """Return the condition on a unit quaternion: it acts on lines as the displacement by α about u."""
    R = tensor_exponential(alpha * u, env.field)

    def acts_so(q: Quaternion) -> bool:
        q = values.quaternion(q)
        unit_norm = values.equal(env.field, q.norm2(), 1)
        return unit_norm and values.equal(env.field, first_principles.tensor_by_sandwich(q), R)

    return values.Solution(acts_so)


def half_angle(env: Env, q: Quaternion) -> tuple[Any, Vector]:
    """Return the half angle in [0, π] and the axis of a unit quaternion."""
    field, w = env.field, q.vector
    if env.dual and values.equal(field, w.re, 0 * w.re):
        length = field.magnitude(w.du)
        axis = w.du / length if not field.same(length, 0) else motions.AXES[0]
        return field.atan2(dualise(0 * length, length), q.scalar), dualise(axis, 0 * axis)
    length = field.magnitude(w)
    return field.atan2(length, q.scalar), w / length


def exponential_map(env: Env) -> values.Map:
    """Return the map from dual vectors a to quaternions ``exp(a/2)``."""

    def preimage(q: Quaternion) -> list[Vector]:
        angle, axis = half_angle(env, q)
        return [2 * angle * axis]

    return values.Map(lambda a: quaternion_exponential(values.divide(a, 2), env.field), preimage)


def covering(env: Env) -> values.Map:
    """Return the map from unit quaternions to orthogonal dual tensors, with both preimages ±q."""

    def preimages(R: Tensor) -> list[Quaternion]:
        q = screw_quaternion(env, *motions.invariants(env, R))
        return [q, -q]

    return values.Map(first_principles.tensor_by_sandwich, preimages)


def opposite(draw: Draw, first: Symbol, second: Symbol) -> Mapping[Symbol, Any]:
    """Return a unit quaternion and its negative as values of two symbols."""
    q = draw.quaternion(draw.real())
    return {first: q, second: -q}
