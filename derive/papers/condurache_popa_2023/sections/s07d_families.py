"""Section 7, five families of parameterizations with their quaternions, tensors and limits: lines 317-340."""

from collections.abc import Callable
from typing import Any

from ....maps.named import scaled, sine
from ....maps.sine import Breusing
from ..definitions import cayley_maps, orders
from . import *
from .general_order import *
from .s07c_parameterizations import W, xw

alpha_vector = vector("α", r"\alpha")
screw = Symbol("screw quaternion", "quaternion", r"\underline{\hat{\mathbf{q}}}", "q^")
P, Q = Symbol("P_n", "function", "P_n", "Pn"), Symbol("Q_n", "function", "Q_n", "Qn")
c, x_breusing = Symbol("c", "scale", "c", "c"), Symbol("x", "number", "x", "x")
one, two = (let(Symbol(f"order {i}", "number", str(i), str(i)), orders.at_order(i, lambda env, i: i)) for i in (1, 2))


def family(definition: Callable[..., Any], order: Definition | None) -> tuple[Definition, ...]:
    """Return the definitions of a family's v and of the factors a(v) at which (59) gives the displacement."""
    of_order = order.symbol if order else n
    arguments = (alpha, u) if order else (n, alpha, u)
    return (*((order,) if order else ()), let(v, definition, *arguments), let(screw, screw_quaternion, alpha, u),
            let(a, cayley_maps.function_of(cayley_maps.scales), of_order, screw, v), *SCREW_OF_V)


NORMAL = (*SCREW, *family(lambda env, n, *screw: n * cayley_maps.at_fraction(scaled)(env, n, *screw), None),
          let(w, cayley_maps.rodrigues_vector, n, alpha, u), let(alpha_vector, multiple, alpha, u))
pw, qw, power = p(norm(w)), q(norm(w)), (1 + xw) ** n
R_by_w, R_corrected = rotation_by(norm(w), power, V), rotation_by(norm(w), power, W)
reachable = finite(alpha / (2 * n))

FIRST = (
    equation("normal-vector", both(equal(v, 2 * n * tan(alpha / (2 * n)) * u), equal(a(v), 2 * n)), where=NORMAL,
             condition=reachable),
    equation("normal-quaternion", equal(pm(q_hat), 1 / root(power) * (pw + qw * v)), where=NORMAL, condition=reachable,
             corrected=equal(pm(q_hat), 1 / root(power) * (pw + qw * w))),
    equation("normal-w", equal(w, v / (2 * n)), where=NORMAL, condition=reachable),
    equation("normal-tensor", equal(R, R_by_w), where=NORMAL, condition=reachable, corrected=equal(R, R_corrected)),
    equation("limit-quaternion", equal(limit(n, (2 * n + v)**n / root((4 * n**2 + x)**n)), exp(alpha_vector / 2)),
             where=NORMAL),
    equation("limit-tensor", equal(limit(n, R_by_w), exp(skew(alpha_vector))), where=NORMAL,
             corrected=equal(limit(n, R_corrected), exp(skew(alpha_vector)))),
)

forward_2, forward_4, forward_n = (positive(Re(cos(alpha / m))) for m in (2, 4, 2 * n))
ORTHOGRAPHIC = family(cayley_maps.member(sine(1)), one)
LAMBERT = family(cayley_maps.member(sine(2)), two)
SECOND = (
    equation("orthographic-vector", both(equal(v, sin(alpha / 2) * u), equal(a(v), root(1 - x))), where=ORTHOGRAPHIC,
             condition=forward_2),
    equation("orthographic-quaternion", equal(pm(q_of(v)), root(1 - x) + v), where=ORTHOGRAPHIC, condition=forward_2),
    equation("orthographic-tensor", equal(R_of(v), I + 2 * root(1 - x) * V + 2 * V**2), where=ORTHOGRAPHIC,
             condition=forward_2),
    equation("lambert-vector", both(equal(v, sin(alpha / 4) * u), equal(a(v), root(1 - x))), where=LAMBERT,
             condition=forward_4),
    equation("lambert-quaternion", equal(pm(q_of(v)), 1 - 2 * x + 2 * root(1 - x) * v), where=LAMBERT,
             condition=forward_4),
    equation("lambert-tensor", equal(R_of(v), I + 4 * root(1 - x) * (1 - x) * V + 8 * (1 - x) * V**2), where=LAMBERT,
             condition=forward_4, corrected=equal(R_of(v), I + 4 * root(1 - x) * (1 - 2 * x) * V + 8 * (1 - x) * V**2)),
)

