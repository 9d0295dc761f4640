"""From proved formulas to files of kernels.

============ ==============================================================================
programs     straight-line programs: traced and scheduled
lowering     recipes: the geometry that all charts share, and the scalars of a chart
rows         a row of the table of kernel functions: arrays, recipe, names, its part for rotations
signatures   the table of kernel functions, and of those of rotations
lowered      all programs of a proved chart
validation   expected results, from the formulas alone; the file on disk computes them
package      the texts of a package, and what its templates are told about a chart
targets      the languages: a printer and a template folder each
catalogue    which charts exist, and names that are reserved
build        the road: prove -> lower -> print -> write -> check
publish      kernels into a folder, or a folder compared with them
============ ==============================================================================

A module imports only from those above it.
"""

from ..output import Difference, RefusedError
from .package import Module, Package
from .publish import check, generate, generate_charts
from .validation import ValidationFailed

__all__ = [
    "Difference",
    "Module",
    "Package",
    "RefusedError",
    "ValidationFailed",
    "check",
    "generate",
    "generate_charts",
]
