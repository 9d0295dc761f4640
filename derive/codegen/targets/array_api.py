"""Arrays of any library: plain Python on arrays of components, with nothing written in place."""

from __future__ import annotations

import importlib
from collections.abc import Mapping, Sequence
from importlib.util import find_spec

import numpy as np

from ..package import Data, Facts
from ..rows import Table
from ..signatures import POSES, ROTATIONS
from ..validation import Library, Machinery
from . import python

WORDS = python.Words(
    options="*, axis: int = -1",
    passed="axis",
    passed_alone="axis",
    placed="axis",
    makes=False,
)

STRICT = "array_api_strict"
STANDARD = (np.dtype(np.float64), np.dtype(np.float32))


class ArrayApi(python.PythonTarget):
    """Target that imports no array library and takes the arrays of each."""

    name = "array-api"
    words = WORDS
    tables = (POSES, ROTATIONS)
    machinery = Machinery(out=False, silent=False)
    unproved = "what array libraries do with arrays other than NumPy's arrays of objects; rounding errors"

    def shared(self) -> Mapping[str, Data]:
        return {
            **self.package(),
            **self.per_table(),
            "_branches.py": {},
            "_chart.py": {},
            "_checks.py": {},
            "_runtime.py": {},
            "_tools.py": {},
        }

    def geometry(self, table: Table) -> Data:
        return python.geometry(table)

    def programs(self, facts: Facts) -> Data:
        return python.printed_scalars(facts)

    def libraries(self) -> Sequence[Library]:
        """Return NumPy, and the strict reference of the standard if installed, with the standard's types."""
        found = [Library("numpy", np.asarray, STANDARD)]
        if find_spec(STRICT) is not None:
            found.append(Library(STRICT, importlib.import_module(STRICT).asarray, STANDARD))
        return found
