"""Compiled NumPy functions under sanitizers: no access out of bounds, no undefined behaviour, in any way of a call."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from derive.maps import Cayley
from tests.support.compilers import find
from tests.support.native import build

pytestmark = [pytest.mark.compiler, pytest.mark.thorough]

ROOT = Path(__file__).parents[2]
SANITIZED = ("optimization=0", "b_sanitize=address,undefined", "b_lundef=false")

CALLS = """
import numpy as np
from dualcay import cayley3
from tests.support.signatures import SIGNATURES, components_first, inputs

assert cayley3.pose.__self__._chart.native
for name in SIGNATURES:
    function, rank = getattr(cayley3, name), len(SIGNATURES[name].result)
    for shape in ((), (1,), (63,), (2, 65), (0,)):  # around the size of a tile
        for dtype in (np.float32, np.float64, np.longdouble):
            last = inputs(cayley3, name, 3, shape, dtype)
            first = [components_first(a, a.ndim - len(shape)) for a in last]
            for values, axis in ((last, -1), (first, 0), ([*map(np.asfortranarray, last)], -1)):
                made = function(*values, axis=axis)
                function(*values, axis=axis, out=np.empty(made.shape, dtype)[...])
                function(*values, axis=axis, out=np.empty(made.shape[::-1], dtype).T)
print("done")
"""


def test_no_access_is_out_of_bounds(shared: Callable[[str, Callable[[Path], object]], Path]) -> None:
    site = shared("native_sanitized", lambda place: build(place, [Cayley(3)], *SANITIZED)) / "site"
    where = [str(find()), "-print-file-name=libasan.so"]
    library = subprocess.run(where, capture_output=True, text=True, check=True).stdout
    environment = {
        **os.environ, "DUALCAY_NATIVE": "1", "LD_PRELOAD": library.strip(), "ASAN_OPTIONS": "detect_leaks=0",
        "PYTHONPATH": os.pathsep.join(map(str, (site, ROOT, ROOT / "generated"))),
    }  # fmt: skip
    done = subprocess.run([sys.executable, "-c", CALLS], env=environment, capture_output=True, text=True, check=False)
    assert done.stdout == "done\n", done.stderr[-3000:]
    assert "runtime error" not in done.stderr
