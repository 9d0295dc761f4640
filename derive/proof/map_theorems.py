"""Theorems for every n on p_n and q_n, and on rotation and motion: tensor, quaternion, tangent operators.

The recurrence of :mod:`derive.maps.polynomials`, applied to symbols, defines p_n and q_n. Vectors are generic: v, its
rate and rotated points have independent components.
"""

from __future__ import annotations

import sympy

from ..algebra.arithmetic import FIRST, double, following, multiply
from ..maps import polynomials
from .coefficients import BINOMIAL, Coefficients
from .evaluation import defined, tangent, tangent_inv, tensor
from .identity import Equation, Premise, definition
from .methods import Theorem, determined, identity
from .notation import *
from .setting import Symbols

ONE = Equation(n, 1)
"""Index at the start of sequences."""


def recurring(
    index: sympy.Expr, *sequences: tuple[sympy.Expr, sympy.Expr | int, sympy.Expr], first: int = 1
) -> tuple[Premise, ...]:
    """Return definitions of sequences by first term and recurrence."""
    return tuple(
        definition(Shifted(term, index, place), value)
        for term, start, following in sequences
        for place, value in ((first, start), (index + 1, following))
    )


def pairs(index: sympy.Expr, p_n: sympy.Expr, q_n: sympy.Expr, at: sympy.Expr) -> tuple[Premise, ...]:
    """Return the recurrence of p and q at a given x, CP23 (56)."""
    after = following((p_n, q_n), at)
    return recurring(index, *zip((p_n, q_n), FIRST, after, strict=True))


def power(base: sympy.Expr) -> tuple[Premise, ...]:
    """Return the recurrence of ``base^n``."""
    return recurring(n, (base**n, base, base * base**n))


RECURRENCE = pairs(n, p, q, x)
UNIT = definition(i**2, -1)

POWERS = determined(
    "powers of 1 + iX", Symbols((i, p, q, X)), ONE,
    (Equation((1 + i * X) ** n, p + i * X * q),),
    *RECURRENCE, definition(x, X**2), UNIT, *power(1 + i * X),
)  # fmt: skip
VECTOR_POWERS = determined(
    "powers of 1 + v", Symbols((p, q), (v,)), ONE,
    (Equation((1 + v) ** n, p + q * v),),
    *RECURRENCE, definition(x, dot(v, v)), *power(1 + v),
)  # fmt: skip
NORM = determined(
    "norm", Symbols((p, q, x)), ONE,
    (Equation((1 + x) ** n, p**2 + x * q**2),),
    *RECURRENCE, *power(1 + x),
)  # fmt: skip
NEXT_SUM = zip((p_sum, q_sum), following((p, q), x), following((p_sum, q_sum), x), strict=True)
ADDITION = determined(
    "addition", Symbols((p_m, q_m, p, q, x)), Equation(m, 1),
    tuple(map(Equation, (p_sum, q_sum), multiply((p_m, q_m), (p, q), x))),
    *pairs(m, p_m, q_m, x), *recurring(m, *NEXT_SUM),
)  # fmt: skip
TWICE = ((m, n), (p_m, p), (q_m, q), (p_sum, p_double), (q_sum, q_double))
DOUBLING = identity(
    "doubling", Symbols((p, q, x)),
    tuple(map(Equation, (p_double, q_double), double((p, q), x))),
    *(ADDITION.premise(place, *TWICE) for place in (0, 1)),
)  # fmt: skip


def _slope(e: sympy.Expr) -> sympy.Expr:
    return e.diff(x) + e.diff(p) * prime(p) + e.diff(q) * prime(q)


_SLOPES = zip((prime(p), prime(q)), (0, 0), map(_slope, following((p, q), x)), strict=True)
SLOPES = determined(
    "slopes", Symbols((p, q, x, n), free=(x,)), ONE,
    (
        Equation(prime(p), n * (p - q) / (2 * (1 + x))),
        Equation(prime(q), (n * (p + x * q) / (1 + x) - q) / (2 * x)),
    ),
    *RECURRENCE, *recurring(n, *_SLOPES),
)  # fmt: skip
AT_ZERO = tuple(Shifted(term, x, 0) for term in (p, q, prime(p), prime(q)))
_NEXT_AT_ZERO = (e.xreplace({x: sympy.Integer(0)} | dict(zip((p, q, prime(p), prime(q)), AT_ZERO, strict=True)))
                 for e in (*following((p, q), x), *map(_slope, following((p, q), x))))
