"""Section 7, vectorial parameterizations v = φ(α) u with a factor a(v): lines 288-316."""

from ..definitions import cayley_maps, orders
from . import *
from .s07_general_order import *
from .s07a_fractional_transform import FOR_EVERY_N, PROVED, by_induction, p_by_binomials, q_by_binomials, target, turned

caym = Symbol("caym_{n/2}", "function", r"\mathrm{caym}_{\frac{n}{2}}", "caymn2")
caym_v = Symbol("caym_{n/2}(v)", "quaternion", r"\mathrm{caym}_{\frac{n}{2}} \underline{\mathbf{v}}", "caymn2v")
caym_map = Symbol("caym with a = 1 + v·v", "function", r"\mathrm{caym}_{\frac{n}{2}}", "caymn2")
v_of_q = Symbol("v(q)", "function", r"\underline{\mathbf{v}}", "v")
phi_inv = Symbol("φ⁻¹", "function", r"\varphi^{-1}", "φ1")
axis = Symbol("axis", "unit vector", r"\underline{\mathbf{u}}", "u")
W, xw = skew(w), norm(w) ** 2

FACTOR = (let(a, cayley_maps.constant, a_value), let(v, multiple, a_value, w))
"""Definitions of v and a(v) ≠ 0 without further relation: v = a w, with a and w free."""

MODIFIED = (
    *FACTOR, *POLYNOMIALS, let(caym_v, cayley_maps.modified, n, a_value, v),
    let(caym, cayley_maps.function_of(cayley_maps.modified_root), n, a_value, v),
    let(q_of, cayley_maps.function_of(cayley_maps.modified), n, a_value, v),
    let(R, cayley_maps.modified_tensor, n, a_value, v), PROVED,
)