w_two = vector("w of order 2", "w", "w")
image_two = Symbol("image of w", "quaternion", r"\mathrm{cay} \underline{\mathbf{w}}", "cayw")
BREUSING = (*family(cayley_maps.member(Breusing()), two), let(x_breusing, lambda env, c: (1 - c * c) / c, c),
            let(w_two, cayley_maps.rodrigues_vector, two.symbol, alpha, u),
            let(image_two, orders.cayley, two.symbol, w_two))
ANY_FACTOR = (two, let(a, cayley_maps.constant, a_value),
              let(q_of, cayley_maps.function_of(cayley_maps.modified), two.symbol, a_value, v),
              let(R_of, cayley_maps.function_of(cayley_maps.modified_tensor), two.symbol, a_value, v))
factor = equal(a(v), root((root(4 + norm(v) ** 4) - x) / 2))
FOURTH = (
    equation("breusing-vector",
             (Reading(both(equal(v, root(tan(alpha / 4) * cot(alpha / 4)) * u), factor), "root of the product"),
              Reading(both(equal(v, tan(alpha / 4) * cot(alpha / 4) * u), factor), "product without a root")),
             where=BREUSING, condition=forward_4,
             corrected=both(equal(v, sin(alpha / 4) / root(cos(alpha / 4)) * u), factor),
             because=both(equal(c * x_breusing, 1 - c**2), equal(4 + x_breusing**2, (x_breusing + 2 * c)**2),
                          equal(cos(alpha / 4) * tan(alpha / 4), sin(alpha / 4)), equal(w_two, tan(alpha / 4) * u),
                          equal(image_two, screw)),
             argument="the remark"),
    equation("breusing-quaternion", equal(pm(q_of(v)), ((a**2)(v) - x) / (a(v)**2 + x) + 2 * a(v) / (a(v)**2 + x) * v),
             where=ANY_FACTOR),
    equation("breusing-tensor",
             equal(R_of(v),
                   I + 4 * a(v) * ((a**2)(v) - x) / (a(v)**2 + x)**2 * V + 8 * (a**2)(v) / (a(v)**2 + x)**2 * V**2),
             where=ANY_FACTOR),
)

SINES = (
    *family(cayley_maps.at_fraction(sine), None), let(P, cayley_maps.powers(0), n), let(Q, cayley_maps.powers(1), n),
)
FIFTH = (
    equation("sine-vector", both(equal(v, sin(alpha / (2 * n)) * u), equal(a(v), root(1 - x))), where=SINES,
             condition=forward_n),
    equation("sine-quaternion", equal(pm(q_of(v)), (root(1 - x) + v)**n, P(norm(v)) + Q(norm(v)) * v), where=SINES,
             condition=forward_n),
    equation("sine-tensor", equal(R_of(v), I + 2 * P(norm(v)) * Q(norm(v)) * V + 2 * (Q**2)(norm(v)) * V**2),
             where=SINES, condition=forward_n),
    equation("sine-P", equal(P(norm(v)), root((1 - x)**n) * p(norm(v) / root(1 - x))), where=SINES,
             condition=nonzero(Re(1 - x))),
    equation("sine-Q", equal(Q(norm(v)), root((1 - x)**(n - 1)) * q(norm(v) / root(1 - x))), where=SINES,
             condition=nonzero(Re(1 - x))),
)

ENTRIES = (*FIRST, *SECOND, *FOURTH, *FIFTH)
