"""Powers of numbers, quaternions and matrices, also with an exponent that grows, and the functions of CP23."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import reduce
from typing import Any

from ...algebra import Quaternion, Structure, Tensor, Vector, first_principles, matrix
from ...algebra.element import NotExactError
from ...algebra.first_principles import quaternion_exponential
from ..numbers.series import Series
from . import values
from .calculus import coefficient
from .environment import Env
from .matrices import exp
from .operator_table import define
from .printed import ATOM, LIST, POWER, Term, Trait


def _power(env: Env, base: Term, exponent: Term) -> Any:
    e = env.value(exponent)
    if Trait.LENGTH in base.operator.traits and isinstance(e, int) and e % 2 == 0:
        return env.field.power(values.square(env.value(base.arguments[0])), e // 2)  # |v|² = v·v needs no root
    value = env.value(base)
    if isinstance(value, int) and isinstance(e, int) and e >= 0:
        return value**e
    if isinstance(e, Series) and isinstance(value, Structure):
        return _limit_of_power(env, value, e)
    if isinstance(value, matrix.Matrix):
        factor = value if e >= 0 else matrix.inverse(value)
        return reduce(matrix.product, [factor] * abs(e), matrix.identity(len(value.rows)))
    if (env.field.ordered or isinstance(e, Series)) and not isinstance(e, int | Fraction | Structure):
        return env.field.exp(env.field.log(value) * e)
    if isinstance(value, Structure) and isinstance(e, int) and e > 1:
        return _next_power(env, value, e)
    return env.field.power(value, e)


def _next_power(env: Env, base: Any, e: int) -> Any:
    """Return a power by the one before, if this is known: sums take them in turn."""
    _, known, power = env.powers.get(id(base), (base, 0, None))
    found = values.multiply(power, base) if known == e - 1 else env.field.power(base, e)
    env.powers[id(base)] = base, e, found
    return found


def _limit_of_power(env: Env, base: Any, e: Series) -> Any:
    """Return the constant term of ``base^e`` for a base near the identity: the exponential of that of ``e log base``.

    The next terms are not known, since the parts of the logarithm need not commute.
    """
    gap = matrix.exactly(base) - matrix.exactly(matrix.identity(len(matrix.rows_of(base))))
    if not all(env.field.vanishes(coefficient(e.field, part, 0)) for part in gap):
        raise NotExactError("a power that grows, of a matrix that does not tend to the identity")
    power, total = gap, gap * e
    for k in range(2, 1 - e.order):
        power = matrix.product(power, gap)
        total = total + power * e * Fraction((-1) ** (k + 1), k)
    found = exp.value(env, matrix.exactly(coefficient(e.field, total, 0)))
    return found.map(lambda c: Series(e.field, 0, [e.field.number(c)]))


define("power", "{0}^{{{1}}}", "{0}^{1}", POWER, (ATOM, LIST), _power, lazy=True)


# ---- functions of CP23 ------------------------------------------------------------------------------------------


def _cayley(env: Env, n: Any, v: Vector) -> Any:
    """Return the rotation of order n: the action of ``(1 + v)ⁿ``, divided by its norm."""
    q = env.field.power(Quaternion(1, v), n)
    return first_principles.tensor_by_sandwich(q) * (1 / env.field.power(1 + v.dot(v), n))


def _polynomial(which: int) -> Callable[[Env, Any, Any], Any]:
    return lambda env, n, x: env.field.pair(n, x)[which]


def _tangent(displacement: Callable[[Vector], Quaternion], v: Vector) -> Tensor:
    return first_principles.tangent(lambda w: displacement(matrix.exactly(w)), v)


p = define("p", r"p_{{{0}}}\left({1}\right)", "p({0}, {1})", ATOM, (LIST, LIST), _polynomial(0))
q = define("q", r"q_{{{0}}}\left({1}\right)", "q({0}, {1})", ATOM, (LIST, LIST), _polynomial(1))
cay = define("cay", r"\operatorname{{cay}}_{{{0}}}\left({1}\right)", "cay({0}, {1})", ATOM, (LIST, LIST), _cayley)
dcay = define("dcay", r"\operatorname{{dcay}}_{{{0}}}\left({1}\right)", "dcay({0}, {1})", ATOM, (LIST, LIST),
              lambda env, n, v: _tangent(lambda w: env.field.power(Quaternion(1, w), n), v))
dexp = define("dexp", r"\operatorname{{dexp}}\left({0}\right)", "dexp({0})", ATOM, (LIST,),
              lambda env, v: _tangent(lambda w: quaternion_exponential(w / 2, env.field), v),
              traits=Trait.TRANSCENDENTAL)
