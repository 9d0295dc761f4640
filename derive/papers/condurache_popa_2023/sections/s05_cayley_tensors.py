"""Section 5, exponential and first-order Cayley transform of orthogonal dual tensors: lines 149-181."""

from ....algebra import real_part
from ..definitions import dual_algebra, motions, orders
from . import *
from .s03_rigid_motion import shift_only, turn_only

A = Symbol("A", "tensor", r"\tilde{\underline{\boldsymbol{\alpha}}}", "α~")
a = Symbol("euler", "dual vector", r"\underline{\boldsymbol{\alpha}}", "α")
a1, a2 = (Symbol(f"alpha{i}", "dual vector", rf"\underline{{\boldsymbol{{\alpha}}}}_{i}", f"α{i}") for i in (1, 2))
a_re, a_du = (Symbol(f"euler real{i}", "real vector", rf"\boldsymbol{{\alpha}}{i}", f"α{i}") for i in ("", "^0"))
b = vector("b")
k = Symbol("k", "index", "k", "k")
turns = Symbol("k", "branch", "k", "k")
cay = Symbol("cay", "function", r"\mathrm{cay}", "cay")
cay_map = Symbol("cay map", "map", r"\mathrm{cay}", "cay")
exp_map = Symbol("exp map", "map", r"\exp", "exp")
recovered = Symbol("recovered", "dual vector", r"\log \underline{\mathbf{R}}", "log R")
slope = Symbol("slope", "tensor",
               r"\tfrac{d}{d\alpha} \exp(\underline{\alpha}\, \tilde{\underline{\mathbf{u}}})", "slope")
start = Symbol("start", "tensor", r"\exp(0\, \tilde{\underline{\mathbf{u}}})", "start")
angle = Symbol("angle of v", "dual number", r"\underline{\alpha}", "α")
axis = Symbol("axis of v", "dual vector", r"\underline{\mathbf{u}}", "u")
v_re, v_du = (Symbol(f"v real{i}", "real vector", rf"\mathbf{{v}}{i}", f"v{i}") for i in ("", "^0"))
rotates = proposition("pure rotation", "pure rotation")
translates = proposition("pure translation", "pure translation")
general = proposition("general displacement", "general rigid body displacement")
below = proposition("below a half turn", r"$\left|\boldsymbol{\alpha}\right| < \pi$")
power_of_e = define("power of e", "e^{{{0}}}", "e{0}", POWER, (LIST,), exp.value, traits=Trait.TRANSCENDENTAL)
commutator = define("commutator", r"\left[{0}, {1}\right]", "{0},{1}", ATOM, (LIST, LIST),
                    lambda env, s, t: s @ t - t @ s)

EULER = (let(a, multiple, alpha, u),)
EXP = (let(exp_map, lambda env: values.Map(lambda a: motions.exponential(env, a),
                                           lambda R: [orders.logarithm(env, R)])),)
CAY = (let(cay, lambda env: lambda A: orders.rotation(env, 1, A.vect())), let(cay_map, orders.cayley_map))
TYPES = (let(rotates, fixes_a_point, R), let(translates, fixes_directions, R), let(general, is_general, R))
EULER_KINDS = (let(R, motions.exponential, a), *TYPES)
AXIS = (let(angle, lambda env, v: 2 * env.field.atan(env.field.magnitude(v)), v), let(axis, dual_algebra.one_axis, v))


