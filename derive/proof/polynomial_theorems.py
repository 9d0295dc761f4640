"""Theorems for every n on p_n and q_n: powers, addition, derivatives, brackets, binomial sums.

The recurrence of :mod:`derive.maps.polynomials`, applied to symbols, defines p_n and q_n.
"""

from __future__ import annotations

import sympy

from ..algebra.cayley_pairs import FIRST, double, following, multiply
from ..maps import polynomials
from .coefficients import BINOMIAL, Coefficients
from .methods import determined, identity
from .notation import *
from .setting import Symbols
from .statement import Equation, Premise, definition
from .theorem import Theorem

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
SQUARE = definition(x, X**2)
UNIT = definition(i**2, -1)

POWERS = determined(
    "powers of 1 + iX", Symbols((i, p, q, X)), ONE,
    (Equation((1 + i * X) ** n, p + i * X * q),),
    *RECURRENCE, SQUARE, UNIT, *power(1 + i * X),
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
    """Return the derivative by x of an expression in x, p_n(x) and q_n(x)."""
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
    """Return the recurrences of cosine and sine of nθ."""
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
