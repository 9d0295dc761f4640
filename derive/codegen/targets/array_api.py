"""Arrays of any library: plain Python on arrays of components, with nothing written in place."""

from __future__ import annotations

import importlib
from collections.abc import Callable, Sequence
from importlib.util import find_spec

import numpy as np

from ..lowered import lower_chart
from ..lowering.retraction import EXPONENTIAL
from ..package import Data
from ..validation import Library, Machinery, runtime
from .python import PythonTarget, printed_scalars

STRICT = "array_api_strict"
STEP_SCALARS = ("pose_scalars", "tangent_scalars", "tangent_inv_scalars")
"""Scalar programs of the exponential that the rules of differentiation need."""

STANDARD = (np.dtype(np.float64), np.dtype(np.float32))


def step_scalars() -> Data:
    """Return the exponential's scalars for the rules of differentiation."""
    scalars = lower_chart(EXPONENTIAL).scalars
    return printed_scalars(EXPONENTIAL, {name: scalars[name] for name in STEP_SCALARS})


class ArrayApi(PythonTarget):
    """Target that imports no array library and accepts the arrays of any."""

    name = "array-api"
    options = "axis: int = -1"
    machinery = Machinery(out=False, silent=False)
    checks = (*PythonTarget.checks, runtime.steps, runtime.rules)

    def shared(self) -> dict[str, Callable[[], Data]]:
        return super().shared() | {"_jax.py": step_scalars}

    def libraries(self) -> Sequence[Library]:
        """Return NumPy, and the strict reference of the standard if installed, with the standard's types."""
        names = ("numpy", *([STRICT] if find_spec(STRICT) else []))
        return [Library(name, importlib.import_module(name).asarray, STANDARD) for name in names]
