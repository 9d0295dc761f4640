"""Translation validation: execute the kernels on disk and compare their results with the formulas."""

from .batches import ValidationFailed
from .run import own_functions, validate

__all__ = ["ValidationFailed", "own_functions", "validate"]
