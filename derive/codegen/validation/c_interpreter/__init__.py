"""C headers executed on exact numbers: the text that a compiler reads, with no rounding of its own.

`source` preprocesses and parses a header, `translate` makes Python functions of it, `memory` checks its pointers, and
`unit` calls its functions. Only the subset of C that emitted headers are made of is read; the rest is refused by name.
The real type is that of the numbers passed in, and a constant is the fraction it denotes.
"""

from .memory import UNSET, CError, Pointer
from .unit import Unit, load

__all__ = ["UNSET", "CError", "Pointer", "Unit", "load"]
