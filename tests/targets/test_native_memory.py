"""Compiled NumPy functions under sanitizers: no access out of bounds, no undefined behaviour in any layout or type."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from derive.codegen.signatures import KERNELS
from derive.maps import Cayley
from tests.support.compilers import find
from tests.support.native import build

pytestmark = [pytest.mark.compiler, pytest.mark.thorough]

SANITIZED = ("optimization=0", "b_sanitize=address,undefined", "b_lundef=false")

CALLS = """
import re
import numpy as np
from dualcay_native import cayley3
from dualcay_native.rotation import cayley3 as rotations

functions = [(getattr(m, name), directly) for m in (cayley3, rotations) for name, directly in m.DIRECT.items()]
draw, called, direct = np.random.default_rng(3), 0, 0
for function, directly in functions:
    parts = re.findall(r"[(]([^)]*)[)]", function.signature)
    *arguments, result = [tuple(map(int, re.findall(r"[0-9]+", part))) for part in parts]
    for shape in ((), (1,), (63,), (2, 65), (0,)):  # around the size of a tile
        for dtype in (np.float32, np.float64, np.longdouble):
            values = [draw.normal(size=shape + part).astype(dtype) for part in arguments]
            for given in (values, [*map(np.asfortranarray, values)], [np.repeat(a, 2, -1)[..., ::2] for a in values]):
                for order in "CF":
                    function(*given, out=np.empty(shape + result, dtype, order))
                    called += 1
                direct += directly(*given) is not None
            if 0 not in shape:
                direct += directly(values[0], *(value[(0,) * len(shape)] for value in values[1:])) is not None
print(called, direct)
"""


def test_no_access_is_out_of_bounds(shared: Callable[[str, Callable[[Path], object]], Path]) -> None:
    site = shared("native_sanitized", lambda place: build(place, [Cayley(3)], *SANITIZED)) / "site"
    where = [str(find()), "-print-file-name=libasan.so"]
    library = subprocess.run(where, capture_output=True, text=True, check=True).stdout.strip()
    assert Path(library).is_file(), f"these tests need AddressSanitizer, which {where[0]} has not"
    environment = {
        **os.environ, "LD_PRELOAD": library, "ASAN_OPTIONS": "detect_leaks=0",
        "PYTHONPATH": str(site),
    }  # fmt: skip
    done = subprocess.run([sys.executable, "-c", CALLS], env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-3000:]
    called, direct = map(int, done.stdout.split())
    assert called > 90 * len(KERNELS)
    assert direct > 10 * len(KERNELS)
    assert "runtime error" not in done.stderr
