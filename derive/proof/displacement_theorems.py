"""Theorems on displacements: screws, poses, points and lines, shadows, composition, rates at a change of branch.

A step between branches keeps the twist. With ``v = r u`` and ``v_k = r_k u``, rates transform by ``v_k' = S_k v'``,
where ``S_k = (r_k/r) (I − u⊗u) + (dr_k/dr) u⊗u``. Momenta transform by the inverse transpose. The twist of a product
of displacements gives the Jacobians of composition. The papers lack these theorems.
"""

from __future__ import annotations

import sympy

from .evaluation import defined, tangent, tensor
from .identity import Equation, Premise, definition
from .map_theorems import ANGLES, ONE, ORIGIN_P, QUATERNION, ROOT, SLOPES, SQUARE, TANGENT, TENSOR, pairs, turning
from .methods import Theorem, determined, identity
from .notation import *
from .setting import Symbols

ZERO = Equation(alpha, 0)
UNIT = definition(dot(u, u), 1)


def circular(angle: sympy.Expr) -> tuple[Premise, ...]:
    """Return initial values and differential equations of cosine and sine of a multiple of α."""
    speed, cosine, sine = angle / alpha, sympy.cos(angle), sympy.sin(angle)
    return (
        definition(Shifted(cosine, alpha, 0), 1),
        definition(Shifted(sine, alpha, 0), 0),
        definition(rate(cosine), -speed * sine),
        definition(rate(sine), speed * cosine),
    )


def pythagoras(angle: sympy.Expr) -> Premise:
    """Return the premise ``sin² + cos² = 1``."""
    return definition(sympy.sin(angle) ** 2 + sympy.cos(angle) ** 2, 1)


FULL, HALF, PART = ((sympy.sin(angle), sympy.cos(angle)) for angle in (alpha, alpha / 2, alpha / (2 * n)))
DOUBLE_ANGLE = determined(
    "double angle", Symbols(HALF), ZERO,
    (Equation(FULL[1], 1 - 2 * HALF[0] ** 2), Equation(FULL[0], 2 * HALF[0] * HALF[1])),
    *circular(alpha), *circular(alpha / 2)[1:], pythagoras(alpha / 2),  # the initial value of cos(α/2) is not needed
)  # fmt: skip


def solution(
    term: sympy.Expr, start: sympy.Expr | int, law: sympy.Expr, variable: sympy.Expr = alpha
) -> tuple[Premise, ...]:
    """Return the initial value and the differential equation of a function of a variable."""
    return definition(Shifted(term, variable, 0), start), definition(rate(term), law)


