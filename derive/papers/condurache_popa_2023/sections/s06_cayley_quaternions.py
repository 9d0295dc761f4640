"""Section 6, Cayley transforms for unit dual quaternions: lines 184-226."""

from ..definitions import low_orders, motions, orders
from . import *
from .s04_dual_quaternions import scalar

x = norm(v) ** 2
q = quaternion("q")
q0 = Symbol("q scalar", "dual number", r"\underline{q}", "q")
cay = Symbol("cay", "function", r"\mathrm{cay}", "cay")
cay_half = Symbol("cay½", "function", r"\mathrm{cay}_{1/2}", "cay12")
cay_map = Symbol("cay map", "map", r"\mathrm{cay}", "cay")
half_map = Symbol("cay½ map", "map", r"\mathrm{cay}_{1/2}", "cay12")
sigma = Symbol("sigma", "dual vector", r"\underline{\boldsymbol{\sigma}}", "σ")
sigma1, sigma2 = (
    Symbol(f"sigma{i}", "dual vector", rf"\underline{{\boldsymbol{{\sigma}}}}_{i}", f"σ{i}") for i in (1, 2)
)
b = vector("b")
b1, b2 = (Symbol(f"b{i}", "dual vector", rf"\underline{{\mathbf{{b}}}}_{i}", f"b{i}") for i in (1, 2))
k = Symbol("k", "index", "k", "k")
Q = Symbol("Q", "real tensor", r"\mathbf{Q}", "Q")
rho = Symbol("rho", "real vector", r"\boldsymbol{\rho}", "ρ")
v_re, v_du = (Symbol(f"v real{i}", "real vector", rf"\mathbf{{v}}{i}", f"v{i}") for i in ("", "^0"))
R = Symbol("R", "orthogonal tensor", r"\underline{\mathbf{R}}", "R")
rotates = proposition("pure rotation", "pure rotation")
translates = proposition("pure translation", "pure translation")
general = proposition("general displacement", "general rigid body displacement")

CAY = (let(cay, lambda env: lambda v: orders.cayley(env, 2, v)), let(cay_map, low_orders.map_of_order(2)))
HALF = (let(cay_half, lambda env: lambda v: orders.cayley(env, 1, v)), let(half_map, low_orders.map_of_order(1)))
SCALAR = (let(q0, scalar_part, q),)
SCREW = (let(q, screw_quaternion, alpha, u),)
COMPOSED = (let(q, low_orders.composed(2), sigma2, sigma1), let(sigma, low_orders.preimage(2), q))
no_full_turn = unequal(Re(alpha), 2 * k * pi, k)
no_half_turn = remark(unequal(Re(alpha), k * pi, k), words(r"k \in \mathbb{Z}", "kZ"))
projector = Q + transpose(Q) + (1 - trace(Q)) * identity


def corollary(number: int, line: int, order: int, slope: Term) -> tuple[Equation, ...]:
    """Return entries on when the Cayley transform of an order is a rotation, a translation, or neither.

    `slope` is the vector ``(Q + Qᵀ + (1 − tr Q) I) ρ = 2 (1 − cos α) d u`` divided by ``v · v⁰ v``.
    """
    types = low_orders.displacement_types(rotates, translates, general)
    where = (let(R, orders.at_order(order, orders.rotation), v), *(let(p, f, R) for p, f in types),
             let(Q, motions.rotation_of, R), let(rho, motions.displacement_of, R), let(v_re, real_of, v),
             let(v_du, dual_of, v))
    return (
        equation(f"corollary-{number}-rotation", "when the transform is a pure rotation", line,
                 iff(rotates, zero(Du(norm(v)))), where=where, also=low_orders.real_magnitude(v),
                 because=equal(projector * rho, slope * dot(v_re, v_du) * v_re),
                 remark="The supporting identity: 2 (1 − cos α) d u, d the translation along the axis."),
        equation(f"corollary-{number}-translation", "when it is a pure translation", line,
                 implies(zero(Re(norm(v))), translates), where=where, also=low_orders.unit_magnitude(v)),
        equation(f"corollary-{number}-general", "in all other cases it is neither", line,
                 implies(both(nonzero(Re(norm(v))), nonzero(Du(norm(v)))), general), where=where),
    )


