"""What the paper's symbols stand for, by their definitions: what its printed formulas are checked against.

Every function has the arguments of `derive.papers.language.evaluation.Definition`: the environment, then values.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from derive.algebra import Quaternion, Tensor, Vector
from derive.maps import first_principles

from ...language import values
from ...language.evaluation import Env
from ...numbers.fields import UndefinedError

Function = Callable[[Any], Any]


def p(env: Env, n: Any) -> Function:
    """The polynomial p_n by its recurrence, as a function of the symbol X or of |v|."""
    return lambda a: env.field.pair(n, _square(a))[0]


def q(env: Env, n: Any) -> Function:
    """The polynomial q_n."""
    return lambda a: env.field.pair(n, _square(a))[1]


def cayley(env: Env, n: Any, v: Vector) -> Quaternion:
    """``(1 + v)^(n/2) (1 − v)^(−n/2)``: the n-th power of 1 + v over its norm."""
    unit: Quaternion = env.power(Quaternion(1, v), n) / env.power(1 + v.dot(v), values.divide(n, 2))
    return unit


def rotation(env: Env, n: Any, v: Vector) -> Tensor:
    """The orthogonal dual tensor of v, by its action ``q r q*``."""
    return first_principles.tensor_by_sandwich(cayley(env, n, v))


def tangent(env: Env, n: Any, v: Vector) -> Tensor:
    """The operator ω = T v̇, with ω = vect(Ṙ Rᵀ) differentiated."""
    return first_principles.tangent(lambda w: rotation(env, n, w), v)


def tangent_inv(env: Env, n: Any, v: Vector) -> Tensor:
    """The inverse operator."""
    return tangent(env, n, v).inverse()


def screw_quaternion(env: Env, alpha: Any, u: Vector) -> Quaternion:
    """``cos(α/2) + u sin(α/2)``."""
    half = values.divide(alpha, 2)
    return Quaternion(env.field.cos(half), env.field.sin(half) * u)


def preimage(env: Env, n: Any, alpha: Any, u: Vector) -> values.Solution:
    """Every v of order n that gives the displacement of α and u."""
    target = screw_quaternion(env, alpha, u)
    either_sign = values.Either(target, -target)
    return values.Solution(lambda v: values.equal(env.field, either_sign, cayley(env, n, as_vector(env, v))))


def as_vector(env: Env, a: Vector | Quaternion) -> Vector:
    """A vector that a formula gives as a quaternion."""
    if isinstance(a, Vector):
        return a
    if not values.equal(env.field, a.scalar, 0):
        raise UndefinedError("no vector: the scalar part is not 0")
    return a.vector


def at_order(order: int, function: Callable[..., Any]) -> Callable[..., Any]:
    """Return the definition at one order."""
    return lambda env, *arguments: function(env, order, *arguments)


def _square(a: Any) -> Any:
    return a.dot(a) if isinstance(a, Vector) else a * a
