"""Arrays of any library: plain Python on arrays of components, with nothing written in place."""

from __future__ import annotations

import importlib
from collections.abc import Sequence
from importlib.util import find_spec

import numpy as np

from ..lowered import lower_chart
from ..lowering.retraction import EXPONENTIAL
from ..lowering.scalar_programs import SCALARS, SQUARES
from ..package import Data
from ..rows import Table
from ..validation import Library, Machinery, runtime
from .python import PythonTarget, printed_scalars

STRICT = "array_api_strict"
TOWERS = {
    "pose_scalars": "tangent_scalars",
    "tangent_scalars": "tangent_dot_scalars",
    "tangent_dot_scalars": "tangent_dot_scalars",
    "inverse_scalars": "tangent_inv_scalars",
    "inverse_at": "tangent_inv_scalars",
    "tangent_inv_at": "tangent_inv_dot_scalars",
    "tangent_inv_scalars": "tangent_inv_dot_scalars",
    "tangent_inv_dot_scalars": "tangent_inv_dot_scalars",
}
"""Scalar programs, and those that return slopes of their results; the last slopes have none."""

STEP_SCALARS = (
    "pose_scalars", "tangent_scalars", "tangent_dot_scalars", "tangent_inv_scalars", "tangent_inv_dot_scalars",
)  # fmt: skip
"""Scalar programs of the exponential that the rules of differentiation need."""

STORED = ("exponential_scalars", "nearest")
"""Geometry programs whose results many steps read, as they do those of scalar programs."""

STANDARD = (np.dtype(np.float64), np.dtype(np.float32))


class ArrayApi(PythonTarget):
    """Target that imports no array library and accepts the arrays of any."""

    name = "array-api"
    options = "axis: int = -1"
    files = (*PythonTarget.files, "_jax.py", "_rules.py", "_torch.py")
    machinery = Machinery(out=False, silent=False)
    checks = (*PythonTarget.checks, runtime.steps, runtime.slopes, runtime.rules)

    def shared(self) -> dict[str, Data]:
        """Return the data of all shared files, with the exponential's scalars for the rules of differentiation."""
        scalars = lower_chart(EXPONENTIAL).scalars
        kept = {name: scalars[name] for name in STEP_SCALARS}
        return super().shared() | {"_slopes.py": {**printed_scalars(EXPONENTIAL, kept), **rules_of_slopes()}}

    def geometry(self, table: Table) -> Data:
        return {**super().geometry(table), "stored": STORED}

    def libraries(self) -> Sequence[Library]:
        """Return NumPy, and the strict reference of the standard if installed, with the standard's types."""
        names = ("numpy", *([STRICT] if find_spec(STRICT) else []))
        return [Library(name, importlib.import_module(name).asarray, STANDARD) for name in names]


def rules_of_slopes() -> Data:
    """Return the names of results whose slopes other programs return, and the numbers of those without."""
    results = {name: SCALARS[name].results for name in TOWERS}
    by_text = {"coefficient": 1}
    for name, slopes in TOWERS.items():
        if last := sum(f"{result}y" not in results[slopes] for result in results[name]):
            by_text[name] = last
    squares = tuple(name for name in TOWERS if SCALARS[name].arguments == SQUARES)
    return {"results": results, "towers": TOWERS, "by_text": by_text, "squares": squares}
