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
    equation("lie-algebra", "the Lie algebra: skew-symmetric tensors", 149, equal(skew(a), -transpose(skew(a))),
             extract="α ~ _ = α ~ _ T", fixed_by="the words skew-symmetric before it"),
    equation("lie-bracket", "bracket of the Lie algebra", 149,
             equal(commutator(skew(a1), skew(a2)), skew(skew(a1) * a2)), extract="α ~ _ 1 , α ~ _ 2 = α ~ _ 1 α _ 2 ~"),
    equation("25", "exponential of a skew-symmetric tensor", 152,
             equal(exp(skew(a)), power_of_e(skew(a)), summation(k, 0, infinity, skew(a) ** k / factorial(k))),
             extract="e x p α ~ _ = e α ~ _ = k = 0 α ~ _ k k !",
             where=(*EULER, let(slope, orders.exponential_slope, alpha, u),
                    let(start, lambda env, u: motions.exponential(env, 0 * u), u)),
             because=both(equal(slope, skew(u) * exp(alpha * skew(u))), equal(start, I)),
             remark="exp is the closed form; it solves the differential equation of the series, from the same start."),
    equation("tensor-exponential-well-defined", "its values are orthogonal", 153, orthogonal(exp(skew(a))),
             where=EULER),
    equation("tensor-exponential-onto", "every orthogonal dual tensor is one", 153, reaches(exp_map, R), where=EXP),
    equation("26", "logarithm of an orthogonal dual tensor", 155, equal(exp(skew(a)), R),
             extract="e x p ( α _ ~ ) = R _", branches=3,
             where=(let(a, lambda env, alpha, u, k: (alpha + 2 * k * env.field.pi) * u, alpha, u, turns),
                    let(R, screw_tensor, alpha, u)),
             remark="One value for each number k of additional turns."),
    equation("euler-vector", "Euler dual vector", 157, equal(a, a_re + epsilon * a_du), extract="α _ = α + ε α 0",
             where=(*EULER, let(a_re, real_of, a), let(a_du, dual_of, a))),
    equation("euler-vector-logarithm", "it is a logarithm", 157, equal(exp(skew(a)), R),
             where=(*EULER, let(R, screw_tensor, alpha, u))),
    equation("general-screw", "(i) general screw displacement", 157, general,
             where=(*EULER, *EULER_KINDS), claimed=both(nonzero(Re(a)), nonzero(Du(a)), nonzero(dot(Re(a), Du(a)))),
             stated=(157, "if α 0 ,   α 0 0 and α · α 0 0"), condition=nonzero(Re(sin(norm(a) / 2))),
             remark="At Re |α| = 2kπ, k ≠ 0, the rotation is the identity and the displacement a pure translation."),
    equation("pure-translation", "(ii) pure translation", 157, translates,
             where=(let(alpha, nilpotent, shift_only), *EULER, *EULER_KINDS),
             claimed=both(zero(Re(a)), nonzero(Du(a))), stated=(157, "if α = 0 and α 0 0")),
    equation("pure-rotation", "(iii) pure rotation", 157, rotates,
             where=(let(alpha, same, turn_only), *EULER, *EULER_KINDS),
             claimed=both(nonzero(Re(a)), zero(dot(Re(a), Du(a)))), stated=(157, "α 0 and α · α 0 = 0")),
    equation("euler-vector-unique", "below a half turn it is unique", 157, equal(a, recovered),
             where=(*EULER, let(R, motions.exponential, a), let(recovered, orders.logarithm, R),
                    let(below, lambda env, alpha: not env.field.ordered
                        or abs(real_part(alpha)) < env.field.pi, alpha)), claimed=below,
             stated=(157, "if α < π")),
    equation("27", "Cayley transform of skew-symmetric tensors", 161, equal(cay(V), (I + V) * (I - V) ** (-1)),
             extract="c a y v ~ _ = I + v ~ _ I v ~ _ 1", where=CAY, remark="cay is the rotation of (1 + v)/|1 + v|."),
    equation("cayley-well-defined", "its values are orthogonal", 162,
             both(nonzero(Re(det(I - V))), orthogonal(cay(V))), where=CAY, because=equal(det(I - V), 1 + x)),
    equation("cayley-onto", "the Cayley transform is onto", 162, reaches(cay_map, R), where=CAY,
             said="is well defined and onto.", corrected=iff(nonzero(Re(1 + trace(R))), reaches(cay_map, R)),
             because=equal(1 + trace(cay(V)), 4 / (1 + x)),
             remark="Half turns are missed: there 1 + trace R has the real part 0, but never on a Cayley transform."),
    equation("cayley-domain", "where the argument is taken from", 164, orthogonal(V), extract="",
             said="For any v ~ _ S O _ 3", corrected=equal(transpose(V), -V), remark="Printed as SO(3) for so(3)."),
    equation("28", "determinant of the Cayley transform", 165,
             equal(det(cay(V)), det((I + V) * (I - V) ** (-1)), (1 + x) / (1 + x), 1),
             extract="d e t c a y v ~ _ = d e t I + v ~ _ I v ~ _ 1 = 1 + v _ 2 1 + v _ 2 = 1", where=CAY),
    equation("29", "orthogonality of the Cayley transform", 167,
             equal(cay(V) * transpose(cay(V)), (I + V) * (I - V) ** (-1) * (I - V) * (I + V) ** (-1), I),
             extract="c a y v ~ _ c a y v ~ _ T = I + v ~ _ I v ~ _ 1 I v ~ _ I + v ~ _ 1 = I", where=CAY),
    equation("30", "inverse of I − ṽ", 170,
             (Reading(equal((I - V) ** (-1), 1 / (1 + x) * (V**2 + V + I)), "I inside the bracket"),
              Reading(equal((I - V) ** (-1), 1 / (1 + x) * (V**2 + V) + I), "the bracket closes before I")),
             extract="I v ~ _ 1 = 1 1 + v _ 2 v ~ _ 2 + v ~ _ + I"),
    equation("31", "Cayley transform by powers of ṽ", 172,
             equal(cay(V), I + 2 * norm(v) / (1 + x) * (V / norm(v)) + bracket(1 - (1 - x) / (1 + x)) * (V**2 / x)),
             extract="c a y v ~ _ = I + 2 v _ 1 + v _ 2 v ~ _ v _ + ( 1 1 v _ 2 1 + v _ 2 ) v ~ _ 2 v _ 2", where=CAY,
             condition=nonzero(Re(v))),
    equation("32", "sine and cosine by the tangent of half the angle", 174,
             both(equal(sin(alpha), 2 * tan(alpha / 2) / (1 + tan2(alpha / 2))),
                  equal(cos(alpha), (1 - tan2(alpha / 2)) / (1 + tan2(alpha / 2)))),
             extract="s i n α _ = 2 t a n α _ 2 1 + t a n 2 α _ 2 ; c o s α _ = 1 t a n 2 α _ 2 1 + t a n 2 α _ 2",
             condition=nonzero(Re(cos(alpha / 2)))),
    equation("33", "Cayley transform in screw form", 176,
             equal(cay(V), I + sin(angle) * skew(axis) + (1 - cos(angle)) * skew(axis) ** 2),
             extract="c a y v ~ _ = I + s i n α _ u ~ _ + 1 c o s α _ u ~ _ 2", where=(*CAY, *AXIS)),
    equation("33-angle", "its angle", 177, equal(angle, 2 * arctan(norm(v))), extract="α _ = 2 a r c t a n v _",
             where=(*CAY, let(angle, orders.angle_of_cayley, v))),
)


