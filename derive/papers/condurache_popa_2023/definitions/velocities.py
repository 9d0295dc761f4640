"""Definitions of section 8: twists and tangent operators, by differentiation from first principles.

Symbols may depend on time: `Env.now` returns their current value, `Env.rate` their time derivative.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ....algebra import Dual, Tensor, Vector, first_principles
from ....algebra.pose import line_through, pose_from_tensor
from ....claims.language import values
from ....claims.language.common_definitions import condition, plain
from ....claims.language.environment import Env
from ....claims.numbers.fields import innermost
from .motions import AXES


def at_rest(env: Env, a: Any) -> Any:
    """Return a value with its time derivatives set to 0."""

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
