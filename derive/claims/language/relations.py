"""Relations and functions of numbers that papers' files use besides those of the two papers in Python."""

from __future__ import annotations

import operator
from collections.abc import Callable
from fractions import Fraction
from typing import Any

from ...algebra import Quaternion, Tensor, Vector, first_principles, pose
from ...algebra.element import NotExactError
from ...algebra.matrix import exactly
from ..numbers.fields import innermost
from . import values
from .environment import Env
from .matrices import exp
from .operator_table import define
from .printed import ATOM, LIST, PRODUCT, RELATION, SUM, OperatorRow, Trait

# ---- relations --------------------------------------------------------------------------------------------------

unlike = define("unlike", r"{0} \neq {1}", "{0} != {1}", RELATION, (SUM, SUM),
                lambda env, a, b: not values.equal(env.field.certain, env.now(a), env.now(b)), traits=Trait.DELICATE)


def _ordered(name: str, sign: str, latex: str, test: Callable[[Any, Any], bool]) -> OperatorRow:
    """Return a relation of real numbers, which compares real parts; it needs a field in which numbers have signs."""

    def value(env: Env, a: Any, b: Any) -> bool:
        if not env.field.ordered:
            raise NotExactError("an inequality")
        a, b = innermost(env.now(a)), innermost(env.now(b))
        return env.field.compared(test, a, b)

    return define(name, f"{{0}} {latex} {{1}}", f"{{0}} {sign} {{1}}", RELATION, (SUM, SUM), value,
                  traits=Trait.DELICATE)


less = _ordered("less", "<", "<", operator.lt)
at_most = _ordered("at most", "<=", r"\leq", operator.le)
greater = _ordered("greater", ">", ">", operator.gt)
at_least = _ordered("at least", ">=", r"\geq", operator.ge)
either = define("or", r" \;\text{or}\; ", " or ", LIST, (RELATION,), lambda env, *parts: any(parts),
                traits=Trait.DELICATE)

# ---- functions of numbers ---------------------------------------------------------------------------------------


def _function(name: str, latex: str, value: Callable[..., Any]) -> OperatorRow:
    return define(name, rf"{latex} {{0}}", f"{name}({{0}})", PRODUCT, (ATOM,), value, traits=Trait.TRANSCENDENTAL)


def _hyperbolic(sign: int) -> Callable[[Env, Any], Any]:
    return lambda env, a: (env.field.exp(a) + sign * env.field.exp(-a)) / 2


def _sinc(env: Env, a: Any) -> Any:
    """Return ``sin a/a``, at 0 by its series to second order, which rates need."""
    return 1 - a * a / 6 if env.field.vanishes(innermost(a)) else env.field.sin(a) / a


acos = _function("acos", r"\arccos", lambda env, a: env.field.acos(a))
asin = _function("asin", r"\arcsin", lambda env, a: env.field.asin(a))
sinh = _function("sinh", r"\sinh", _hyperbolic(-1))
cosh = _function("cosh", r"\cosh", _hyperbolic(1))
tanh = _function("tanh", r"\tanh", lambda env, a: _hyperbolic(-1)(env, a) / _hyperbolic(1)(env, a))
sinc = _function("sinc", r"\operatorname{{sinc}}", _sinc)
atan2 = define("atan2 of two", r"\operatorname{{atan2}}\left({0}, {1}\right)", "atan2({0}, {1})", ATOM, (LIST, LIST),
               lambda env, y, x: env.field.atan2(y, x), traits=Trait.TRANSCENDENTAL)


def _floor(env: Env, a: Any) -> Any:
    if isinstance(a, int | Fraction):
        return int(a // 1)
    return env.field.floor(a)


floor = define("floor of number", r"\left\lfloor {0} \right\rfloor", "floor({0})", ATOM, (LIST,), _floor)


def _distance(env: Env, a: Vector, b: Vector) -> Any:
    normal = values.re(a).cross(values.re(b))
    parallel = env.field.same(innermost(normal.dot(normal)), 0)
    return (pose.distance_of_parallels if parallel else pose.distance)(a, b, env.field)


distance = define("distance", r"d\left({0}, {1}\right)", "distance({0}, {1})", ATOM, (LIST, LIST), _distance,
                  traits=Trait.APART)

# ---- functions of CP23 ------------------------------------------------------------------------------------------


def _cayley(env: Env, n: Any, v: Vector) -> Any:
    """Return the rotation of order n: the action of ``(1 + v)ⁿ``, divided by its norm."""
    q = env.field.power(Quaternion(1, v), n)
    return first_principles.tensor_by_sandwich(q) * (1 / env.field.power(1 + v.dot(v), n))


def _polynomial(which: int) -> Callable[[Env, Any, Any], Any]:
    return lambda env, n, x: env.field.pair(n, x)[which]


def _tangent(rotation: Callable[[Vector], Tensor], v: Vector) -> Tensor:
    return first_principles.tangent(lambda w: rotation(exactly(w)), v)


p = define("p", r"p_{{{0}}}\left({1}\right)", "p({0}, {1})", ATOM, (LIST, LIST), _polynomial(0))
q = define("q", r"q_{{{0}}}\left({1}\right)", "q({0}, {1})", ATOM, (LIST, LIST), _polynomial(1))
cay = define("cay", r"\operatorname{{cay}}_{{{0}}}\left({1}\right)", "cay({0}, {1})", ATOM, (LIST, LIST), _cayley)
dcay = define("dcay", r"\operatorname{{dcay}}_{{{0}}}\left({1}\right)", "dcay({0}, {1})", ATOM, (LIST, LIST),
              lambda env, n, v: _tangent(lambda w: _cayley(env, n, w), v))
dexp = define("dexp", r"\operatorname{{dexp}}\left({0}\right)", "dexp({0})", ATOM, (LIST,),
              lambda env, v: _tangent(lambda w: exp.value(env, Tensor.skew(w)), v), traits=Trait.TRANSCENDENTAL)