def corollary(number: int, line: int, order: int, name: str, slope: Term) -> tuple[Entry, ...]:
    """Return the entries about Cayley transforms of an order that are rotations, translations, or neither.

    `slope` is s in ``(Q + Qᵀ + (1 − tr Q) I) ρ = 2 (1 − cos α) d u = s (v · v⁰) v``, v real.
    """
    where = (let(R, orders.at_order(order, orders.rotation), v), *TYPES, let(Q, motions.rotation_of, R),
             let(rho, motions.displacement_of, R), let(v_re, real_of, v), let(v_du, dual_of, v))
    return (
        equation(f"corollary-{number}-rotation", f"when the {name} is a pure rotation", line,
                 iff(rotates, zero(Du(norm(v)))), where=where,
                 because=equal((Q + transpose(Q) + (1 - trace(Q)) * I) * rho, slope * dot(v_re, v_du) * v_re),
                 remark="The supporting identity: 2 (1 − cos α) d u, d the translation along the axis."),
        equation(f"corollary-{number}-translation", "when it is a pure translation", line,
                 implies(zero(Re(norm(v))), translates), where=where),
        equation(f"corollary-{number}-general", "in all other cases it is neither", line,
                 implies(both(nonzero(Re(norm(v))), nonzero(Du(norm(v)))), general), where=where),
    )


size = 1 + norm(v_re) ** 2
RODRIGUES = (
    *corollary(1, 180, 1, "Cayley transform", Number(8) / size**2),
    equation("rodrigues-vector", "Rodrigues dual vector", 181, equal(cay(skew(b)), R), extract="c a y b ~ _ = R _",
             where=(*CAY, let(b, orders.rodrigues, alpha, u), let(R, screw_tensor, alpha, u)),
             claimed=unequal(Re(alpha), k * pi, k), stated=(181, "R e α _ k π")),
    equation("rodrigues-domain", "where the Rodrigues dual vector exists", 181,
             iff(remark(unequal(Re(alpha), k * pi, k), words(r"k \in \mathbb{Z}", "kZ")), defined(tan(alpha / 2) * u)),
             said="exists for the purpose of having c a y b ~ _ = R _ , R _ S O _ 3 , R _ = R _ α _ , u _ and "
                  "R e α _ k π ,   k Z .",
             corrected=iff(unequal(Re(alpha), (2 * k + 1) * pi, k), defined(tan(alpha / 2) * u)),
             remark="Only odd multiples of π are excluded; at even ones b is there, with real part 0."),
)

ENTRIES = (*ALGEBRA, *RODRIGUES)
