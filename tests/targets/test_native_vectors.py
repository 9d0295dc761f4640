"""Compiled NumPy functions as vector code: only whole vectors are computed, so results do not depend on the batch."""

from __future__ import annotations

import importlib
import platform
from collections.abc import Callable, Iterator
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

import dualcay
from derive.codegen.signatures import ROTATIONS
from derive.maps import Cayley
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
