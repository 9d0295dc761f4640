"""Section 6, Cayley transforms for unit dual quaternions: lines 184-226."""


from ..definitions import motions
from ..definitions.orders import at_order, cayley, composed, image_is, quaternion_map
from . import *
from .s04_dual_quaternions import scalar
from .s05_cayley_tensors import cay, cay_map, corollary, k, size

q = quaternion("q")
q0 = Symbol("q scalar", "dual number", r"\underline{q}", "q")
cay_half = Symbol("cay½", "function", r"\mathrm{cay}_{1/2}", "cay12")
half_map = Symbol("cay½ map", "map", r"\mathrm{cay}_{1/2}", "cay12")
sigma = Symbol("sigma", "dual vector", r"\underline{\boldsymbol{\sigma}}", "σ")
sigma1, sigma2 = (
    Symbol(f"sigma{i}", "dual vector", rf"\underline{{\boldsymbol{{\sigma}}}}_{i}", f"σ{i}") for i in (1, 2)
)
b = vector("b")
b1, b2 = (Symbol(f"b{i}", "dual vector", rf"\underline{{\mathbf{{b}}}}_{i}", f"b{i}") for i in (1, 2))

CAY = (let(cay, lambda env: lambda v: cayley(env, 2, v)), let(cay_map, at_order(2, quaternion_map)))
HALF = (let(cay_half, lambda env: lambda v: cayley(env, 1, v)), let(half_map, at_order(1, quaternion_map)))
SCALAR = (let(q0, scalar_part, q),)
SCREW = (let(q, screw_quaternion, alpha, u),)
COMPOSED = (let(q, at_order(2, composed), sigma2, sigma1), let(sigma, at_order(2, image_is), q))
no_full_turn = unequal(Re(alpha), 2 * k * pi, k)
no_half_turn = remark(unequal(Re(alpha), k * pi, k), words(r"k \in \mathbb{Z}", "kZ"))


ENTRIES = (
    equation("34", "Cayley transform of dual vectors", 188, equal(cay(v), (1 + v) * (1 - v) ** (-1)),
             extract="c a y v _ = 1 + v _ 1 v _ 1", where=CAY,
             remark="cay is the unit quaternion that turns by four times the arc tangent of |v|."),
    equation("cayley-quaternion-well-defined", "its values are unit quaternions", 189,
             both(nonzero(Re(norm(1 - v))), unit_quaternion(cay(v))), where=CAY),
    equation("cayley-quaternion-onto", "the Cayley transform is onto", 189, reaches(cay_map, q),
             where=(*CAY, *SCALAR), said="is well defined and onto.",
             corrected=iff(nonzero(Re(1 + q0)), reaches(cay_map, q)), because=equal(1 + scalar(cay(v)), 2 / (1 + x)),
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
             extract="v _ = q ^ _ 1 q _ ^ + 1", where=(let(v, at_order(2, image_is), q),),
             condition=nonzero(Re(q + 1))),
    *corollary(2, 197, 2, "transform", Number(64) / size**3),
    equation("37", "unit dual quaternion by angle and axis", 199, equal(q, cos(alpha / 2) + u * sin(alpha / 2)),
             extract="q ^ _ = c o s α _ 2 + u _ s i n α _ 2", where=(let(q, motions.lift, alpha, u),)),
    equation("38", "modified Rodrigues dual vector", 201, equal(sigma, tan(alpha / 4) * u),
             extract="σ _ = t a n α _ 4 u _", where=(*SCREW, let(sigma, at_order(2, image_is), q)),
             claimed=no_full_turn, stated=(200, "for R e α _ 2 k π")),
    equation("38-domain", "where the modified Rodrigues dual vector exists", 200,
             iff(no_full_turn, defined(tan(alpha / 4) * u)), said="The results for R e α _ 2 k π",
             corrected=iff(unequal(Re(alpha), (4 * k + 2) * pi, k), defined(tan(alpha / 4) * u)),
             remark="Multiples of 4π are not singular: there the displacement is a translation and Re σ = 0."),
    equation("39", "composition of two displacements, n = 2", 205, equal(sigma, (q - 1) / (q + 1)),
             extract="σ _ = q ^ _ 1 q ^ _ + 1", where=COMPOSED, condition=nonzero(Re(q + 1))),
    equation("40", "the same by the two vectors", 207,
             equal(sigma, ((1 + sigma2) / (1 - sigma2) * ((1 + sigma1) / (1 - sigma1)) - 1)
                   / ((1 + sigma2) / (1 - sigma2) * ((1 + sigma1) / (1 - sigma1)) + 1)),
             extract="σ _ = 1 + σ _ 2 1 σ _ 2 1 + σ _ 1 1 σ _ 1 1 1 + σ _ 2 1 σ _ 2 1 + σ _ 1 1 σ _ 1 + 1",
             where=COMPOSED, condition=nonzero(Re(q + 1))),
    equation("41", "the same without quaternions", 209,
             equal(sigma, ((1 - norm(sigma2) ** 2) * sigma1 + (1 - norm(sigma1) ** 2) * sigma2
                           + 2 * cross(sigma2, sigma1))
                   / ((1 - dot(sigma2, sigma1)) ** 2 + norm(cross(sigma2, sigma1)) ** 2)),
             extract="σ _ = 1 σ _ 2 2 σ _ 1 + 1 σ _ 1 2 σ _ 2 + 2 σ _ 2 × σ _ 1 1 σ _ 2 · σ _ 1 2 + σ _ 2 × σ _ 1 2",
             where=COMPOSED, condition=nonzero(Re(q + 1))),
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
             extract="v _ = q ^ _ 2 1 q ^ _ 2 + 1", where=(let(v, at_order(1, image_is), q), *SCALAR),
             condition=nonzero(Re(q0))),
    equation("44-screw", "the same by angle and axis", 221, equal(v, tan(alpha / 2) * u),
             extract="v _ = t a n α _ 2 u _", where=(*SCREW, let(v, at_order(1, image_is), q)), claimed=no_half_turn,
             stated=(221, "R e α _ k π")),
    equation("44-domain", "where it exists", 221, iff(no_half_turn, defined(tan(alpha / 2) * u)),
             said="This dual vector is v _ = t a n α _ 2 u _ ,   R e α _ k π",
             corrected=iff(unequal(Re(alpha), (2 * k + 1) * pi, k), defined(tan(alpha / 2) * u)),
             remark="Only odd multiples of π are excluded."),
    *corollary(3, 224, 1, "transform", Number(8) / size**2),
    equation("45", "composition of two displacements, n = 1", 226,
             equal(b, (b1 + b2 + cross(b2, b1)) / (1 - dot(b1, b2))),
             extract="b _ = b _ 1 + b _ 2 + b _ 2 × b _ 1 1 b _ 1 · b _ 2",
             where=(let(q, at_order(1, composed), b2, b1), let(b, at_order(1, image_is), q)),
             condition=nonzero(Re(1 - dot(b1, b2)))),
)
