"""C text executed on any type of number: what a compiler would read, with every freedom to round taken away.

=========== =========================================================================================
source      the preprocessor and the parser: a header and what it includes as a syntax tree
types       real, int, size_t, pointers and arrays; conversions; what is refused because it would round
memory      cells, pointers with bounds, cells that were never written
expressions a syntax tree as Python closures over a frame of cells
statements  the same for statements and function bodies
unit        a translation unit: its functions, callable; which conditions took which value
=========== =========================================================================================

The real type of the text is whatever is passed in: ring elements, numbers of 50 digits, fractions. A constant is the
fraction it denotes, so nothing rounds that the number type does not round itself. Types are static, as in C: a division
of two integers is an error wherever it stands, executed or not.
"""

from .errors import CError
from .memory import UNSET, Pointer
from .unit import Unit, load

__all__ = ["UNSET", "CError", "Pointer", "Unit", "load"]
