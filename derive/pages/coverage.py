"""Table of the theorems and the validation behind each kernel function, for docs/theorems.md.

Theorems prove the formula. Validation (:mod:`derive.codegen.validation`) executes the kernel's text on disk and
compares it with the formula, exactly on symbols or to 50 digits at seeded random screws.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, NamedTuple


class Coverage(NamedTuple):
    """Validation of one kernel function, names of the theorems behind its formula, and the part without a theorem.

    Validation compares the emitted function with its formula. "text" means constants, for functions without arguments.
    """

    validation: Literal["exact", "50 digits", "text"]
    theorems: tuple[str, ...]
    only_validated: str = ""


_SLOPES = ("slopes of the tangent operators", "second slopes of the tangent operators")
_PRODUCT = ("twist of a product", "twist", "rates of v")
_SMALL = ("exponential of a quaternion", "composition", "quaternion")
_BRANCHES = "the choice of axis, of sign and of the branch among the angles of one screw; half turns and translations"

_BRANCH = "the branch nearest v"
_PRINCIPAL = "the principal v of the product quaternion"
_SHADOW = ("shadow, even branch", "shadow, odd branch")

_NAMED: Mapping[str, Coverage] = {
    "quaternion": Coverage("exact", ("quaternion", "screw")),
    "tensor": Coverage("exact", ("tensor", "orthogonality", "screw", "exponential")),
    "pose": Coverage("exact", ("pose", "orthogonality")),
    "transform_point transform_line": Coverage("exact", ("pose", "line")),
    "inverse": Coverage("exact", ("orthogonality", "quaternion")),
    "tangent dcay": Coverage("exact", ("tangent", "twist", "axis", "determinant")),
    "tangent_inv dcay_inv": Coverage("exact", ("tangent_inv", "inverse", "rates of v")),
    "body_tangent": Coverage("exact", ("body twist", "axis", "determinant")),
    "body_tangent_inv": Coverage("exact", ("rates of v", "inverse")),
    "twist": Coverage("exact", ("twist", "quaternion rate")),
    "body_twist": Coverage("exact", ("body twist", "quaternion rate")),
    "rate": Coverage("exact", ("rates of v", "inverse")),
    "body_rate": Coverage("exact", ("rates of v", "body twist")),
    "tangent_dot body_tangent_dot twist_dot body_twist_dot": Coverage(
        "exact", (*_SLOPES, "rate of the tangent operator", "structure equation")
    ),
    "rate_dot body_rate_dot": Coverage("exact", (*_SLOPES, "rate of the inverse operator")),
    "twist_jacobian body_twist_jacobian cotangent_jacobian body_cotangent_jacobian": Coverage(
        "exact", (*_SLOPES, "Jacobian of the twist", "structure equation", "structure equation in the body")
    ),
    "rate_jacobian body_rate_jacobian": Coverage("exact", (*_SLOPES, "Jacobian of the rate")),
    "transition": Coverage("exact", ("transition, space twist given", "Jacobian of the rate", "inverse")),
    "body_transition": Coverage("exact", ("transition, body twist given", "Jacobian of the rate", "inverse")),
    "cotangent body_cotangent": Coverage("exact", ("tangent", "body twist")),
    "from_quaternion from_tensor": Coverage("50 digits", ("screw", "multiples of an angle"), _BRANCHES),
    "from_pose": Coverage("50 digits", ("screw", "multiples of an angle", "pose"), _BRANCHES),
    "from_screw": Coverage("50 digits", ("screw",), "tan of a dual angle"),
    "to_screw": Coverage("50 digits", ("screw", "pose"), _BRANCHES),
    "angle to_exponential": Coverage("50 digits", ("screw", "axis"), "the angle of a length"),
    "from_exponential": Coverage("50 digits", ("screw",), "tan of a dual angle, whole turns beyond the edge"),
    "shadow": Coverage("50 digits", ("Moebius step", *_SHADOW), "the axis and its sign"),
    "shadow_jacobian": Coverage("50 digits", (*_SHADOW, "axis", "rates of v"), "the axis and its sign"),
    "principal": Coverage("50 digits", _SHADOW, _BRANCHES),
    "adjoint": Coverage("exact", ("tensor", "pose", "line")),
    "transform_point_jacobians": Coverage("exact", ("pose", "line", "twist")),
    "transform_line_jacobians": Coverage("exact", ("line", "twist")),
    "between": Coverage("50 digits", ("composition", "quaternion"), _PRINCIPAL),
    "retract body_retract": Coverage("50 digits", _SMALL, _BRANCH),
    "retract_jacobians body_retract_jacobians": Coverage("50 digits", (*_SMALL, *_PRODUCT), _BRANCH),
    "local body_local": Coverage("50 digits", _SMALL, "the principal angle"),
    "local_jacobians body_local_jacobians": Coverage("50 digits", (*_SMALL, *_PRODUCT), "the principal angle"),
    "interpolate": Coverage("50 digits", _SMALL, "the shorter way, and the branch that is followed from v1"),
    "compose_jacobians between_jacobians": Coverage("50 digits", _PRODUCT, _PRINCIPAL),
    "compose": Coverage("50 digits", ("composition", "quaternion"), _PRINCIPAL),
    "singular_angles": Coverage("text", ("determinant", "multiples of an angle")),
}
"""Coverage by names of kernel functions."""

ROWS = {tuple(names.split()): covered for names, covered in _NAMED.items()}
"""Coverage by the functions that share it."""

COVERAGE = {name: covered for names, covered in ROWS.items() for name in names}
"""Coverage by kernel function."""
