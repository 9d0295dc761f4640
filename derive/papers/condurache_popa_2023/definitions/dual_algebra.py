"""Definitions of section 2: dual numbers, dual vectors and dual tensors."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ....algebra import Quaternion, Tensor, Vector, first_principles, real_part
from ....claims.language import values
from ....claims.language.common_definitions import condition
from ....claims.language.environment import Env
from ....claims.language.values import dualise
from ....claims.numbers.fields import innermost

Frame = Callable[[int], Vector]
"""Vectors of a basis by number, 1 to 3."""


def multiplies_onto(env: Env, a: Any) -> bool:
    """Return whether some multiple of a is 1."""
    try:
        return bool(env.equal(a * (1 / a), 1))
    except ZeroDivisionError:
        return False


@condition
def magnitudes(env: Env, m: Any, a: Vector) -> bool:
    """Return whether m is a magnitude of a: ``m m = a · a``, and ``|m°| = |a°|`` if Re m = 0."""
    if not env.equal(m * m, a.dot(a)):
        return False
    return real_part(m) != 0 or env.equal(m.du * m.du, a.du.dot(a.du))


@condition
def coordinates(env: Env, alpha: Any, a: Vector) -> bool:
    """Return whether ``a = α u`` for some unit vector u."""
    if real_part(alpha) != 0:
        return env.equal(a.dot(a), alpha * alpha)
    return env.equal(a.re, 0 * a.re) and env.equal(a.du.dot(a.du), alpha.du**2)


@condition
def axes(env: Env, u: Vector, a: Vector) -> bool:
    """Return whether u is a unit vector and ``a = (a · u) u``."""
    return env.equal(u.dot(u), 1) and env.equal(a, a.dot(u) * u)


def one_axis(env: Env, a: Vector) -> Any:
    """Return a unit vector along a."""
    if not env.field.vanishes(innermost(a.dot(a))):
        return a / env.field.magnitude(a)
    length = env.field.magnitude(a.du)
    axis = a.du / length if length != 0 else Vector(1, 0, 0)
    return dualise(axis, 0 * axis)


@condition
def on_line(env: Env, r: Vector, a: Vector) -> bool:
    """Return whether r is on the line of a: ``r × u`` is the dual part of the unit vector of a."""
    axis = one_axis(env, a)
    return env.equal(r.cross(axis.re), axis.du)


# ---- dual tensors ---------------------------------------------------------------------------------------------------


def frame(env: Env, q: Quaternion) -> Callable[[int], Vector]:
    """Return a right-handed orthonormal basis of dual vectors: the standard basis displaced by q."""
    turned = first_principles.tensor_by_sandwich(q)
    return lambda k: turned @ Vector(*(int(k == j) for j in (1, 2, 3)))


def matrix(frame: Frame, image: Callable[[Vector], Vector]) -> Tensor:
    """Return the matrix ``e_j · T e_k`` of a linear map T."""
    return Tensor.from_entries(frame(j).dot(image(frame(k))) for j in (1, 2, 3) for k in (1, 2, 3))


def axial(env: Env, a: Tensor) -> Any:
    """Return the vector a with ``A b = a × b``: ``½ Σ e × A e`` over the standard basis."""
    axes = (Vector(*row) for row in Tensor.identity().rows)
    return sum((e.cross(a @ e) for e in axes), start=Vector(0, 0, 0)) * values.divide(1, 2)