ALGEBRA = (
    equation("lie-algebra", equal(skew(a), -transpose(skew(a)))),
    equation("lie-bracket", equal(commutator(skew(a1), skew(a2)), skew(skew(a1) * a2))),
    equation("25", equal(exp(skew(a)), power_of_e(skew(a)), summation(k, 0, infinity, skew(a) ** k / factorial(k))),
             where=(*EULER, let(slope, orders.exponential_slope, alpha, u),
                    let(start, lambda env, u: motions.exponential(env, 0 * u), u)),
             because=both(equal(slope, skew(u) * exp(alpha * skew(u))), equal(start, I))),
    equation("tensor-exponential-well-defined", orthogonal(exp(skew(a))), where=EULER),
    equation("tensor-exponential-onto", reaches(exp_map, R), where=EXP),
    equation("26", equal(exp(skew(a)), R), branches=3,
             where=(let(a, lambda env, alpha, u, k: (alpha + 2 * k * env.field.pi) * u, alpha, u, turns),
                    let(R, screw_tensor, alpha, u))),
    equation("euler-vector", equal(a, a_re + epsilon * a_du),
             where=(*EULER, let(a_re, real_of, a), let(a_du, dual_of, a))),
    equation("euler-vector-logarithm", equal(exp(skew(a)), R), where=(*EULER, let(R, screw_tensor, alpha, u))),
    equation("general-screw", general, where=(*EULER, *EULER_KINDS),
             claimed=both(nonzero(Re(a)), nonzero(Du(a)), nonzero(dot(Re(a), Du(a)))),
             condition=nonzero(Re(sin(norm(a) / 2)))),
    equation("pure-translation", translates, where=(let(alpha, nilpotent, shift_only), *EULER, *EULER_KINDS),
             claimed=both(zero(Re(a)), nonzero(Du(a)))),
    equation("pure-rotation", rotates, where=(let(alpha, same, turn_only), *EULER, *EULER_KINDS),
             claimed=both(nonzero(Re(a)), zero(dot(Re(a), Du(a))))),
    equation("euler-vector-unique", equal(a, recovered),
             where=(*EULER, let(R, motions.exponential, a), let(recovered, orders.logarithm, R),
                    let(below, lambda env, alpha: not env.field.ordered or abs(real_part(alpha)) < env.field.pi,
                        alpha)),
             claimed=below),
    equation("27", equal(cay(V), (I + V) * (I - V) ** (-1)), where=CAY),
    equation("cayley-well-defined", both(nonzero(Re(det(I - V))), orthogonal(cay(V))), where=CAY,
             because=equal(det(I - V), 1 + x)),
    equation("cayley-onto", reaches(cay_map, R), where=CAY,
             corrected=iff(nonzero(Re(1 + trace(R))), reaches(cay_map, R)),
             because=equal(1 + trace(cay(V)), 4 / (1 + x))),
    equation("cayley-domain", orthogonal(V), corrected=equal(transpose(V), -V)),
    equation("28", equal(det(cay(V)), det((I + V) * (I - V) ** (-1)), (1 + x) / (1 + x), 1), where=CAY),
    equation("29", equal(cay(V) * transpose(cay(V)), (I + V) * (I - V) ** (-1) * (I - V) * (I + V) ** (-1), I),
             where=CAY),
    equation("30",
             (Reading(equal((I - V) ** (-1), 1 / (1 + x) * (V**2 + V + I)), "I inside the bracket"),
              Reading(equal((I - V) ** (-1), 1 / (1 + x) * (V**2 + V) + I), "the bracket closes before I"))),
    equation("31",
             equal(cay(V), I + 2 * norm(v) / (1 + x) * (V / norm(v)) + bracket(1 - (1 - x) / (1 + x)) * (V**2 / x)),
             where=CAY, condition=nonzero(Re(v))),
    equation("32",
             both(equal(sin(alpha), 2 * tan(alpha / 2) / (1 + tan2(alpha / 2))),
                  equal(cos(alpha), (1 - tan2(alpha / 2)) / (1 + tan2(alpha / 2)))),
             condition=nonzero(Re(cos(alpha / 2)))),
    equation("33", equal(cay(V), I + sin(angle) * skew(axis) + (1 - cos(angle)) * skew(axis) ** 2),
             where=(*CAY, *AXIS)),
    equation("33-angle", equal(angle, 2 * arctan(norm(v))), where=(*CAY, let(angle, orders.angle_of_cayley, v))),
)


def corollary(number: int, order: int, slope: Term) -> tuple[Entry, ...]:
    """Return the entries about Cayley transforms of an order that are rotations, translations, or neither.

    `slope` is s in ``(Q + Qᵀ + (1 − tr Q) I) ρ = 2 (1 − cos α) d u = s (v · v⁰) v``, v real.
    """
    where = (let(R, orders.at_order(order, orders.rotation), v), *TYPES, let(Q, motions.rotation_of, R),
             let(rho, motions.displacement_of, R), let(v_re, real_of, v), let(v_du, dual_of, v))
    return (
        equation(f"corollary-{number}-rotation", iff(rotates, zero(Du(norm(v)))), where=where,
                 because=equal((Q + transpose(Q) + (1 - trace(Q)) * I) * rho, slope * dot(v_re, v_du) * v_re)),
        equation(f"corollary-{number}-translation", implies(zero(Re(norm(v))), translates), where=where),
        equation(f"corollary-{number}-general", implies(both(nonzero(Re(norm(v))), nonzero(Du(norm(v)))), general),
                 where=where),
    )


size = 1 + norm(v_re) ** 2
RODRIGUES = (
    *corollary(1, 1, Number(8) / size**2),
    equation("rodrigues-vector", equal(cay(skew(b)), R),
             where=(*CAY, let(b, orders.rodrigues, alpha, u), let(R, screw_tensor, alpha, u)),
             claimed=unequal(Re(alpha), k * pi, k)),
    equation("rodrigues-domain",
             iff(remark(unequal(Re(alpha), k * pi, k), words(r"k \in \mathbb{Z}", "kZ")), defined(tan(alpha / 2) * u)),
             corrected=iff(unequal(Re(alpha), (2 * k + 1) * pi, k), defined(tan(alpha / 2) * u))),
)

ENTRIES = (*ALGEBRA, *RODRIGUES)
