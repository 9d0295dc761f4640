"""Definitions shared by both papers: functions of the environment and of values, for `evaluation.let`."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from derive.algebra import Dual, Quaternion, Tensor, Vector
from derive.maps import first_principles

from . import values
from .evaluation import Env


def plain(f: Callable[..., Any]) -> Callable[..., Any]:
    """Return the definition given by a function that needs only values."""
    return lambda env, *arguments: f(*arguments)


same = plain(lambda a: a)
real_of, dual_of = plain(values.re), plain(values.du)
scalar_part, vector_part = plain(lambda q: q.scalar), plain(lambda q: q.vector)
multiple = plain(lambda factor, a: factor * a)
from_parts, vector_from_parts = plain(Dual), plain(values.dualise)
nilpotent = plain(lambda a: values.dualise(0 * a, a))
skew_of, transpose_of, inverse_of = plain(Tensor.skew), plain(lambda T: T.transpose), plain(lambda T: T.inverse())
image = plain(lambda T, a: T @ a)


def component_of(index: int, part: Callable[[Any], Any] = lambda a: a) -> Callable[..., Any]:
    """Return the definition of a vector component, counted from 1; `part` maps it to its real or dual part."""
    return plain(lambda a: part(tuple(a)[index - 1]))


def screw_quaternion(env: Env, alpha: Any, u: Vector) -> Quaternion:
    """Return ``cos(α/2) + u sin(α/2)``."""
    half = values.divide(alpha, 2)
    return Quaternion(env.field.cos(half), env.field.sin(half) * u)


def screw_tensor(env: Env, alpha: Any, u: Vector) -> Tensor:
    """Return the orthogonal dual tensor of an angle and an axis, computed from its quaternion."""
    return first_principles.tensor_by_sandwich(screw_quaternion(env, alpha, u))
