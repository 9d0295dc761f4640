"""Section 4, dual quaternions: lines 120-145."""

from ....algebra import Quaternion
from ....maps.first_principles import tensor_by_sandwich
from ....maps.pose import pose_from_tensor
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
    equation("20", "dual quaternions", 121, equal(any_q, couple(s, w)), extract="q ^ _ = q _ , q _", where=PARTS),
    equation("quaternion-module", "dual quaternions are a module of rank 4", 122,
             both(equal(lam * (q1 + q2), lam * q1 + lam * q2), equal((lam + mu) * q1, lam * q1 + mu * q1),
                  equal(any_q, couple(s, 0 * w) + couple(0, w))), where=PARTS),
    equation("21", "product of dual quaternions", 124,
             equal(q1 * q2, couple(dot(s1, s2) - dot(w1, w2), s1 * w2 + s2 * w1 + cross(w1, w2))),
             extract="q ^ _ 1 q ^ _ 2 = q _ 1 · q _ 2 q _ 1 · q _ 2 , q _ 1 q _ 2 + q _ 2 q _ 1 + q _ 1 × q _ 2",
             where=INDEXED),
    equation("quaternion-algebra", "the product is associative and linear", 125,
             both(equal(q1 * q2 * q3, q1 * (q2 * q3)),
                  equal(q1 * (lam * q2 + mu * q3), lam * (q1 * q2) + mu * (q1 * q3)))),
    equation("non-commutative", "the product does not commute", 125, nonzero(i_ * j_ - j_ * i_),
             where=(let(i_, lambda env: Quaternion(0, motions.AXES[0])),
                    let(j_, lambda env: Quaternion(0, motions.AXES[1])))),
    equation("conjugate", "conjugate of a dual quaternion", 125, equal(conjugate(any_q), couple(s, -w)),
             extract="q ^ _ * = q _ , q _", where=PARTS, fixed_by="line 195, where the conjugate of 1 + v is 1 − v"),
    equation("quaternion-norm", "norm of a dual quaternion", 125,
             (Reading(equal(norm(any_q), root(any_q * conjugate(any_q))), "with a root"),
              Reading(equal(norm(any_q), any_q * conjugate(any_q)), "without a root")),
             extract="q ^ _ = q ^ _ q ^ _ *", remark="Only with the root is the norm of a vector its magnitude (4)."),
    equation("quaternion-submodules", "numbers and vectors as submodules", 125,
             both(equal(couple(lam, 0 * a) * couple(mu, 0 * a), couple(lam * mu, 0 * a)),
                  equal(couple(lam, 0 * a) + couple(mu, 0 * a), couple(lam + mu, 0 * a)),
                  equal(couple(0, a) + couple(0, b), couple(0, a + b)), equal(lam * couple(0, a), couple(0, lam * a)))),
    equation("scalar-plus-vector", "sum of scalar and vector part", 125, equal(any_q, s + w),
             extract="q ^ _ = q _ + q _", where=PARTS),
    equation("quaternion-parts", "real and dual part of a dual quaternion", 125, equal(any_q, q_re + epsilon * q_du),
             extract="q ^ _ = q ^ + ε q ^ 0", where=(let(q_re, real_of, any_q), let(q_du, dual_of, any_q))),
    equation("22", "unit dual quaternion by rotation and displacement", 129,
             equal(unit, (1 + epsilon * half * rho) * q_re),
             extract="q ^ _ = 1 + ε 1 2 ρ ^ q ^", where=HALVES, remark="ρ is the displacement of its tensor."),
    equation("22-product", "the unit norm, by real and dual part", 132,
             equal((q_re + epsilon * q_du) * (conjugate(q_re) + epsilon * conjugate(q_du)), 1),
             extract="( q ^ + ε q ^ 0 ) ( q ^ * + ε q ^ 0 * ) = 1", where=HALVES),
    equation("22-expanded", "the unit norm, expanded", 132,
             equal(q_re * conjugate(q_re) + epsilon * (q_du * conjugate(q_re) + q_re * conjugate(q_du)), 1),
             extract="q ^ q ^ * + ε q ^ 0 q ^ * + q ^ q ^ 0 * = 1", where=HALVES),
    equation("22-parts", "its real and dual part", 132,
             both(equal(q_re * conjugate(q_re), 1), zero(q_du * conjugate(q_re) + q_re * conjugate(q_du))),
             extract="q ^ q ^ * = 1 q ^ 0 q ^ * + q ^ q ^ 0 * = 0", where=HALVES),
    equation("22-vector", "q⁰ q* is a vector", 132, zero(scalar(q_du * conjugate(q_re))), where=HALVES),
    equation("22-displacement", "the displacement", 132, equal(rho, 2 * q_du * conjugate(q_re)),
             extract="ρ ^ = 2 q ^ 0 q ^ *", where=HALVES),
    equation("23", "unit dual quaternion by angle and axis", 134,
             equal(unit, cos(alpha / 2) + u * sin(alpha / 2), exp(alpha / 2 * u)),
             extract="q ^ _ = c o s α _ 2 + u _ s i n α _ 2 = e x p α _ 2 u _",
             where=(let(unit, motions.lift, alpha, u),)),
    equation("exponential-unit", "the exponential is a unit quaternion", 136, unit_quaternion(exp(half * euler)),
             where=(let(euler, multiple, alpha, u),)),
    equation("exponential-onto", "the exponential is onto", 136, reaches(exp_map, unit),
             where=(let(exp_map, motions.quaternion_exponential_map),)),
    equation("24", "tensor of a unit dual quaternion", 141, equal(Delta(s + w), I + 2 * s * skew(w) + 2 * skew(w) ** 2),
             extract="q _ + q _ = I _ + 2 q _ q ~ _ + 2 q ~ _ 2", where=(*ACTION, *UNIT_PARTS),
             remark="Δ(q) is the tensor of v ↦ q v q*."),
    equation("24-exponential", "the tensor is an exponential", 143, equal(Delta(unit), exp(alpha * skew(u))),
             extract="q ^ _ = e x p α _   u _ ~", where=(*ACTION, let(unit, screw_quaternion, alpha, u))),
    equation("homomorphism-well-defined", "the tensor is orthogonal", 143, orthogonal(Delta(unit)), where=ACTION),
    equation("homomorphism", "products go to products", 143,
             equal(Delta(units[1] * units[0]), Delta(units[1]) * Delta(units[0])),
             extract="q ^ _ 2 q ^ _ 1 = q ^ _ 2 q ^ _ 1", where=ACTION),
    equation("homomorphism-onto", "every orthogonal dual tensor is reached", 144, reaches(Delta_map, R), where=ACTION),
    equation("not-injective", "q and −q have the same tensor", 145, equal(Delta(unit), Delta(-unit)), where=ACTION),
    equation("double-cover", "exactly two quaternions have the same tensor", 145,
             both(branches(Delta_map, R, 2),
                  iff(equal(Delta(units[0]), Delta(units[1])), equal(units[0], pm(units[1])))),
             where=(*ACTION, *UNIT_PARTS),
             because=both(equal(1 + trace(Delta(unit)), 4 * s**2), equal(vect(Delta(unit)), 2 * s * w),
                          equal(Delta(unit) + transpose(Delta(unit)) + (1 - trace(Delta(unit))) * I, 4 * dyad(w, w))),
             remark="The supporting identity: the tensor determines all products of two components of q."),
)
