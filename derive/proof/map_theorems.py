"""Theorems for every n on rotation and motion: tensor, quaternion, tangent operators.

Vectors are generic: v, its rate and rotated points have independent components.
"""

from __future__ import annotations

from .evaluation import defined, tangent, tangent_inv, tensor
from .methods import identity
from .notation import *
from .polynomial_theorems import NORM, ORIGIN, SLOPES, VECTOR_POWERS
from .setting import Symbols
from .statement import Equation, definition

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
