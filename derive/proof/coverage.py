"""Table of the theorems and the validation behind each kernel function, for docs/theorems.md.

Theorems prove the formula. Validation (:mod:`derive.codegen.validation`) executes the kernel's text on disk and
compares it with the formula, exactly on symbols or to 50 digits at seeded random screws.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, NamedTuple


class Coverage(NamedTuple):
    """Validation of one kernel function, names of the theorems behind its formula, and the part without a theorem.

    The validation compares the emitted function with its formula; it is "text" for constants without arguments.
    """

    validation: Literal["exact", "50 digits", "text"]
    theorems: tuple[str, ...]
    only_validated: str = ""


_TANGENT = ("tangent", "twist", "axis", "determinant")
_INVERSE = ("tangent_inv", "inverse", "rates of v")
_SLOPES = ("slopes of the tangent operators", "second slopes of the tangent operators")
_SECOND = (*_SLOPES, "rate of the tangent operator", "structure equation")
_SECOND_INVERSE = (*_SLOPES, "rate of the inverse operator")
_JACOBIAN = (*_SLOPES, "Jacobian of the twist", "structure equation", "structure equation in the body")
_JACOBIAN_INVERSE = (*_SLOPES, "Jacobian of the rate")
_PRODUCT = ("twist of a product", "twist", "rates of v")
_SMALL = ("exponential of a quaternion", "composition", "quaternion")
_BRANCHES = "the choice of axis, of sign and of the branch among the angles of one screw; half turns and translations"

COVERAGE: Mapping[str, Coverage] = {
    "quaternion": Coverage("exact", ("quaternion", "screw")),
    "tensor": Coverage("exact", ("tensor", "orthogonality", "screw", "exponential")),
    "pose": Coverage("exact", ("pose", "orthogonality")),
    "transform_point": Coverage("exact", ("pose", "line")),
    "transform_line": Coverage("exact", ("pose", "line")),
    "inverse": Coverage("exact", ("orthogonality", "quaternion")),
    "tangent": Coverage("exact", _TANGENT),
    "dcay": Coverage("exact", _TANGENT),
    "tangent_inv": Coverage("exact", _INVERSE),
    "dcay_inv": Coverage("exact", _INVERSE),
    "body_tangent": Coverage("exact", ("body twist", "axis", "determinant")),
    "body_tangent_inv": Coverage("exact", ("rates of v", "inverse")),
    "twist": Coverage("exact", ("twist", "quaternion rate")),
    "body_twist": Coverage("exact", ("body twist", "quaternion rate")),
    "rate": Coverage("exact", ("rates of v", "inverse")),
    "body_rate": Coverage("exact", ("rates of v", "body twist")),
    **{name: Coverage("exact", _SECOND) for name in ("tangent_dot", "body_tangent_dot", "twist_dot", "body_twist_dot")},
    **{name: Coverage("exact", _SECOND_INVERSE) for name in ("rate_dot", "body_rate_dot")},
    **{name: Coverage("exact", _JACOBIAN) for name in ("twist_jacobian", "body_twist_jacobian")},
    **{name: Coverage("exact", _JACOBIAN) for name in ("cotangent_jacobian", "body_cotangent_jacobian")},
    **{name: Coverage("exact", _JACOBIAN_INVERSE) for name in ("rate_jacobian", "body_rate_jacobian")},
    "cotangent": Coverage("exact", ("tangent", "body twist")),
    "body_cotangent": Coverage("exact", ("tangent", "body twist")),
    "from_quaternion": Coverage("50 digits", ("screw", "multiples of an angle"), _BRANCHES),
    "from_tensor": Coverage("50 digits", ("screw", "multiples of an angle"), _BRANCHES),
    "from_pose": Coverage("50 digits", ("screw", "multiples of an angle", "pose"), _BRANCHES),
    "from_screw": Coverage("50 digits", ("screw",), "tan of a dual angle"),
    "to_screw": Coverage("50 digits", ("screw", "pose"), _BRANCHES),
    "angle": Coverage("50 digits", ("screw", "axis"), "the angle of a length"),
    "to_exponential": Coverage("50 digits", ("screw", "axis"), "the angle of a length"),
    "from_exponential": Coverage("50 digits", ("screw",), "tan of a dual angle, whole turns beyond the edge"),
    "shadow": Coverage(
        "50 digits", ("Moebius step", "shadow, even branch", "shadow, odd branch"), "the axis and its sign"
    ),
    "shadow_jacobian": Coverage(
        "50 digits", ("shadow, even branch", "shadow, odd branch", "axis", "rates of v"), "the axis and its sign"
    ),
    "principal": Coverage("50 digits", ("shadow, even branch", "shadow, odd branch"), _BRANCHES),
    "adjoint": Coverage("exact", ("tensor", "pose", "line")),
    "transform_point_jacobians": Coverage("exact", ("pose", "line", "twist")),
    "transform_line_jacobians": Coverage("exact", ("line", "twist")),
    "between": Coverage("50 digits", ("composition", "quaternion"), "the principal v of the product quaternion"),
    **{name: Coverage("50 digits", _SMALL, "the branch nearest v") for name in ("retract", "body_retract")},
    **{
        name: Coverage("50 digits", (*_SMALL, *_PRODUCT), "the branch nearest v")
        for name in ("retract_jacobians", "body_retract_jacobians")
    },
    **{name: Coverage("50 digits", _SMALL, "the principal angle") for name in ("local", "body_local")},
    "interpolate": Coverage("50 digits", _SMALL, "the shorter way, and the branch that is followed from v1"),
    "compose_jacobians": Coverage("50 digits", _PRODUCT, "the principal v of the product quaternion"),
    "between_jacobians": Coverage("50 digits", _PRODUCT, "the principal v of the product quaternion"),
    "compose": Coverage("50 digits", ("composition", "quaternion"), "the principal v of the product quaternion"),
    "singular_angles": Coverage("text", ("determinant", "multiples of an angle")),
}
"""Coverage by kernel function."""
