"""C kernels: their results equal the NumPy kernels' results, also at singular points."""

from __future__ import annotations

import importlib
import itertools

import numpy as np
import pytest

from benchmarks.c_form import FLAGS, TYPES, CForm, compiled
from derive.codegen.signatures import POSES, PUBLIC, ROTATIONS, lower_chart
from derive.codegen.validation.compiled import compiler
from derive.maps import Cayley

pytestmark = [pytest.mark.compiler, pytest.mark.thorough]

ORDERS = (1, 3, 8)
LIBRARY = {"tan", "atan2"}  # functions rounded differently by C libraries and NumPy

COUNT = 300

QUICKLY = (*FLAGS, "-O1")
"""Flags for quick compilation: the final -O1 overrides earlier levels, and avoids slow vectorization."""


# one real type for each order, since all orders share their geometry
@pytest.fixture(scope="module", params=zip(ORDERS, itertools.cycle(TYPES)), ids=lambda p: f"{p[0]}-{p[1]}")
def both(request, folder, shared):
    """Return the C kernels and the NumPy kernels of an order, and the real type."""
    order, real = request.param
    command, chart = compiler(), Cayley(order)
    built = shared(f"c-{order}-{real}", lambda place: compiled(command, folder("c"), chart, real, place, flags=QUICKLY))
    return CForm(built / "library.so", real), importlib.import_module(f"dualcay.cayley{order}"), np.dtype(TYPES[real])


