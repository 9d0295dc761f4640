"""Translation validation: what was printed is executed as text on disk, and its results equal the formula's.

============= ========================================================================================
run           load a package from disk and call its public functions, in both layouts
c_text        interpret a C header, in all the ways its functions may be called
c_calls       C functions called on flat components
c_interpreter a preprocessor, parser and interpreter of C on numbers of any type
compiled      compile the differential test beside a C header, and run it
============= ========================================================================================

What results must be is said by ``codegen.cases``.
"""

from .run import ValidationFailed, validate

__all__ = ["ValidationFailed", "validate"]
