"""Section 7, the fractional Cayley transform of order n and its inverse: lines 231-269, 286-287."""

from typing import Any

from ..definitions import cayley_maps, motions, orders, preimages
from . import *
from .s07_general_order import *

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
FOR_EVERY_N = "For every n by induction with Pascal's rule, the supporting identity."
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
    equation("46", "fractional Cayley transform of order n", 234, equal(cay_v, (1 + v)**(n / 2) * (1 - v)**(-(n / 2))),
             extract="c a y n 2 v _ = 1 + v _ n 2 1 v _ n 2", where=(let(cay_v, orders.cayley, n, v),),
             fixed_by="lines 243 and 261: ((1 + v)/(1 − v)) to the power n/2"),
    equation("theorem-11-well-defined", "the value is a unit quaternion", 237,
             both(equal(cay_v * conjugate(cay_v), 1), equal(norm(cay_v), 1)), where=(let(cay_v, orders.cayley, n, v),)),
    equation("theorem-11-onto", "the transform is onto the unit quaternions", 235, reaches(cay, target), where=ONTO,
             because=both(by_roots, step, equal(s_1 * root(1 + x), 1), equal((1 + s_2) * (1 + x), 2)),
             argument=ARGUMENT, said="are well defined and onto.",
             corrected=both(implies(no_less(n, 3), reaches(cay, target)),
                            implies(equal(n, 2), iff(reaches(cay, target), nonzero(Re(1 + scalar)))),
                            implies(equal(n, 1), iff(reaches(cay, target), positive(Re(scalar))))),
             remark="Order 1 misses scalar parts with real part ≤ 0 (of the half turns either sign), order 2 misses "
             "real part −1; from order 3 on it is onto."),
    equation("47", "inverse of the transform", 241, equal(v, (q_hat**(2 / n) - 1) / (q_hat**(2 / n) + 1)),
             extract="v _ = q ^ _ 2 n 1 q ^ _ 2 n + 1",
             where=(let(v, orders.preimage, n, alpha, u), let(q_hat, screw_quaternion, alpha, u)),
             condition=nonzero(Re(q_hat**(2 / n) + 1)),
             remark="Executed with the principal root; the other branches are (49)."),
    equation("theorem-12-branches", "the inverse has n branches", 240, branches(cay_counted, target, n), where=ONTO,
             said="is a multi-valued function with n branches",
             corrected=implies(several, both_signs), because=both(by_roots, step), argument=ARGUMENT,
             remark="n vectors belong to q and −q together: for even n only n/2 of them to q. A branch is infinite "
             "where Re q² = (−1)ⁿ, and a translation has infinitely many preimages on the branches k ≠ 0."),
    equation("theorem-12-preimages", "every branch is mapped back to q", 240, equal(image, q_hat),
             where=(let(v_k, cayley_maps.branch, n, k, alpha, u), let(image, orders.cayley, n, v_k),
                    let(q_hat, screw_quaternion, alpha, u)),
             condition=finite(turned), said="The inverse of the previous fractional order Cayley map",
             corrected=equal(image, pm(q_hat)), remark="The other sign appears on odd branches of even order already."),
    equation("corollary-4-rotation", "pure rotation if and only if |v| is real", 245,
             iff(is_rotation, zero(Du(norm(v)))), where=TYPES),
    equation("corollary-4-translation", "pure translation if |v| has real part 0", 245,
             implies(negated(nonzero(Re(norm(v)))), is_translation), where=TYPES),
    equation("corollary-4-otherwise", "general screw displacement otherwise", 245,
             implies(both(nonzero(Du(norm(v))), nonzero(Re(norm(v)))), is_screw), where=TYPES,
             condition=nonzero(Re(q(norm(v)))),
             remark="Where Re q_n = 0, a full turn, the displacement is a translation although Re |v| ≠ 0 (n ≥ 3)."),
    equation("48", "quaternion of the natural invariants", 247, equal(q_hat, cos(alpha / 2) + u * sin(alpha / 2)),
             extract="q ^ _ = c o s α _ 2 + u _ s i n α _ 2", where=(let(q_hat, motions.lift, alpha, u),)),
    equation("49", "all branches of the inverse", 249,
             remark(equal(v, tan(turned) * u), words(r"k = 0, 1, \dots, n-1", "k=0,1,n-1")),
             extract="v _ = t a n α _ + 2 k π 2 n u _ , k = 0,1 , , n 1",
             where=(let(v, orders.preimage, n, alpha, u),), condition=finite(turned)),
    equation("principal-vector", "higher-order Rodrigues dual vector", 250, equal(v_0, tan(alpha / (2 * n)) * u),
             extract="v _ 0 = t a n α _ 2 n u _", where=(let(v_0, orders.preimage, n, alpha, u),),
             condition=finite(alpha / (2 * n))),
    equation("shadow-vectors", "shadow parameterizations of the same pose", 251, equal(v_k, tan(turned) * u),
             extract="v _ k = t a n α _ + 2 k π 2 n u _", where=(let(v_k, orders.preimage, n, alpha, u),),
             claimed=nonzero(k), stated=(251, "For k = 1 , , n 1"), condition=finite(turned), orders=(2, 3, 4, 5)),
    equation("shadow-formula", "shadow from the principal parameter", 251,
             (Reading(equal(r_k, (r_0 + tan(turn)) / (1 - r_0 * tan(turn))), "v₀, v_k: signed coefficients along u"),
              Reading(equal(norm(v_k), (norm(v_0) + tan(turn)) / (1 - norm(v_0) * tan(turn))),
                      "v₀, v_k: magnitudes of the vectors")),
             extract="v _ k = v _ 0 + t a n k π n 1 v _ 0 t a n k π n", where=COEFFICIENTS,
             condition=both(finite(alpha / (2 * n)), nonzero(cos(turn)), finite(turned)),
             remark="At k = n/2 the tangent is infinite, and v_k = −1/v₀."),
    equation("shadow-at-infinity", "shadow where the principal parameter is infinite", 251,
             (Reading(tends(Re(r_far), -cot(turn)), "with a minus"), Reading(tends(Re(r_far), cot(turn)), "without")),
             extract="R e v _ k c o t k π n", where=(let(r_far, at_infinity, n, k),),
             claimed=nonzero(k), stated=(251, "For k = 1 , , n 1"), orders=(2, 3, 4, 5)),
    equation("shadow-avoids-singularity", "where v is infinite, a shadow is finite", 251,
             nonzero(sin(pi / n)), where=(), condition=no_less(n, 2),
             remark="At Re α = nπ the shadow k = 1 is −cot(π/n) u; order 1 has no shadow."),
)

