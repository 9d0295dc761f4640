"""Translation validation: execute the kernels on disk and compare their results with the formulas."""

from .batches import ValidationFailed
from .replay import NUMPY, Library, replay
from .run import own_functions, validate

__all__ = ["NUMPY", "Library", "ValidationFailed", "own_functions", "replay", "validate"]
