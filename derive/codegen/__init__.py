"""Generator: proved formulas become files of kernels, by the stages of `build`."""

from ..output import Difference, RefusedError
from .build import check_charts, generate, generate_charts
from .package import Module, Package
from .validation import ValidationFailed

__all__ = [
    "Difference", "Module", "Package", "RefusedError", "ValidationFailed", "check_charts", "generate",
    "generate_charts",
]  # fmt: skip