size = 1 + norm(v_re) ** 2
WHOLE = (
    equation("34", "Cayley transform of dual vectors", 188, equal(cay(v), (1 + v) * (1 - v) ** (-1)),
             extract="c a y v _ = 1 + v _ 1 v _ 1", where=CAY,
             remark="cay is the unit quaternion that turns by four times the arc tangent of |v|."),
    equation("cayley-quaternion-well-defined", "its values are unit quaternions", 189,
             both(nonzero(Re(norm(1 - v))), unit_quaternion(cay(v))), where=CAY),
    equation("cayley-quaternion-onto", "the Cayley transform is onto", 189, reaches(cay_map, q),
             where=(*CAY, *SCALAR), said="is well defined and onto.",
             corrected=iff(nonzero(Re(1 + q0)), reaches(cay_map, q)),
             because=equal(1 + scalar(cay(v)), 2 / (1 + x)),
             remark="Quaternions with Re q = −1 are missed: 1 + q never has the real part 0 on a Cayley transform."),
    equation("35", "Cayley transform as a quotient", 192, equal(cay(v), (1 + v) / (1 - v), (1 + v) ** 2 / (1 + x)),
             extract="c a y v _ = 1 + v _ 1 v _ = 1 + v _ 2 1 + v _ 2", where=CAY,
             fixed_by="(53) at n = 2, with the powers of v summed"),
    equation("36", "norm of the Cayley transform", 194,
             equal(norm(cay(v)), norm(1 + v) / norm(1 - v), root(1 + x) / root(1 + x), 1),
             extract="c a y v _ = 1 + v _ 1 v _ = 1 + v _ 2 1 + v _ 2 = 1", where=CAY),
    equation("norm-of-1-plus-v", "norm of 1 + v", 195,
             (Reading(equal(norm(1 + v), root((1 + v) * (1 - v)), root(1 - v**2), root(1 + x)), "with roots"),
              Reading(equal(norm(1 + v), (1 + v) * (1 - v), 1 - v**2, 1 + x), "without roots")),
             extract="1 + v _ = 1 + v _ 1 v _ = 1 v _ 2 = 1 + v _ 2"),
    equation("cayley-quaternion-inverse", "inverse of the Cayley transform", 195, equal(v, (q - 1) / (q + 1)),
             extract="v _ = q ^ _ 1 q _ ^ + 1", where=(let(v, low_orders.preimage(2), q),),
             condition=nonzero(Re(q + 1))),
    *corollary(2, 197, 2, Number(64) / size**3),
    equation("37", "unit dual quaternion by angle and axis", 199, equal(q, cos(alpha / 2) + u * sin(alpha / 2)),
             extract="q ^ _ = c o s α _ 2 + u _ s i n α _ 2", where=(let(q, motions.lift, alpha, u),)),
    equation("38", "modified Rodrigues dual vector", 201, equal(sigma, tan(alpha / 4) * u),
             extract="σ _ = t a n α _ 4 u _", where=(*SCREW, let(sigma, low_orders.preimage(2), q)),
             claimed=no_full_turn, stated=(200, "for R e α _ 2 k π")),
    equation("38-domain", "where the modified Rodrigues dual vector exists", 200,
             iff(no_full_turn, defined(tan(alpha / 4) * u)),
             said="The results for R e α _ 2 k π",
             corrected=iff(unequal(Re(alpha), (4 * k + 2) * pi, k), defined(tan(alpha / 4) * u)),
             also=low_orders.three_turns(alpha),
             remark="Multiples of 4π are not singular: there the displacement is a translation and Re σ = 0."),
    equation("39", "composition of two displacements, n = 2", 205, equal(sigma, (q - 1) / (q + 1)),
             extract="σ _ = q ^ _ 1 q ^ _ + 1", where=COMPOSED, condition=nonzero(Re(q + 1)),
             also=low_orders.back_to_back(sigma2, sigma1)),
    equation("40", "the same by the two vectors", 207,
             equal(sigma, ((1 + sigma2) / (1 - sigma2) * ((1 + sigma1) / (1 - sigma1)) - 1)
                   / ((1 + sigma2) / (1 - sigma2) * ((1 + sigma1) / (1 - sigma1)) + 1)),
             extract="σ _ = 1 + σ _ 2 1 σ _ 2 1 + σ _ 1 1 σ _ 1 1 1 + σ _ 2 1 σ _ 2 1 + σ _ 1 1 σ _ 1 + 1",
             where=COMPOSED, condition=nonzero(Re(q + 1)), also=low_orders.back_to_back(sigma2, sigma1)),
    equation("41", "the same without quaternions", 209,
             equal(sigma, ((1 - norm(sigma2) ** 2) * sigma1 + (1 - norm(sigma1) ** 2) * sigma2
                           + 2 * cross(sigma2, sigma1))
                   / ((1 - dot(sigma2, sigma1)) ** 2 + norm(cross(sigma2, sigma1)) ** 2)),
             extract="σ _ = 1 σ _ 2 2 σ _ 1 + 1 σ _ 1 2 σ _ 2 + 2 σ _ 2 × σ _ 1 1 σ _ 2 · σ _ 1 2 + σ _ 2 × σ _ 1 2",
             where=COMPOSED, condition=nonzero(Re(q + 1)), also=low_orders.back_to_back(sigma2, sigma1)),
)

