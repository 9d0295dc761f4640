"""Targets of generation: each module has a printer, data for its templates, and a way to execute its text.

========== =====================================================================
expression steps of a program as expressions, in the dialect of a language
infix      programs as plain Python
python     base class and interface of the Python targets
numpy      NumPy: plain Python, and calls with ``out``
array_api  arrays of any library
numba      compiled loops of few outputs
c99        programs as C functions
c          headers for C and C++
native     NumPy functions in C
========== =====================================================================
"""

from __future__ import annotations

from collections.abc import Mapping

from ..package import Target
from .array_api import ArrayApi
from .c import C
from .native import Native
from .numba import Numba
from .numpy import Numpy

_ROWS: tuple[Target, ...] = (Numpy(), ArrayApi(), Numba(), C(), Native())

TARGETS: Mapping[str, Target] = {target.name: target for target in _ROWS}
"""Targets by name."""

__all__ = ["TARGETS", "Target"]
