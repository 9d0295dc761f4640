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
             where=(*PARTS, let(size, dual_algebra.magnitudes, a_)),
             remark="Line 59 leaves the dual part open where Re a = 0; the form here makes |λ a| = |λ| |a|."),
    equation("5", "a dual vector is a dual number times a unit dual vector", 64, equal(a_, alpha * u_a),
             extract="a _ = α _ u _ a",
             where=(let(alpha, lambda env, a: env.field.magnitude(a), a_), let(u_a, dual_algebra.one_axis, a_))),
    equation("polar-magnitude", "the dual number of Proposition 1", 65, equal(pm(alpha), norm(a_)),
             extract="± α _ = a _", where=(let(alpha, dual_algebra.coordinates, a_),)),
    equation("6", "the unit dual vector of Proposition 1", 66,
             equal(pm(u_a),
                   cases((a / norm(a) + epsilon * (cross(a, cross(a0, a)) / norm(a) ** 3), nonzero(Re(a_))),
                         (remark(a0 / norm(a0) + epsilon * (cross(w, a0) / norm(a0)),
                                 words(r"\mathbf{v} \in V_3", "vV3")), zero(Re(a_))))),
             extract="± u _ a = a a + ε a × a 0 × a a 3     R e a _ 0 a 0 a 0 + ε v × a 0 a 0 , v V 3     R e a _ = 0",
             where=(*PARTS, let(u_a, dual_algebra.axes, a_)), condition=nonzero(a_),
             because=both(equal(dot(cross(w, a0), a0), 0), equal(epsilon * a0, epsilon * norm(a0) * (
                 a0 / norm(a0) + epsilon * (cross(w, a0) / norm(a0))))),
             remark="The supporting identity is the case Re a = 0. For a = 0 any unit vector serves."),
    equation("polar-unique", "both are unique up to sign", 67,
             both(equal(pm(lam), norm(a_)), equal(pm(u), a_ / norm(a_))),
             where=(let(a_, multiple, lam, u),), claimed=nonzero(Re(lam)), stated=(67, "for R e a _ 0"),
             remark="a is any product λ u of a dual number and a unit dual vector."),
    equation("line", "the line of a dual vector", 68, equal(r, cross(a, a0) / norm(a) ** 2 + lam_real * (a / norm(a))),
             extract="r = a × a 0 a 2 + λ a a", where=(*PARTS, let(r, dual_algebra.on_line, a_)),
             claimed=nonzero(Re(a_)), stated=(68, "with R e a _ 0")),
    equation("line-free", "the line where the real part is zero", 68,
             remark(equal(r, w + lam_real * (a0 / norm(a0))),
                    words(r"\mathbf{v} \in V_3,\ \lambda \in \mathbb{R}", "vV3λR")),
             extract="r = v + λ a 0 a 0 , v V 3 , λ R", where=(let(r, condition(
                 lambda env, r, a0, w: env.equal((r - w).cross(a0), 0 * a0)), a0, w),),
             condition=nonzero(a0), remark="a = 0 has no line."),
)