HALVES = (
    equation("42", "fractional Cayley transform", 213, equal(cay_half(v), (1 + v) ** half * (1 - v) ** (-half)),
             extract="c a y 1 2 v _ = 1 + v _ 1 2 1 v _ 1 2", where=HALF,
             because=equal(cay_half(v) ** 2, (1 + v) * (1 - v) ** (-1)),
             remark="The supporting identity is the square of both sides."),
    equation("cayley-half-onto", "the fractional Cayley transform is onto", 214, reaches(half_map, q),
             where=(*HALF, *SCALAR), said="It is well defined and onto.",
             corrected=iff(nonzero(Re(q0)), reaches(half_map, pm(q))),
             because=equal(scalar(cay_half(v)) ** 2, 1 / (1 + x)),
             remark="Half turns are missed, and of q and −q one is reached: the scalar part is 1/√(1 + |v|²)."),
    equation("43", "fractional Cayley transform as a quotient", 217,
             equal(cay_half(v), root((1 + v) / (1 - v)), pm((1 + v) / root(1 + x))),
             extract="c a y 1 2 v _ = 1 + v _ 1 v _ = ± 1 + v _ 1 + v _ 2", where=HALF,
             fixed_by="(42), with the exponent 1/2; (102) and (116) for the root in the denominator",
             because=equal(cay_half(v), (1 + v) / root(1 + x))),
    equation("cayley-half-well-defined", "its values are unit quaternions", 218,
             equal(norm(cay_half(v)), 1), extract="c a y 1 2 v _ = 1", where=HALF),
    equation("44", "inverse of the fractional Cayley transform", 220, equal(v, (q**2 - 1) / (q**2 + 1)),
             extract="v _ = q ^ _ 2 1 q ^ _ 2 + 1", where=(let(v, low_orders.preimage(1), q), *SCALAR),
             condition=nonzero(Re(q0))),
    equation("44-screw", "the same by angle and axis", 221, equal(v, tan(alpha / 2) * u),
             extract="v _ = t a n α _ 2 u _", where=(*SCREW, let(v, low_orders.preimage(1), q)), claimed=no_half_turn,
             stated=(221, "R e α _ k π")),
    equation("44-domain", "where it exists", 221, iff(no_half_turn, defined(tan(alpha / 2) * u)),
             said="This dual vector is v _ = t a n α _ 2 u _ ,   R e α _ k π",
             corrected=iff(unequal(Re(alpha), (2 * k + 1) * pi, k), defined(tan(alpha / 2) * u)),
             remark="Only odd multiples of π are excluded."),
    *corollary(3, 224, 1, Number(8) / size**2),
    equation("45", "composition of two displacements, n = 1", 226,
             equal(b, (b1 + b2 + cross(b2, b1)) / (1 - dot(b1, b2))),
             extract="b _ = b _ 1 + b _ 2 + b _ 2 × b _ 1 1 b _ 1 · b _ 2",
             where=(let(q, low_orders.composed(1), b2, b1), let(b, low_orders.preimage(1), q)),
             condition=nonzero(Re(1 - dot(b1, b2))), also=low_orders.to_a_half_turn(b1, b2)),
)

ENTRIES = (*WHOLE, *HALVES)
