"""Section 3, rigid motion through orthogonal dual tensors: lines 91-116."""

from functools import partial

from ....algebra import real_part
from ....algebra.pose import Pose, foot, pose_from_tensor
from ..definitions import motions
from . import *

R1, R2 = (Symbol(f"R{i}", "orthogonal tensor", rf"\underline{{\mathbf{{R}}}}_{i}", f"R{i}") for i in (1, 2))
R_of = Symbol("R(α, u)", "function", r"\underline{\mathbf{R}}", "R")
g, g1, g2 = (Symbol(name, "pose", latex, name) for name, latex in (("g", "g"), ("g1", "g_1"), ("g2", "g_2")))
any_turn = Symbol("Q any", "rotation", r"\mathbf{Q}", "Q")
any_shift = Symbol("rho any", "real vector", r"\boldsymbol{\rho}", "ρ")
turns = tuple(Symbol(f"Q{i}", "rotation", rf"\mathbf{{Q}}_{i}", f"Q{i}") for i in (1, 2))
shifts = tuple(Symbol(f"rho{i}", "real vector", rf"\boldsymbol{{\rho}}_{i}", f"ρ{i}") for i in (1, 2))
phi, phi_inv = Symbol("phi", "function", r"\phi", "ϕ"), Symbol("phi⁻¹", "function", r"\phi^{-1}", "ϕ1")
screw_map = Symbol("screw", "map", r"(\underline{\alpha}, \underline{\mathbf{u}}) \mapsto \underline{\mathbf{R}}", "")
angle = Symbol("alpha real", "real angle", r"\alpha", "α")
shift = Symbol("d of α", "real", "d", "d")
axis = Symbol("u real", "real vector", r"\mathbf{u}", "u")
moment = Symbol("u0", "real vector", r"\mathbf{u}^0", "u0")
turn_only = Symbol("alpha only", "real angle", r"\alpha", "α")
shift_only = Symbol("d", "real", "d", "d")
point = Symbol("r", "real vector", r"\mathbf{r}", "r")
lam = Symbol("lambda", "real", r"\lambda", "λ")
v = Symbol("v real", "real vector", r"\mathbf{v}", "v")
sign = Symbol("sign", "sign", r"\pm", "±")
principal = proposition("principal angle", r"$-\pi < \alpha \leq \pi$")
of_two = define("of two", r"{0}\left({1}, {2}\right)", "{0} {1},{2}", ATOM, (ATOM, LIST, LIST),
                lambda env, f, a, b: f(a, b))
atan2 = define("atan2", r"\operatorname{{atan2}}\left({0};\, {1}\right)", "atan2 {0};{1}", PRODUCT, (LIST, LIST),
               lambda env, y, x: env.field.atan2(y, x), traits=Trait.TRANSCENDENTAL)
when = define("when", r"\text{{when }} {0}", "when {0}", LIST, (LIST,), lambda env, a: a)
when_between = define(
    "when between", r"\text{{when }} {0} \in \left({1}, {2}\right)", "when {0} {1},{2}", LIST, (LIST,),
    lambda env, a, low, high: not env.field.ordered
    or (low < a < high and not env.field.same(a, low) and not env.field.same(a, high)),
)

INVARIANTS = (let(Q, motions.rotation_of, R), let(rho, motions.displacement_of, R))
GIVEN = tuple(let(symbol, plain(Pose), Q_i, rho_i) for symbol, Q_i, rho_i in zip((g1, g2), turns, shifts, strict=True))
PHI = (let(phi, lambda env: motions.moved_lines), let(phi_inv, lambda env: pose_from_tensor))
SCREW = (
    let(R, screw_tensor, alpha, u), *INVARIANTS, let(angle, real_of, alpha), let(shift, dual_of, alpha),
    let(axis, real_of, u), let(moment, dual_of, u), let(point, plain(foot), u),
    let(R_of, lambda env: lambda alpha, u: screw_tensor(env, alpha, u)),
)
versine = 1 - cos(angle)
size = root((1 + trace(Q)) * (3 - trace(Q)))

