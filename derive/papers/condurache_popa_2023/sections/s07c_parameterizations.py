"""Section 7, vectorial parameterizations v = φ(α) u with a factor a(v): lines 288-316."""

from ..definitions import cayley_maps, orders
from . import *
from .general_order import *
from .s07a_fractional_transform import PROVED, by_induction, p_by_binomials, q_by_binomials, target, turned

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
    equation("59", equal(caym(v), (a(v) + v)**(n / 2) * (a(v) - v)**(-(n / 2))), where=MODIFIED,
             condition=implies(zero(Re(v)), positive(Re(a(v)**n)))),
    equation("theorem-15-unit", both(equal(caym_v * conjugate(caym_v), 1), equal(norm(caym_v), 1)), where=MODIFIED),
    equation("theorem-15-value", equal(caym(v), pm((a(v) + v)**n / root((a(v)**2 + x)**n))), where=MODIFIED),
    equation("60", remark(equal(v_of_q(q_hat), a(v) * tan(turned) * u), words(r"k = 0, 1, \dots, n-1", "k=0,1,n-1")),
             where=(let(q_hat, screw_quaternion, alpha, u), let(a, cayley_maps.constant, a_value),
                    let(v, orders.solution, n, q_hat, a_value),
                    let(v_of_q, cayley_maps.function_of(orders.solution), n, q_hat, a_value)),
             condition=finite(turned)),
    equation("theorem-15-branches", equal(preimage_count(caym_map, q_hat) + preimage_count(caym_map, -q_hat), n),
             where=(let(q_hat, screw_quaternion, alpha, u), let(a, cayley_maps.constant, a_value),
                    let(caym_map, cayley_maps.cayley_function_of_growing_scale, n),
                    let(v, orders.solution, n, q_hat, a_value)),
             condition=finite(turned), corrected=equal(v, a(v) * tan(turned) * u)),
    equation("61", equal(pm(q_of(v)), (a(v) + v)**n / root((a(v)**2 + x)**n)),
             where=(let(a, cayley_maps.constant, a_value),
                    let(v, lambda env, n, a, *screw: a * cayley_maps.rodrigues_vector(env, n, *screw), n, a_value,
                        alpha, u),
                    let(q_of, cayley_maps.function_of(screw_quaternion), alpha, u)),
             condition=finite(alpha / (2 * n))),
    equation("theorem-16-factor", equal(a(v), norm(v) * cot((phi_inv(norm(v)) + 2 * k * pi) / (2 * n))),
             where=(let(phi_inv, cayley_maps.constant, alpha), let(axis, cayley_maps.direction, v),
                    let(target, screw_quaternion, alpha, axis),
                    let(a, cayley_maps.function_of(cayley_maps.scales), n, target, v)),
             condition=both(finite(turned), nonzero(Re(v)), nonzero(Re(sin(turned))))),
    equation("theorem-16-step", equal(a(v), norm(v) * cot(turned)),
             where=(let(axis, cayley_maps.direction, v), let(target, screw_quaternion, alpha, axis),
                    let(a, cayley_maps.function_of(cayley_maps.scales), n, target, v)),
             condition=both(finite(turned), nonzero(Re(v)), nonzero(Re(sin(turned))))),
    equation("62", equal(pm(q_of(v)), 1 / root((1 + xw)**n) * (p(norm(w)) + q(norm(w)) * v)), where=MODIFIED,
             corrected=equal(pm(q_of(v)), 1 / root((1 + xw)**n) * (p(norm(w)) + q(norm(w)) * w))),
    equation("vector-w", equal(w, v / a(v)), where=FACTOR),
    equation("63", p_by_binomials, where=MODIFIED, because=by_induction),
    equation("64", q_by_binomials, where=MODIFIED, because=by_induction),
    equation("65", equal(R, rotation_by(norm(w), (1 + xw)**n, V)), where=MODIFIED,
             corrected=equal(R, rotation_by(norm(w), (1 + xw)**n, W))),
)
