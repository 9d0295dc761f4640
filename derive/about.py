"""What can be said of the toolkit before any of it is loaded: `--help` and completion show it at once.

Tests hold the names to the tables of what they name.
"""

from __future__ import annotations

__version__ = "0.1.0"
"""Of the toolkit, and of the kernels it writes: the one place."""

ORDERS = (1, 2, 3, 4, 5, 8)
"""Orders whose modules are committed."""

FAMILIES = (
    "exponential", "orthographic", "lambert", "breusing", "sine3", "sine4", "scaled1", "scaled2", "scaled3", "scaled4",
    "scaled5", "wiener_milenkovic",
)  # fmt: skip
"""Families whose modules are committed."""

MAX_ORDER = 64
"""Largest order generated without being asked twice: proof times beyond it are not measured."""

TARGETS = ("numpy", "array-api", "numba", "c", "native")
"""Keys of `derive.codegen.targets.TARGETS`."""

TARGET = TARGETS[0]
"""Target of the committed modules."""

FORMULAS = ("p", "q", "quaternion", "tensor", "tangent", "tangent_inv")
"""Attributes of `derive.Cayley` that are formulas."""

PAPERS = ("condurache-popa-2023", "karakilic-2010")
"""Slugs of `derive.papers.PAPERS`."""

FORMATS = ("text", "json", "markdown", "html", "latex")
"""Keys of `derive.papers.report.FORMATS`."""