PROVED = let(by_induction, cayley_maps.proved(51, 52, 53))
BY_INDUCTION = (*CAYLEY, PROVED)
p_by_binomials = equal(p(X), summation(
    index, 0, floor_over(n, 2), (-Number(1))**index * binomial(n, 2 * index) * X**(2 * index)))
q_by_binomials = equal(q(X), summation(
    index, 0, floor_over(n - 1, 2), (-Number(1))**index * binomial(n, 2 * index + 1) * X**(2 * index)))
POLYNOMIAL = (
    equation("50", "unit dual quaternion of order n", 254,
             equal(pm(q_hat), 1 / root((1 + x)**n) * (p(norm(v)) + q(norm(v)) * v)),
             extract="± q ^ _ = 1 1 + v _ 2 n p n v _ + q n v _ v _", where=BY_INDUCTION, because=by_induction,
             remark="For every n it is (53) with (51) and (52), the supporting theorems."),
    equation("51", "p_n by binomial coefficients", 256, p_by_binomials,
             extract="p n X = k = 0 n / 2 1 k n 2 k X 2 k", where=BY_INDUCTION,
             because=by_induction, remark=FOR_EVERY_N),
    equation("52", "q_n by binomial coefficients", 257, q_by_binomials,
             extract="q n X = k = 0 n 1 / 2 1 k n 2 k + 1 X 2 k", where=BY_INDUCTION,
             because=by_induction, remark=FOR_EVERY_N),
    equation("theorem-13-proof", "the transform with its sign", 260,
             equal(pm(q_hat), (1 + v)**(n / 2) * (1 - v)**(-(n / 2))),
             extract="± q ^ _ = 1 _ + v _ n 2 1 _ v _ n 2", where=CAYLEY,
             fixed_by="lines 243 and 261: ((1 + v)/(1 − v)) to the power n/2"),
    equation("53", "the transform as a power and as a sum", 261,
             equal(pm(q_hat), (1 + v)**n / root((1 + x)**n),
                   1 / root((1 + x)**n) * summation(index, 0, n, binomial(n, index) * v**index)),
             extract="± q ^ _ = 1 _ + v _ n 1 _ + v _ 2 n = 1 1 _ + v _ 2 n k = 0 n n k v _ k", where=BY_INDUCTION,
             because=by_induction, remark=FOR_EVERY_N),
    equation("54", "powers of a dual vector as quaternion", 263,
             equal(v**exponent, cases((norm(v)**(4 * power), equal(exponent, 4 * power)),
                                      (norm(v)**(4 * power) * v, equal(exponent, 4 * power + 1)),
                                      (-norm(v)**(4 * power + 2), equal(exponent, 4 * power + 2)),
                                      (-norm(v)**(4 * power + 2) * v, equal(exponent, 4 * power + 3)))),
             extract="v _ k = v _ 4 p , k = 4 p v _ 4 p v _ , k = 4 p + 1 v _ 4 p + 2 , k = 4 p + 2 "
                     "v _ 4 p + 2 v _ , k = 4 p + 3", where=(let(power, lambda env, k: k // 4, exponent),), branches=12,
             because=both(equal(v**2, -norm(v)**2), equal(v**4, norm(v)**4)),
             fixed_by="line 195: (1 + v)(1 − v) = 1 − v² = 1 + |v|²",
             remark="Every p by v⁴ = |v|⁴; p = 0 is v² = −|v|²."),
    equation("55", "unit dual quaternion of order n, again", 265,
             equal(pm(q_hat), 1 / root((1 + x)**n) * (p(norm(v)) + dot(q(norm(v)), v))),
             extract="± q ^ _ = 1 1 _ + v _ 2 n p n v _ + q n v _ · v _", where=BY_INDUCTION, because=by_induction,
             remark="For every n it is (53) with (51) and (52), the supporting theorems."),
    equation("56", "recurrence of p_n and q_n", 269,
             both(equal(p_next(X), p(X) - X**2 * q(X)), equal(q_next(X), q(X) + q(X)), equal(p_1(X), 1),
                  equal(q_1(X), 1)),
             extract="p n + 1 X = p n X X 2 q n X q n + 1 X = q n X + q n X p 1 X = 1 , q 1 X = 1",
             where=(*POLYNOMIALS, *STEP), remark="Contradicts (52): q₂ would be 2q₁ = 2 by chance, and q₃ would be 4.",
             corrected=step),
    equation("57", "orthogonal dual tensor of order n", 279, equal(R, rotation_by(norm(v), (1 + x)**n, V)),
             extract="R _ = I _ + 2 p n v _ q n v _ 1 + v _ 2 n v ~ _ + 2 q n 2 v _ 1 + v _ 2 n v ~ _ 2", where=CAYLEY),
)

quotient_2, quotient_1 = ((1 + a) / (1 - a) for a in (v_2, v_1))
product = (quotient_2 ** (n / 2) * quotient_1 ** (n / 2)) ** (2 / n)
COMPOSITION = (
    equation("58", "composition of two displacements of order n", 287, equal(v_composed, (product - 1) / (product + 1)),
             extract="v _ = 1 + v _ 2 1 v _ 2 n 2 1 + v _ 1 1 v _ 1 n 2 2 n 1 1 + v _ 2 1 v _ 2 n 2 1 + v _ 1 1 v _ 1 "
             "n 2 2 n + 1", where=(let(v_composed, lambda env, n, second, first: orders.solution(
                 env, n, orders.cayley(env, n, second) * orders.cayley(env, n, first)), n, v_2, v_1),),
             condition=nonzero(Re(product + 1)),
             remark="Executed with principal roots; the other roots give shadows. Roots of products of two general "
             "quaternions leave every exact field at hand."),
)

ENTRIES = (*FRACTIONAL, *POLYNOMIAL, *COMPOSITION)
