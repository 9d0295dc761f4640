r"""Theorems on the limit of Cayley maps for growing order, and on the rate of convergence.

At order n, let ``v`` be 2n times the vector of the map, and ``ε = 1/(2n)²``. Then ``v = φ(α) u`` with

.. math::
    \varphi(\alpha) = \frac{\tan(\sqrt\varepsilon\,\alpha)}{\sqrt\varepsilon} \qquad
    \varphi' = 1 + \varepsilon\,\varphi^2

Hence α solves ``dα/dr = 1/(1 + ε r²)``, ``r = |v|``, with α = 0 at r = 0. The right side is analytic in ε and r where
``|ε| r² < 1``: for α < nπ/2, half the edge of the chart. The solution and all maps are analytic there too.

The theorems state these maps and their derivatives by ε, both at ε = 0, as dual numbers with ``ε² = 0``. Quaternion,
tensor and T therefore differ from the values of the exponential map by ``1/(4 n²)`` times the coefficient of ε, plus
terms of order ``1/n⁴``.
"""

from __future__ import annotations

import sympy

from .displacement_theorems import DOUBLE_ANGLE, EXPONENTIAL, UNIT, VERSOR_EXPONENTIAL, circular, pythagoras, solution
from .identity import Equation, Premise, definition
from .methods import determined, identity
from .notation import *
from .setting import Symbols

SCOPE = "1/(2n)^2 = epsilon, to first order"

HALF = sympy.cos(alpha / 2), sympy.sin(alpha / 2)
OF_LENGTH = sympy.cos(r / 2), sympy.sin(r / 2)
SPEED = 1 / (1 + epsilon * r**2)
"""Derivative dα/dr, equal to the factor of T along the axis."""

SYMBOLS = (OF_LENGTH[1], OF_LENGTH[0], r)


ANGLE = determined(
    "growing order: angle", Symbols(SYMBOLS), Equation(r, 0),
    (
        Equation(alpha, r - epsilon * r**3 / 3),
        Equation(HALF[0], OF_LENGTH[0] + epsilon * r**3 / 6 * OF_LENGTH[1]),
        Equation(HALF[1], OF_LENGTH[1] - epsilon * r**3 / 6 * OF_LENGTH[0]),
    ),
    *solution(alpha, 0, SPEED, r),
    *solution(HALF[0], 1, -HALF[1] * SPEED / 2, r),
    *solution(HALF[1], 0, HALF[0] * SPEED / 2, r),
    *(Premise(premise.equation.replaced({alpha: r})) for premise in circular(alpha / 2)),
    definition(rate(r), 1),
    scope=SCOPE,
)  # fmt: skip

T, dexp = structure("T"), structure("dexp")
AT_LENGTH = alpha, r
LENGTH = sympy.sin(r), sympy.cos(r)
ROTATION = exponential(r * skew(u))
ALONG = dyad(u, u)

MAPS = identity(
    "growing order: maps", Symbols(SYMBOLS, (u,), (r,)),
    (
        Equation(q_hat, exponential(r / 2 * u) * (1 - epsilon * r**3 / 6 * u)),
        Equation(R, ROTATION * (I - epsilon * r**3 / 3 * skew(u))),
        Equation(T, dexp - epsilon * r**2 / 3 * (ROTATION + 2 * ALONG)),
    ),
    definition(v, r * u),
    definition(f, 2 * HALF[1] * HALF[0] / r),
    definition(g, 2 * HALF[1] ** 2 / r**2),
    definition(h, (SPEED - f) / r**2),
    definition(q_hat, HALF[0] + HALF[1] / r * v),
    definition(R, I + f * skew(v) + g * skew(v) ** 2),
    definition(T, f * I + g * skew(v) + h * dyad(v, v)),
    definition(dexp, (LENGTH[0] * I + (1 - LENGTH[1]) * skew(u) + (r - LENGTH[0]) * ALONG) / r),
    ANGLE.premise(1), ANGLE.premise(2), EXPONENTIAL.premise(0, AT_LENGTH), VERSOR_EXPONENTIAL.premise(0, AT_LENGTH),
    *(DOUBLE_ANGLE.premise(place, AT_LENGTH) for place in (0, 1)), pythagoras(r / 2), UNIT,
    scope=SCOPE,
)  # fmt: skip

GROWING_ORDER = (ANGLE, MAPS)
