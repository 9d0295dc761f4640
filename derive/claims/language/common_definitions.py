"""Definitions of papers in Python, for `evaluation.let`, and operators for claims in words.

A claim without a formula is a symbol (`proposition`) whose definition computes its truth.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ...algebra import Dual, Quaternion, Tensor, Vector, first_principles
from ...algebra.pose import Pose, pose_from_tensor
from ..numbers.fields import innermost
from . import values
from .environment import Env
from .operator_table import define
from .printed import ATOM, LIST, RELATION, SUM, Symbol, Term, Trait


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
    """Return the definition of a vector component, counted from 1."""
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
