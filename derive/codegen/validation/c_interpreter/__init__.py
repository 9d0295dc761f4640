"""C headers executed on exact numbers: the text that a compiler reads, with no rounding of its own.

========= ==========================================================================================
memory    cells, pointers with bounds, cells that were never written
source    preprocess and parse a header and the files that it includes
translate translate a syntax tree to Python functions, and refuse what is outside the subset
unit      a translation unit: its functions, ready to be called
========= ==========================================================================================

Only the subset of C that the emitted headers are made of is read; anything else is refused by name. The real type is
whatever is passed in: ring elements, numbers of 50 digits, fractions. A constant is the fraction it denotes. Types are
static, as in C: a division of two integers is an error wherever it stands, executed or not.
"""

from .memory import UNSET, CError, Pointer
from .unit import Unit, load

__all__ = ["UNSET", "CError", "Pointer", "Unit", "load"]
