"""Definitions of section 2: dual numbers, dual vectors and dual tensors."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ....algebra import Quaternion, Tensor, Vector, real_part
from ....maps import first_principles
from ...language import values
from ...language.environment import Env
from ...language.values import dualise

Frame = Callable[[int], Vector]
"""Vectors of a basis by number, 1 to 3."""

# ---- dual numbers ---------------------------------------------------------------------------------------------------


def multiplies_onto(env: Env, a: Any) -> bool:
    """Return whether some multiple of a is 1."""
    try:
        return bool(values.equal(env.field, a * (1 / a), 1))
    except ZeroDivisionError:
        return False


# ---- dual vectors ---------------------------------------------------------------------------------------------------


def magnitudes(env: Env, a: Vector) -> values.Solution:
    """Return the condition on a magnitude m: ``m m = a · a``, and ``|m°| = |a°|`` if Re m = 0."""

    def is_magnitude(m: Any) -> bool:
        if not values.equal(env.field, m * m, a.dot(a)):
            return False
        return real_part(m) != 0 or values.equal(env.field, m.du * m.du, a.du.dot(a.du))

    return values.Solution(is_magnitude)


def coordinates(env: Env, a: Vector) -> values.Solution:
    """Return the condition on α: ``a = α u`` for some unit vector u."""

    def divides(number: Any) -> bool:
        if real_part(number) != 0:
            return values.equal(env.field, a.dot(a), number * number)
        return values.equal(env.field, a.re, 0 * a.re) and values.equal(env.field, a.du.dot(a.du), number.du**2)

    return values.Solution(divides)


def axes(env: Env, a: Vector) -> values.Solution:
    """Return the condition on u: it is a unit vector and ``a = (a · u) u``."""

    def carries(axis: Vector) -> bool:
        unit = values.equal(env.field, axis.dot(axis), 1)
        return unit and values.equal(env.field, a, a.dot(axis) * axis)

    return values.Solution(carries)


def one_axis(env: Env, a: Vector) -> Vector:
    """Return a unit vector along a."""
    if real_part(a.dot(a)) != 0:
        axis: Vector = a / env.field.magnitude(a)
        return axis
    length = env.field.magnitude(a.du)
    axis = a.du / length if length != 0 else Vector(1, 0, 0)
    lifted: Vector = dualise(axis, 0 * axis)
    return lifted


def on_line(env: Env, a: Vector) -> values.Solution:
    """Return the condition on a point r of the line of a: ``r × u`` is the dual part of the unit vector of a."""
    axis = one_axis(env, a)
    return values.Solution(lambda point: values.equal(env.field, point.cross(axis.re), axis.du))


# ---- dual tensors ---------------------------------------------------------------------------------------------------


def frame(env: Env, q: Quaternion) -> Callable[[int], Vector]:
    """Return a right-handed orthonormal basis of dual vectors: the standard basis displaced by q."""
    turned = first_principles.tensor_by_sandwich(q)
    return lambda k: turned @ Vector(*(int(k == j) for j in (1, 2, 3)))


def matrix(frame: Frame, image: Callable[[Vector], Vector]) -> Tensor:
    """Return the matrix ``e_j · T e_k`` of a linear map T."""
    return Tensor.from_entries(frame(j).dot(image(frame(k))) for j in (1, 2, 3) for k in (1, 2, 3))


def axial(env: Env, a: Tensor) -> Vector:
    """Return the vector a with ``A b = a × b``: ``½ Σ e × A e`` over the standard basis."""
    total: Any = Vector(0, 0, 0)
    for row in Tensor.identity().rows:
        total = total + Vector(*row).cross(a @ Vector(*row))
    axial: Vector = total * values.divide(1, 2)
    return axial