ENTRIES = (
    equation("13", both(equal(R * transpose(R), I), equal(det(R), 1))),
    equation("orthogonal-group",
             both(orthogonal(I), orthogonal(R1 * R2), orthogonal(transpose(R1)), equal(R1 * transpose(R1), I))),
    equation("14", equal(R, (I + epsilon * skew(rho)) * Q), where=INVARIANTS),
    equation("structure-parts", both(equal(Q * transpose(Q), I), equal(det(Q), 1), equal(Du(rho), 0)),
             where=INVARIANTS),
    equation("structure-unique", equal(phi_inv(phi(g1)), g1), where=(*PHI, *GIVEN)),
    equation("15", equal(phi(g), (I + epsilon * skew(any_shift)) * any_turn),
             where=(*PHI, let(g, plain(Pose), any_turn, any_shift))),
    equation("isomorphism", equal(phi(g1 * g2), phi(g1) * phi(g2)), where=(*PHI, *GIVEN)),
    equation("isomorphism-onto", both(equal(phi(phi_inv(R)), R), equal(phi_inv(phi(g1)), g1)), where=(*PHI, *GIVEN)),
    equation("16", equal(phi_inv(R), pose(Q, rho)),
             where=(let(phi_inv, lambda env: partial(motions.pose_of, env)), *INVARIANTS)),
    equation("structural-invariants", both(equal(Q, Re(R)), equal(rho, vect(dot(Du(R), transpose(Q))))),
             where=(let(Q, same, any_turn), let(rho, same, any_shift),
                    let(R, plain(lambda Q, rho: motions.moved_lines(Pose(Q, rho))), any_turn, any_shift))),
    equation("17",
             equal(of_two(R_of, alpha, u), I + sin(alpha) * skew(u) + (1 - cos(alpha)) * skew(u) ** 2,
                   exp(alpha * skew(u))),
             where=SCREW),
    equation("representation", reaches(screw_map, R),
             where=(let(screw_map, lambda env: values.Map(
                 lambda screw: screw_tensor(env, *screw), lambda R: [motions.invariants(env, R)])),)),
    equation("18", equal(angle, atan2(sign * half * size, (trace(Q) - 1) / 2)),
             where=(*INVARIANTS, let(angle, motions.angles_of, R, sign))),
    equation("18-axis",
             equal(axis, sign * cases(
                 (vect(1 / size * (Q - transpose(Q))), when_between(trace(Q), -1, 3)),
                 (remark((Q * v + v) / norm(Q * v + v), words(r"\mathbf{v} \in V_3", "vV3")),
                  when(remark(equal(trace(Q), -1), words(r"\text{Q is symmetric}", "Qissymmetric")))),
                 (rho / norm(rho), when(remark(equal(trace(Q), 3), words("Q = I", "Q=I")))))),
             where=(*INVARIANTS, let(axis, motions.axes_of, R, sign)),
             condition=both(implies(zero(trace(Q) + 1), nonzero(Q * v + v)),
                            implies(zero(trace(Q) - 3), nonzero(rho)))),
    equation("18-translation", equal(shift, dot(rho, axis)), where=SCREW),
    equation("18-moment",
             equal(moment,
                   cases((half * cross(rho, axis) + half * cot(angle / 2) * cross(axis, cross(rho, axis)),
                          nonzero(angle)),
                         (half * cross(rho, axis), zero(angle)))),
             where=(*SCREW[:-3], let(moment, motions.moments_of, alpha, u),
                    let(principal, lambda env,
                        alpha: not env.field.ordered or -env.field.pi < real_part(alpha) <= env.field.pi, alpha)),
             claimed=principal),
    equation("natural-rotation", equal(Q * point + rho, point), where=(let(R, screw_tensor, turn_only, u), *SCREW[1:])),
    equation("natural-translation", equal(Q, I), where=(let(alpha, nilpotent, shift_only), *SCREW)),
    equation("mozzi-chasles", equal(Q * (point + lam * axis) + rho, point + lam * axis + shift * axis), where=SCREW),
    equation("19",
             both(equal(Q, I + sin(angle) * skew(axis) + versine * skew(axis) ** 2),
                  equal(rho, shift * axis + sin(angle) * moment + versine * cross(axis, moment))),
             where=SCREW),
)
