"""Targets of generation: each module has a printer, data for its templates, and a way to execute its text."""

from __future__ import annotations

from collections.abc import Mapping

from ..package import Target
from .array_api import ArrayApi
from .c import C
from .js import Js
from .json import Json
from .matlab import Matlab
from .native import Native
from .numba import Numba
from .numpy import Numpy
from .rust import Rust

_ALL: tuple[Target, ...] = (Numpy(), ArrayApi(), Numba(), C(), Native(), Json(), Rust(), Js(), Matlab())
TARGETS: Mapping[str, Target] = {target.name: target for target in _ALL}

__all__ = ["TARGETS", "Target"]
