"""Builds of compiled NumPy functions: as vector code, where results do not depend on the batch; under sanitizers."""

from __future__ import annotations

import importlib
import os
import platform
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

import dualcay
from derive.codegen.signatures import KERNELS, ROTATIONS
from derive.maps import Cayley
from tests.support.compilers import find
from tests.support.native import build, found, require_one_in_all_layouts
from tests.support.rotation_arguments import arguments

pytestmark = [pytest.mark.compiler, pytest.mark.thorough]

CHARTS = (Cayley(3),)
NAMES = ("from_quaternion", "compose", "local", "to_exponential", "interpolate", "rate", "tensor")
"""Functions that compute angles, and two without angles."""


@pytest.fixture(scope="module")
def site(shared: Callable[[str, Callable[[Path], object]], Path]) -> Path:
    """Return the folder of a build for rotations alone; such a build takes only half a minute."""
    return shared("native_vectors", lambda place: build(place, CHARTS, "optimization=3", only="rotation")) / "site"


@pytest.fixture(scope="module")
def rotations(site: Path) -> Iterator[ModuleType]:
    with found("dualcay_on_vectors", site) as name:
        yield importlib.import_module(f"{name}.rotation.cayley3")


def test_angles_are_computed_on_vectors_where_the_library_does(site: Path) -> None:
    (library,) = site.glob("dualcay_native/rotation/cayley3*.so")
    kind, version = platform.libc_ver()
    there = kind == "glibc" and [*map(int, version.split("."))] >= [2, 35] and platform.machine() == "x86_64"
    assert (b"_ZGV" in library.read_bytes()) == there


@pytest.mark.parametrize("name", NAMES)
def test_layouts_agree_to_the_digit(rotations: ModuleType, name: str) -> None:
    assert rotations.CHART.native
    row = ROTATIONS.public[name]
    values = arguments(row, dualcay.rotation.cayley3, (150,))
    require_one_in_all_layouts(getattr(rotations, name), values, row.shape)


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("count", [1, 7, 8, 9, 63, 64, 65, 130])
def test_rows_of_any_number_are_read_and_written_within_their_bounds(
    rotations: ModuleType, count: int, dtype: type
) -> None:
    """Expect unchanged memory beside the results, since only whole vectors are written in place."""
    v = np.full((3, count + 32), np.nan, dtype)[:, 16:-16]
    v[...] = rotations.random(count, rng=1).T
    made = rotations.compose(v, v, axis=0)
    last = np.ascontiguousarray(v.T)
    np.testing.assert_array_equal(made, rotations.compose(last, last).T)
    target = np.full((3, count + 32), 5, dtype)
    rotations.compose(v, v, axis=0, out=target[:, 16:-16])
    np.testing.assert_array_equal(target[:, 16:-16], made)
    assert (target[:, :16] == 5).all()
    assert (target[:, -16:] == 5).all()


SANITIZED = ("optimization=0", "b_sanitize=address,undefined", "b_lundef=false")

CALLS = """
import re
import numpy as np
from dualcay_native import cayley3
from dualcay_native.rotation import cayley3 as rotations
from tests.support.layouts import restrided

functions = [(getattr(m, name), directly) for m in (cayley3, rotations) for name, directly in m.DIRECT.items()]
draw, called, direct = np.random.default_rng(3), 0, 0
for function, directly in functions:
    parts = re.findall(r"[(]([^)]*)[)]", function.signature)
    *arguments, result = [tuple(map(int, re.findall(r"[0-9]+", part))) for part in parts]
    for shape in ((), (1,), (63,), (2, 65), (65, 1), (1, 65), (0,), (0, 1)):  # around the size of a tile
        for dtype in (np.float32, np.float64, np.longdouble):
            values = [draw.normal(size=shape + part).astype(dtype) for part in arguments]
            spread = [np.repeat(a, 2, -1)[..., ::2] if a.ndim else a for a in values]
            forms = [values, [np.array(a, order="F") for a in values], spread]
            forms += zip(*map(restrided, values)) if 1 in shape else ()
            expected = function(*values)
            for given in forms:
                for order in "CF":
                    out = np.empty(shape + result, dtype, order)
                    for target in restrided(out) if 1 in shape else [out]:
                        np.testing.assert_array_equal(function(*given, out=target), expected)
                        called += 1
                found = directly(*given)
                if found is not None:
                    np.testing.assert_array_equal(found, expected)
                    direct += 1
            if 0 not in shape:
                direct += directly(values[0], *(value[(0,) * len(shape)] for value in values[1:])) is not None
print(called, direct)
"""


def test_no_access_is_out_of_bounds(shared: Callable[[str, Callable[[Path], object]], Path]) -> None:
    """Run every compiled function in all layouts, also with axes of length 1 of any stride, under AddressSanitizer."""
    where = [str(find()), "-print-file-name=libasan.so"]
    library = subprocess.run(where, capture_output=True, text=True, check=True).stdout.strip()
    if not Path(library).is_file():
        pytest.skip(f"AddressSanitizer is not installed for {where[0]}")
    site = shared("native_sanitized", lambda place: build(place, [Cayley(3)], *SANITIZED)) / "site"
    paths = os.pathsep.join(map(str, (site, Path(__file__).parents[2])))
    environment = {**os.environ, "LD_PRELOAD": library, "ASAN_OPTIONS": "detect_leaks=0", "PYTHONPATH": paths}
    done = subprocess.run([sys.executable, "-c", CALLS], env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-3000:]
    called, direct = map(int, done.stdout.split())
    assert called > 90 * len(KERNELS)
    assert direct > 10 * len(KERNELS)
    assert "runtime error" not in done.stderr
