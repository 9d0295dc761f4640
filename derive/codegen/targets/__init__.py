"""Targets of generation: each module has a printer, the data of its templates, and the execution of its text.

========== =====================================================================
target     protocol of a target
expression the steps of a program as expressions, in a dialect
infix      programs as plain Python
python     base class and interface of the Python targets
numpy      NumPy: plain Python, and calls with ``out``
array_api  the arrays of any library
numba      compiled loops of few outputs
c99        programs as C functions
c          headers for C and C++
native     NumPy functions in C
========== =====================================================================
"""

from __future__ import annotations

from collections.abc import Mapping

from .array_api import ArrayApi
from .c import C
from .native import Native
from .numba import Numba
from .numpy import Numpy
from .target import Target

_ROWS: tuple[Target, ...] = (Numpy(), ArrayApi(), Numba(), C(), Native())

TARGETS: Mapping[str, Target] = {target.name: target for target in _ROWS}
"""Targets by name."""

__all__ = ["TARGETS", "Target"]