ENTRIES = (
    equation("59", "modified fractional Cayley transform", 293,
             equal(caym(v), (a(v) + v)**(n / 2) * (a(v) - v)**(-(n / 2))),
             extract="c a y m n 2 v _ = a v _ + v _ n 2 a v _ v _ n 2", where=MODIFIED,
             fixed_by="line 296: the value as (a + v)ⁿ over its norm",
             condition=implies(zero(Re(v)), positive(Re(a(v)**n))),
             remark="It is the map (46) of v/a; the root of odd order leaves the sign open. Where Re v = 0 and "
             "Re a < 0 it has no value at odd n: a root of a negative number."),
    equation("theorem-15-unit", "the value is a unit quaternion", 296,
             both(equal(caym_v * conjugate(caym_v), 1), equal(norm(caym_v), 1)), where=MODIFIED),
    equation("theorem-15-value", "the value as a power over its norm", 296,
             equal(caym(v), pm((a(v) + v)**n / root((a(v)**2 + x)**n))),
             extract="c a y m n 2 v _ = ± a v _ + v _ n a v _ 2 + v _ 2 n", where=MODIFIED),
    equation("60", "inverse of the modified transform", 298,
             remark(equal(v_of_q(q_hat), a(v) * tan(turned) * u), words(r"k = 0, 1, \dots, n-1", "k=0,1,n-1")),
             extract="v _ q _ ^ = a v _ t a n α _ + 2 k π 2 n u _ , k = 0,1 , , n 1",
             where=(let(q_hat, screw_quaternion, alpha, u), let(a, cayley_maps.constant, a_value),
                    let(v, orders.solution, n, q_hat, a_value),
                    let(v_of_q, cayley_maps.function_of(orders.solution), n, q_hat, a_value)),
             condition=finite(turned)),
    equation("theorem-15-branches", "the inverse has n branches for every a(v)", 297,
             equal(preimage_count(caym_map, q_hat) + preimage_count(caym_map, -q_hat), n),
             where=(let(q_hat, screw_quaternion, alpha, u), let(a, cayley_maps.constant, a_value),
                    let(caym_map, cayley_maps.cayley_function_of_growing_scale, n),
                    let(v, orders.solution, n, q_hat, a_value)),
             condition=finite(turned), said="the inverse of the mapping Equation (59) contains n branches",
             corrected=equal(v, a(v) * tan(turned) * u),
             remark="Refuted with a(v) = 1 + |v|², where |v| = a(v) tan has two solutions or none on a branch; (60) is "
             "an equation for v, not a formula."),
    equation("61", "unit dual quaternion of a vectorial parameterization", 301,
             equal(pm(q_of(v)), (a(v) + v)**n / root((a(v)**2 + x)**n)),
             extract="± q _ ^ v _ = a v _ + v _ n a v _ 2 + v _ 2 n",
             where=(let(a, cayley_maps.constant, a_value),
                    let(v, lambda env, n, a, *screw: a * cayley_maps.rodrigues_vector(env, n, *screw),
                        n, a_value, alpha, u),
                    let(q_of, cayley_maps.function_of(screw_quaternion), alpha, u)),
             condition=finite(alpha / (2 * n)),
             remark="v = φ(α) u with any value a(v) = φ(α) cot(α/2n); another k is another angle and ±."),
    equation("theorem-16-factor", "factor a(v) of a vectorial parameterization", 302,
             equal(a(v), norm(v) * cot((phi_inv(norm(v)) + 2 * k * pi) / (2 * n))),
             extract="a v _ = v _ c o t φ 1 v _ + 2 k π 2 n",
             where=(let(phi_inv, cayley_maps.constant, alpha), let(axis, cayley_maps.direction, v),
                    let(target, screw_quaternion, alpha, axis),
                    let(a, cayley_maps.function_of(cayley_maps.scales), n, target, v)),
             condition=both(finite(turned), nonzero(Re(v)), nonzero(Re(sin(turned)))),
             remark="Where Re v = 0 the factor is the limit 2n φ′(0) on the principal branch."),
    equation("theorem-16-step", "the same before φ is inverted", 304, equal(a(v), norm(v) * cot(turned)),
             extract="a v _ = v _ c o t α _ + 2 k π 2 n",
             where=(let(axis, cayley_maps.direction, v), let(target, screw_quaternion, alpha, axis),
                    let(a, cayley_maps.function_of(cayley_maps.scales), n, target, v)),
             condition=both(finite(turned), nonzero(Re(v)), nonzero(Re(sin(turned)))),
             remark="It follows from (60), not from (61)."),
    equation("62", "unit dual quaternion by p_n and q_n", 307,
             equal(pm(q_of(v)), 1 / root((1 + xw)**n) * (p(norm(w)) + q(norm(w)) * v)),
             extract="± q _ ^ v _ = 1 1 + w _ 2 n p n w _ + q n w _ v _", where=MODIFIED,
             corrected=equal(pm(q_of(v)), 1 / root((1 + xw)**n) * (p(norm(w)) + q(norm(w)) * w)),
             remark="The vector part is along w = v/a(v), not v."),
    equation("vector-w", "the vector w", 308, equal(w, v / a(v)), extract="w _ = v _ a v _", where=FACTOR),
    equation("63", "p_n by binomial coefficients, again", 309, p_by_binomials,
             extract="p n X = k = 0 n / 2 1 k n 2 k X 2 k", where=MODIFIED, because=by_induction, remark=FOR_EVERY_N),
    equation("64", "q_n by binomial coefficients, again", 310, q_by_binomials,
             extract="q n X = k = 0 n 1 / 2 1 k n 2 k + 1 X 2 k", where=MODIFIED,
             because=by_induction, remark=FOR_EVERY_N),
    equation("65", "orthogonal dual tensor of a vectorial parameterization", 314,
             equal(R, rotation_by(norm(w), (1 + xw)**n, V)),
             extract="R _ = I _ + 2 p n w _ q n w _ 1 + w _ 2 n v ~ _ + 2 q n 2 w _ 1 + w _ 2 n v ~ _ 2",
             where=MODIFIED, corrected=equal(R, rotation_by(norm(w), (1 + xw)**n, W)),
             remark="Both terms hold w = v/a(v), not v."),
)
