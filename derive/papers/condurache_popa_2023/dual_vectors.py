"""Section 2.2, dual vectors: lines 56-68."""

from __future__ import annotations

from typing import Any

from derive.algebra import Vector, real_part

from .. import values
from ..equation import equation
from ..evaluation import Env, let
from ..notation import (
    Re,
    both,
    bracket,
    cases,
    cross,
    dot,
    dualise,
    epsilon,
    equal,
    nonzero,
    norm,
    pm,
    remark,
    triple,
    words,
    zero,
)  # fmt: skip
from ..terms import Letter
from .alphabet import dual, real_vector, vector
from .alphabet import unit as unit_letter

a, a0 = real_vector("a"), Letter("a0 real", "real vector", r"\mathbf{a}^0", "a0")
w = real_vector("v")
a_, b_, c_ = vector("a"), vector("b"), vector("c")
lam, mu = dual("lambda", r"\lambda", "λ"), dual("mu", r"\mu", "μ")
lam_real = Letter("lambda", "real", r"\lambda", "λ")
alpha = Letter("alpha_", "dual number", r"\underline{\alpha}", "α")
u_a = Letter("u_a", "unit vector", r"\underline{\mathbf{u}}_a", "ua")
size = Letter("|a|", "dual number", r"\left|\underline{\mathbf{a}}\right|", "a")
r = Letter("r", "real vector", r"\mathbf{r}", "r")
u = unit_letter("u")
basis = tuple(Letter(f"e{i}", "constant", rf"\mathbf{{e}}_{i}", f"e{i}") for i in (1, 2, 3))


def _vector(env: Env, re: Vector, du: Vector) -> Any:
    """The dual vector with these parts."""
    return dualise(re, du)


def _nilpotent(env: Env, du: Vector) -> Any:
    return dualise(0 * du, du)


def _multiple(env: Env, factor: Any, axis: Vector) -> Vector:
    product: Vector = factor * axis
    return product


def _magnitude(env: Env, a: Vector) -> values.Solution:
    """Every m with ``m m = a · a`` and positive real part; at Re a = 0, also of the size of the dual part."""

    def is_magnitude(m: Any) -> bool:
        if not values.equal(env.field, m * m, a.dot(a)):
            return False
        return real_part(m) != 0 or values.equal(env.field, m.du * m.du, a.du.dot(a.du))

    return values.Solution(is_magnitude)


def _coordinate(env: Env, a: Vector) -> values.Solution:
    """Every α with ``a = α u`` for some unit vector u."""

    def divides(number: Any) -> bool:
        if real_part(number) != 0:
            return values.equal(env.field, a.dot(a), number * number)
        return values.equal(env.field, a.re, 0 * a.re) and values.equal(env.field, a.du.dot(a.du), number.du**2)

    return values.Solution(divides)


def _axis(env: Env, a: Vector) -> values.Solution:
    """Every unit vector u that a is a multiple of: ``a = (a · u) u``."""

    def carries(axis: Vector) -> bool:
        unit = values.equal(env.field, axis.dot(axis), 1)
        return unit and values.equal(env.field, a, a.dot(axis) * axis)

    return values.Solution(carries)


def _magnitude_value(env: Env, a: Vector) -> Any:
    return env.field.magnitude(a)


def axis_value(env: Env, a: Vector) -> Vector:
    """One unit vector along a."""
    if real_part(a.dot(a)) != 0:
        axis: Vector = a / env.field.magnitude(a)
        return axis
    length = env.field.magnitude(a.du)
    axis = a.du / length if length != 0 else Vector(1, 0, 0)
    lifted: Vector = dualise(axis, 0 * axis)
    return lifted


def _on_line(env: Env, a: Vector) -> values.Solution:
    """Every point of the line of a: its moment ``r × u`` is the dual part of the unit vector."""
    axis = axis_value(env, a)
    return values.Solution(lambda point: values.equal(env.field, point.cross(axis.re), axis.du))


def _on_free_line(env: Env, a0: Vector, through: Vector) -> values.Solution:
    """Every point of the line through `through` along a⁰."""
    return values.Solution(
        lambda point: values.equal(env.field, (point - through).cross(a0), 0 * a0)
    )


def _basis(i: int) -> Any:
    return lambda env: Vector(*(int(i == k) for k in range(3)))


PARTS = (let(a_, _vector, a, a0),)
BASIS = tuple(let(e, _basis(i)) for i, e in enumerate(basis))
e1, e2, e3 = basis

