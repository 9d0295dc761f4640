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
    equation("1", "dual numbers", 47,
             both(remark(equal(a_, a + epsilon * a0), words(r"a, a^0 \in \mathbb{R}", "aa0R")),
                  equal(epsilon**2, 0), nonzero(epsilon)),
             extract="a _ = a + ε a 0 a , a 0 R , ε 2 = 0 , ε 0", where=PARTS),
    equation("magnitude-square", "square of the magnitude", 48, equal(norm(a_) ** 2, a_**2), extract="a _ 2 = a _ 2",
             because=equal(norm(a_) * norm(a_), a_**2)),
    equation("magnitude", "magnitude of a dual number", 48, equal(norm(a_), norm(a) + epsilon * sgn(a) * a0),
             extract="a _ = a + ε s g n a a 0", where=PARTS, condition=nonzero(a),
             remark="At Re a = 0 the square of the magnitude leaves its dual part open; (4) makes it ε |a⁰|."),
    equation("inverse-exists", "which dual numbers have an inverse", 48, iff(invertible, nonzero(Re(a_))), where=ZERO),
    equation("inverse", "inverse of a dual number", 48, equal(a_ ** (-1), 1 / a_, 1 / a - epsilon * (a0 / a**2)),
             extract="a _ 1 = 1 a _ = 1 a ε a 0 a 2", where=PARTS, claimed=nonzero(Re(a_)),
             stated=(48, "exists solely when R e a _ 0")),
    equation("zero-divisors", "zero divisors", 48, iff(divides_zero, zero(Re(a_))), where=ZERO),
    equation("commutative-ring", "dual numbers are a commutative ring with unit", 48,
             both(equal(a_ + b_, b_ + a_), equal(a_ * b_, b_ * a_), equal((a_ * b_) * c_, a_ * (b_ * c_)),
                  equal(a_ * (b_ + c_), a_ * b_ + a_ * c_), equal(1 * a_, a_))),
    equation("invertible-or-zero-divisor", "each element is one or the other", 48,
             iff(invertible, negated(divides_zero)), where=ZERO),
    equation("2", "functions of dual numbers", 50, equal(f(a_), f(a) + epsilon * a0 * prime(f)(a)),
             extract="f a _ = f a + ε a 0 f a", where=PARTS, claimed=nonzero(a),
             stated=(49, "Any differentiable function"),
             fixed_by="lines 51 and 52: the derivatives of cos, sin, tan and arctan",
             remark="Checked on functions made of products and quotients: any polynomial, 1/a, a power series."),
    equation("cosine", "cosine of a dual number", 51, equal(cos(angle_), cos(angle) - epsilon * a0 * sin(angle)),
             extract="c o s a _ = c o s a ε a 0 s i n a", where=PARTS),
    equation("sine", "sine of a dual number", 51, equal(sin(angle_), sin(angle) + epsilon * a0 * cos(angle)),
             extract="s i n a _ = s i n a + ε a 0 c o s a", where=PARTS),
    equation("power", "power of a dual number", 52,
             remark(equal(a_**n, a**n + epsilon * a0 * n * a ** (n - 1)), words(r"\forall n", "n")),
             extract="a _ n = a n + ε a 0 n a n 1 n", where=PARTS, fixed_by="(2), of which it is the case f(a) = aⁿ",
             because=equal((power_of_a + epsilon * a0 * n * power_of_a / a) * (a + epsilon * a0),
                           power_of_a * a + epsilon * a0 * (n + 1) * power_of_a),
             remark="The supporting identity is the step from n to n + 1."),
    equation("tangent", "tangent of a dual number", 52, equal(tan(angle_), tan(angle) + epsilon * (a0 / cos2(angle))),
             extract="t a n a _ = t a n a + ε a 0 c o s 2 a", where=PARTS, condition=nonzero(cos(angle))),
    equation("arc-tangent", "arc tangent of a dual number", 52,
             equal(arctan(a_), arctan(a) + epsilon * (a0 / (1 + a**2))),
             extract="a r c t a n a _ = a r c t a n a + ε a 0 1 + a 2", where=PARTS,
             because=equal(tan(angle + epsilon * (a0 / (1 + tan(angle) ** 2))), tan(angle) + epsilon * a0),
             remark="The supporting identity: the dual number on the right has the tangent a."),
)
