"""Compiled NumPy functions of the distribution ``dualcay-native``, for modules with the same programs.

``DUALCAY_NATIVE=0`` in the environment switches them off. An installation that cannot be loaded, or that holds other
programs, is ignored with a single warning.
"""

from __future__ import annotations

import importlib
import os
import warnings
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np

PACKAGE = "dualcay_native"

_warned: list[str] = []


class Compiled(NamedTuple):
    """Compiled function for arrays of any layout; ``directly`` takes plain float64 arrays only, else returns None."""

    function: np.ufunc
    directly: Callable[..., Any]


def functions(module: str, programs: str) -> Mapping[str, Compiled]:
    """Return the compiled functions of a kernel module by name; empty unless a build of ``programs`` is installed."""
    if os.environ.get("DUALCAY_NATIVE") == "0":
        return {}
    name = PACKAGE + module.removeprefix(__name__.rpartition(".")[0])
    try:
        found = importlib.import_module(name)
    except ModuleNotFoundError as error:
        if not name.startswith(error.name or name + "."):
            _warn(f"{name} cannot be loaded: {error}")
        return {}
    except Exception as error:  # any error that another build of Python or NumPy may raise
        _warn(f"{name} cannot be loaded: {error}")
        return {}
    if programs != found.PROGRAMS or not hasattr(found, "DIRECT"):
        _warn(f"{name} was built of other programs than {module} holds: install what the same version generates")
        return {}
    return {name: Compiled(getattr(found, name), directly) for name, directly in found.DIRECT.items()}


def _warn(reason: str) -> None:
    if not _warned:
        _warned.append(reason)
        warnings.warn(f"{reason}; NumPy runs instead", RuntimeWarning, stacklevel=2)
