"""Translation validation: the emitted file is executed on exact elements, and its results equal the formula's.

============= ======================================================================================
exact         what every rational function must return on symbols (ring elements), from the formula
digits        what the maps with sqrt, tan and atan2 must return at seeded screws, to 50 digits
run           load the package from disk and call its public functions, in both layouts
cases         seeded numbers and their exact results, for languages whose kernels take no exact elements
maps_at       inverse maps, screws, shadows and composition at given numbers
screws        seeded screws on which every side of every selection is taken
c_text        interpret a C header on the same elements and numbers, in all the ways it may be called
c_calls       the arrays of such a call in memory
c_interpreter C text on any type of number
compiled      compile the differential test beside a C header, and run it
============= ======================================================================================
"""

from .run import ValidationFailed, validate

__all__ = ["ValidationFailed", "validate"]
