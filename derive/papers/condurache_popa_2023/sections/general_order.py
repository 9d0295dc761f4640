"""Symbols of section 7 for a general order n."""

from typing import Any

from ..definitions import cayley_maps, orders
from . import *

p = Symbol("p_n", "function", "p_n", "pn")
q = Symbol("q_n", "function", "q_n", "qn")
k = Symbol("k", "branch", "k", "k")
X = Symbol("X", "argument", "X", "X")
w = vector("w")
a_value = Symbol("a_", "scale", r"\underline{a}", "a")
a = Symbol("a", "function", r"\underline{a}", "a")
q_of = Symbol("q(v)", "function", r"\underline{\hat{\mathbf{q}}}", "q^")
R_of = Symbol("R(v)", "function", r"\underline{\mathbf{R}}", "R")

POLYNOMIALS = (let(p, orders.p, n), let(q, orders.q, n))
CAYLEY = (*POLYNOMIALS, let(q_hat, orders.cayley, n, v), let(R, orders.rotation, n, v))
"""Definitions in terms of v by (46)."""

SCREW = (*POLYNOMIALS, let(q_hat, screw_quaternion, alpha, u), let(R, screw_tensor, alpha, u))
"""Definitions in terms of the displacement with angle α and axis u."""

SCREW_OF_V = (
    *POLYNOMIALS, let(q_of, cayley_maps.function_of(screw_quaternion), alpha, u),
    let(R_of, cayley_maps.function_of(screw_tensor), alpha, u),
)
"""Definitions in terms of the displacement, printed as functions of v."""


def finite(angle: Term) -> Term:
    return nonzero(Re(cos(angle)))


def rotation_by(length: Term, power: Any, skew_of_w: Term) -> Any:
    """Return the tensor of (57) at a vector w, from its magnitude, ``(1 + |w|²)ⁿ`` and its skew-symmetric tensor."""
    return I + 2 * p(length) * q(length) / power * skew_of_w + 2 * (q**2)(length) / power * skew_of_w**2
