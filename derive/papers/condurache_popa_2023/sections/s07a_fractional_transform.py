"""Section 7, the fractional Cayley transform of order n and its inverse: lines 231-269, 286-287."""

from typing import Any

from ..definitions import cayley_maps, motions, orders, preimages
from . import *
from .general_order import *

cay = Symbol("cay_{n/2}", "function", r"\mathrm{cay}_{\frac{n}{2}}", "cayn2")
cay_counted = Symbol("cay_{n/2} counted", "function", r"\mathrm{cay}_{\frac{n}{2}}", "cayn2")
cay_v = Symbol("cay_{n/2}(v)", "quaternion", r"\mathrm{cay}_{\frac{n}{2}} \underline{\mathbf{v}}", "cayn2v")
target = Symbol("target", "unit quaternion", r"\underline{\hat{\mathbf{q}}}", "q^")
scalar = Symbol("q_0", "number", r"\underline{q}", "q")
s_1, s_2 = (Symbol(f"q_0 of order {i}", "number", rf"\underline{{q}}^{{(n={i})}}", "q") for i in (1, 2))
by_induction = proposition("binomial sums for every n", "the binomial sums and powers of 1 + v, by induction on n")
by_roots = proposition("preimages counted by roots", "the identities of the roots of $F_n$, by induction on n")
image = Symbol("image", "quaternion", r"\mathrm{cay}_{\frac{n}{2}} \underline{\mathbf{v}}_k", "cayvk")
v_0, v_k = vector("v_0", text="v0"), vector("v_k", text="vk")
r_0, r_k = (Symbol(f"r_{i}", "number", rf"\underline{{v}}_{i}", f"v{i}") for i in "0k")
r_far = Symbol("r_k at infinity", "number", r"\underline{v}_k", "vk")
index = Symbol("j", "index", "k", "k")
exponent, power = Symbol("exponent", "branch", "k", "k"), Symbol("quarter of k", "number", "p", "p")
p_next = Symbol("p_{n+1}", "function", "p_{n+1}", "pn+1")
q_next = Symbol("q_{n+1}", "function", "q_{n+1}", "qn+1")
p_1, q_1 = Symbol("p_1", "function", "p_1", "p1"), Symbol("q_1", "function", "q_1", "q1")
v_1, v_2 = vector("v_1", text="v1"), vector("v_2", text="v2")
v_composed = vector("v composed", "v", "v")
is_rotation, is_translation, is_screw = (
    proposition(name, rf"{name} by $\mathrm{{cay}}_{{n/2}} \underline{{\mathbf{{v}}}}$")
    for name in ("pure rotation", "pure translation", "general screw displacement")
)

STEP = (let(p_next, orders.next_p, n), let(q_next, orders.next_q, n),
        let(p_1, orders.at_order(1, orders.p)), let(q_1, orders.at_order(1, orders.q)))
step = both(equal(p_next(X), p(X) - X**2 * q(X)), equal(q_next(X), q(X) + p(X)), equal(p_1(X), 1), equal(q_1(X), 1))
ARGUMENT = "definitions/preimages, for every n,"
ONTO = (*POLYNOMIALS, *STEP, let(by_roots, preimages.counted_by_roots),
        let(cay, cayley_maps.cayley_function, n), let(cay_counted, cayley_maps.counted_cayley_function, n),
        let(scalar, scalar_part, target), let(s_1, lambda env, v: orders.cayley(env, 1, v).scalar, v),
        let(s_2, lambda env, v: orders.cayley(env, 2, v).scalar, v))
