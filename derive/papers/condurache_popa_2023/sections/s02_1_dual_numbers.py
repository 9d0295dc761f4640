"""Section 2.1, dual numbers: lines 46-52."""

from ....algebra import real_part
from ..definitions import dual_algebra
from . import *

a, a0, b, b0 = real("a"), Symbol("a0", "real", "a^0", "a0"), real("b"), Symbol("b0", "real", "b^0", "b0")
a_, b_, c_ = dual("a"), dual("b"), dual("c")
sgn = Symbol("sgn", "function", r"\operatorname{sgn}", "sgn")
f = Symbol("f", "smooth function", "f", "f")
angle = Symbol("angle", "real angle", "a", "a")
angle_ = Symbol("angle_", "dual number", r"\underline{a}", "a")
power_of_a = Symbol("a^n", "real", "a^n", "an")
divides_zero = proposition("a divides zero", r"$\underline{a}$ is a zero divisor")
invertible = proposition("a is invertible", r"$\underline{a}$ is invertible")
prime = define("derivative", "{0}'", "{0}'", ATOM, (ATOM,), lambda env, function: function.derivative)


PARTS = (
    let(a_, from_parts, a, a0), let(b_, from_parts, b, b0), let(angle_, from_parts, angle, a0),
    let(sgn, lambda env: lambda x: x / abs(x) if x != 0 else 0),
)
ZERO = (let(divides_zero, lambda env, a: env.field.same(real_part(a) ** 2, 0), a_),
        let(invertible, dual_algebra.multiplies_onto, a_))

ENTRIES = (
    equation("1",
             both(remark(equal(a_, a + epsilon * a0), words(r"a, a^0 \in \mathbb{R}", "aa0R")), equal(epsilon**2, 0),
                  nonzero(epsilon)),
             where=PARTS),
    equation("magnitude-square", equal(norm(a_) ** 2, a_**2), because=equal(norm(a_) * norm(a_), a_**2)),
    equation("magnitude", equal(norm(a_), norm(a) + epsilon * sgn(a) * a0), where=PARTS, condition=nonzero(a)),
    equation("inverse-exists", iff(invertible, nonzero(Re(a_))), where=ZERO),
    equation("inverse", equal(a_ ** (-1), 1 / a_, 1 / a - epsilon * (a0 / a**2)), where=PARTS, claimed=nonzero(Re(a_))),
    equation("zero-divisors", iff(divides_zero, zero(Re(a_))), where=ZERO),
    equation("commutative-ring",
             both(equal(a_ + b_, b_ + a_), equal(a_ * b_, b_ * a_), equal((a_ * b_) * c_, a_ * (b_ * c_)),
                  equal(a_ * (b_ + c_), a_ * b_ + a_ * c_), equal(1 * a_, a_))),
    equation("invertible-or-zero-divisor", iff(invertible, negated(divides_zero)), where=ZERO),
    equation("2", equal(f(a_), f(a) + epsilon * a0 * prime(f)(a)), where=PARTS, claimed=nonzero(a)),
    equation("cosine", equal(cos(angle_), cos(angle) - epsilon * a0 * sin(angle)), where=PARTS),
    equation("sine", equal(sin(angle_), sin(angle) + epsilon * a0 * cos(angle)), where=PARTS),
    equation("power", remark(equal(a_**n, a**n + epsilon * a0 * n * a ** (n - 1)), words(r"\forall n", "n")),
             where=PARTS,
             because=equal((power_of_a + epsilon * a0 * n * power_of_a / a) * (a + epsilon * a0),
                           power_of_a * a + epsilon * a0 * (n + 1) * power_of_a)),
    equation("tangent", equal(tan(angle_), tan(angle) + epsilon * (a0 / cos2(angle))), where=PARTS,
             condition=nonzero(cos(angle))),
    equation("arc-tangent", equal(arctan(a_), arctan(a) + epsilon * (a0 / (1 + a**2))), where=PARTS,
             because=equal(tan(angle + epsilon * (a0 / (1 + tan(angle) ** 2))), tan(angle) + epsilon * a0)),
)
