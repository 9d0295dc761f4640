"""From proved formulas to files of kernels.

============ ==============================================================================
compiler     the road: prove, lower, print, write, validate, publish
catalogue    which orders are committed, and the commands that make them
targets      the table of languages: a printer, a template folder and a row each
lowering     recipes from formulas to straight-line programs
program      straight-line programs
trace        the tracer that records them
registers    the order of steps and scratch registers by liveness
expression   the steps of a program as expressions, in a dialect
infix        programs as plain Python
inplace      programs as NumPy calls with ``out``, beside the plain form
jit          programs as compiled loops of few outputs
c99          programs as C
signatures   arguments and results of the kernel functions as flat arrays
differential tables of seeded cases for the tests of compiled targets
docstrings   what only Python modules say of a map
module       the text of a module, through the templates
validation   the file on disk computes its formula
============ ==============================================================================
"""

from ..output import Difference, RefusedError
from .compiler import Module, Package, build, check, generate
from .validation import ValidationFailed

__all__ = ["Difference", "Module", "Package", "RefusedError", "ValidationFailed", "build", "check", "generate"]