turned = (alpha + 2 * k * pi) / (2 * n)
turn = k * pi / n
both_signs = equal(preimage_count(cay_counted, target) + preimage_count(cay_counted, -target), n)
several = both(nonzero(Re(target**2 - 1)), nonzero(Re(target**2 - (-Number(1)) ** n)))
COEFFICIENTS = (
    let(r_0, lambda env, n, alpha: cayley_maps.branch_coefficient(env, n, 0, alpha), n, alpha),
    let(r_k, cayley_maps.branch_coefficient, n, k, alpha), let(v_0, cayley_maps.rodrigues_vector, n, alpha, u),
    let(v_k, cayley_maps.branch, n, k, alpha, u),
)
TYPES = (
    *CAYLEY, let(is_rotation, fixes_a_point, R), let(is_translation, fixes_directions, R), let(is_screw, is_general, R),
)


def at_infinity(env: Env, n: int, k: int) -> Any:
    """Return the coefficient of v_k at α = nπ, where v_0 is infinite."""
    return cayley_maps.branch_coefficient(env, n, k, n * env.field.pi)


FRACTIONAL = (
    equation("46", equal(cay_v, (1 + v)**(n / 2) * (1 - v)**(-(n / 2))), where=(let(cay_v, orders.cayley, n, v),)),
    equation("theorem-11-well-defined", both(equal(cay_v * conjugate(cay_v), 1), equal(norm(cay_v), 1)),
             where=(let(cay_v, orders.cayley, n, v),)),
    equation("theorem-11-onto", reaches(cay, target), where=ONTO,
             because=both(by_roots, step, equal(s_1 * root(1 + x), 1), equal((1 + s_2) * (1 + x), 2)),
             argument=ARGUMENT,
             corrected=both(implies(no_less(n, 3), reaches(cay, target)),
                            implies(equal(n, 2), iff(reaches(cay, target), nonzero(Re(1 + scalar)))),
                            implies(equal(n, 1), iff(reaches(cay, target), positive(Re(scalar)))))),
    equation("47", equal(v, (q_hat**(2 / n) - 1) / (q_hat**(2 / n) + 1)),
             where=(let(v, orders.preimage, n, alpha, u), let(q_hat, screw_quaternion, alpha, u)),
             condition=nonzero(Re(q_hat**(2 / n) + 1))),
    equation("theorem-12-branches", branches(cay_counted, target, n), where=ONTO,
             corrected=implies(several, both_signs), because=both(by_roots, step), argument=ARGUMENT),
    equation("theorem-12-preimages", equal(image, q_hat),
             where=(let(v_k, cayley_maps.branch, n, k, alpha, u), let(image, orders.cayley, n, v_k),
                    let(q_hat, screw_quaternion, alpha, u)),
             condition=finite(turned), corrected=equal(image, pm(q_hat))),
    equation("corollary-4-rotation", iff(is_rotation, zero(Du(norm(v)))), where=TYPES),
    equation("corollary-4-translation", implies(negated(nonzero(Re(norm(v)))), is_translation), where=TYPES),
    equation("corollary-4-otherwise", implies(both(nonzero(Du(norm(v))), nonzero(Re(norm(v)))), is_screw), where=TYPES,
             condition=nonzero(Re(q(norm(v))))),
    equation("48", equal(q_hat, cos(alpha / 2) + u * sin(alpha / 2)), where=(let(q_hat, motions.lift, alpha, u),)),
    equation("49", remark(equal(v, tan(turned) * u), words(r"k = 0, 1, \dots, n-1", "k=0,1,n-1")),
             where=(let(v, orders.preimage, n, alpha, u),), condition=finite(turned)),
    equation("principal-vector", equal(v_0, tan(alpha / (2 * n)) * u), where=(let(v_0, orders.preimage, n, alpha, u),),
             condition=finite(alpha / (2 * n))),
    equation("shadow-vectors", equal(v_k, tan(turned) * u), where=(let(v_k, orders.preimage, n, alpha, u),),
             claimed=nonzero(k), condition=finite(turned), orders=(2, 3, 4, 5)),
    equation("shadow-formula",
             (Reading(equal(r_k, (r_0 + tan(turn)) / (1 - r_0 * tan(turn))), "v₀, v_k: signed coefficients along u"),
              Reading(equal(norm(v_k), (norm(v_0) + tan(turn)) / (1 - norm(v_0) * tan(turn))),
                      "v₀, v_k: magnitudes of the vectors")),
             where=COEFFICIENTS, condition=both(finite(alpha / (2 * n)), nonzero(cos(turn)), finite(turned))),
    equation("shadow-at-infinity",
             (Reading(tends(Re(r_far), -cot(turn)), "with a minus"), Reading(tends(Re(r_far), cot(turn)), "without")),
             where=(let(r_far, at_infinity, n, k),), claimed=nonzero(k), orders=(2, 3, 4, 5)),
    equation("shadow-avoids-singularity", nonzero(sin(pi / n)), where=(), condition=no_less(n, 2)),
)

