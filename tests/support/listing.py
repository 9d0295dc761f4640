"""Programs as data, run on rows of doubles with the C library's functions."""

from __future__ import annotations

import ctypes
import ctypes.util
import json
import operator
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from derive.codegen.rows import inside
from derive.codegen.validation.listings import Listing
from tests.support.languages import TABLES, Case, parted


def _of_c(name: str, count: int = 1) -> Callable[..., Any]:
    function = getattr(ctypes.CDLL(ctypes.util.find_library("m")), name)
    function.argtypes, function.restype = [ctypes.c_double] * count, ctypes.c_double
    each = np.frompyfunc(function, count, 1)
    return lambda *numbers: each(*numbers).astype(float)


def run(folder: Path, cases: Sequence[Case], place: Path) -> list[list[np.ndarray]]:
    """Return the results of the programs in a folder for each case."""
    operations = {
        "select": np.where, "and": np.logical_and, "or": np.logical_or, "sqrt": np.sqrt, "abs": np.abs,
        "divide": operator.truediv, **{name: _of_c(name) for name in ("tan", "expm1", "log1p")},
        "atan2": _of_c("atan2", 2),
    }  # fmt: skip
    found, listings = [], dict[str, Listing]()
    for case in cases:
        file = inside(TABLES[case.table], f"{case.chart}.json")
        if file not in listings:
            data = json.loads((folder / file).read_text(encoding="utf-8"))
            listings[file] = Listing(data, lambda number: float.fromhex(number["float"]), operations)
        with np.errstate(all="ignore"):
            made = listings[file].call(case.function, [list(a.T) for a in case.arguments], case.branch)
        rows = [np.broadcast_to(np.asarray(part, float), len(case.arguments[0])) for part in made]
        found.append(parted(case, np.stack(rows, axis=1)))
    return found