def special(rng, size):
    """Return columns of components: ordinary values, zeros, pure translations, tiny, huge and infinite values, NaN."""
    columns = rng.uniform(-1, 1, (size, COUNT))
    columns[:, 0] = 0
    columns[: size // 2, 1:4] = 0
    columns[:, 4] *= 1e-30
    columns[:, 5] *= 1e12
    columns[:, 6] = np.inf
    columns[0, 7] = np.nan
    columns[size // 2 :, 8] = 0
    columns[1:, 9] = 0
    return columns


def arguments(name, module, dtype, rng, table=POSES):
    """Return arguments of a function, components first; inverse maps get valid poses."""
    v = special(rng, table.functions["shadow"].results[0].size)
    if name in ("from_quaternion", "from_tensor", "from_pose"):
        made = getattr(module, {"from_quaternion": "quaternion", "from_tensor": "tensor", "from_pose": "pose"}[name])
        return [np.ascontiguousarray(made(v, axis=0).reshape(-1, COUNT), dtype)]
    arrays = [special(rng, array.size) for array in table.public[name].arguments]
    return [np.ascontiguousarray(array, dtype) for array in arrays]


def by_numpy(module, name, arrays, branch, table=POSES):
    """Return the result of the NumPy kernel, components first and flat."""
    shaped = [
        array.reshape(*given.shape, COUNT)
        for array, given in zip(arrays, table.public[name].arguments, strict=True)
    ]
    found = getattr(module, name)(*shaped, *branch, axis=0)
    parts = found if isinstance(found, tuple) else (found,)
    return [part.reshape(-1, COUNT) for part in parts]


def by_c(form, name, arrays, branch, layout, table=POSES):
    size = table.public[name].results
    given = arrays if layout == "rows" else [np.ascontiguousarray(array.T) for array in arrays]
    shapes = [(a.size, COUNT) if layout == "rows" else (COUNT, a.size) for a in size]
    out = tuple(np.empty(shape, arrays[0].dtype) for shape in shapes)
    form.call(name, *given, out=out, branch=branch, layout=layout)
    return out if layout == "rows" else [part.T for part in out]


def test_maps_without_tan_are_bit_identical(both):
    form, module, dtype = both
    operations = lower_chart(Cayley(module.ORDER)).operations
    plain = [name for name, row in PUBLIC.items() if not row.branch and row.kernel in operations]
    rational = [name for name in plain if not LIBRARY & operations[PUBLIC[name].kernel].keys()]
    assert {"pose", "rate", "tangent_dot"} <= set(rational)
    for name in rational:
        arrays = arguments(name, module, dtype, np.random.default_rng(7))
        pairs = zip(by_c(form, name, arrays, 0, "rows"), by_numpy(module, name, arrays, []), strict=True)
        for found, expected in pairs:
            np.testing.assert_array_equal(found, _with_nan_of(found, expected), err_msg=name)


@pytest.mark.parametrize("name", PUBLIC)
def test_both_layouts_agree_up_to_rounding(both, name):
    form, module, dtype = both
    arrays = arguments(name, module, dtype, np.random.default_rng(11))
    n = module.ORDER
    for branch in (0, 1, n - 1, -1, 5 * n + 1) if PUBLIC[name].branch else (0,):
        expected = by_numpy(module, name, arrays, [branch] if PUBLIC[name].branch else [])
        for layout in ("rows", "aos"):
            for ours, theirs in zip(by_c(form, name, arrays, branch, layout), expected, strict=True):
                assert_close(ours, theirs)


def test_rotations_agree_up_to_rounding(folder, tmp_path):
    """Compare one order; rotations share the scalars of poses, compared above for every order."""
    command = compiler()
    library = compiled(command, folder("c"), Cayley(3), "double", tmp_path, ROTATIONS, QUICKLY)
    form, module = CForm(library, "double", ROTATIONS), importlib.import_module("dualcay.rotation.cayley3")
    for name, row in ROTATIONS.public.items():
        arrays = arguments(name, module, np.dtype(np.float64), np.random.default_rng(13), ROTATIONS)
        for branch, layout in itertools.product((0, 1, 2, -1) if row.branch else (0,), ("rows", "aos")):
            found = by_c(form, name, arrays, branch, layout, ROTATIONS)
            expected = by_numpy(module, name, arrays, [branch] if row.branch else [], ROTATIONS)
            for ours, theirs in zip(found, expected, strict=True):
                assert_close(ours, theirs)


def _with_nan_of(found, expected):
    """Return results of NumPy with the NaN of C, whose products with 0 recorded programs leave out."""
    return np.where(np.isnan(found), found, expected)


def assert_close(found, expected):
    """Require equality up to rounding, column by column; the tolerance is larger near small angles and poles."""
    expected = _with_nan_of(found, expected)
    finite = np.isfinite(expected)
    size = np.where(finite, np.abs(expected), 0).astype(np.float64)
    room = 1000 * np.finfo(found.dtype).eps * size.max(axis=0) * (1 + size[:3].max(axis=0))
    np.testing.assert_array_equal(found[~finite], expected[~finite])
    off = np.abs(np.where(finite, found, 0) - np.where(finite, expected, 0))
    assert (off <= room).all(), f"columns {np.flatnonzero((off > room).any(axis=0))}"


@pytest.mark.parametrize("name", ["shadow", "principal", "compose", "twist", "rate", "transform_line"])
def test_a_result_may_take_the_place_of_an_argument(both, name):
    form, module, dtype = both
    arrays = arguments(name, module, dtype, np.random.default_rng(3))
    for layout in ("rows", "aos"):
        (expected,) = by_c(form, name, arrays, 1, layout)
        given = [np.ascontiguousarray(array if layout == "rows" else array.T) for array in arrays]
        form.call(name, *given, out=given[0], branch=1, layout=layout)
        np.testing.assert_array_equal(given[0] if layout == "rows" else given[0].T, expected)


@pytest.mark.parametrize("shift", range(1, 6))
def test_a_single_result_may_overlap_an_argument(both, shift):
    form, _, dtype = both
    values = np.random.default_rng(shift).uniform(-0.3, 0.3, 6).astype(dtype)
    for name, size in (("pose", 16), ("quaternion", 8), ("shadow", 6), ("principal", 6), ("tangent", 18)):
        expected = np.empty((1, size), dtype)
        form.call(name, values[np.newaxis].copy(), out=expected, layout="aos")
        shared = np.zeros(size + shift, dtype)
        shared[:6] = values
        form.call(name, shared[np.newaxis, :6], out=shared[np.newaxis, shift:], layout="aos")
        np.testing.assert_array_equal(shared[shift:], expected[0])


def test_shadows_and_principal_undo_each_other(both):
    form, module, dtype = both
    v = np.ascontiguousarray(np.random.default_rng(5).uniform(-0.1, 0.1, (6, COUNT)) / module.ORDER, dtype)
    moved, back = np.empty_like(v), np.empty_like(v)
    form.call("shadow", v, out=moved, branch=1)
    form.call("principal", moved, out=back)
    np.testing.assert_allclose(back, v, atol=200 * np.finfo(dtype).eps)