ORIGIN = determined(
    "values at x = 0", Symbols((n,)), ONE,
    (
        Equation(AT_ZERO[0], 1, wrong=sympy.Integer(0)),
        Equation(AT_ZERO[1], n, wrong=sympy.Integer(0)),
        Equation(AT_ZERO[2], -n * (n - 1) / 2),
        Equation(AT_ZERO[3], -n * (n - 1) * (n - 2) / 6),
    ),
    *recurring(n, *zip(AT_ZERO, (*FIRST, 0, 0), _NEXT_AT_ZERO, strict=True)),
)  # fmt: skip
BRACKETS_AT_ZERO = identity(
    "brackets at x = 0", Symbols((n,)),
    tuple(map(Equation, polynomials.brackets_of(*AT_ZERO), (2 * n * (n**2 - 1) / 3, n * (n**2 + 2) / 3))),
    *ORIGIN.given(),
)  # fmt: skip
BRACKETS = identity(
    "brackets", Symbols((p, q, x, n), free=(x,)),
    (Equation(n * (1 + x) ** (n - 1) - p * q, x * c), Equation((1 + x) * q - n * p, x * d)),
    *map(definition, (c, d), polynomials.brackets_of(p, q, prime(p), prime(q))), *SLOPES.given(), *NORM.given(),
)  # fmt: skip


def _series(coefficient: sympy.Expr, exponent: sympy.Expr = j, first: int = 0) -> sympy.Sum:
    return sympy.Sum(coefficient * x**exponent, (j, first, sympy.oo))


choose = sympy.binomial
SIGN = sympy.Integer(-1) ** j
SUMS = Theorem(
    "binomial sums",
    (
        Equation(p, _series(SIGN * choose(n, 2 * j)), (51, 63)),
        Equation(q, _series(SIGN * choose(n, 2 * j + 1)), (52, 64)),
    ),
    (*RECURRENCE, BINOMIAL),
    Coefficients(),
)
BINOMIAL_THEOREM = Theorem(
    "binomial theorem",
    (Equation((1 + x) ** n, _series(choose(n, j))),),
    (*recurring(n, ((1 + x) ** n, 1, (1 + x) * (1 + x) ** n), first=0), BINOMIAL),
    Coefficients(first=0),
)
BRACKET_SUMS = Theorem(
    "binomial sums of the brackets",
    (
        Equation(c, _series(n * choose(n - 1, j) - SIGN * choose(2 * n, 2 * j + 1) / 2, j - 1, 1)),
        Equation(d, _series(SIGN * (choose(n, 2 * j + 1) - choose(n, 2 * j - 1) - n * choose(n, 2 * j)), j - 1, 1)),
    ),
    (
        *BRACKETS.given(), *SUMS.given(), SUMS.premise(1, (n, 2 * n), (q, q_double)), DOUBLING.premise(1),
        BINOMIAL_THEOREM.premise(0, (n, n - 1)), BINOMIAL,
    ),
    Coefficients(),
)  # fmt: skip
COSINE, SINE = sympy.cos(n * theta), sympy.sin(n * theta)
TURN, RISE = sympy.cos(theta), sympy.sin(theta)


def turning(angle: sympy.Symbol) -> tuple[Premise, ...]:
    cosine, sine, turn, rise = sympy.cos(n * angle), sympy.sin(n * angle), sympy.cos(angle), sympy.sin(angle)
    return recurring(n, (cosine, turn, turn * cosine - rise * sine), (sine, rise, rise * cosine + turn * sine))


ANGLES = determined(
    "multiples of an angle", Symbols((COSINE, SINE, TURN, RISE), free=(TURN, RISE)), ONE,
    (Equation(p, COSINE / TURN**n), Equation(q, SINE * TURN / (RISE * TURN**n))),
    *RECURRENCE, definition(x, (RISE / TURN) ** 2), *turning(theta),
)  # fmt: skip

POLYNOMIAL_THEOREMS = (
    POWERS, VECTOR_POWERS, NORM, ADDITION, DOUBLING, SLOPES, ORIGIN, BRACKETS_AT_ZERO, BRACKETS, SUMS,
    BINOMIAL_THEOREM, BRACKET_SUMS, ANGLES,
)  # fmt: skip
"""Theorems on p_n and q_n, each after the theorems it uses."""


