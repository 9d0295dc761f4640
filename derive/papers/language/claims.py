"""Operators for claims in words: has a value, avoids a value, is a rotation, is a unit quaternion.

A claim without a formula is a symbol (`proposition`) whose definition computes its truth.
"""

from __future__ import annotations

from contextlib import suppress
from typing import Any

from derive.algebra import Quaternion, Tensor
from derive.maps.pose import Pose

from ..numbers.fields import innermost
from . import values
from .evaluation import Env
from .notation import define
from .terms import ATOM, LIST, RELATION, SUM, Symbol, Term, Trait


def proposition(name: str, latex: str) -> Symbol:
    """Return a symbol for a statement in words; a definition computes its truth value."""
    return Symbol(name, "proposition", rf"\text{{{latex}}}", name)


def _defined(env: Env, statement: Term) -> bool:
    with suppress(ArithmeticError):
        env.value(statement)
        return True
    return False


defined = define("defined", r"{0} \text{{ has a value}}", "{0}", RELATION, (SUM,), _defined, lazy=True,
                 traits=Trait.DELICATE)


def _unequal(env: Env, a: Term, multiple: Term, index: Term) -> bool:
    """Return whether `a` differs from `multiple` at every integer index; True for generic symbols."""
    if not env.field.ordered:
        return True
    first, second = (innermost(env.bound(index, k).value(multiple)) for k in (0, 1))
    turns = (innermost(env.value(a)) - first) / (second - first)
    return not env.field.same(turns, round(float(turns)))


unequal = define("unequal", r"{0} \neq {1}", "{0}≠{1}", RELATION, (SUM,), _unequal,
                 lazy=True, traits=Trait.DELICATE)
"""Claim ``unequal(Re(alpha), 2 * k * pi, k)``: Re α ≠ 2kπ for every integer k."""


def _orthogonal(env: Env, a: Any) -> bool:
    """Return whether a value is a proper orthogonal tensor."""
    if not isinstance(a, Tensor):
        return False
    return values.equal(env.field, a @ a.transpose, Tensor.identity()) and values.equal(env.field, a.det(), 1)


orthogonal = define("orthogonal", r"{0} \in \underline{{SO}}_3", "{0}", RELATION, (SUM,), _orthogonal)
unit_quaternion = define("unit quaternion", r"{0} \in \underline{{U}}", "{0}", RELATION, (SUM,),
                         lambda env, a: isinstance(a, Quaternion) and values.equal(env.field, a.norm2(), 1))
pose = define("pose", r"\begin{{pmatrix}} {0} & {1} \\ 0 & 1 \end{{pmatrix}}", "({0},{1},0,1)", ATOM, (LIST, LIST),
              lambda env, rotation, displacement: Pose(rotation, displacement))


def fixes_a_point(env: Env, motion: Pose) -> bool:
    """Return whether a displacement is a pure rotation: ρ is orthogonal to the axis, the kernel of ``Q − I``."""
    Q, rho = motion.rotation, motion.displacement
    projector = Q + Q.transpose + Tensor.identity() * (1 - Q.trace())  # 2 (1 − cos α) u ⊗ u
    along = rho if fixes_directions(env, motion) else projector @ rho
    return values.equal(env.field, along, 0 * rho)


def fixes_directions(env: Env, motion: Pose) -> bool:
    """Return whether a displacement is a pure translation, the identity included."""
    return values.equal(env.field, motion.rotation, Tensor.identity())


def is_general(env: Env, motion: Pose) -> bool:
    """Return whether a displacement is neither a pure rotation nor a pure translation."""
    return not fixes_a_point(env, motion) and not fixes_directions(env, motion)
