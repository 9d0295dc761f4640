"""Translation validation: the text on disk is executed, and its results equal those of the formula.

============= ==========================================================================================
vectors       vectors of a chart and their branches, from φ alone
formulas      expected values of algebraic functions, on symbols or at numbers
inverse_maps  expected values of all other functions, at numbers of 50 digits
decimals      numbers of 50 digits as kernels take them, and how near they have to be
screws        seeded screws on which every side of every selection is taken
samples       seeded cases with expected values of 50 digits
batches       cases of every function, and how results are compared with them
float_cases   cases in floats, for replays and for compiled tests
loading       load a package from disk under a name of its own
run           run a Python package on exact numbers
c_text        run a C header on exact numbers, in all the ways its functions may be called
c_interpreter a preprocessor, parser and translator of the C that headers are made of
compiled      compile the differential test beside a C header, and run it
replay        call a package on floats, one by one and in arrays
============= ==========================================================================================
"""

from .errors import ValidationFailed
from .replay import NUMPY, Library, Machinery, replay, replay_package
from .run import own_functions, validate

__all__ = [
    "NUMPY",
    "Library",
    "Machinery",
    "ValidationFailed",
    "own_functions",
    "replay",
    "replay_package",
    "validate",
]
