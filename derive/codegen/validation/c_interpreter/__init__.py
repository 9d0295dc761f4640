"""Interpreter that executes the text of C headers on exact numbers.

`source` preprocesses and parses a header, `translate` makes Python functions of it, `memory` checks its pointers, and
`unit` calls its functions. Only the subset of C used in emitted headers is read; anything else raises `CError`.
Numbers of any Python type may be passed in for real arguments, and constants become exact fractions.
"""

from .memory import UNSET, CError, Pointer
from .unit import Unit, load

__all__ = ["UNSET", "CError", "Pointer", "Unit", "load"]
