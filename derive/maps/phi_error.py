"""Error for a φ that cannot be a chart, or has no kernels."""

from __future__ import annotations

SYMBOLIC_ONLY = "its chart is symbolic only; derive.Parameterization has its formulas, dualcay compare its figures"


class PhiError(ValueError):
    """Error for a refused φ, with the reason."""
