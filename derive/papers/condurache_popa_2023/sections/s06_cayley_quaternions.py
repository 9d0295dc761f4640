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
    equation("34", equal(cay(v), (1 + v) * (1 - v) ** (-1)), where=CAY),
    equation("cayley-quaternion-well-defined", both(nonzero(Re(norm(1 - v))), unit_quaternion(cay(v))), where=CAY),
    equation("cayley-quaternion-onto", reaches(cay_map, q), where=(*CAY, *SCALAR),
             corrected=iff(nonzero(Re(1 + q0)), reaches(cay_map, q)), because=equal(1 + scalar(cay(v)), 2 / (1 + x))),
    equation("35", equal(cay(v), (1 + v) / (1 - v), (1 + v) ** 2 / (1 + x)), where=CAY),
    equation("36", equal(norm(cay(v)), norm(1 + v) / norm(1 - v), root(1 + x) / root(1 + x), 1), where=CAY),
    equation("norm-of-1-plus-v",
             (Reading(equal(norm(1 + v), root((1 + v) * (1 - v)), root(1 - v**2), root(1 + x)), "with roots"),
              Reading(equal(norm(1 + v), (1 + v) * (1 - v), 1 - v**2, 1 + x), "without roots"))),
    equation("cayley-quaternion-inverse", equal(v, (q - 1) / (q + 1)), where=(let(v, at_order(2, image_is), q),),
             condition=nonzero(Re(q + 1))),
    *corollary(2, 2, Number(64) / size**3),
    equation("37", equal(q, cos(alpha / 2) + u * sin(alpha / 2)), where=(let(q, motions.lift, alpha, u),)),
    equation("38", equal(sigma, tan(alpha / 4) * u), where=(*SCREW, let(sigma, at_order(2, image_is), q)),
             claimed=no_full_turn),
    equation("38-domain", iff(no_full_turn, defined(tan(alpha / 4) * u)),
             corrected=iff(unequal(Re(alpha), (4 * k + 2) * pi, k), defined(tan(alpha / 4) * u))),
    equation("39", equal(sigma, (q - 1) / (q + 1)), where=COMPOSED, condition=nonzero(Re(q + 1))),
    equation("40",
             equal(sigma,
                   ((1 + sigma2) / (1 - sigma2) * ((1 + sigma1) / (1 - sigma1)) - 1)
                   / ((1 + sigma2) / (1 - sigma2) * ((1 + sigma1) / (1 - sigma1)) + 1)),
             where=COMPOSED, condition=nonzero(Re(q + 1))),
    equation("41",
             equal(sigma,
                   ((1 - norm(sigma2) ** 2) * sigma1 + (1 - norm(sigma1) ** 2) * sigma2 + 2 * cross(sigma2, sigma1))
                   / ((1 - dot(sigma2, sigma1)) ** 2 + norm(cross(sigma2, sigma1)) ** 2)),
             where=COMPOSED, condition=nonzero(Re(q + 1))),
    equation("42", equal(cay_half(v), (1 + v) ** half * (1 - v) ** (-half)), where=HALF,
             because=equal(cay_half(v) ** 2, (1 + v) * (1 - v) ** (-1))),
    equation("cayley-half-onto", reaches(half_map, q), where=(*HALF, *SCALAR),
             corrected=iff(nonzero(Re(q0)), reaches(half_map, pm(q))),
             because=equal(scalar(cay_half(v)) ** 2, 1 / (1 + x))),
    equation("43", equal(cay_half(v), root((1 + v) / (1 - v)), pm((1 + v) / root(1 + x))), where=HALF,
             because=equal(cay_half(v), (1 + v) / root(1 + x))),
    equation("cayley-half-well-defined", equal(norm(cay_half(v)), 1), where=HALF),
    equation("44", equal(v, (q**2 - 1) / (q**2 + 1)), where=(let(v, at_order(1, image_is), q), *SCALAR),
             condition=nonzero(Re(q0))),
    equation("44-screw", equal(v, tan(alpha / 2) * u), where=(*SCREW, let(v, at_order(1, image_is), q)),
             claimed=no_half_turn),
    equation("44-domain", iff(no_half_turn, defined(tan(alpha / 2) * u)),
             corrected=iff(unequal(Re(alpha), (2 * k + 1) * pi, k), defined(tan(alpha / 2) * u))),
    *corollary(3, 1, Number(8) / size**2),
    equation("45", equal(b, (b1 + b2 + cross(b2, b1)) / (1 - dot(b1, b2))),
             where=(let(q, at_order(1, composed), b2, b1), let(b, at_order(1, image_is), q)),
             condition=nonzero(Re(1 - dot(b1, b2)))),
)
