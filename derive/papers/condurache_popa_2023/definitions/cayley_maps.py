"""Definitions of section 7: Cayley maps with preimages, families v = φ(α) u, factors a(v)."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from ....algebra import Quaternion, Tensor, Vector, first_principles, real_part
from ....claims.language import values
from ....claims.language.environment import Env
from ....claims.numbers.fields import UndefinedError, innermost
from ....claims.numbers.generic import EveryOrder
from ....maps import Cayley
from ....maps.chart import Chart
from ....maps.elementary import alpha as angle_of_phi
from ....maps.elementary import evaluate
from ....proof.proved import citing
from .dual_algebra import condition
from .motions import half_angle
from .orders import cayley


def proved(*numbers: int) -> Callable[[Env], bool]:
    """Return a definition that is true if theorems for every order prove all these equations."""
    return lambda env: set(numbers) <= _proved_among(numbers)


@cache
def _proved_among(numbers: tuple[int, ...]) -> frozenset[int]:
    return frozenset(number for proof in citing(numbers) if proof.proved for number in proof.equations)


# ---- the map and its preimages ----------------------------------------------------------------------------------


def cayley_function(env: Env, n: Any) -> values.Map:
    """Return the map (46) with its preimages: the finite vectors v_k of all branches k."""
    return _map(env, n, lambda v: v, lambda t, u: [t * u])


def cayley_function_of_growing_scale(env: Env, n: Any) -> values.Map:
    """Return the map (59) with ``a(v) = 1 + v·v``; ``|v|/a(v) = t`` has two, one or no solutions on a branch."""

    def solve(t: Any, u: Vector) -> list[Vector]:
        if env.field.same(real_part(t), 0):
            return [t * u]
        discriminant = 1 - 4 * t * t
        if innermost(discriminant) < 0:
            return []
        root = env.field.sqrt(discriminant)
        return [(1 + root) / (2 * t) * u, (1 - root) / (2 * t) * u]

    return _map(env, n, lambda v: v / (1 + v.dot(v)), solve)


def counted_cayley_function(env: Env, n: Any) -> values.Map:
    """Return the map (46); `preimages` raises for translations at n > 1, which have infinitely many."""
    f = cayley_function(env, n)

    def preimages(q: Quaternion) -> list[Vector]:
        if n > 1 and env.equal(q.vector.re, 0 * q.vector.re):
            raise UndefinedError("infinitely many preimages")
        return f.preimages(q)

    return values.Map(f.image, preimages)


def _map(
    env: Env, n: Any, to_w: Callable[[Vector], Vector], from_t: Callable[[Any, Vector], list[Vector]]
) -> values.Map:
    def preimages(q: Quaternion) -> list[Vector]:
        angle, u = half_angle(env, q)
        found: list[Vector] = []
        for k in range(n):
            turn = (angle + k * env.field.pi) / n
            cosine = env.field.cos(turn)
            if innermost(cosine) != 0:
                found += from_t(env.field.sin(turn) / cosine, u)
        return found

    return values.Map(lambda v: cayley(env, n, to_w(v)), preimages)


def branch_coefficient(env: Env, n: Any, k: int, alpha: Any) -> Any:
    """Return the signed coefficient of v_k along u: the tangent of (α + 2kπ)/2n."""
    angle = values.divide(alpha + 2 * k * env.field.pi if k else alpha, 2 * n)
    return values.divide(env.field.sin(angle), _pole(env.field.cos(angle)))


def branch(env: Env, n: Any, k: int, alpha: Any, u: Vector) -> Any:
    """Return the preimage ``v_k`` of branch k."""
    return branch_coefficient(env, n, k, alpha) * u


# ---- any factor a(v) --------------------------------------------------------------------------------------------


def constant(env: Env, value: Any) -> Callable[[Any], Any]:
    return lambda argument: value


def function_of(definition: Callable[..., Any]) -> Callable[..., Any]:
    """Return the definition of a symbol printed as a function of v: the constant function with the defined value."""
    return lambda env, *arguments: constant(env, definition(env, *arguments))


def modified(env: Env, n: Any, a: Any, v: Vector) -> Any:
    """Return the map (59): the Cayley map of order n at v/a."""
    return cayley(env, n, v / a)


def modified_root(env: Env, n: Any, a: Any, v: Vector) -> Any:
    """Return the map (59), with both signs ± unless n is an even integer."""
    q = modified(env, n, a, v)
    return q if isinstance(n, int) and n % 2 == 0 else values.Either(q, -q)


def modified_tensor(env: Env, n: Any, a: Any, v: Vector) -> Tensor:
    return first_principles.tensor_by_sandwich(modified(env, n, a, v))


def direction(env: Env, v: Vector) -> Any:
    """Return the direction ``v/|v|``."""
    return v / _pole(env.field.magnitude(v))


@condition
def scales(env: Env, a: Any, n: Any, q: Quaternion, v: Vector) -> bool:
    """Return whether the map (59) with the factor a takes v to ±q."""
    return env.equal(values.Either(q, -q), modified(env, n, a, v))


# ---- families ---------------------------------------------------------------------------------------------------


def member(chart: Chart) -> Callable[..., Any]:
    """Return the definition ``v = φ(α) u`` of a chart."""
    return lambda env, alpha, u: u * evaluate(chart.phi, angle_of_phi, alpha, env.field)


def at_fraction(charts: Callable[[int], Chart]) -> Callable[..., Any]:
    """Return the definition of the order-1 vector of charts at the angle α/n, e.g. ``tan(α/2n) u`` for `Cayley`."""
    first = member(charts(1))
    return lambda env, n, alpha, u: first(env, values.divide(alpha, n), u)


rodrigues_vector = at_fraction(Cayley)


def powers(which: int) -> Callable[[Env, Any], Callable[[Any], Any]]:
    """Return the definition of P_n (0) or Q_n (1) as a function of |v|, from ``(√(1 − v²) + v)ⁿ = P_n + Q_n v``."""

    def at(env: Env, n: Any, length: Any) -> tuple[Any, Any]:
        c, x = env.field.sqrt(1 - length * length), length * length
        if isinstance(env.field, EveryOrder) and not isinstance(n, int):
            power = env.field.power(Quaternion(c, Vector(length, 0 * length, 0 * length)), n)
            return power.scalar, power.vector.c1 / length
        P, Q = c, 1 + 0 * c
        for _ in range(n - 1):
            P, Q = c * P - x * Q, P + c * Q
        return P, Q

    return lambda env, n: lambda length: at(env, n, length)[which]


def _pole(a: Any) -> Any:
    if innermost(a) == 0:
        raise ZeroDivisionError("a pole")
    return a
