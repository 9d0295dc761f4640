"""Definitions of p_n and q_n, of the Cayley map of order n, and of its rotation and tangent operator."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ....algebra import Quaternion, Tensor, Vector
from ....maps import first_principles
from ...language import values
from ...language.common_definitions import condition, screw_quaternion
from ...language.environment import Env
from ...numbers.fields import UndefinedError


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
    """Return a definition with its order fixed."""
    return lambda env, *arguments: function(env, order, *arguments)


def _square(a: Any) -> Any:
    return a.dot(a) if isinstance(a, Vector) else a * a
