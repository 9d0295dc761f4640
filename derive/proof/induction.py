"""Theorems on p_n and q_n for every order, by induction: base, step and each residue decided exactly.

The definition is the recurrence p_1 = q_1 = 1, p_{n+1} = p_n - x q_n, q_{n+1} = p_n + q_n. In an induction step p and q
stand for p_n and q_n, and the statement at n for itself.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy
from sympy.polys.fields import field
from sympy.polys.rings import ring

from ..algebra import Coefficient, Quaternion
from .differential_field import Setting, p_slope, q_slope
from .identity import Check, Claim, Proof, decide

INDUCTION = "induction on n, residues in Q(n, x, p, q)"


def _next(x: Coefficient, p: Coefficient, q: Coefficient) -> tuple[Coefficient, Coefficient]:
    return p - x * q, p + q


def _power_of_complex() -> Iterator[Check]:
    _, X, p, q = ring("X,p,q", sympy.QQ_I)  # Gaussian rationals: the imaginary unit is a constant
    i = sympy.QQ_I(0, 1)
    following = _next(X**2, p, q)
    yield "base n = 1: (1 + iX) - (p_1 + i X q_1)", (1 + i * X) - (1 + i * X * 1)
    yield "step n -> n + 1", (p + i * X * q) * (1 + i * X) - (following[0] + i * X * following[1])


def _power_of_vector() -> Iterator[Check]:
    at = Setting()
    unit = Quaternion(at.one, at.v)
    yield from at.entries("base n = 1", (unit - Quaternion(at.one, at.v * 1)).vector)
    p, q = _next(at.x, at.p, at.q)
    step = Quaternion(at.p, at.v * at.q) * unit - Quaternion(p, at.v * q)
    yield "step n -> n + 1, scalar part", at.residue(step.scalar)
    yield from at.entries("step n -> n + 1, vector part", step.vector)


def _norm() -> Iterator[Check]:
    _, x, p, q = ring("x,p,q", sympy.QQ)
    following = _next(x, p, q)
    yield "base n = 1", 1 + x * 1 - (1 + x)
    yield "step n -> n + 1", following[0] ** 2 + x * following[1] ** 2 - (1 + x) * (p**2 + x * q**2)


def _addition() -> Iterator[Check]:
    _, x, p, q, r, s = ring("x,p,q,r,s", sympy.QQ)  # p_m, q_m, p_n, q_n

    def law(p: Coefficient, q: Coefficient) -> tuple[Coefficient, Coefficient]:
        return p * r - x * q * s, p * s + q * r

    for name, stated, recurrence in zip("pq", law(x**0, x**0), _next(x, r, s), strict=True):
        yield f"base m = 1, {name}_(1+n)", stated - recurrence
    for name, stated, recurrence in zip("pq", law(*_next(x, p, q)), _next(x, *law(p, q)), strict=True):
        yield f"step m -> m + 1, {name}_(m+1+n)", stated - recurrence
    doubled = [value.compose([(r, p), (s, q)]) for value in law(p, q)]
    yield "m = n: p_2n", doubled[0] - (p**2 - x * q**2)
    yield "m = n: q_2n", doubled[1] - 2 * p * q


def _pascal() -> Iterator[Check]:
    # the two ratios to C(n, k); the border k = n + 1 apart, where C(n, n + 1) = 0
    _, n, k = field("n,k", sympy.QQ)
    yield "Pascal's rule, 0 < k <= n", (n + 1) / (n + 1 - k) - (1 + k / (n - k + 1))
    yield "Pascal's rule, k = n + 1: C(n + 1, n + 1) - C(n, n + 1) - C(n, n)", 1 - 0 - 1


def _binomial_sums() -> Iterator[Check]:
    yield from _pascal()
    yield "base n = 1: p_1 - C(1, 0)", 1 - sympy.binomial(1, 0)
    yield "base n = 1: q_1 - C(1, 1)", 1 - sympy.binomial(1, 1)
    # the coefficients of x^j with C(n, 2j - 1), C(n, 2j), C(n, 2j + 1) and (-1)^j as symbols
    _, below, even, above, sign = ring("below,even,above,sign", sympy.QQ)
    p_j, q_j, q_before = sign * even, sign * above, -sign * below
    yield "step n -> n + 1, p: (-1)^j C(n + 1, 2j) by Pascal", sign * (even + below) - (p_j - q_before)
    yield "step n -> n + 1, q: (-1)^j C(n + 1, 2j + 1) by Pascal", sign * (above + even) - (p_j + q_j)


def _slopes() -> Iterator[Check]:
    at = Setting()
    n, x, p, q = at.symbols
    yield "base n = 1: p'", at.residue(p_slope(at.one, x, at.one, at.one))
    yield "base n = 1: q'", at.residue(q_slope(at.one, x, at.one, at.one))
    following = _next(x, p, q)
    rules = p_slope(n + 1, x, *following), q_slope(n + 1, x, *following)
    for name, value, rule in zip("pq", following, rules, strict=True):
        yield f"step n -> n + 1: {name}'", at.residue(at.slope(value) - rule)


def _brackets() -> Iterator[Check]:
    at = Setting()
    n, x, p, q = at.symbols
    dp, dq = p_slope(n, x, p, q), q_slope(n, x, p, q)
    power = p**2 + x * q**2
    yield "n (1+x)^(n-1) - p q - x c_n", at.residue(n * power / (1 + x) - p * q - x * (2 * (p * dq - q * dp)))
    yield "(1+x) q - n p - x d_n", at.residue((1 + x) * q - n * p - x * (q - 2 * dq - 2 * dp))


def _bracket_sums() -> Iterator[Check]:
    yield from _pascal()  # hence the binomial theorem for (1+x)^(n-1) and the sums for q_n, p_n and q_2n
    yield from _addition()  # hence p q = q_2n / 2, whose coefficients are (-1)^j C(2n, 2j + 1)/2
    _, n, below, even, above, sign, binomial, odd = ring("n,below,even,above,sign,binomial,odd", sympy.QQ)
    half = sympy.QQ(1, 2)
    yield "c_n, coefficient of x^0: n C(n-1, 0) - C(2n, 1)/2", n - (2 * n) * half
    yield "c_n, coefficient of x^j", n * binomial - half * (sign * odd) - (n * binomial - half * sign * odd)
    yield "d_n, coefficient of x^0: C(n, 1) - n C(n, 0)", n - n * 1
    stated = sign * (above - below - n * even)
    yield "d_n, coefficient of x^j", sign * above + (-sign) * below - n * (sign * even) - stated


def _values_at_zero() -> Iterator[Check]:
    _, n = field("n", sympy.QQ)
    one = n**0

    def values(n: Coefficient) -> tuple[Coefficient, ...]:  # p, q, p', q' at x = 0
        return n**0, n, n * (1 - n) / 2, -n * (n - 1) * (n - 2) / 6

    for name, stated, value in zip(("p", "q", "p'", "q'"), values(one), (1, 1, 0, 0), strict=True):
        yield f"base n = 1: {name}(0)", stated - value
    p, q, dp, dq = values(n)
    following = p, p + q, dp - q, dp + dq  # the recurrence and its derivative, at x = 0
    for name, stated, value in zip(("p", "q", "p'", "q'"), values(n + 1), following, strict=True):
        yield f"step n -> n + 1: {name}(0)", stated - value
    yield "c_n(0) = 2 (p q' - q p')", 2 * (p * dq - q * dp) - 2 * n * (n**2 - 1) / 3
    yield "d_n(0) = q - 2 q' - 2 p'", q - 2 * dq - 2 * dp - n * (n**2 + 2) / 3


def polynomial_theorems() -> tuple[Proof, ...]:
    """Prove, for every n, what the formulas need to know of p_n and q_n."""
    power = Claim("(1 + iX)^n = p_n + i X q_n, x = X^2", r"(1 + iX)^n = p_n + i X q_n", INDUCTION, (51, 52, 56))
    vector = Claim(
        "(1 + v)^n = p_n + q_n v for a dual vector v as quaternion", r"(1 + v)^n = p_n + q_n v", INDUCTION, (53, 54, 55)
    )
    norm = Claim("p_n^2 + x q_n^2 = (1+x)^n", r"p_n^2 + x q_n^2 = (1+x)^n", INDUCTION, (50,))
    addition = Claim(
        "p_(m+n) = p_m p_n - x q_m q_n, q_(m+n) = p_m q_n + q_m p_n; p_2n = p_n^2 - x q_n^2, q_2n = 2 p_n q_n",
        r"p_{m+n} = p_m p_n - x q_m q_n,\; q_{m+n} = p_m q_n + q_m p_n",
        "induction on m, residues in Q[x, p_m, q_m, p_n, q_n]",
    )
    sums = Claim(
        "p_n = sum (-1)^j C(n, 2j) x^j, q_n = sum (-1)^j C(n, 2j+1) x^j",
        r"p_n = \sum_j (-1)^j \binom{n}{2j} x^j,\; q_n = \sum_j (-1)^j \binom{n}{2j+1} x^j",
        "induction on n, coefficient by coefficient with Pascal's rule",
        (51, 52, 56),
    )
    slopes = Claim(
        "p_n' = n (p_n - q_n)/(2 (1+x)), q_n' = [n (p_n + x q_n)/(1+x) - q_n]/(2x)",
        r"p_n' = \frac{n (p_n - q_n)}{2 (1+x)},\; q_n' = \frac{1}{2x}\left[\frac{n (p_n + x q_n)}{1+x} - q_n\right]",
        INDUCTION,
    )
    brackets = Claim(
        "n (1+x)^(n-1) - p_n q_n = x c_n, c_n = 2 (p_n q_n' - q_n p_n'); "
        "(1+x) q_n - n p_n = x d_n, d_n = q_n - 2 q_n' - 2 p_n'; so x divides both brackets",
        r"n (1+x)^{n-1} - p_n q_n = 2 x (p_n q_n' - q_n p_n'),\; (1+x) q_n - n p_n = x (q_n - 2 q_n' - 2 p_n')",
        "residue in the differential field Q(n, x)(p, q)",
        (88, 89),
    )
    bracket_sums = Claim(
        "c_n = sum_(j>=1) [n C(n-1, j) - (-1)^j C(2n, 2j+1)/2] x^(j-1), "
        "d_n = sum_(j>=1) (-1)^j [C(n, 2j+1) - C(n, 2j-1) - n C(n, 2j)] x^(j-1)",
        r"c_n = \sum_{j \ge 1} \left[n \binom{n-1}{j} - \tfrac12 (-1)^j \binom{2n}{2j+1}\right] x^{j-1},\;"
        r"d_n = \sum_{j \ge 1} (-1)^j \left[\binom{n}{2j+1} - \binom{n}{2j-1} - n \binom{n}{2j}\right] x^{j-1}",
        "the binomial sums and doubling, coefficient by coefficient",
        (88, 89),
    )
    at_zero = Claim(
        "at x = 0: p_n = 1, q_n = n, p_n' = -n(n-1)/2, q_n' = -C(n, 3), c_n = 2n(n^2-1)/3, d_n = n(n^2+2)/3",
        r"p_n(0) = 1,\; q_n(0) = n,\; c_n(0) = \tfrac23 n (n^2-1),\; d_n(0) = \tfrac13 n (n^2+2)",
        "induction on n, residues in Q(n)",
    )
    table = (
        (power, _power_of_complex),
        (vector, _power_of_vector),
        (norm, _norm),
        (addition, _addition),
        (sums, _binomial_sums),
        (slopes, _slopes),
        (brackets, _brackets),
        (bracket_sums, _bracket_sums),
        (at_zero, _values_at_zero),
    )
    return tuple(decide(claim, checks) for claim, checks in table)
