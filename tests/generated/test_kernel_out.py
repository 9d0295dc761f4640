"""Argument ``out``: it is returned itself; layouts, overlap, refusals. Rows of memory that results do not show."""

from __future__ import annotations

import itertools
import re
from types import ModuleType

import numpy as np
import pytest

from dualcay import _kernel
from tests.support import thorough
from tests.support.kernels import ALIKE, load, orders
from tests.support.signatures import KINDS, SIGNATURES, assert_nearly_equal, inputs, rows_of

order = orders(ALIKE)
FUNCTION = pytest.mark.parametrize("name", thorough.sampled(SIGNATURES, KINDS.values()))
AXIS = pytest.mark.parametrize("axis", [-1, 0])


def arranged(kernel: ModuleType, name: str, order: int, shape: tuple[int, ...], axis: int) -> list[np.ndarray]:
    arguments = inputs(kernel, name, order, shape)
    return rows_of(name, arguments) if axis == 0 else arguments


@FUNCTION
@AXIS
def test_out_is_filled_and_returned(kernel: ModuleType, order: int, name: str, axis: int) -> None:
    for shape in ((), (5,), (2, 3), (0,)):
        arguments = arranged(kernel, name, order, shape, axis)
        expected = getattr(kernel, name)(*arguments, axis=axis)
        spacious = np.full([2 * n for n in expected.shape], np.nan)
        contiguous, fortran = (np.full(expected.shape, np.nan, order=order) for order in "CF")
        for out in (contiguous, fortran, spacious[tuple(slice(None, None, 2) for _ in expected.shape)]):
            assert getattr(kernel, name)(*arguments, axis=axis, out=out) is out
            assert_nearly_equal(out, expected)
        assert np.isnan(spacious[tuple(slice(1, None, 2) for _ in expected.shape)]).all()


OVERLAPPING = [(name, count) for count in (1, 50) for name in SIGNATURES]
LONG = [(name, 17_000) for name in ("pose", "from_pose", "compose", "transform_point", "interpolate", "rate_jacobian")]
FEW = [*itertools.product(KINDS.values(), (1, 50)), *LONG[::2]]


@pytest.mark.parametrize("case", thorough.sampled([*OVERLAPPING, *LONG], FEW), ids=str)
@AXIS
def test_out_may_overlap_an_argument(case: tuple[str, int], axis: int) -> None:
    """Start ``out`` before, at or after the argument in memory; elements must be read before they are overwritten.

    Long batches run in blocks that do not depend on the function: a sample of sizes of arguments and results suffices.
    """
    kernel, (name, count) = load(3), case
    arguments = [np.resize(a, (count, *a.shape[1:])) for a in inputs(kernel, name, 3, (min(count, 50),))]
    if axis == 0:
        arguments = rows_of(name, arguments)
    expected = getattr(kernel, name)(*arguments, axis=axis)
    for i, argument in enumerate(arguments):
        room = max(argument.size, expected.size)
        for start, out_start in ((0, 0), (7, 0), (0, 7), (room // 2, 0), (0, room // 2)):
            buffer = np.zeros(2 * room + 7)
            given = list(arguments)
            given[i] = buffer[start : start + argument.size].reshape(argument.shape)
            given[i][...] = argument
            out = buffer[out_start : out_start + expected.size].reshape(expected.shape)
            assert getattr(kernel, name)(*given, axis=axis, out=out) is out
            assert_nearly_equal(out, expected)


@FUNCTION
@AXIS
def test_out_of_a_wrong_shape_or_type_is_refused(kernel: ModuleType, order: int, name: str, axis: int) -> None:
    function, arguments = getattr(kernel, name), arranged(kernel, name, order, (5,), axis)
    right = function(*arguments, axis=axis).shape
    for wrong in ((7, *right[1:]), right[:-1], (1, *right), (*right[:-1], right[-1] + 1)):
        with pytest.raises(ValueError, match=f"{re.escape(str(right))}.*{re.escape(str(wrong))}"):
            function(*arguments, axis=axis, out=np.zeros(wrong))
    single = [a[0] if axis == -1 else a[..., 0] for a in arguments]
    with pytest.raises(ValueError, match="out"):
        function(*single, axis=axis, out=np.zeros(right))
    for given, shape in ((arguments, right), (single, function(*single, axis=axis).shape)):
        for out in (np.zeros(shape, int), np.zeros(shape, bool), np.zeros(shape).tolist()):
            with pytest.raises(TypeError, match="out"):
                function(*given, axis=axis, out=out)
        frozen = np.zeros(shape)
        frozen.flags.writeable = False
        with pytest.raises(ValueError, match="read-only"):
            function(*given, axis=axis, out=frozen)


# --- rows of memory ---------------------------------------------------------------------------------------------------

LINE = _kernel.CACHE_LINE  # size of a cache line and of the widest vector register, in bytes


def test_rows_of_scratch_begin_on_a_cache_line() -> None:
    for size in (1, 63, 64, 1000, 100_000):
        scratch = _kernel.Scratch()
        memory = scratch.take(size)
        assert memory.ctypes.data % LINE == 0
        assert memory.size >= size
        scratch.give_back(memory)
        assert scratch.take(size) is memory
    for dtype in map(np.dtype, (np.float32, np.float64, np.longdouble)):
        for cells in (1, 7, 8, 100, 16384):
            padded = _kernel._padded(cells, dtype)
            assert padded >= cells
            assert padded * dtype.itemsize % LINE == 0


def test_dense_or_broadcast_rows_are_read_without_copying() -> None:
    is_read, dtype = _kernel._unit_stride, np.dtype(np.float64)
    dense, one = np.ones((6, 10)), np.broadcast_to(np.ones((6, 1)), (6, 10))
    spread, same = np.ones((6, 20))[:, ::2], np.broadcast_to(np.ones(20)[::2], (6, 10))
    for rows, wanted in ((dense, True), (one, True), (spread, False), (same, False), (dense.astype(np.float32), False)):
        assert is_read(rows, dtype, broadcast=True) is wanted
    assert [is_read(rows, dtype) for rows in (dense, one)] == [True, False]
