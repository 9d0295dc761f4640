"""Generator: proved formulas become files of kernels.

============ ==============================================================================
programs     straight-line programs: traced and scheduled
lowering     recipes of the geometry programs that all charts share, and of a chart's scalar programs
rows         one row of the table of kernel functions: arrays, recipe, names, and its real part
signatures   the tables of kernel functions: for poses, and for rotations alone
lowered      all programs of a proved chart
validation   expected results from the formulas alone, compared with results of the files on disk
package      texts of a package, and the data of a chart for its templates
targets      languages: a printer and a template folder each
catalogue    existing charts, and reserved names
build        pipeline in stages: prove -> lower -> print -> write -> check
publish      last stage: write kernels into a folder, or compare a folder with them
============ ==============================================================================

Each module imports only modules listed above it.
"""

from ..output import Difference, RefusedError
from .package import Module, Package
from .publish import check_charts, generate, generate_charts
from .validation import ValidationFailed

__all__ = [
    "Difference", "Module", "Package", "RefusedError", "ValidationFailed", "check_charts", "generate",
    "generate_charts",
]  # fmt: skip