PROVED = let(by_induction, cayley_maps.proved(51, 52, 53))
BY_INDUCTION = (*CAYLEY, PROVED)
p_by_binomials = equal(p(X), summation(
    index, 0, floor_over(n, 2), (-Number(1))**index * binomial(n, 2 * index) * X**(2 * index)))
q_by_binomials = equal(q(X), summation(
    index, 0, floor_over(n - 1, 2), (-Number(1))**index * binomial(n, 2 * index + 1) * X**(2 * index)))
POLYNOMIAL = (
    equation("50", equal(pm(q_hat), 1 / root((1 + x)**n) * (p(norm(v)) + q(norm(v)) * v)), where=BY_INDUCTION,
             because=by_induction),
    equation("51", p_by_binomials, where=BY_INDUCTION, because=by_induction),
    equation("52", q_by_binomials, where=BY_INDUCTION, because=by_induction),
    equation("theorem-13-proof", equal(pm(q_hat), (1 + v)**(n / 2) * (1 - v)**(-(n / 2))), where=CAYLEY),
    equation("53",
             equal(pm(q_hat), (1 + v)**n / root((1 + x)**n),
                   1 / root((1 + x)**n) * summation(index, 0, n, binomial(n, index) * v**index)),
             where=BY_INDUCTION, because=by_induction),
    equation("54",
             equal(v**exponent,
                   cases((norm(v)**(4 * power), equal(exponent, 4 * power)),
                         (norm(v)**(4 * power) * v, equal(exponent, 4 * power + 1)),
                         (-norm(v)**(4 * power + 2), equal(exponent, 4 * power + 2)),
                         (-norm(v)**(4 * power + 2) * v, equal(exponent, 4 * power + 3)))),
             where=(let(power, lambda env, k: k // 4, exponent),), branches=12,
             because=both(equal(v**2, -norm(v)**2), equal(v**4, norm(v)**4))),
    equation("55", equal(pm(q_hat), 1 / root((1 + x)**n) * (p(norm(v)) + dot(q(norm(v)), v))), where=BY_INDUCTION,
             because=by_induction),
    equation("56",
             both(equal(p_next(X), p(X) - X**2 * q(X)), equal(q_next(X), q(X) + q(X)), equal(p_1(X), 1),
                  equal(q_1(X), 1)),
             where=(*POLYNOMIALS, *STEP), corrected=step),
    equation("57", equal(R, rotation_by(norm(v), (1 + x)**n, V)), where=CAYLEY),
)

quotient_2, quotient_1 = ((1 + a) / (1 - a) for a in (v_2, v_1))
product = (quotient_2 ** (n / 2) * quotient_1 ** (n / 2)) ** (2 / n)
COMPOSITION = (
    equation("58", equal(v_composed, (product - 1) / (product + 1)),
             where=(let(v_composed, lambda env, n, second,
                        first: orders.solution(env, n, orders.cayley(env, n, second) * orders.cayley(env, n, first)), n,
                        v_2, v_1),),
             condition=nonzero(Re(product + 1))),
)

ENTRIES = (*FRACTIONAL, *POLYNOMIAL, *COMPOSITION)
