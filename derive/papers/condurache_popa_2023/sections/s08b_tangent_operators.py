"""Section 8, tangent operators of the exponential and of the Cayley maps of order n: lines 388-412."""

from ....algebra import real_part
from ....maps import first_principles
from ....maps.exponential import tensor_exponential
from ...numbers.fields import innermost
from ..definitions import orders, velocities
from ..definitions.cayley_maps import proved
from . import *
from .s07_general_order import *
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

TWISTS = (let(omega, velocities.twist, R), let(omega_B, velocities.body_twist, R))
EXPONENTIAL = (
    let(a, multiple, alpha, u), let(R, screw_tensor, alpha, u), *TWISTS, let(sinc, velocities.sinc),
    let(dexp, lambda env, a: first_principles.tangent(lambda w: tensor_exponential(w, env.field), env.now(a)), a),
    let(dexp_inv, inverse_of, dexp), let(dexp_T, transpose_of, dexp), let(dexp_inv_T, transpose_of, dexp_inv),
    let(invertible, lambda env, T: not env.field.same(innermost(real_part(T.det())), 0), dexp),
    let(half_sinc, lambda env, alpha: velocities.sinc(env)(values.divide(env.now(alpha), 2)), alpha),
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
    equation("81", "twist by the Euler dual vector", 390, equal(omega, dexp * rate(a)),
             extract="ω _ = d e x p α _ α _ ˙", where=EXPONENTIAL, moving=True),
    equation("82", "tangent tensor dexp", 392,
             equal(dexp, I + half * (sinc**2)(norm(a) / 2) * A + (1 - sinc(norm(a))) * (A**2 / norm(a)**2)),
             extract="d e x p α _ = I + 1 2 s i n c 2 α _ 2 α _ ~ + ( 1 s i n c α _ ) α _ ~ 2 α _ 2", where=EXPONENTIAL,
             condition=nonzero(Re(a)),
             remark="Where Re α = 0 the last quotient has no value; dexp is I + α̃/2 + α̃²/6 there."),
    equation("sinc", "sinc by cases", 393,
             equal(sinc(angle), cases((sin(angle) / angle, provided(nonzero(Re(angle)))),
                                      (1, provided(zero(Re(angle)))))),
             extract="s i n c α _ = s i n α _ α _ i f R e α _ 0 1 i f R e α _ = 0",
             where=(let(sinc, velocities.sinc_by_series),)),
    equation("83", "kinematic equation of the Euler dual vector, spatial twist", 395, equal(rate(a), dexp_inv * omega),
             extract="α _ ˙ = d e x p α _ 1 ω _", where=EXPONENTIAL, moving=True, condition=full_turn,
             remark="At Re |α| = 2kπ, k ≥ 1, dexp has no inverse."),
    equation("dexp-inverse-domain", "where dexp has an inverse", 396,
             implies(nonzero(Re(norm(a) - 2 * pi)), invertible), where=EXPONENTIAL,
             said="if the real part of α _ is different by 2 π", corrected=iff(full_turn, invertible),
             remark="Not at 2π only: also not at 4π, 6π, …"),
    equation("84", "inverse tangent tensor of the exponential", 397,
             equal(dexp_inv, I - half * A + (1 - norm(a) / 2 * cot(norm(a) / 2)) * (A**2 / norm(a)**2)),
             extract="d e x p α _ 1 = I 1 2 α _ ~ + ( 1 α _ 2 c o t α _ 2 ) α _ ~ 2 α _ 2", where=EXPONENTIAL,
             claimed=nonzero(Re(norm(a) - 2 * pi)), stated=(396, "if the real part of α _ is different by 2 π"),
             condition=nonzero(Re(sin(norm(a) / 2))),
             remark="No value at 4π, 6π, …, where dexp is singular, nor at Re α = 0, where it is I − α̃/2 + α̃²/12."),
    equation("85", "kinematic equation of the Euler dual vector, body twist", 399,
             (Reading(equal(rate(a), dexp_inv_T * omega_B), "inverse transpose"),
              Reading(equal(rate(a), dexp_T * omega_B), "transpose")),
             extract="α _ ˙ = d e x p α _ T ω _ B", where=EXPONENTIAL, moving=True, condition=full_turn),
    equation("86", "twists by the Rodrigues dual vector", 402,
             both(equal(omega, dcay * rate(v)), equal(omega_B, transpose(dcay) * rate(v))),
             extract="ω _ = d c a y n v ˙ _ ω _ B = d c a y n T v ˙ _", where=OF_V, moving=True),
    equation("87", "rate of the Rodrigues dual vector", 403,
             both(equal(rate(v), dcay_inv * omega), equal(rate(v), dcay_inv_T * omega_B)),
             extract="v ˙ _ = d c a y n 1 ω _ v ˙ _ = d c a y n T ω _ B", where=OF_V, moving=True, condition=regular,
             fixed_by="(86): ω_B = dcay_nᵀ v̇, of which it is the inverse"),
    equation("88", "tangent operator of order n", 405,
             equal(dcay, 2 * q(norm(v)) * p(norm(v)) / (1 + x)**n * I + 2 * (q**2)(norm(v)) / (1 + x)**n * V
                   + 2 * (n * (1 + x)**(n - 1) - q(norm(v)) * p(norm(v))) / (x * (1 + x)**n) * VV),
             extract="d c a y n = 2 q n v _ p n v _ 1 + v _ 2 n I _ + 2 q n 2 v _ 1 + v _ 2 n v ~ _ + 2 n 1 + v _ 2 n "
             "1 q n v _ p n v _ v _ 2 1 + v _ 2 n v _ v _", where=(*OF_V, let(for_every_n, proved(88))),
             because=for_every_n, condition=nonzero(Re(x)),
             remark="Where Re v = 0 the last quotient is 0/0; |v|² divides the bracket as a polynomial."),
    equation("89", "kinematic tensor of order n", 406,
             equal(dcay_inv, p(norm(v)) / (2 * q(norm(v))) * I - half * V
                   + ((1 + x) * q(norm(v)) - n * p(norm(v))) / (2 * n * x * q(norm(v))) * VV),
             extract="d c a y n 1 = p n v _ 2 q n v _ _ I _ 1 2 v ~ _ + 1 + v _ 2 q n v _ n p n v _ 2 n v _ 2 q n v _ "
             "_ v _ v _", where=(*OF_V, let(for_every_n, proved(89))), because=for_every_n,
             condition=both(nonzero(Re(x)), nonzero(Re(q(norm(v))))),
             remark="Where Re v = 0 the last quotient is 0/0; where Re q_n = 0 dcay_n has no inverse (n ≥ 3)."),
    equation("90", "kinematic equation of the Rodrigues dual vector, spatial twist", 409,
             equal(rate(v), dcay_inv * omega), extract="v ˙ _ = d c a y n 1 ω _", where=OF_V, moving=True,
             condition=regular),
    equation("91", "kinematic equation of the Rodrigues dual vector, body twist", 410,
             equal(rate(v), dcay_inv_T * omega_B), extract="v ˙ _ = d c a y n T ω _ B", where=OF_V, moving=True,
             condition=regular, fixed_by="(86): ω_B = dcay_nᵀ v̇, of which it is the inverse"),
    equation("six-real-equations", "the vector problems are six real equations", 412,
             both(equal(equations_in(a), 6), equal(equations_in(v), 6)), where=(let(a, multiple, alpha, u),)),
)
