"""Section 2.2, dual vectors: lines 56-68."""

from ....algebra import Tensor, Vector
from ..cp23_notation import unit as unit_vector
from ..definitions import dual_algebra
from . import *

a, a0 = real_vector("a"), Symbol("a0 real", "real vector", r"\mathbf{a}^0", "a0")
w = real_vector("v")
a_, b_, c_ = vector("a"), vector("b"), vector("c")
lam, mu = dual("lambda", r"\lambda", "λ"), dual("mu", r"\mu", "μ")
lam_real = Symbol("lambda", "real", r"\lambda", "λ")
alpha = Symbol("alpha_", "dual number", r"\underline{\alpha}", "α")
u_a = Symbol("u_a", "unit vector", r"\underline{\mathbf{u}}_a", "ua")
size = Symbol("|a|", "dual number", r"\left|\underline{\mathbf{a}}\right|", "a")
r = Symbol("r", "real vector", r"\mathbf{r}", "r")
u = unit_vector("u")
basis = tuple(Symbol(f"e{i}", "dual vector", rf"\mathbf{{e}}_{i}", f"e{i}") for i in (1, 2, 3))


PARTS = (let(a_, vector_from_parts, a, a0),)
BASIS = tuple(let(e, lambda env, row=row: Vector(*row)) for e, row in zip(basis, Tensor.identity().rows, strict=True))
e1, e2, e3 = basis

ENTRIES = (
    equation("3",
             both(remark(equal(a_, a + epsilon * a0), words(r"\mathbf{a}, \mathbf{a}^0 \in V_3", "aa0V3")),
                  equal(epsilon**2, 0), nonzero(epsilon)),
             where=PARTS),
    equation("triple-product", equal(triple(a_, b_, c_), dot(a_, cross(b_, c_)))),
    equation("vector-module",
             both(equal(lam * (a_ + b_), lam * a_ + lam * b_), equal((lam + mu) * a_, lam * a_ + mu * a_),
                  equal(lam * (mu * a_), lam * mu * a_),
                  equal(a_, bracket(dot(a_, e1)) * e1 + bracket(dot(a_, e2)) * e2 + bracket(dot(a_, e3)) * e3)),
             where=BASIS),
    equation("vector-magnitude", equal(dot(norm(a_), norm(a_)), dot(a_, a_))),
    equation("4",
             equal(size,
                   cases((norm(a) + epsilon * (dot(a0, a) / norm(a)), nonzero(Re(a_))),
                         (epsilon * norm(a0), zero(Re(a_))))),
             where=(*PARTS, let(size, dual_algebra.magnitudes, a_))),
    equation("5", equal(a_, alpha * u_a),
             where=(let(alpha, lambda env, a: env.field.magnitude(a), a_), let(u_a, dual_algebra.one_axis, a_))),
    equation("polar-magnitude", equal(pm(alpha), norm(a_)), where=(let(alpha, dual_algebra.coordinates, a_),)),
    equation("6",
             equal(pm(u_a),
                   cases((a / norm(a) + epsilon * (cross(a, cross(a0, a)) / norm(a) ** 3), nonzero(Re(a_))),
                         (remark(a0 / norm(a0) + epsilon * (cross(w, a0) / norm(a0)),
                                 words(r"\mathbf{v} \in V_3", "vV3")),
                          zero(Re(a_))))),
             where=(*PARTS, let(u_a, dual_algebra.axes, a_)), condition=nonzero(a_),
             because=both(equal(dot(cross(w, a0), a0), 0),
                          equal(epsilon * a0,
                                epsilon * norm(a0) * (a0 / norm(a0) + epsilon * (cross(w, a0) / norm(a0)))))),
    equation("polar-unique", both(equal(pm(lam), norm(a_)), equal(pm(u), a_ / norm(a_))),
             where=(let(a_, multiple, lam, u),), claimed=nonzero(Re(lam))),
    equation("line", equal(r, cross(a, a0) / norm(a) ** 2 + lam_real * (a / norm(a))),
             where=(*PARTS, let(r, dual_algebra.on_line, a_)), claimed=nonzero(Re(a_))),
    equation("line-free",
             remark(equal(r, w + lam_real * (a0 / norm(a0))),
                    words(r"\mathbf{v} \in V_3,\ \lambda \in \mathbb{R}", "vV3λR")),
             where=(let(r, condition(lambda env, r, a0, w: env.equal((r - w).cross(a0), 0 * a0)), a0, w),),
             condition=nonzero(a0)),
)
