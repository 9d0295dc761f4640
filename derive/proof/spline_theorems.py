r"""Theorems on splines of poses, whose factors have vectors ``v = λ(t) d``: the parts λ are C², and twists have a rate.

A part λ rises from 0 to 1 over three spans of four knots ``t_0 < … < t_3``. It is a polynomial λ_k in each span.
Neighbours, and the constants 0 and 1 at the ends, differ by a multiple of the cube of the distance from their knot.
Hence λ, λ̇ and λ̈ have no jump, for any knots.

The twist of a factor and the derivative of its twist are polynomials in λ̇ and λ̈ with functions of v that are as smooth
as φ. A sum of twists carried by poses is smooth where its terms are.
"""

from __future__ import annotations

import sympy

from .identity import Equation, definition
from .methods import Theorem, identity
from .notation import *
from .phi_premises import *
from .setting import Symbols

EVERY_SPLINE = "every spline"

time = sympy.Symbol("t")
KNOTS = t_0, t_1, t_2, t_3 = sympy.symbols("t_0:4")
PARTS = sympy.symbols("lambda_1:4")
part, part_1, part_2 = sympy.symbols("lambda lambdadot lambdaddot")
step = structure("d")


def pieces() -> tuple[sympy.Expr, ...]:
    """Return λ in its three spans: the integral of ``3 Q/(t_3 − t_0)`` with the quadratic B-spline Q of the knots."""
    lengths = t_1 - t_0, t_2 - t_1, t_3 - t_2
    shares = [(time - knot) / length for knot, length in zip(KNOTS, lengths)]
    early, late = (t_2 - t_1) / (t_2 - t_0), (t_2 - t_1) / (t_3 - t_1)
    last, whole = lengths[2] / (t_3 - t_1), t_3 - t_0
    u = shares[1]
    risen = (1 - early) * u + early * u**2 - (early + late) * u**3 / 3
    return (
        lengths[0] ** 2 / ((t_2 - t_0) * whole) * shares[0] ** 3,
        (1 - early) * lengths[0] / whole + 3 * lengths[1] / whole * risen,
        1 - lengths[2] * last * (1 - shares[2]) ** 3 / whole,
    )


def _of_parts() -> Theorem:
    """Return the theorem that neighbouring polynomials differ by a cube at their knot."""
    pairs = zip((0, *PARTS), (*PARTS, 1), KNOTS)
    claim = tuple(
        Equation(after - before, (time - knot) ** 3 / sympy.Mul(*(other - knot for other in KNOTS if other != knot)))
        for before, after, knot in pairs
    )
    given = (definition(symbol, piece) for symbol, piece in zip(PARTS, pieces()))
    return identity("spline: parts are C2", Symbols((time, *KNOTS), (), KNOTS), claim, *given, scope=EVERY_SPLINE)


def _of_factor() -> Theorem:
    """Return the theorem on the twist T v̇ of a factor and its derivative; v and v̇ are parallel, so ``g v × v̇ = 0``."""
    bend = part_2 * rho + RATE_SLOPE * dot(v, step) * part_1**2
    return identity(
        "spline: twist of a factor", Symbols((*SYMBOLS, part, part_1, part_2), (step,), (phi, phi_1)),
        (Equation(omega, part_1 * rho * step), Equation(rate(omega), bend * step)),
        definition(omega, f * rate(v) + h * dot(v, rate(v)) * v), *SCALARS[2:4], SCALARS[5],
        definition(v, part * step), definition(rate(part), part_1), definition(rate(part_1), part_2),
        definition(rate(x), 2 * part * part_1 * dot(step, step)), *OF_ANGLE, OF_PHI[0], *SQUARES, scope=EVERY_SPLINE,
    )  # fmt: skip


SPLINES = _of_parts(), _of_factor()
