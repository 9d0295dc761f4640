"""Definitions of the papers: polynomials p_n and q_n, Cayley maps of order n, their inverses, screws, poses, charts.

CP23 is Condurache and Popa, Symmetry 15(11) 2011 (2023), cited by equation number. Names are imported on first
use. The grammar of a user's φ can therefore be checked without SymPy.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .cayley import Cayley
    from .formula import Formula, IsotropicMap, QuaternionMap
    from .grammar import PhiError
    from .named import family, parameterization
    from .polynomials import x

__all__ = ["Cayley", "Formula", "IsotropicMap", "PhiError", "QuaternionMap", "family", "parameterization", "x"]

_HOMES = {
    "Cayley": "cayley", **dict.fromkeys(("Formula", "IsotropicMap", "QuaternionMap"), "formula"), "family": "named",
    "PhiError": "grammar", "parameterization": "named", "x": "polynomials",
}  # fmt: skip

if not TYPE_CHECKING:

    def __getattr__(name: str) -> object:
        if name not in _HOMES:
            raise AttributeError(f"module 'derive.maps' has no attribute {name!r}")
        return getattr(importlib.import_module(f"derive.maps.{_HOMES[name]}"), name)
