"""Translation validation: execute the kernels on disk and compare their results with the formulas.

=============== ==========================================================================================
vectors         vectors of a chart and their branches, from φ alone
expected_values expected values of algebraic functions, on symbols or at numbers
inverse_maps    expected values of all other functions, at numbers of 50 digits
calls           the list of calls: functions, arguments drawn by kind, expected results
screws          seeded screws that cover every side of every selection
samples         calls on symbols, and seeded calls on numbers of 50 digits
float_cases     calls in floats, for replays and for compiled tests
decimals        numbers of 50 digits that kernels take, and the tolerance of their results
batches         calls of every function by branch, and the comparison of results
loading         load a package from disk under a unique name
run             run a Python package on exact numbers
c_text          run a C header on exact numbers, in both call forms and all array layouts
c_interpreter   preprocessor, parser and translator for the subset of C used in headers
compiled        compile and run the differential test of a C header
replay          call a package on floats, one by one and in arrays
runtime         run-time parts that are written by hand, on a few cases with independent values
motions         the same for parts of the NumPy target
stand_ins       short replacements of SciPy and JAX
=============== ==========================================================================================
"""

from .batches import ValidationFailed
from .replay import NUMPY, Library, Machinery, replay
from .run import own_functions, validate

__all__ = ["NUMPY", "Library", "Machinery", "ValidationFailed", "own_functions", "replay", "validate"]
