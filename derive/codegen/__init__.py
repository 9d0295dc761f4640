"""From proved formulas to files of kernels.

============ ==============================================================================
programs     straight-line programs, traced from formulas
lowering     recipes: the geometry that all charts share, and the scalars of a chart
rows         what a row says of a kernel function: arrays, recipe, names, its part for rotations
signatures   the table of kernel functions, and of those of rotations
lowered      all programs of a proved chart
cases        what functions must return, from the formulas alone
differential tables of seeded cases for the tests of compiled targets
validation   the file on disk computes its formula
facts        what a module says besides its programs
targets      the languages: a printer and a template folder each
taken        names that a chart of one's own may not bear
catalogue    what is committed, and the commands that make it
module       the texts of a package, through the templates
package      a module with its texts, and a package of them
compiler     the road: prove, lower, print, write, validate, publish
============ ==============================================================================

A module imports only from those above it.
"""

from ..output import Difference, RefusedError
from .compiler import build, check, generate, generate_charts
from .package import Module, Package
from .validation import ValidationFailed

__all__ = [
    "Difference",
    "Module",
    "Package",
    "RefusedError",
    "ValidationFailed",
    "build",
    "check",
    "generate",
    "generate_charts",
]
