"""Section 8, tangent operators of the exponential and of the Cayley maps of order n: lines 388-412."""

from ....algebra import first_principles, real_part
from ....algebra.first_principles import tensor_exponential
from ....claims.numbers.fields import innermost
from ..definitions import motions, orders
from ..definitions.cayley_maps import proved
from . import *
from .general_order import *
from .s08a_kinematics import omega, omega_B

R = Symbol("R of the motion", "orthogonal tensor", r"\underline{\mathbf{R}}", "R")
a = vector("α", r"\alpha")
A = skew(a)
dexp = Symbol("dexp", "tensor", r"\mathrm{dexp}_{\underline{\boldsymbol{\alpha}}}", "dexpα")
dexp_inv = Symbol("dexp⁻¹", "tensor", r"\mathrm{dexp}_{\underline{\boldsymbol{\alpha}}}^{-1}", "dexpα-1")
dexp_T = Symbol("dexpᵀ", "tensor", r"\mathrm{dexp}_{\underline{\boldsymbol{\alpha}}}^{T}", "dexpαT")
dexp_inv_T = Symbol("dexp⁻ᵀ", "tensor", r"\mathrm{dexp}_{\underline{\boldsymbol{\alpha}}}^{-T}", "dexpα-T")
sinc = Symbol("sinc", "function", r"\operatorname{sinc}", "sinc")
angle = dual("angle", r"\alpha", "α")
invertible = proposition("invertible", r"$\mathrm{dexp}_{\underline{\boldsymbol{\alpha}}}$ has an inverse")
half_sinc = Symbol("sinc |α|/2", "number", r"\operatorname{sinc}\frac{|\underline{\boldsymbol{\alpha}}|}{2}", "sincα2")
dcay = Symbol("dcay_n", "tensor", r"\mathrm{dcay}_n", "dcayn")
dcay_inv = Symbol("dcay_n⁻¹", "tensor", r"\mathrm{dcay}_n^{-1}", "dcayn-1")
dcay_inv_T = Symbol("dcay_n⁻ᵀ", "tensor", r"\mathrm{dcay}_n^{-T}", "dcayn-T")
q_now = Symbol("q_n now", "number", r"q_n\left(\left|\underline{\mathbf{v}}\right|\right)", "qnv")

TWISTS = (let(omega, motions.twist, R), let(omega_B, motions.body_twist, R))
EXPONENTIAL = (
    let(a, multiple, alpha, u), let(R, screw_tensor, alpha, u), *TWISTS, let(sinc, motions.sinc),
    let(dexp, lambda env, a: first_principles.tangent(lambda w: tensor_exponential(w, env.field), env.now(a)), a),
    let(dexp_inv, inverse_of, dexp), let(dexp_T, transpose_of, dexp), let(dexp_inv_T, transpose_of, dexp_inv),
    let(invertible, lambda env, T: not env.field.same(innermost(real_part(T.det())), 0), dexp),
    let(half_sinc, lambda env, alpha: motions.sinc(env)(values.divide(env.now(alpha), 2)), alpha),
)
full_turn = nonzero(Re(half_sinc))

OF_V = (
    *POLYNOMIALS, let(R, orders.rotation, n, v), *TWISTS, let(dcay, orders.tangent, n, v),
    let(dcay_inv, inverse_of, dcay), let(dcay_inv_T, transpose_of, dcay_inv),
    let(q_now, lambda env, n, v: orders.q(env, n)(env.now(v)), n, v),
)
regular = nonzero(Re(q_now))
for_every_n = proposition("for every n", "the same for every n, by the differential ring of p_n and q_n")

ENTRIES = (
    equation("81", equal(omega, dexp * rate(a)), where=EXPONENTIAL),
    equation("82", equal(dexp, I + half * (sinc**2)(norm(a) / 2) * A + (1 - sinc(norm(a))) * (A**2 / norm(a)**2)),
             where=EXPONENTIAL, condition=nonzero(Re(a))),
    equation("sinc",
             equal(sinc(angle),
                   cases((sin(angle) / angle, provided(nonzero(Re(angle)))), (1, provided(zero(Re(angle)))))),
             where=(let(sinc, motions.sinc_by_series),)),
    equation("83", equal(rate(a), dexp_inv * omega), where=EXPONENTIAL, condition=full_turn),
    equation("dexp-inverse-domain", implies(nonzero(Re(norm(a) - 2 * pi)), invertible), where=EXPONENTIAL,
             corrected=iff(full_turn, invertible)),
    equation("84", equal(dexp_inv, I - half * A + (1 - norm(a) / 2 * cot(norm(a) / 2)) * (A**2 / norm(a)**2)),
             where=EXPONENTIAL, claimed=nonzero(Re(norm(a) - 2 * pi)), condition=nonzero(Re(sin(norm(a) / 2)))),
    equation("85",
             (Reading(equal(rate(a), dexp_inv_T * omega_B), "inverse transpose"),
              Reading(equal(rate(a), dexp_T * omega_B), "transpose")),
             where=EXPONENTIAL, condition=full_turn),
    equation("86", both(equal(omega, dcay * rate(v)), equal(omega_B, transpose(dcay) * rate(v))), where=OF_V),
    equation("87", both(equal(rate(v), dcay_inv * omega), equal(rate(v), dcay_inv_T * omega_B)), where=OF_V,
             condition=regular),
    equation("88",
             equal(dcay,
                   2 * q(norm(v)) * p(norm(v)) / (1 + x)**n * I + 2 * (q**2)(norm(v)) / (1 + x)**n * V + 2
                   * (n * (1 + x)**(n - 1) - q(norm(v)) * p(norm(v))) / (x * (1 + x)**n) * VV),
             where=(*OF_V, let(for_every_n, proved(88))), because=for_every_n, condition=nonzero(Re(x))),
    equation("89",
             equal(dcay_inv,
                   p(norm(v)) / (2 * q(norm(v))) * I - half * V + ((1 + x) * q(norm(v)) - n * p(norm(v)))
                   / (2 * n * x * q(norm(v))) * VV),
             where=(*OF_V, let(for_every_n, proved(89))), because=for_every_n,
             condition=both(nonzero(Re(x)), nonzero(Re(q(norm(v)))))),
    equation("90", equal(rate(v), dcay_inv * omega), where=OF_V, condition=regular),
    equation("91", equal(rate(v), dcay_inv_T * omega_B), where=OF_V, condition=regular),
    equation("six-real-equations", both(equal(equations_in(a), 6), equal(equations_in(v), 6)),
             where=(let(a, multiple, alpha, u),)),
)
