"""Letters of section 7 that belong to a general order n."""

from __future__ import annotations

from ..evaluation import let
from ..notation import Re, cos, dyad, identity, nonzero, norm, skew
from ..terms import Letter, Term
from . import cayley_maps, meanings
from .alphabet import alpha, n, tensor, u, v, vector
from .motions import screw_tensor

I, V, VV, x = identity, skew(v), dyad(v, v), norm(v) ** 2

p = Letter("p_n", "function", "p_n", "pn")
q = Letter("q_n", "function", "q_n", "qn")
q_hat = Letter("q", "quaternion", r"\underline{\hat{\mathbf{q}}}", "q^")
R = tensor("R", "orthogonal tensor")
k = Letter("k", "branch", "k", "k")
X = Letter("X", "argument", "X", "X")
w = vector("w")
a_value = Letter("a_", "scale", r"\underline{a}", "a")
a = Letter("a", "function", r"\underline{a}", "a")
q_of = Letter("q(v)", "function", r"\underline{\hat{\mathbf{q}}}", "q^")
R_of = Letter("R(v)", "function", r"\underline{\mathbf{R}}", "R")

POLYNOMIALS = (let(p, meanings.p, n), let(q, meanings.q, n))
CAYLEY = (*POLYNOMIALS, let(q_hat, meanings.cayley, n, v), let(R, meanings.rotation, n, v))
"""Checked against the definition (46)."""

SCREW = (*POLYNOMIALS, let(q_hat, meanings.screw_quaternion, alpha, u), let(R, screw_tensor, alpha, u))
"""Checked against the displacement with the natural invariants α and u."""

SCREW_OF_V = (
    *POLYNOMIALS,
    let(q_of, cayley_maps.function_of(meanings.screw_quaternion), alpha, u),
    let(R_of, cayley_maps.function_of(screw_tensor), alpha, u),
)
"""The same, written as functions of v."""


def finite(angle: Term) -> Term:
    """tan has a value."""
    return nonzero(Re(cos(angle)))
