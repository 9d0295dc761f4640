"""Symbols of the paper, and operators of sections 7 and 8."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ...algebra import Quaternion, Tensor, Vector
from ...algebra.element import Element
from ...claims.language.environment import Env
from ...claims.language.operator_table import define, dyad, identity, norm, skew
from ...claims.language.printed import ATOM, LIST, PRODUCT, RELATION, SUM, Symbol, Term, Trait, with_trait
from ...claims.numbers.fields import UndefinedError, innermost


def _letters(quantity: str, shape: str, ending: str = "", mark: str = "") -> Callable[..., Symbol]:
    """Return the function that makes symbols of a quantity: letters set by a LaTeX template, names with an ending."""

    def symbol(name: str, latex: str | None = None, text: str | None = None) -> Symbol:
        return Symbol(f"{name}{ending}", quantity, shape.format(latex or name), text or f"{name}{mark}")

    return symbol


real = _letters("real", "{}")
real_vector = _letters("real vector", r"\mathbf{{{}}}", " real")
dual = _letters("dual number", r"\underline{{{}}}", "_")
vector, unit, tensor, orthogonal_tensor = (
    _letters(quantity, r"\underline{{\mathbf{{{}}}}}")
    for quantity in ("dual vector", "unit vector", "tensor", "orthogonal tensor")
)
quaternion = _letters("unit quaternion", r"\underline{{\hat{{\mathbf{{{}}}}}}}", mark="^")

n = Symbol("n", "order", "n", "n")
alpha = Symbol("alpha", "angle", r"\underline{\alpha}", "α")
u = unit("u")
v = vector("v")
I, V, VV, x = identity, skew(v), dyad(v, v), norm(v) ** 2
R, Q = orthogonal_tensor("R"), Symbol("Q", "real tensor", r"\mathbf{Q}", "Q")
rho = Symbol("rho", "real vector", r"\boldsymbol{\rho}", "ρ")
q_hat = Symbol("q", "quaternion", r"\underline{\hat{\mathbf{q}}}", "q^")

# ---- limits, inequalities, numbers of preimages and of real equations -------------------------------------------

FAR_ORDERS = (40, 80)
"""Orders at which a sequence must agree to count as constant."""


def _positive(env: Env, a: Any) -> bool:
    """Return whether a number has a positive real part; True for generic symbols."""
    return not env.field.ordered or bool(innermost(a) > 0)


positive = define("positive", "{0} > 0", "{0}>0", RELATION, (SUM,), _positive)
no_less = define("no less", r"{0} \geq {1}", "{0}≥{1}", RELATION, (SUM, SUM),
                 lambda env, a, b: isinstance(a, Element) or a >= b)
"""Claim ``no_less(n, 3)`` about orders; True for a symbolic order."""


def _limit(env: Env, index: Term, body: Term) -> Any:
    """Return the limit of a sequence that is constant from some order on; raise for other sequences."""
    if not isinstance(index, Symbol):
        raise TypeError("only a symbol can tend to infinity")
    if not isinstance(env.value(index), int):
        return env.value(body)
    free = {symbol: value for symbol, value in env.values.items() if symbol not in env.definitions}
    places = (Env(env.field, {**free, index: n}, env.definitions, env.dual, env.moving) for n in FAR_ORDERS)
    first, second = (place.value(body) for place in places)
    if not env.equal(first, second):
        raise UndefinedError(f"still changing at order {FAR_ORDERS[-1]}")
    return second


limit = define("limit", r"\lim_{{{0} \to \infty}} {1}", "lim {0} {1}", PRODUCT, (ATOM, PRODUCT), _limit, lazy=True)
provided = define("if", r"\text{{if }} {0}", "if {0}", RELATION, (LIST,), lambda env, a: a)
tends = define("tends", r"{0} \to {1}", "{0} {1}", RELATION, (SUM,), lambda env, a, b: env.equal(a, b))
preimage_count = define("preimage count", r"\#\, {0}^{{-1}}\left({1}\right)", "#{0}{1}", ATOM, (ATOM, LIST),
                        lambda env, f, target: f.reaches(env.field, target))


def _components(a: Any) -> int:
    sizes = {Vector: 3, Quaternion: 4, Tensor: 9}
    return 2 * sizes.get(type(a), 1)


equations_in = define("real equations", r"\#_{{\mathbb{{R}}}}\, {0}", "#{0}", PRODUCT, (ATOM,),
                      lambda env, a: _components(a))
"""Number of real components of a dual quantity, which is the number of real equations for its rate."""


def is_algebraic(*statements: Term) -> bool:
    """Return whether no statement contains a transcendental function."""
    return not with_trait(Trait.TRANSCENDENTAL, *statements)