ENTRIES = (
    equation("3", "dual vectors", 57,
             both(remark(equal(a_, a + epsilon * a0), words(r"\mathbf{a}, \mathbf{a}^0 \in V_3", "aa0V3")),
                  equal(epsilon**2, 0), nonzero(epsilon)),
             extract="a _ = a + ε a 0 ; a , a 0 V 3 , ε 2 = 0 , ε 0", where=PARTS),
    equation("triple-product", "triple scalar product", 58, equal(triple(a_, b_, c_), dot(a_, cross(b_, c_))),
             extract="a _ , b _ , c _ = a _ · b _ × c _"),
    equation("vector-module", "dual vectors are a free module", 58,
             both(equal(lam * (a_ + b_), lam * a_ + lam * b_), equal((lam + mu) * a_, lam * a_ + mu * a_),
                  equal(lam * (mu * a_), lam * mu * a_),
                  equal(a_, bracket(dot(a_, e1)) * e1 + bracket(dot(a_, e2)) * e2 + bracket(dot(a_, e3)) * e3)),
             where=BASIS),
    equation("vector-magnitude", "what the magnitude fulfils", 59, equal(dot(norm(a_), norm(a_)), dot(a_, a_)),
             extract="a _ · a _ = a _ · a _"),
    equation("4", "magnitude of a dual vector", 60,
             equal(size, cases((norm(a) + epsilon * (dot(a0, a) / norm(a)), nonzero(Re(a_))),
                               (epsilon * norm(a0), zero(Re(a_))))),
             extract="a _ = a + ε a 0 · a a , R e a _ 0 ε a 0 , R e a _ = 0",
             where=(*PARTS, let(size, _magnitude, a_)),
             remark="Line 59 leaves the dual part open where Re a = 0; the form here makes |λ a| = |λ| |a|."),
    equation("5", "a dual vector is a dual number times a unit dual vector", 64, equal(a_, alpha * u_a),
             extract="a _ = α _ u _ a", where=(let(alpha, _magnitude_value, a_), let(u_a, axis_value, a_))),
    equation("polar-magnitude", "the dual number of Proposition 1", 65, equal(pm(alpha), norm(a_)),
             extract="± α _ = a _", where=(let(alpha, _coordinate, a_),)),
    equation("6", "the unit dual vector of Proposition 1", 66,
             equal(pm(u_a),
                   cases((a / norm(a) + epsilon * (cross(a, cross(a0, a)) / norm(a) ** 3), nonzero(Re(a_))),
                         (remark(a0 / norm(a0) + epsilon * (cross(w, a0) / norm(a0)),
                                 words(r"\mathbf{v} \in V_3", "vV3")), zero(Re(a_))))),
             extract="± u _ a = a a + ε a × a 0 × a a 3     R e a _ 0 a 0 a 0 + ε v × a 0 a 0 , v V 3     R e a _ = 0",
             where=(*PARTS, let(u_a, _axis, a_)), condition=nonzero(a_),
             also=lambda draw: {"a = 0": {a: Vector(0, 0, 0), a0: Vector(0, 0, 0)}},
             because=both(equal(dot(cross(w, a0), a0), 0), equal(epsilon * a0, epsilon * norm(a0) * (
                 a0 / norm(a0) + epsilon * (cross(w, a0) / norm(a0))))),
             remark="The supporting identity is the case Re a = 0. For a = 0 any unit vector serves."),
    equation("polar-unique", "both are unique up to sign", 67,
             both(equal(pm(lam), norm(a_)), equal(pm(u), a_ / norm(a_))),
             where=(let(a_, _multiple, lam, u),), claimed=nonzero(Re(lam)),
             remark="a is any product λ u of a dual number and a unit dual vector."),
    equation("line", "the line of a dual vector", 68,
             equal(r, cross(a, a0) / norm(a) ** 2 + lam_real * (a / norm(a))),
             extract="r = a × a 0 a 2 + λ a a", where=(*PARTS, let(r, _on_line, a_)), claimed=nonzero(Re(a_))),
    equation("line-free", "the line where the real part is zero", 68,
             remark(equal(r, w + lam_real * (a0 / norm(a0))),
                    words(r"\mathbf{v} \in V_3,\ \lambda \in \mathbb{R}", "vV3λR")),
             extract="r = v + λ a 0 a 0 , v V 3 , λ R", where=(let(r, _on_free_line, a0, w),),
             condition=nonzero(a0), remark="a = 0 has no line."),
)  # fmt: skip
