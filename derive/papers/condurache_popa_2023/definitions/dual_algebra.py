"""Definitions of section 2, and of all sections: dual numbers, vectors and tensors, and operators for claims in words.

A claim without a formula is a symbol (`proposition`) whose definition computes its truth.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ....algebra import Dual, Quaternion, Tensor, Vector, first_principles, real_part
from ....algebra.pose import Pose, pose_from_tensor
from ....claims.language import values
from ....claims.language.environment import Env
from ....claims.language.operator_table import define
from ....claims.language.printed import ATOM, LIST, RELATION, SUM, Symbol, Term, Trait
from ....claims.language.values import dualise
from ....claims.numbers.fields import innermost


def plain(f: Callable[..., Any]) -> Callable[..., Any]:
    """Return the function of a `Definition` that ignores the environment and applies f to the values."""
    return lambda env, *arguments: f(*arguments)


def condition(test: Callable[..., bool]) -> Callable[..., values.Solution]:
    """Return the definition by a condition: the symbol is any value with ``test(env, value, *arguments)``."""
    return lambda env, *arguments: values.Solution(lambda value: test(env, value, *arguments))


same = plain(lambda a: a)
real_of, dual_of = plain(values.re), plain(values.du)
scalar_part, vector_part = plain(lambda q: q.scalar), plain(lambda q: q.vector)
multiple = plain(lambda factor, a: factor * a)
from_parts, vector_from_parts = plain(Dual), plain(values.dualise)
nilpotent = plain(lambda a: values.dualise(0 * a, a))
skew_of, transpose_of, inverse_of = plain(Tensor.skew), plain(lambda T: T.transpose), plain(lambda T: T.inverse())
image = plain(lambda T, a: T @ a)


def component_of(index: int) -> Callable[..., Any]:
    return plain(lambda a: tuple(a)[index - 1])


def screw_quaternion(env: Env, alpha: Any, u: Vector) -> Quaternion:
    """Return ``cos(α/2) + u sin(α/2)``."""
    half = values.divide(alpha, 2)
    return Quaternion(env.field.cos(half), env.field.sin(half) * u)


def screw_tensor(env: Env, alpha: Any, u: Vector) -> Tensor:
    """Return the orthogonal dual tensor of an angle and an axis, computed from its quaternion."""
    return first_principles.tensor_by_sandwich(screw_quaternion(env, alpha, u))


# ---- claims in words ------------------------------------------------------------------------------------------


def proposition(name: str, latex: str) -> Symbol:
    """Return a symbol for a statement in words; a definition computes its truth value."""
    return Symbol(name, "proposition", rf"\text{{{latex}}}", name)


def _defined(env: Env, statement: Term) -> bool:
    try:
        env.value(statement)
    except ArithmeticError:
        return False
    return True


defined = define("defined", r"{0} \text{{ has a value}}", "{0}", RELATION, (SUM,), _defined, lazy=True,
                 traits=Trait.DELICATE)


def _unequal(env: Env, a: Term, multiple: Term, index: Term) -> bool:
    """Return whether `a` differs from `multiple` at every integer index; True for generic symbols."""
    if not env.field.ordered:
        return True
    first, second = (innermost(env.bound(index, k).value(multiple)) for k in (0, 1))
    turns = (innermost(env.value(a)) - first) / (second - first)
    return not env.field.same(turns, round(float(turns)))


unequal = define("unequal", r"{0} \neq {1}", "{0}≠{1}", RELATION, (SUM,), _unequal, lazy=True, traits=Trait.DELICATE)
"""Claim ``unequal(Re(alpha), 2 * k * pi, k)``: Re α ≠ 2kπ for every integer k."""


def _orthogonal(env: Env, a: Any) -> bool:
    if not isinstance(a, Tensor):
        return False
    return env.equal(a @ a.transpose, Tensor.identity()) and env.equal(a.det(), 1)


orthogonal = define("orthogonal", r"{0} \in \underline{{SO}}_3", "{0}", RELATION, (SUM,), _orthogonal)
unit_quaternion = define("unit quaternion", r"{0} \in \underline{{U}}", "{0}", RELATION, (SUM,),
                         lambda env, a: isinstance(a, Quaternion) and env.equal(a.norm2(), 1))
pose = define("pose", r"\begin{{pmatrix}} {0} & {1} \\ 0 & 1 \end{{pmatrix}}", "({0},{1},0,1)", ATOM, (LIST, LIST),
              lambda env, rotation, displacement: Pose(rotation, displacement))


def fixes_a_point(env: Env, R: Tensor) -> bool:
    """Return whether a displacement is a pure rotation: ρ is orthogonal to the axis, the kernel of ``Q − I``."""
    motion = pose_from_tensor(R)
    Q, rho = motion.rotation, motion.displacement
    projector = Q + Q.transpose + Tensor.identity() * (1 - Q.trace())  # 2 (1 − cos α) u ⊗ u
    along = rho if fixes_directions(env, R) else projector @ rho
    return env.equal(along, 0 * rho)


def fixes_directions(env: Env, R: Tensor) -> bool:
    """Return whether a displacement is a pure translation, the identity included."""
    return env.equal(pose_from_tensor(R).rotation, Tensor.identity())


def is_general(env: Env, R: Tensor) -> bool:
    """Return whether a displacement is neither a pure rotation nor a pure translation."""
    return not fixes_a_point(env, R) and not fixes_directions(env, R)


Frame = Callable[[int], Vector]
"""Vectors of a basis by number, 1 to 3."""


def multiplies_onto(env: Env, a: Any) -> bool:
    try:
        return bool(env.equal(a * (1 / a), 1))
    except ZeroDivisionError:
        return False


@condition
def magnitudes(env: Env, m: Any, a: Vector) -> bool:
    """Return whether m is a magnitude of a: ``m m = a · a``, and ``|m°| = |a°|`` if Re m = 0."""
    if not env.equal(m * m, a.dot(a)):
        return False
    return real_part(m) != 0 or env.equal(m.du * m.du, a.du.dot(a.du))


@condition
def coordinates(env: Env, alpha: Any, a: Vector) -> bool:
    """Return whether ``a = α u`` for some unit vector u."""
    if real_part(alpha) != 0:
        return env.equal(a.dot(a), alpha * alpha)
    return env.equal(a.re, 0 * a.re) and env.equal(a.du.dot(a.du), alpha.du**2)


@condition
def axes(env: Env, u: Vector, a: Vector) -> bool:
    """Return whether u is a unit vector and ``a = (a · u) u``."""
    return env.equal(u.dot(u), 1) and env.equal(a, a.dot(u) * u)


def one_axis(env: Env, a: Vector) -> Any:
    if not env.field.vanishes(innermost(a.dot(a))):
        return a / env.field.magnitude(a)
    length = env.field.magnitude(a.du)
    axis = a.du / length if length != 0 else Vector(1, 0, 0)
    return dualise(axis, 0 * axis)


@condition
def on_line(env: Env, r: Vector, a: Vector) -> bool:
    """Return whether r is on the line of a: ``r × u`` is the dual part of the unit vector of a."""
    axis = one_axis(env, a)
    return env.equal(r.cross(axis.re), axis.du)


# ---- dual tensors ---------------------------------------------------------------------------------------------------


def frame(env: Env, q: Quaternion) -> Callable[[int], Vector]:
    """Return a right-handed orthonormal basis of dual vectors: the standard basis displaced by q."""
    turned = first_principles.tensor_by_sandwich(q)
    return lambda k: turned @ Vector(*(int(k == j) for j in (1, 2, 3)))


def matrix(frame: Frame, image: Callable[[Vector], Vector]) -> Tensor:
    """Return the matrix ``e_j · T e_k`` of a linear map T."""
    return Tensor.from_entries(frame(j).dot(image(frame(k))) for j in (1, 2, 3) for k in (1, 2, 3))


def axial(env: Env, a: Tensor) -> Any:
    """Return the vector a with ``A b = a × b``: ``½ Σ e × A e`` over the standard basis."""
    axes = (Vector(*row) for row in Tensor.identity().rows)
    return sum((e.cross(a @ e) for e in axes), start=Vector(0, 0, 0)) * values.divide(1, 2)
