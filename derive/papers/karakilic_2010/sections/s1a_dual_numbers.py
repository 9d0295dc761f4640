"""Section 1, dual numbers and their functions: lines 23-41."""

from collections.abc import Callable
from typing import Any

from . import *

a1, a1_, b1, b1_ = real("a", 1), real("a", 1, star=True), real("b", 1), real("b", 1, star=True)
a, a_, a_hat, b_hat, c_hat = real("a"), real("a", star=True), *(hat(name, "dual number") for name in "abc")

NUMBERS = (
    equation("dual-number", "dual numbers and the dual unit", 23,
             both(equal(a_hat, a + e * a_), equal(e**2, 0), nonzero(e)), where=(let(a_hat, from_parts, a, a_),)),
    equation("addition", "sum of dual numbers", 25,
             equal(group(a1 + e * a1_) + group(b1 + e * b1_), group(a1 + b1) + e * (a1_ + b1_)),
             extract=shown(r"(a_{1} + ea_{1}^{*}) + (b_{1} + eb_{1}^{*}) = (a_{1} + b_{1}) + e(a_{1}^{*} + "
                           r"b_{1}^{*})")),
    equation("multiplication", "product of dual numbers", 26,
             equal((a1 + e * a1_) * (b1 + e * b1_), group(a1 * b1) + e * (a1 * b1_ + a1_ * b1)),
             extract=shown(r"(a_{1} + ea_{1}^{*}).(b_{1} + eb_{1}^{*}) = (a_{1}b_{1}) "
                           r"+ e(a_{1}b_{1}^{*} + a_{1}^{*}b_{1})")),
    equation("zero-divisors", "zero divisors", 28, equal(3 * e * group(5 * e), 15 * e**2, 0),
             extract=shown(r"3e.5e = 15e^2 = 0")),
    equation("ring", "the dual numbers are a commutative ring with identity", 28,
             both(equal(a_hat * b_hat, b_hat * a_hat),
                  equal(group(a_hat * b_hat) * c_hat, a_hat * group(b_hat * c_hat)),
                  equal(group(a_hat + b_hat) + c_hat, a_hat + group(b_hat + c_hat)),
                  equal(a_hat + b_hat, b_hat + a_hat),
                  equal(a_hat * (b_hat + c_hat), a_hat * b_hat + a_hat * c_hat), equal(1 * a_hat, a_hat))),
    equation("no-field", "the dual numbers are not a field", 28,
             both(nonzero(e), negated(equal(e * a_hat, 1))), because=equal((e * a_hat) * e, 0),
             remark="If e had the inverse â then e would be (e â) e = 0."),
)

# ---- functions ------------------------------------------------------------------------------------------------

DEGREE = 5
series = tuple(real("a", index) for index in range(DEGREE + 1))
x, x_, x_0, x_hat = real("x"), real("x", star=True), real("x", 0), hat("x", "dual number")
f, f_prime = (Symbol(name, "function", name, name) for name in ("f", "f'"))
a_k = Symbol("a of k", "function", "a", "a")
top = Symbol("top", "number", r"\infty", "∞")
angle, angle_hat = real("x", quantity="real angle"), hat("x", "angle")


def _coefficients(env: Env, *numbers: Any) -> Callable[[int], Any]:
    return lambda index: numbers[index]


def _function(env: Env, centre: Any, *numbers: Any) -> Callable[[Any], Any]:
    """Return the function with this power series about `centre`, by Horner's rule."""

    def value(point: Any) -> Any:
        result: Any = 0
        for number in reversed(numbers):
            result = result * (point - centre) + number
        return result

    return value


def _derivative(env: Env, centre: Any, *numbers: Any) -> Callable[[Any], Any]:
    return _function(env, centre, *(index * number for index, number in enumerate(numbers) if index))


SERIES = (let(a_k, _coefficients, *series), let(f, _function, x_0, *series), let(f_prime, _derivative, x_0, *series),
          let(top, lambda env: DEGREE))
power = x - x_0

FUNCTIONS = (
    equation("extension", "analytic functions of dual numbers", 32,
             equal(f(x + e * x_), summation(k, 0, top, coefficient(a_k, k) * (x + e * x_ - x_0) ** k),
                   summation(k, 0, top, coefficient(a_k, k) * power**k)
                   + e * summation(k, 0, top, k * coefficient(a_k, k) * power ** (k - 1) * x_),
                   f(x) + e * x_ * f_prime(x)),
             extract=shown(r"f(x + ex^*) = \sum_{k=0}^{\infty} a_k (x + ex^* - x_0)^k"
                           r"= \sum_{k=0}^{\infty} a_k (x - x_0)^k + e \sum_{k=0}^{\infty} k a_k (x - x_0)^{k-1} x^*"
                           r"= f(x) + ex^* f'(x)"),
             where=SERIES, condition=nonzero(power), also=lambda draw: {"x = x₀": dict.fromkeys((x, x_0), draw.real())},
             remark="Executed up to the fifth power with six free coefficients; the series is the same term by term. "
             "At x = x₀ the term k = 0 of the last sum has no value; it starts at k = 1."),
    equation("sine", "sine of a dual number", 39,
             equal(Sin(angle_hat), Sin(group(angle + e * x_)), Sin(angle) + e * x_ * Cos(angle)),
             extract=shown(r"Sin\hat{x} = Sin(x + ex^*) = Sinx + ex^*Cosx"),
             where=(let(angle_hat, from_parts, angle, x_),)),
    equation("cosine", "cosine of a dual number", 40,
             equal(Cos(angle_hat), Cos(group(angle + e * x_)), Cos(angle) - e * x_ * Sin(angle)),
             extract=shown(r"Cos\hat{x} = Cos(x + ex^*) = Cosx - ex^*Sinx"),
             where=(let(angle_hat, from_parts, angle, x_),)),
    equation("exponential", "exponential of a dual number", 41,
             equal(power_of_e(x_hat), power_of_e(x) + e * x_ * power_of_e(x)),
             extract=shown(r"e^{\hat{x}} = e^x + ex^*e^x"), where=(let(x_hat, from_parts, x, x_),)),
)

ENTRIES = (*NUMBERS, *FUNCTIONS)
