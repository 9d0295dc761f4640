"""Translation validation: what was printed is executed as text on disk, and its results equal the formula's.

============= ========================================================================================
loading       load a package from disk under a name of its own
run           call its public functions, in both layouts
offered       the names and constants of a module, which are its own text
refusals      wrong calls, which a package must refuse as documented
sample        what of a chart has not been shown by another of the package
c_text        interpret a C header, in all the ways its functions may be called
c_calls       C functions called on flat components
c_interpreter a preprocessor, parser and interpreter of C on numbers of any type
compiled      compile the differential test beside a C header, and run it
replay        call a package on floats, in all the ways its functions may be called
helpers       matrix6, identity and random poses
ways          those that are the same for every function: broadcasting, ``out``, layouts, calls at the same time
calls         a call whose results are known, and how they compare
known         results to many digits, and how far rounding may move them
rounding      running error analysis of programs
============= ========================================================================================

What results must be is said by ``codegen.cases``.
"""

from .calls import NUMPY, Library
from .errors import ValidationFailed
from .replay import Machinery, replay, replay_package
from .run import validate
from .sample import Choose, Seen, everything

__all__ = [
    "NUMPY",
    "Choose",
    "Library",
    "Machinery",
    "Seen",
    "ValidationFailed",
    "everything",
    "replay",
    "replay_package",
    "validate",
]
