"""Section 4, dual quaternions: lines 120-145."""

from ....algebra import Quaternion
from ....algebra.first_principles import tensor_by_sandwich
from ....algebra.pose import pose_from_tensor
from ..definitions import motions
from . import *
from .s02_2_dual_vectors import lam, mu

any_q = Symbol("q", "quaternion", r"\underline{\hat{\mathbf{q}}}", "q^")
some = tuple(Symbol(f"q{i}", "quaternion", rf"\underline{{\hat{{\mathbf{{q}}}}}}_{i}", f"q^{i}") for i in (1, 2, 3))
q1, q2, q3 = some
s, s1, s2 = (Symbol(f"scalar{i}", "dual number", rf"\underline{{q}}{i and f'_{i}'}", f"q{i}") for i in ("", "1", "2"))
w, w1, w2 = (
    Symbol(f"vector{i}", "dual vector", rf"\underline{{\mathbf{{q}}}}{i and f'_{i}'}", f"q{i}") for i in ("", "1", "2")
)
q_re, q_du = (Symbol(name, "real quaternion", latex, text) for name, latex, text in (
    ("q real", r"\hat{\mathbf{q}}", "q^"), ("q0", r"\hat{\mathbf{q}}^0", "q^0")))
unit = quaternion("q")
units = tuple(
    Symbol(f"unit{i}", "unit quaternion", rf"\underline{{\hat{{\mathbf{{q}}}}}}_{i}", f"q^{i}") for i in (1, 2)
)
rho = Symbol("rho", "real vector", r"\hat{\boldsymbol{\rho}}", "ρ^")
a, b = vector("a"), vector("b")
euler = Symbol("euler", "dual vector", r"\underline{\boldsymbol{\alpha}}", "α")
Delta = Symbol("Delta", "function", r"\Delta", " ")
Delta_map = Symbol("Delta map", "map", r"\Delta", " ")
exp_map = Symbol("exp map", "map", r"\exp \tfrac{1}{2}", " ")
i_, j_ = (Symbol(f"unit {name}", "quaternion", rf"\hat{{\mathbf{{{name}}}}}", name) for name in "ij")
scalar = define("scalar part", r"\operatorname{{scal}} {0}", "{0}", PRODUCT, (PRODUCT,), scalar_part)

PARTS = (let(s, scalar_part, any_q), let(w, vector_part, any_q))
INDEXED = (let(s1, scalar_part, q1), let(w1, vector_part, q1), let(s2, scalar_part, q2), let(w2, vector_part, q2))
HALVES = (let(q_re, real_of, unit), let(q_du, dual_of, unit),
          let(rho, plain(lambda q: pose_from_tensor(tensor_by_sandwich(q)).displacement), unit))
ACTION = (let(Delta, lambda env: tensor_by_sandwich), let(Delta_map, motions.covering))
UNIT_PARTS = (let(s, scalar_part, unit), let(w, vector_part, unit))

ENTRIES = (
    equation("20", equal(any_q, couple(s, w)), where=PARTS),
    equation("quaternion-module",
             both(equal(lam * (q1 + q2), lam * q1 + lam * q2), equal((lam + mu) * q1, lam * q1 + mu * q1),
                  equal(any_q, couple(s, 0 * w) + couple(0, w))),
             where=PARTS),
    equation("21", equal(q1 * q2, couple(dot(s1, s2) - dot(w1, w2), s1 * w2 + s2 * w1 + cross(w1, w2))), where=INDEXED),
    equation("quaternion-algebra",
             both(equal(q1 * q2 * q3, q1 * (q2 * q3)),
                  equal(q1 * (lam * q2 + mu * q3), lam * (q1 * q2) + mu * (q1 * q3)))),
    equation("non-commutative", nonzero(i_ * j_ - j_ * i_),
             where=(let(i_, lambda env: Quaternion(0, motions.AXES[0])),
                    let(j_, lambda env: Quaternion(0, motions.AXES[1])))),
    equation("conjugate", equal(conjugate(any_q), couple(s, -w)), where=PARTS),
    equation("quaternion-norm",
             (Reading(equal(norm(any_q), root(any_q * conjugate(any_q))), "with a root"),
              Reading(equal(norm(any_q), any_q * conjugate(any_q)), "without a root"))),
    equation("quaternion-submodules",
             both(equal(couple(lam, 0 * a) * couple(mu, 0 * a), couple(lam * mu, 0 * a)),
                  equal(couple(lam, 0 * a) + couple(mu, 0 * a), couple(lam + mu, 0 * a)),
                  equal(couple(0, a) + couple(0, b), couple(0, a + b)), equal(lam * couple(0, a), couple(0, lam * a)))),
    equation("scalar-plus-vector", equal(any_q, s + w), where=PARTS),
    equation("quaternion-parts", equal(any_q, q_re + epsilon * q_du),
             where=(let(q_re, real_of, any_q), let(q_du, dual_of, any_q))),
    equation("22", equal(unit, (1 + epsilon * half * rho) * q_re), where=HALVES),
    equation("22-product", equal((q_re + epsilon * q_du) * (conjugate(q_re) + epsilon * conjugate(q_du)), 1),
             where=HALVES),
    equation("22-expanded",
             equal(q_re * conjugate(q_re) + epsilon * (q_du * conjugate(q_re) + q_re * conjugate(q_du)), 1),
             where=HALVES),
    equation("22-parts", both(equal(q_re * conjugate(q_re), 1), zero(q_du * conjugate(q_re) + q_re * conjugate(q_du))),
             where=HALVES),
    equation("22-vector", zero(scalar(q_du * conjugate(q_re))), where=HALVES),
    equation("22-displacement", equal(rho, 2 * q_du * conjugate(q_re)), where=HALVES),
    equation("23", equal(unit, cos(alpha / 2) + u * sin(alpha / 2), exp(alpha / 2 * u)),
             where=(let(unit, motions.lift, alpha, u),)),
    equation("exponential-unit", unit_quaternion(exp(half * euler)), where=(let(euler, multiple, alpha, u),)),
    equation("exponential-onto", reaches(exp_map, unit), where=(let(exp_map, motions.quaternion_exponential_map),)),
    equation("24", equal(Delta(s + w), I + 2 * s * skew(w) + 2 * skew(w) ** 2), where=(*ACTION, *UNIT_PARTS)),
    equation("24-exponential", equal(Delta(unit), exp(alpha * skew(u))),
             where=(*ACTION, let(unit, screw_quaternion, alpha, u))),
    equation("homomorphism-well-defined", orthogonal(Delta(unit)), where=ACTION),
    equation("homomorphism", equal(Delta(units[1] * units[0]), Delta(units[1]) * Delta(units[0])), where=ACTION),
    equation("homomorphism-onto", reaches(Delta_map, R), where=ACTION),
    equation("not-injective", equal(Delta(unit), Delta(-unit)), where=ACTION),
    equation("double-cover",
             both(branches(Delta_map, R, 2),
                  iff(equal(Delta(units[0]), Delta(units[1])), equal(units[0], pm(units[1])))),
             where=(*ACTION, *UNIT_PARTS),
             because=both(equal(1 + trace(Delta(unit)), 4 * s**2), equal(vect(Delta(unit)), 2 * s * w),
                          equal(Delta(unit) + transpose(Delta(unit)) + (1 - trace(Delta(unit))) * I, 4 * dyad(w, w)))),
)
