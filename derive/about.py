"""Facts about the toolkit, which help, `list` and completion show without loading anything else.

Tests compare these names with the tables that define them.
"""

from __future__ import annotations

from pathlib import Path

__version__ = "0.1.0"
"""Version of the toolkit, and of the kernels it writes."""

ORDERS = (1, 2, 3, 4, 5, 8)
"""Orders whose modules are committed."""

FAMILIES = (
    "exponential", "orthographic", "lambert", "breusing", "sine3", "sine4", "scaled1", "scaled2", "scaled3", "scaled4",
    "scaled5", "wiener_milenkovic",
)  # fmt: skip
"""Families whose modules are committed."""

MAX_ORDER = 64
"""Largest order generated without --max-n, since proof times beyond it are not measured."""

TARGETS = ("numpy", "array-api", "numba", "c", "native")
"""Keys of `derive.codegen.targets.TARGETS`."""

TARGET = TARGETS[0]
"""Target of the committed modules."""

FORMULAS = ("p", "q", "quaternion", "tensor", "tangent", "tangent_inv")
"""Attributes of `derive.Cayley` that are formulas."""

FUNCTIONS = (
    "quaternion", "tensor", "pose", "transform_point", "transform_line", "inverse", "tangent", "tangent_inv",
    "body_tangent", "body_tangent_inv", "twist", "rate", "body_twist", "body_rate", "tangent_dot",
    "body_tangent_dot", "twist_dot", "body_twist_dot", "rate_dot", "body_rate_dot", "twist_jacobian",
    "body_twist_jacobian", "rate_jacobian", "body_rate_jacobian", "cotangent", "body_cotangent",
    "cotangent_jacobian", "body_cotangent_jacobian", "from_quaternion", "from_tensor", "from_pose", "from_screw",
    "to_screw", "angle", "to_exponential", "from_exponential", "shadow", "shadow_jacobian", "principal", "compose",
    "between", "compose_jacobians", "between_jacobians", "retract", "body_retract", "retract_jacobians",
    "body_retract_jacobians", "local", "body_local", "interpolate", "adjoint", "transform_point_jacobians",
    "transform_line_jacobians",
)  # fmt: skip
"""Functions of a kernel module: keys of `derive.codegen.signatures.PUBLIC`."""

PAPERS = ("condurache-popa-2023", "karakilic-2010")
"""Slugs of `derive.papers.PAPERS`."""

FORMATS = ("text", "json", "markdown", "html", "latex")
"""Keys of `derive.papers.report.FORMATS`."""


def checkout() -> Path | None:
    """Return the root of the project's checkout that contains the running toolkit; None for an installed one."""
    root = Path(__file__).parent.parent
    return root if (root / "templates").is_dir() and (root / "pyproject.toml").is_file() else None
