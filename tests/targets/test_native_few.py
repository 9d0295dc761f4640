"""Compiled NumPy functions of a few kernels of rotations, built in seconds: layouts, direct calls, lost results."""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterator
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

import dualcay
from derive.codegen.signatures import ROTATIONS
from derive.maps import Cayley
from tests.support.native import PLAIN, Few, build, found, require_one_in_all_layouts
from tests.support.rotation_arguments import arguments

pytestmark = pytest.mark.compiler

KERNELS = ("tensor", "from_tensor", "twist", "interpolate")
"""Kernels of one and of several arguments, of a matrix, of a table, and of a number beside vectors."""


@pytest.fixture(scope="module")
def rotations(shared: Callable[[str, Callable[[Path], object]], Path]) -> Iterator[ModuleType]:
    """Yield the module of a chart for rotations, of which a few kernels are compiled."""
    few = Few(KERNELS)
    site = shared("native_few", lambda place: build(place, [Cayley(2)], *PLAIN, only="rotation", native=few)) / "site"
    with found("dualcay_on_few", site) as name:
        yield importlib.import_module(f"{name}.rotation.cayley2")


def drawn(name: str, count: int) -> tuple[list[np.ndarray], list[np.ndarray]]:
    """Return arguments of a kernel, and the array of its table if it takes one."""
    table = [np.array([0.5, -0.5][: len(ROTATIONS.kernels[name].constants)])] * bool(ROTATIONS.kernels[name].constants)
    return list(arguments(ROTATIONS.public[name], dualcay.rotation.cayley2, (count,))), table


def test_the_kernels_alone_are_compiled(rotations: ModuleType) -> None:
    assert set(rotations.CHART.native) == set(KERNELS)
    for name, compiled in rotations.CHART.native.items():
        assert compiled.function.__name__ == compiled.directly.__name__ == name


@pytest.mark.parametrize("name", KERNELS[:3])
def test_layouts_agree_to_the_digit(rotations: ModuleType, name: str) -> None:
    require_one_in_all_layouts(getattr(rotations, name), drawn(name, 150)[0], ROTATIONS.public[name].shape)


@pytest.mark.parametrize("name", KERNELS)
@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.longdouble])
def test_results_are_those_of_numpy(rotations: ModuleType, name: str, dtype: type) -> None:
    values = [array.astype(dtype) for array in drawn(name, 150)[0]]
    expected, got = (getattr(module, name)(*values) for module in (dualcay.rotation.cayley2, rotations))
    assert got.dtype == dtype
    np.testing.assert_allclose(got, expected, rtol=0, atol=200 * np.finfo(dtype).eps)


@pytest.mark.parametrize("name", KERNELS)
def test_direct_calls_take_plain_float64_arrays_and_agree_to_the_digit(rotations: ModuleType, name: str) -> None:
    """Check that direct calls take aligned float64 arrays of any batch shape, and decline others silently."""
    function, directly = rotations.CHART.native[name]
    values, table = drawn(name, 12)
    parts = [array.shape[1:] for array in values]
    for batch in ((), (1,), (12,), (3, 4), (0,), (2, 0), (1, 12, 1)):
        given = [*(np.resize(a, batch + part) for a, part in zip(values, parts, strict=True)), *table]
        np.testing.assert_array_equal(directly(*given), function(*given))
        assert directly(*given).flags.c_contiguous
    spread = [*(a[::2] for a in values), *table]
    np.testing.assert_array_equal(directly(*spread), function(*spread))
    refused = [
        [a.astype(np.float32) for a in values], [a.tolist() for a in values], [np.ma.array(a) for a in values],
        [a.astype(a.dtype.newbyteorder()) for a in values], values[1:], [*values, *values],
        [a.reshape(3, 4, *a.shape[1:])[:, ::2] for a in values],
        [np.frombuffer(b"-" + a.tobytes(), offset=1).reshape(a.shape) for a in values],
        *([[a[..., :-1] for a in values]] if all(parts) else []),
    ]  # fmt: skip
    assert [directly(*given, *table) for given in refused] == [None] * len(refused)


def test_direct_calls_take_one_rotation_beside_a_batch(rotations: ModuleType) -> None:
    function, directly = rotations.CHART.native["twist"]
    (v, w), table = drawn("twist", 12)
    for given in ((v, w[0]), (v[0], w), (v.reshape(3, 4, 3), w[0])):
        np.testing.assert_array_equal(directly(*given, *table), function(*given, *table))
    for given in ((v, w[:5]), (v, w[:1]), (v, w[:, np.newaxis]), (v.reshape(3, 4, 3), w), (v[:5], w)):
        assert directly(*given, *table) is None


@pytest.mark.parametrize("axis", [-1, 0])
def test_results_that_are_not_finite_are_those_of_numpy(rotations: ModuleType, axis: int) -> None:
    """Leave a result to NumPy if it is not finite; an error of a call before does not count."""
    given = drawn("twist", 9)[0]
    given[0][3, 1], given[1][5, 0] = np.inf, np.nan
    values = [array.T.copy() for array in given] if axis == 0 else given
    expected, got = (module.twist(*values, axis=axis) for module in (dualcay.rotation.cayley2, rotations))
    finite = np.isfinite(expected)
    assert np.array_equal(finite, np.isfinite(got))
    np.testing.assert_allclose(got[finite], expected[finite], rtol=0, atol=1e-14)
    directly = rotations.CHART.native["tensor"].directly
    assert directly(given[0]) is None
    assert directly(given[0][:3]) is not None
