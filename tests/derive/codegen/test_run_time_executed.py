"""Run-time parts of the NumPy target: properties that results do not show."""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from derive.codegen.package import shared_texts
from derive.codegen.targets import TARGETS
from derive.codegen.validation.loading import loaded
from derive.output import files

LINE = 64  # size of a cache line and of the widest vector register, in bytes


@pytest.fixture(scope="module")
def part(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Callable[[str], Any]]:
    """Yield a function that imports a run-time module of the NumPy target by name."""
    folder: Path = tmp_path_factory.mktemp("kernels")
    files.write(folder, shared_texts(TARGETS["numpy"]))
    with loaded(folder) as package:
        yield lambda name: importlib.import_module(f"{package}.{name}")


def test_rows_of_scratch_begin_on_a_cache_line(part: Callable[[str], Any]) -> None:
    kernel = part("_kernel")
    for size in (1, 63, 64, 1000, 100_000):
        scratch = kernel.Scratch()
        memory = scratch.take(size)
        assert memory.ctypes.data % LINE == 0
        assert memory.size >= size
        scratch.give_back(memory)
        assert scratch.take(size) is memory
    for dtype in map(np.dtype, (np.float32, np.float64, np.longdouble)):
        for cells in (1, 7, 8, 100, 16384):
            padded = kernel._padded(cells, dtype)
            assert padded >= cells
            assert padded * dtype.itemsize % LINE == 0


@pytest.mark.parametrize("shape", [(6,), (2, 3)])
def test_single_poses_are_read_with_components_first_or_last(part: Callable[[str], Any], shape: Any) -> None:
    last = np.arange(30.0).reshape(5, *shape)
    first = np.moveaxis(last, 0, -1)
    for array, axis in ((last, -1), (first, 0)):
        assert part("_runtime")._poses(array, shape, (5,), axis, array.dtype) == last.reshape(5, 6).tolist()


def test_dense_or_broadcast_rows_are_read_without_copying(part: Callable[[str], Any]) -> None:
    is_read, dtype = part("_kernel")._unit_stride, np.dtype(np.float64)
    dense, one = np.ones((6, 10)), np.broadcast_to(np.ones((6, 1)), (6, 10))
    spread, same = np.ones((6, 20))[:, ::2], np.broadcast_to(np.ones(20)[::2], (6, 10))
    for rows, wanted in ((dense, True), (one, True), (spread, False), (same, False), (dense.astype(np.float32), False)):
        assert is_read(rows, dtype, broadcast=True) is wanted
    assert [is_read(rows, dtype) for rows in (dense, one)] == [True, False]