ROTATION = exponential(alpha * skew(u))
EXPONENTIAL = determined(
    "exponential", Symbols(FULL, (u,)), ZERO,
    (Equation(ROTATION, I + FULL[0] * skew(u) + (1 - FULL[1]) * skew(u) ** 2, (17,)),),
    *solution(ROTATION, I, skew(u) * ROTATION), *circular(alpha), UNIT,
)  # fmt: skip
VERSOR = exponential(alpha / 2 * u)
VERSOR_EXPONENTIAL = determined(
    "exponential of a quaternion", Symbols(HALF, (u,)), ZERO,
    (Equation(VERSOR, HALF[1] + u * HALF[0], (23,)),),
    *solution(VERSOR, 1, u / 2 * VERSOR), *circular(alpha / 2), UNIT,
)  # fmt: skip
TURNED_ROOT = sympy.cos(beta) - r * sympy.sin(beta)
MOEBIUS = definition(r_k, (r * sympy.cos(beta) + sympy.sin(beta)) / TURNED_ROOT)
_FREE = (r, sympy.sin(beta), sympy.cos(beta))
TURNED = determined(
    "Moebius step",
    Symbols((p, q, sympy.cos(n * beta), sympy.sin(n * beta), sympy.sin(beta), sympy.cos(beta), r), free=_FREE), ONE,
    (
        Equation(p_k, (p * sympy.cos(n * beta) - r * q * sympy.sin(n * beta)) / TURNED_ROOT**n),
        Equation(q_k, (p * sympy.sin(n * beta) + r * q * sympy.cos(n * beta)) / (r_k * TURNED_ROOT**n)),
    ),
    *pairs(n, p, q, r**2), *pairs(n, p_k, q_k, r_k**2), *turning(beta), MOEBIUS,
)  # fmt: skip
COMPOSITION = identity(
    "composition", Symbols((scalar, scalar_1, scalar_2), (vector, first, second)),
    (
        Equation(sandwich(scalar + vector), I + 2 * scalar * skew(vector) + 2 * skew(vector) ** 2, (24,)),
        Equation(
            sandwich((scalar_2 + second) * (scalar_1 + first)), sandwich(scalar_2 + second) * sandwich(scalar_1 + first)
        ),
    ),
    definition(scalar**2 + dot(vector, vector), 1),
)  # fmt: skip
FIRST_ORDER = identity(
    "composition at n = 1", Symbols((), (b_1, b_2), (b_1,)),
    (
        Equation(b, (b_1 + b_2 + cross(b_2, b_1)) / (1 - dot(b_1, b_2)), (45,)),
        Equation((1 + b_2) * (1 + b_1), (1 - dot(b_1, b_2)) * (1 + b)),
    ),
    definition(b, first_order(b_2, b_1)),
    scope="n = 1",
)  # fmt: skip
_DOT, _CROSS = dot(sigma_2, sigma_1), cross(sigma_2, sigma_1)
_ABOVE = (1 - dot(sigma_2, sigma_2)) * sigma_1 + (1 - dot(sigma_1, sigma_1)) * sigma_2 + 2 * _CROSS
SECOND_ORDER = identity(
    "composition at n = 2", Symbols((), (sigma_1, sigma_2), (sigma_1,)),
    (
        Equation(sigma, _ABOVE / ((1 - _DOT) ** 2 + dot(_CROSS, _CROSS)), (41,)),
        Equation(
            (1 + dot(sigma, sigma)) * (1 + sigma_2) ** 2 * (1 + sigma_1) ** 2,
            (1 + dot(sigma_2, sigma_2)) * (1 + dot(sigma_1, sigma_1)) * (1 + sigma) ** 2,
        ),
    ),
    definition(sigma, second_order(sigma_2, sigma_1)),
    scope="n = 2",
)  # fmt: skip
_QUATERNION, _UNIT_NORM = scalar + vector, definition(scalar**2 + dot(vector, vector), 1)
FIRST_INVERSE = identity(
    "inverse map at n = 1", Symbols((scalar,), (vector,), (scalar,)),
    (Equation((1 + dot(b, b)) * _QUATERNION**2, (1 + b) ** 2),),
    definition(b, vector / scalar), _UNIT_NORM, scope="n = 1",
)  # fmt: skip
SECOND_INVERSE = identity(
    "inverse map at n = 2", Symbols((scalar,), (vector,), (scalar,)),
    (Equation((1 + dot(sigma, sigma)) * _QUATERNION, (1 + sigma) ** 2),),
    definition(sigma, vector / (1 + scalar)), _UNIT_NORM, scope="n = 2",
)  # fmt: skip
CLOSED_AT = {1: (FIRST_INVERSE, FIRST_ORDER), 2: (SECOND_INVERSE, SECOND_ORDER)}
"""Theorems on closed forms of the inverse map and of composition, by order."""
LINE = identity(
    "line", Symbols((p, q, x, n), (v, point, along, rho), (x,)),
    (
        Equation(
            (I + epsilon * skew(rho)) * R * (along + epsilon * cross(point, along)),
            R * along + epsilon * cross(R * point + rho, R * along),
        ),
    ),
    TENSOR, SQUARE, ORIGIN_P,
)  # fmt: skip
_ON_AXIS = ((theta, alpha / (2 * n)),)
SCREW = identity(
    "screw", Symbols((*HALF, *PART), (u,), (PART[0],)),
    (
        Equation(q_hat, HALF[1] + u * HALF[0], (23, 37, 48)),
        Equation(R, I + FULL[0] * skew(u) + (1 - FULL[1]) * skew(u) ** 2, (17,)),
    ),
    definition(v, PART[0] / PART[1] * u), definition(x, dot(v, v)), UNIT, definition(ROOT, 1 / PART[1] ** n),
    QUATERNION, TENSOR, ANGLES.premise(0, *_ON_AXIS), ANGLES.premise(1, *_ON_AXIS), *DOUBLE_ANGLE.given(),
    pythagoras(alpha / 2), definition(Shifted(PART[1], alpha, 0), 1, wrong=sympy.Integer(0)),
)  # fmt: skip
"""Theorem on quaternion and tensor of v along the axis u, with the dual angle α."""
_FOLLOW = 2 * epsilon * dot(v, v_dual)
POSE = identity(
    "pose", Symbols((p, q, x, n), (v, v_dual), (x,)),
    (Equation(R_dual, (I + epsilon * skew(rho)) * Q, (14,)),),
    definition(V, v + epsilon * v_dual),
    definition(x_dual, dot(V, V)),
    definition(p_dual, p + _FOLLOW * prime(p)),
    definition(q_dual, q + _FOLLOW * prime(q)),
    defined(R_dual, tensor, (n, x_dual, p_dual, q_dual), V),
    definition(Q, real(R_dual)), TANGENT, definition(rho, dcay * v_dual), SQUARE, *SLOPES.given(), ORIGIN_P,
)  # fmt: skip
"""Theorem that R is the rotation Q followed by the translation dcay v°."""


def branch_step(sign: int) -> tuple[Premise, ...]:
    """Return the premises cos nβ = `sign` and sin nβ = 0 (sign 1 for even branches, −1 for odd), and p at x = 0."""
    cosine = definition(sympy.cos(n * beta), sign, wrong=sympy.Integer(0))
    return cosine, definition(sympy.sin(n * beta), 0), ORIGIN_P


