"""What only Python modules say of a map: their public names, definitions in LaTeX, where numbers overflow."""

from __future__ import annotations

import textwrap
from typing import Any

import numpy as np

from ..maps import Cayley

PUBLIC = (
    "body_rate", "body_twist", "compose", "dcay", "dcay_inv", "from_pose", "from_quaternion", "from_screw",
    "from_tensor", "pose", "principal", "quaternion", "rate", "shadow", "singular_angles", "tangent", "tangent_inv",
    "tensor", "to_screw", "transform_line", "transform_point", "twist",
)  # fmt: skip
"""Functions of a kernel module."""


def docstrings(cayley: Cayley) -> dict[str, Any]:
    """By the names of their holes."""
    maps = (cayley.quaternion, cayley.tensor, cayley.tangent, cayley.tangent_inv)
    return {
        "public": PUBLIC,
        "definitions": {f.name: _display(f"{f.symbol} = {f.definition}") for f in maps},
        "largest": {
            name: f"{float(np.finfo(name).max) ** (0.5 / cayley.order):.1g}" for name in ("float32", "float64")
        },
    }


def _display(latex: str) -> str:
    """LaTeX broken into lines of a docstring."""
    return "\n        ".join(textwrap.wrap(latex, 108, break_long_words=False, break_on_hyphens=False))
