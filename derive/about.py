"""Facts about the toolkit for help, `list` and completion, which load no other module to show them.

Tests compare these names with the tables that define them.
"""

from __future__ import annotations

from pathlib import Path

__version__ = "0.1.0"
"""Version of the toolkit, and of the kernels it writes."""

INSTALL = 'pip install ".[derive]"  in the folder of its source'
"""Command that installs the libraries of the toolkit."""

ORDERS = (1, 2, 3, 4, 5, 8)
"""Orders whose modules are committed."""

FAMILIES = (
    "exponential", "orthographic", "lambert", "breusing", "sine3", "sine4", "scaled1", "scaled2", "scaled3", "scaled4",
    "scaled5", "wiener_milenkovic",
)  # fmt: skip
"""Families whose modules are committed."""

OTHER_FAMILIES = ("reduced_euler_rodrigues", "homochoric", "isochoric")
"""Families by name whose modules are not committed."""

MAX_ORDER = 64
"""Largest order generated without --max-n; proof times of higher orders were not measured."""

TARGETS = ("numpy", "array-api", "numba", "c", "native", "json", "rust", "js", "matlab")
"""Keys of `derive.codegen.targets.TARGETS`."""

TARGET = TARGETS[0]
"""Target of the committed modules."""

FORMULAS = ("p", "q", "quaternion", "tensor", "tangent", "tangent_inv")
"""Attributes of `derive.Cayley` that are formulas."""

SHEET = "sheet"
"""Name of the formula sheet, beside the names of formulas."""

PAPERS = ("condurache-popa-2023", "karakilic-2010")
"""Slugs of the registered papers: names of files and packages in `derive.papers`."""

FORMATS = ("text", "json", "markdown", "html", "latex", "github", "sarif")
"""Keys of `derive.claims.report.FORMATS`."""


def checkout() -> Path | None:
    """Return the root of the project's checkout that contains the running toolkit; None for an installed one."""
    root = Path(__file__).parent.parent
    return root if (root / "templates").is_dir() and (root / "pyproject.toml").is_file() else None