def _shadow(sign: int) -> Theorem:
    """Return the theorem on shadows: a Moebius step by an angle β with nβ = kπ leaves R unchanged."""
    cosine, sine = sympy.cos(beta), sympy.sin(beta)
    return identity(
        f"shadow, {'even' if sign == 1 else 'odd'} branch", Symbols((p, q, sine, cosine, r), (u,), (r, sine, cosine)),
        (Equation(R_k, R),),
        defined(R, tensor, (n, r**2, p, q), r * u), defined(R_k, tensor, (n, r_k**2, p_k, q_k), r_k * u),
        *TURNED.given(), MOEBIUS, *branch_step(sign),
    )  # fmt: skip


DISPLACEMENT_THEOREMS = (
    DOUBLE_ANGLE, EXPONENTIAL, VERSOR_EXPONENTIAL, SCREW, POSE, LINE, TURNED, _shadow(1), _shadow(-1), COMPOSITION,
)  # fmt: skip


STEP = identity(
    "slope of a Moebius step",
    Symbols((sympy.sin(beta), sympy.cos(beta), r), free=(r, sympy.sin(beta), sympy.cos(beta))),
    (Equation(1 + r_k**2, (1 + r**2) / TURNED_ROOT**2), Equation(rate(r_k), 1 / TURNED_ROOT**2)),
    MOEBIUS, definition(rate(r), 1), pythagoras(beta),
)  # fmt: skip
_SIDES = tuple(side(angle) for angle in (beta, gamma) for side in (sympy.sin, sympy.cos))
BOTH, FURTHER = beta + gamma, sympy.cos(gamma) - r_k * sympy.sin(gamma)
BOTH_ROOT = sympy.cos(BOTH) - r * sympy.sin(BOTH)


def _transported(there: sympy.Expr, here: sympy.Expr, root: sympy.Expr) -> sympy.Expr:
    """Return the tensor S of a step from ``here u`` to ``there u``; `root` is the divisor of the step."""
    return there / here * (I - dyad(u, u)) + dyad(u, u) / root**2


def _transport(sign: int) -> Theorem:
    """Return the theorem that a step S_k between branches keeps the twist; S_kᵀ transforms momenta."""
    cosine, sine = sympy.cos(beta), sympy.sin(beta)
    return identity(
        f"transport, {'even' if sign == 1 else 'odd'} branch",
        Symbols((p, q, r_k, sine, cosine, r, n), (u,), (r, r_k, sine, cosine)),
        (Equation(dcay_k * transport, dcay),),
        definition(transport, _transported(r_k, r, TURNED_ROOT)),
        defined(dcay, tangent, (n, r**2, p, q), r * u), defined(dcay_k, tangent, (n, r_k**2, p_k, q_k), r_k * u),
        *TURNED.given(), STEP.premise(0), UNIT, *branch_step(sign),
    )  # fmt: skip


TWICE = identity(
    "transport, step by step", Symbols((r, *_SIDES), (u,), (r, *_SIDES)),
    (
        Equation(r_jk, (r * sympy.cos(BOTH) + sympy.sin(BOTH)) / BOTH_ROOT),
        Equation(
            _transported(r_jk, r, BOTH_ROOT), _transported(r_jk, r_k, FURTHER) * _transported(r_k, r, TURNED_ROOT)
        ),
    ),
    MOEBIUS,
    definition(r_jk, (r_k * sympy.cos(gamma) + sympy.sin(gamma)) / FURTHER),
    definition(sympy.cos(BOTH), sympy.cos(beta) * sympy.cos(gamma) - sympy.sin(beta) * sympy.sin(gamma)),
    definition(sympy.sin(BOTH), sympy.sin(beta) * sympy.cos(gamma) + sympy.cos(beta) * sympy.sin(gamma)),
    UNIT,
)  # fmt: skip
_TWO, _ONE = scalar_2 + second, scalar_1 + first


def _moving(scalar: sympy.Expr, vector: sympy.Expr, twist: sympy.Expr) -> tuple[Premise, ...]:
    """Return the premises ``q' = ω q/2``, CP23 (75), for scalar and vector part."""
    return (
        definition(rate(scalar), -dot(twist, vector) / 2),
        definition(rate(vector), (scalar * twist + cross(twist, vector)) / 2),
    )


PRODUCT = identity(
    "twist of a product", Symbols((scalar_2, scalar_1), (second, first, omega_1, omega_2)),
    (Equation(rate(_TWO * _ONE), (omega_2 + sandwich(_TWO) * omega_1) * _TWO * _ONE / 2),),
    *_moving(scalar_1, first, omega_1), *_moving(scalar_2, second, omega_2),
    definition(scalar_2**2 + dot(second, second), 1),
)  # fmt: skip
"""Theorem that implies ``T(v) v' = T(v2) v2' + R(v2) T(v1) v1'`` for ``R(v) = R(v2) R(v1)``."""

TRANSPORT_THEOREMS = (STEP, TWICE, _transport(1), _transport(-1), PRODUCT)