SQUARE = definition(dot(v, v), x)
ORIGIN_P, ORIGIN_Q = ORIGIN.premise(0), ORIGIN.premise(1)
ROOT = (1 + x) ** (n / 2)
QUATERNION = definition(q_hat, (p + q * v) / ROOT, (50, 55), wrong=(p + 2 * q * v) / ROOT)
ROOT_SLOPE = definition(prime(ROOT), n * ROOT / (2 * (1 + x)))
MOTION = (definition(rate(v), v_dot), definition(rate(x), 2 * dot(v, v_dot)), SQUARE, *SLOPES.given(), ORIGIN_P)
SCALARS = (p, q, x, n)
AT_V, MOVING = Symbols(SCALARS, (v,), (x,)), Symbols(SCALARS, (v, v_dot), (x,))

POWER = (1 + x) ** n
F, G, BRACKET = 2 * p * q / POWER, 2 * q**2 / POWER, 2 * (n * (1 + x) ** (n - 1) - p * q)
"""Coefficients as printed in CP23."""
BODY = definition(omega_body, transpose(R) * omega)
STRETCHED, INVERSE_BRACKET = 2 * n / (1 + x) * v, ((1 + x) * q - n * p) / (2 * n * x * q)
TENSOR, TANGENT, INVERSE = defined(R, tensor), defined(dcay, tangent), defined(dcay_inv, tangent_inv, numbers=(89,))

TWIST = identity(
    "twist", MOVING,
    (Equation(omega, dcay * rate(v), (86,)), Equation(rate(R), skew(omega) * R, (70,))),
    TENSOR, TANGENT, definition(omega, vect(rate(R) * transpose(R))), *MOTION,
)  # fmt: skip
MAP_THEOREMS = (
    identity(
        "tensor", AT_V,
        (Equation(R, I + F * skew(v) + G * skew(v) ** 2, (57,)),),
        TENSOR, SQUARE, *NORM.given(), ORIGIN_P,
    ),
    identity(
        "orthogonality", AT_V,
        (Equation(R * transpose(R), I, (13, 72, 73)), Equation(det(R), 1, (13, 73))),
        TENSOR, SQUARE, ORIGIN_P,
    ),
    identity(
        "quaternion", Symbols(SCALARS, (v, point), (x,)),
        (
            Equation(q_hat, (1 + v) ** n / ROOT, (53,)),
            Equation(q_hat * conjugate(q_hat), 1),
            Equation(q_hat * point * conjugate(q_hat), R * point),
        ),
        QUATERNION, TENSOR, SQUARE, *NORM.given(), *VECTOR_POWERS.given(), ORIGIN_P,
    ),
    identity(
        "tangent", AT_V,
        (Equation(dcay, F * I + G * skew(v) + BRACKET / (x * POWER) * dyad(v, v), (88,)),),
        TANGENT, *NORM.given(), ORIGIN_P,
    ),
    identity(
        "tangent_inv", AT_V,
        (Equation(dcay_inv, p / (2 * q) * I - skew(v) / 2 + INVERSE_BRACKET * dyad(v, v), (89,)),),
        INVERSE, ORIGIN_Q,
    ),
    identity(
        "inverse", AT_V,
        (Equation(dcay * dcay_inv, I), Equation(dcay_inv * dcay, I)),
        TANGENT, INVERSE, SQUARE, ORIGIN_P, ORIGIN_Q,
    ),
    identity(
        "axis", AT_V,
        (Equation(dcay * v, STRETCHED), Equation(transpose(dcay) * v, STRETCHED)),
        TANGENT, SQUARE, ORIGIN_P,
    ),
    identity(
        "determinant", AT_V,
        (Equation(det(dcay), 8 * n * q**2 / (1 + x) ** (n + 1)),),
        TANGENT, SQUARE, *NORM.given(), ORIGIN_P,
    ),
    TWIST,
    identity(
        "body twist", MOVING,
        (
            Equation(transpose(dcay), transpose(R) * dcay),
            Equation(omega_body, transpose(dcay) * rate(v), (86,)),
            Equation(rate(R), R * skew(omega_body), (74,)),
        ),
        TENSOR, TANGENT, TWIST.premise(0), BODY, *MOTION,
    ),
    identity(
        "quaternion rate", MOVING,
        (Equation(rate(q_hat), omega * q_hat / 2, (75,)), Equation(rate(q_hat), q_hat * omega_body / 2, (76,))),
        TENSOR, TANGENT, QUATERNION, TWIST.premise(0), BODY, *MOTION, ROOT_SLOPE,
    ),
    identity(
        "rates of v", MOVING,
        (
            Equation(rate(v), dcay_inv * omega, (87, 90)),
            Equation(rate(v), transpose(dcay_inv) * omega_body, (87, 91)),
        ),
        TENSOR, TANGENT, INVERSE, TWIST.premise(0), BODY, *MOTION[:3], ORIGIN_P, ORIGIN_Q,
    ),
)  # fmt: skip
